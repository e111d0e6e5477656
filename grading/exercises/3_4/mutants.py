from grading.variants import Mutant

PUBLISH = "self.publisher.publish(OccupancyGrid(header=Header(frame_id='map'), info=info, data=data))"
COUNT = '=list(grid.data).count(100)'

MUTANTS = [
    Mutant('absolute_map', old="self.create_publisher(OccupancyGrid, 'map'",
           new="self.create_publisher(OccupancyGrid, '/map'", expect='a relative name has no leading slash',
           breaks='topics', also=('walls',)),
    Mutant('absolute_walls', old="'walls'", new="'/walls'", expect='a relative name has no leading slash',
           breaks='topics'),
    Mutant('answers_before_a_map', old="self.publisher = self.create_publisher(Int32, 'walls', LATCHED)", new='''
        self.publisher = self.create_publisher(Int32, 'walls', LATCHED)
        self.publisher.publish(Int32(data=0))
        self.create_timer(1.0, lambda: self.publisher.publish(Int32(data=0)))
        ''', expect='MapReader says 0', breaks='walls'),
    Mutant('answers_grow', edits=(('(Int32(data=list(grid.data).count(100)))', '(Int32(data=self.walls))'),
            ('def on_map(self, grid):', '''
            walls = 0

            def on_map(self, grid):
                self.walls += list(grid.data).count(100)
            ''')), expect='MapReader says', breaks='walls'),
    Mutant('answers_once', old='def on_map(self, grid):', new='''
        def on_map(self, grid):
            if hasattr(self, 'done'):
                return
            self.done = True
        ''', expect='each map gets one', breaks='walls'),
    Mutant('answers_only_changes', old='def on_map(self, grid):', new='''
        def on_map(self, grid):
            before, self.before = getattr(self, 'before', None), list(grid.data).count(100)
            if before == self.before:
                return
        ''', expect='each map gets one', breaks='walls'),
    Mutant('best_effort', old=', durability=', new=', reliability=ReliabilityPolicy.BEST_EFFORT, durability=',
           expect='BEST_EFFORT', breaks='qos'),
    Mutant('capital_frame', old="frame_id='map'", new="frame_id='Map'", expect="header.frame_id is 'Map'",
           breaks='frame'),
    Mutant('column_by_column', old='cell] for row in rows for cell in row',
           new='row[x]] for x in range(len(rows[0])) for row in rows', expect='column by column', breaks='order'),
    Mutant('counts_nearly_walls', old=COUNT, new='=sum(cell > 50 for cell in grid.data)', expect='only 100 is a wall',
           breaks='walls'),
    Mutant('counts_free_cells', old=COUNT, new='=list(grid.data).count(0)', expect='MapReader says', breaks='walls'),
    Mutant('deep_subscription', old="(OccupancyGrid, 'map', self.on_map, LATCHED)",
           new="(OccupancyGrid, 'map', self.on_map, QoSProfile(depth=5, durability=DurabilityPolicy.TRANSIENT_LOCAL))",
           expect='has the depth 5, expected 1', breaks='qos'),
    Mutant('fixed_size', old='width=len(rows[0]), height=len(rows)', new='width=3, height=2', expect='wide and',
           breaks='size'),
    Mutant('from_right_to_left', old='for cell in row]', new='for cell in row[::-1]]', expect='from right to left',
           breaks='order'),
    Mutant('keeps_all_answers', old='(depth=1, durability', new='(depth=10, durability',
           expect='has the depth 10, expected 1', breaks='qos'),
    Mutant('last_row_first', old='for row in rows for cell', new='for row in reversed(rows) for cell',
           expect='from the last row to the first', breaks='order'),
    Mutant('no_frame', edits=(('from std_msgs.msg import Header', ''),
            ("(header=Header(frame_id='map'), info", '(info')), expect='header.frame_id', breaks='frame'),
    Mutant('no_resolution', old=', resolution=0.1)', new=')', expect='info.resolution is 0', breaks='resolution'),
    Mutant('publishes_later', old=PUBLISH, new='''
        grid = OccupancyGrid(header=Header(frame_id='map'), info=info, data=data)
        self.timer = self.create_timer(1.0, lambda: (self.publisher.publish(grid), self.timer.cancel()))
        ''', expect='Publish it in the constructor', breaks='one-map'),
    Mutant('publishes_twice', old=PUBLISH, new='''
        grid = OccupancyGrid(header=Header(frame_id='map'), info=info, data=data)
        self.publisher.publish(grid)
        self.publisher.publish(grid)
        ''', expect='maps in its constructor', breaks='one-map'),
    Mutant('reader_name', old="'map_reader'", new="'reader'", expect="expected 'map_reader'", breaks='reader-node'),
    Mutant('repeats_in_timer', old=PUBLISH, new='''
        self.grid = OccupancyGrid(header=Header(frame_id='map'), info=info, data=data)
        self.publisher.publish(self.grid)
        self.create_timer(60.0, lambda: self.publisher.publish(self.grid))
        ''', expect='Nothing needs to be repeated', breaks='one-map'),
    Mutant('resolution_in_centimetres', old='resolution=0.1', new='resolution=10.0', expect='info.resolution is 10',
           breaks='resolution'),
    Mutant('server_name', old="'map_server'", new="'mapserver'", expect="expected 'map_server'", breaks='server-node'),
    Mutant('size_exchanged', old='[0]), height=len(rows', new='), height=len(rows[0]',
           expect='width and height are exchanged', breaks='size'),
    Mutant('unknown_is_free', old="'?': -1", new="'?': 0", expect="the cell '?' in row", breaks='cells'),
    Mutant('unknown_is_wall', old=COUNT, new='=len([cell for cell in grid.data if cell != 0])',
           expect='unknown (-1) is no wall', breaks='walls'),
    Mutant('volatile_answer', old="(Int32, 'walls', LATCHED)", new="(Int32, 'walls', 1)",
           expect='offers durability VOLATILE', breaks='qos'),
    Mutant('volatile_reader', old="(OccupancyGrid, 'map', self.on_map, LATCHED)",
           new="(OccupancyGrid, 'map', self.on_map, 1)", expect='it does not get a map that was published before',
           breaks='late'),
    Mutant('volatile_server', old="(OccupancyGrid, 'map', LATCHED)", new="(OccupancyGrid, 'map', 1)",
           expect='VOLATILE', breaks='qos'),
    Mutant('wall_is_one', old="{'#': 100", new="{'#': 1", expect="the cell '#' in row", breaks='cells',
           also=('walls',)),
    Mutant('keeps_everything', old='QoSProfile(depth=1,', new='QoSProfile(history=rclpy.qos.HistoryPolicy.KEEP_ALL,',
           expect='keeps everything (KEEP_ALL)', breaks='qos'),
    Mutant('short_life', breaks='qos', old='QoSProfile(depth=1, ', new='QoSProfile(depth=1, lifespan=Duration(seconds=10), ',
           imports='from rclpy.duration import Duration', expect='has the lifespan 10 s', also=('late', 'one-map')),
    Mutant('one_more_topic', breaks='walls', old="self.publisher = self.create_publisher(Int32, 'walls', LATCHED)", new="""
        self.publisher = self.create_publisher(Int32, 'walls', LATCHED)
        self.free = self.create_publisher(Int32, 'free', LATCHED)
        """, expect='one topic too many'),
    Mutant('counts_from_100_on', old=COUNT, new='=sum(cell >= 100 for cell in grid.data)', expect='only 100 is a wall',
           breaks='walls'),
    Mutant('only_in_the_frame_map', old='def on_map(self, grid):', new="""
        def on_map(self, grid):
            if grid.header.frame_id != 'map':
                return
        """, expect='each map gets one', breaks='walls'),
    Mutant('forty_maps', breaks='walls', old='def on_map(self, grid):', new="""
        def on_map(self, grid):
            self.number = getattr(self, 'number', 0) + 1
            if self.number > 40:
                return
        """, expect='That many came, one after the other'),
    Mutant('fifty_rows_at_most', old='cell] for row in rows for cell in row', new='cell] for row in rows[:50] for cell in row',
           expect='values, expected', breaks='cells'),
    Mutant('hundred_columns_at_most', breaks='size', old='width=len(rows[0])', new='width=min(len(rows[0]), 100)',
           expect='the map is 100 wide'),
    Mutant('publisher_of_the_reader_in_the_class', breaks='walls', expect='what is kept in the class, or outside of it',
           old="self.publisher = self.create_publisher(Int32", new="MapReader.publisher = self.create_publisher(Int32"),
    Mutant('again_for_each_subscriber', breaks='one-map', old=PUBLISH, new="""
        grid = OccupancyGrid(header=Header(frame_id='map'), info=info, data=data)
        self.publisher.publish(grid)
        self.known = 1

        def look():
            there = self.publisher.get_subscription_count()
            if there > self.known:
                self.publisher.publish(grid)
            self.known = max(there, self.known)

        self.create_timer(0.5, look)
        """, expect='When another subscriber had come'),
    Mutant('older_maps_do_not_count', old='self.publisher.publish(Int32(data=list(grid.data).count(100)))', new="""
        stamp = grid.header.stamp.sec
        if stamp >= getattr(self, 'newest', 0):
            self.newest = stamp
            self.publisher.publish(Int32(data=list(grid.data).count(100)))
        """, expect='each map gets one', breaks='walls', also=('late',)),
    Mutant('counts_for_listeners_only', old='self.publisher.publish(Int32(data=list(grid.data).count(100)))', new="""
        if self.publisher.get_subscription_count():
            self.publisher.publish(Int32(data=list(grid.data).count(100)))
        """, expect='came while nobody listened on walls', breaks='walls', also=('late',)),
]
