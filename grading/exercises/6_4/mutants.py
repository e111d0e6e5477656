from grading.variants import Mutant

SCANS = 'test_scans'

MUTANTS = [
    Mutant('spread_over_all', breaks='place', old='number * scan.angle_increment',
           new='number * (scan.angle_max - scan.angle_min) / max(1, len(scan.ranges))', expect='of the scan, ('),
    Mutant('each_place_once', breaks='range', also='one-cloud', old='cloud = create_cloud_xyz32(scan.header, points)',
           new='cloud = create_cloud_xyz32(scan.header, list(dict.fromkeys(points)))', expect='each hit is a point'),
    Mutant('waits_half_a_second', breaks='later', old='''
        future.add_done_callback(lambda future: self.publish(cloud, future.result()))
        ''', new='''
        begin = self.get_clock().now()
        future.add_done_callback(
            lambda future: self.get_clock().now() - begin < Duration(seconds=0.5) and self.publish(cloud, future.result()))
        ''', expect='do not give up so soon'),
    Mutant('from_min_to_max', breaks='place', old='number * scan.angle_increment',
           new='number * (scan.angle_max - scan.angle_min) / max(1, len(scan.ranges) - 1)',
           expect='spread from angle_min to angle_max'),
    Mutant('always_laser', breaks='frame', also=('one-cloud', 'later', 'hopeless', 'range'),
           old='scan.header.frame_id', new="'laser'", expect='not of the frame in the header of the scan'),
    Mutant('blocks', breaks='later', also=('hopeless',), old='''
        future = self.buffer.wait_for_transform_async('map', scan.header.frame_id, when)
        future.add_done_callback(lambda future: self.publish(cloud, future.result()))
        ''', new='''
        try:
            timeout = Duration(seconds=0.3)
            self.publish(cloud, self.buffer.lookup_transform('map', scan.header.frame_id, when, timeout))
        except TransformException as error:
            self.get_logger().warning(str(error))
        ''', expect='do not block'),
    Mutant('counts_hits', breaks='place', old='scan.ranges',
           new='r for r in scan.ranges if scan.range_min <= r <= scan.range_max', expect='counted from hit to hit'),
    Mutant('gives_up', breaks='later', also=('hopeless',), old='''
        future = self.buffer.wait_for_transform_async('map', scan.header.frame_id, when)
        future.add_done_callback(lambda future: self.publish(cloud, future.result()))
        ''', new='''
        try:
            self.publish(cloud, self.buffer.lookup_transform('map', scan.header.frame_id, when))
        except TransformException as error:
            self.get_logger().warning(str(error))
        ''', expect='do not block'),
    Mutant('in_a_row', breaks='hopeless', edits=(('def on_scan', 'async def on_scan'),
            ('''
            future = self.buffer.wait_for_transform_async('map', scan.header.frame_id, when)
            future.add_done_callback(lambda future: self.publish(cloud, future.result()))
            ''', "self.publish(cloud, await self.buffer.wait_for_transform_async('map', scan.header.frame_id, when))")),
           expect='waits behind the others'),
    Mutant('keeps_all', breaks='range', old='''
        if scan.range_min <= distance <= scan.range_max:
            points.append((distance * math.cos(angle), distance * math.sin(angle), 0.0))
        ''', new='points.append((distance * math.cos(angle), distance * math.sin(angle), 0.0))',
           expect='gave a cloud of 12 points'),
    Mutant('newest', breaks='time', also=('hopeless', 'place', 'later'), old='when = Time.from_msg(scan.header.stamp)',
           new='when = Time()', expect='This is the newest transform'),
    Mutant('only_the_name', breaks='place', old='self.publisher.publish(do_transform_cloud(cloud, laser_in_map))',
           new='''
        cloud.header.frame_id = 'map'
        self.publisher.publish(cloud)
        ''', expect='only the name of the frame has changed'),
    Mutant('stamp_of_now', breaks='stamp', old='''
        cloud = create_cloud_xyz32(scan.header, points)
        when = Time.from_msg(scan.header.stamp)
        ''', new='''
        scan.header.stamp, measured = self.get_clock().now().to_msg(), scan.header.stamp
        cloud = create_cloud_xyz32(scan.header, points)
        when = Time.from_msg(measured)
        ''', expect='A stamp says when it was measured'),
    Mutant('swapped', breaks='place', edits=(("'map', scan.header.frame_id", "scan.header.frame_id, 'map'"),
            ('def publish(self, cloud, laser_in_map):', '''
            def publish(self, cloud, laser_in_map):
                laser_in_map.header.frame_id = 'map'
            ''')), expect='target and source are swapped'),
    Mutant('base_link', breaks='frame', old='scan.header.frame_id', new="'base_link'",
           expect='not of the frame in the header of the scan'),
    Mutant('own_limits', breaks='range', old='scan.range_min <= distance <= scan.range_max',
           new='0.1 <= distance <= 12.0', expect='gave a cloud of'),
    Mutant('limits_left_out', breaks='range', old='scan.range_min <= distance <= scan.range_max',
           new='scan.range_min < distance < scan.range_max', expect='gave a cloud of'),
    Mutant('only_inf', breaks='range', old='scan.range_min <= distance <= scan.range_max',
           new='math.isfinite(distance)', expect='gave a cloud of'),
    Mutant('backwards', breaks='order', also=('range',), old='points.append((', new='points.insert(0, (',
           expect='their order is not that of the scan'),
    Mutant('to_the_right', breaks='place', also=('time', 'later', 'range', 'hopeless'), old='scan.angle_min + number',
           new='scan.angle_min - number', expect='of the scan, ('),
    Mutant('from_zero', breaks='place', also=('time', 'later', 'range', 'hopeless'), old='scan.angle_min + number',
           new='number', expect='of the scan, ('),
    Mutant('one_per_hit', breaks='one-cloud', also=('range', 'time', 'later', 'hopeless'),
           old='self.publisher.publish(do_transform_cloud(cloud, laser_in_map))', new="""
        for _ in range(2):
            self.publisher.publish(do_transform_cloud(cloud, laser_in_map))
        """, expect='expected one'),
    Mutant('other_name', breaks='name', old="'scan_to_map'", new="'scan2map'", expect='Your node is called'),
    Mutant('other_topic', breaks='topics', also=('one-cloud', 'later', 'hopeless', 'range'), old="'points'",
           new="'cloud'", expect='has no publisher on /points'),
    Mutant('only_the_last_waits', breaks='later', also=('hopeless',), edits=(
           ('when = Time.from_msg(scan.header.stamp)', """
           self.last = cloud
           when = Time.from_msg(scan.header.stamp)
           """), ('lambda future: self.publish(cloud, future.result())',
                  'lambda future: cloud is self.last and self.publish(cloud, future.result())')),
           expect='each scan waits for its own transform'),
    Mutant('whole_seconds', breaks='time', also=('later', 'hopeless', 'one-cloud', 'frame'),
           old='Time.from_msg(scan.header.stamp)', new='Time(seconds=scan.header.stamp.sec)',
           expect='count the nanoseconds, too'),
    Mutant('no_cloud_without_hits', old='self.publisher.publish(do_transform_cloud(cloud, laser_in_map))', new="""
        if cloud.width:
            self.publisher.publish(do_transform_cloud(cloud, laser_in_map))
        """, expect='expected one', breaks='one-cloud'),
    Mutant('depth_of_one', old="'points', 10)", new="'points', 1)", expect='has the depth 1, expected 10',
           breaks='topics'),
    Mutant('rounded_distances', breaks='range', old='scan.range_min <= distance <= scan.range_max',
           new='scan.range_min <= round(distance, 2) <= scan.range_max', expect='gave a cloud of'),
    Mutant('always_to_the_left', breaks='place', also=('frame',), old='number * scan.angle_increment',
           new='number * abs(scan.angle_increment)', expect='of the scan, ('),
    Mutant('stamp_in_microseconds', breaks='stamp', old='self.publisher.publish(do_transform_cloud(cloud, laser_in_map))',
           new="""
        cloud = do_transform_cloud(cloud, laser_in_map)
        cloud.header.stamp.nanosec = cloud.header.stamp.nanosec // 1000 * 1000
        self.publisher.publish(cloud)
        """, expect='A stamp says when it was measured'),
    Mutant('three_may_wait', breaks='later', edits=(
           ("self.buffer = Buffer()", """
           self.buffer = Buffer()
           self.waiting = []
           """), ('when = Time.from_msg(scan.header.stamp)', """
           when = Time.from_msg(scan.header.stamp)
           self.waiting = [*self.waiting[-2:], cloud]
           """), ('lambda future: self.publish(cloud, future.result())',
                  'lambda future: cloud in self.waiting and self.publish(cloud, future.result())')),
           expect='each scan waits for its own transform', also=('hopeless', 'frame')),
    Mutant('one_of_each_time', breaks='later', edits=(
           ("self.buffer = Buffer()", """
           self.buffer = Buffer()
           self.waiting = {}
           """), ('when = Time.from_msg(scan.header.stamp)', """
           when = Time.from_msg(scan.header.stamp)
           self.waiting[when.nanoseconds] = cloud
           """), ('lambda future: self.publish(cloud, future.result())',
                  'lambda future: cloud is self.waiting[when.nanoseconds] and self.publish(cloud, future.result())')),
           expect='each scan waits for its own transform', also=('frame',)),
    Mutant('frame_without_its_robot', breaks='frame', old="'map', scan.header.frame_id",
           new="'map', scan.header.frame_id.split('/')[-1]", also=('later', 'time'), expect='no cloud came on /points'),
    Mutant('frame_of_the_first', breaks='frame', old='def on_scan(self, scan):', new="""
        def on_scan(self, scan):
            self.frame = getattr(self, 'frame', scan.header.frame_id)
            scan.header.frame_id = self.frame
        """, also=('time', 'later', 'hopeless'), expect='not of the frame in the header of the scan'),
    Mutant('only_newer_ones', breaks='one-cloud', also=('hopeless', 'frame', 'later', 'time'), old='def publish(self, cloud, laser_in_map):', new="""
        def publish(self, cloud, laser_in_map):
            stamp = Time.from_msg(cloud.header.stamp)
            if stamp < getattr(self, 'last', stamp):
                return
            self.last = stamp
        """, expect='no cloud came on /points'),
    Mutant('zero_is_no_distance', old='if scan.range_min <= distance', new='if distance and scan.range_min <= distance',
           breaks='range', expect='also if it is 0.0'),
    Mutant('nothing_is_beyond_30_m', old='def on_scan(self, scan):', new="""
        def on_scan(self, scan):
            scan.range_max = min(scan.range_max, 30.0)
        """, breaks='range', expect='gave a cloud of'),
    Mutant('same_distances_once', breaks='one-cloud', old='def on_scan(self, scan):', new="""
        def on_scan(self, scan):
            if list(scan.ranges) == getattr(self, 'last', None):
                return
            self.last = list(scan.ranges)
        """, expect='as those of a robot that stands still'),
    Mutant('a_degree_for_each', breaks='range', old='enumerate(scan.ranges)', new='enumerate(scan.ranges[:360])',
           expect='gave a cloud of 360 points'),
    Mutant('sixty_scans_at_most', breaks='one-cloud', old='    def on_scan(self, scan):', new='''
    def on_scan(self, scan):
        self.count = getattr(self, 'count', 0) + 1
        if self.count > 60:
            return
''', expect='however many there were before'),
    Mutant('no_cloud_without_distances', breaks='one-cloud', old='points = []', new="""
        if not scan.ranges:
            return
        points = []
        """, expect='ranges is empty'),
    Mutant('nearest_of_none', breaks='one-cloud', old='points = []', new="""
        self.nearest = min(scan.ranges)
        points = []
        """, expect='ValueError'),
    Mutant('futures_by_frame', breaks='time', also=('hopeless',), edits=(('self.buffer = Buffer()', """
        self.buffer = Buffer()
        self.futures = {}
        """), ("future = self.buffer.wait_for_transform_async('map', scan.header.frame_id, when)", """
        future = self.futures.get(scan.header.frame_id)
        if future is None or future.done():
            future = self.buffer.wait_for_transform_async('map', scan.header.frame_id, when)
            self.futures[scan.header.frame_id] = future
        """)), expect='Ask for the transform anew for each scan'),
    Mutant('first_transform_of_a_frame', breaks='time', also=('hopeless',), edits=(
           ('self.buffer = Buffer()', """
        self.buffer = Buffer()
        self.futures = {}
        """), ("future = self.buffer.wait_for_transform_async('map', scan.header.frame_id, when)", """
        if scan.header.frame_id not in self.futures:
            self.futures[scan.header.frame_id] = self.buffer.wait_for_transform_async('map', scan.header.frame_id, when)
        future = self.futures[scan.header.frame_id]
        """)), expect='Ask for the transform anew for each scan'),
    Mutant('cloud_in_self', breaks='later', old="""
        future.add_done_callback(lambda future: self.publish(cloud, future.result()))
        """, new="""
        self.cloud = cloud
        future.add_done_callback(lambda future: self.publish(self.cloud, future.result()))
        """, expect='went out in the place of others'),
    Mutant('points_in_self', breaks='later', edits=(('points = []', 'self.points = []'),
           ('points.append((', 'self.points.append(('), ('cloud = create_cloud_xyz32(scan.header, points)', ''),
           ('lambda future: self.publish(cloud, future.result())',
            'lambda future: self.publish(create_cloud_xyz32(scan.header, self.points), future.result())')),
           expect='has the points of another scan'),
]
