from grading.variants import Mutant

CUP = 'test_cup'
FOUND = "found = self.buffer.lookup_transform_full('base_link', Time(), 'cup', then, 'map')"

MUTANTS = [
    Mutant('heading_only', breaks='point', edits=((FOUND, '''
            robot = self.buffer.lookup_transform('map', 'base_link', Time())
            cup = self.buffer.lookup_transform('map', 'cup', then)
            '''), ('''
        point = PointStamped(header=found.header)
        place = found.transform.translation
        point.point.x, point.point.y, point.point.z = place.x, place.y, place.z
        ''', '''
        point = PointStamped(header=robot.header)
        point.header.frame_id = 'base_link'
        c, r, q = cup.transform.translation, robot.transform.translation, robot.transform.rotation
        yaw = math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y**2 + q.z**2))
        dx, dy = c.x - r.x, c.y - r.y
        point.point.x = math.cos(yaw) * dx + math.sin(yaw) * dy
        point.point.y = math.cos(yaw) * dy - math.sin(yaw) * dx
        point.point.z = c.z - r.z
        ''')), expect='it is turned by more than its yaw'),
    Mutant('listens_when_asked', breaks='none', also=('then', 'robot-now', 'far'), edits=(
           ('self.listener = TransformListener(self.buffer, self)', 'self.listener = None'),
           ('then = self.get_clock().now() - Duration(seconds=seconds)', '''
            self.listener = self.listener or TransformListener(self.buffer, self)
            then = self.get_clock().now() - Duration(seconds=seconds)
            ''')), expect='so that they hear what comes before the first question'),
    Mutant('another_time_instead', breaks='too-long', also=('none', 'far', 'then', 'robot-now',), old='return None',
           new='''
        try:
            found = self.buffer.lookup_transform('base_link', 'cup', Time())
        except TransformException:
            return None
        ''', expect='Do not take another time instead'),
    Mutant('asks_for_now', breaks='robot-now', old="', Time(),", new="', self.get_clock().now(),",
           expect='The newest transform has the time 0 in a look-up'),
    Mutant('times_exchanged', breaks='then', also=('too-long', 'far', 'stamp', 'robot-now'),
           old="'base_link', Time(), 'cup', then, 'map'", new="'base_link', then, 'cup', Time(), 'map'",
           expect='the two times are exchanged'),
    Mutant('cup_of_now', breaks='then', also=('too-long', 'far',),
           old="found = self.buffer.lookup_transform_full('base_link', Time(), 'cup', then, 'map')",
           new="found = self.buffer.lookup_transform('base_link', 'cup', Time())", expect='where the cup was just now'),
    Mutant('does_not_catch', breaks='none', also=('too-long',), old='''
        try:
            found = self.buffer.lookup_transform_full('base_link', Time(), 'cup', then, 'map')
        except TransformException:
            return None
        ''', new="found = self.buffer.lookup_transform_full('base_link', Time(), 'cup', then, 'map')",
           expect='LookupException'),
    Mutant('in_the_map', breaks='point', also=('none', 'too-long',),
           old="found = self.buffer.lookup_transform_full('base_link', Time(), 'cup', then, 'map')",
           new="found = self.buffer.lookup_transform('map', 'cup', then)", expect='This is in the frame map.'),
    Mutant('new_buffer_each_time', breaks='robot-now', also=('far',), old='def where_was(self, seconds):', new='''
        def where_was(self, seconds):
            self.buffer = Buffer(Duration(seconds=31))
            self.listener = TransformListener(self.buffer, self)
        ''', expect='is there one buffer, with one listener, for the life of the node?'),
    Mutant('robot_is_fixed', breaks='robot-now', old="('base_link', Time(), 'cup', then, 'map')",
           new="('base_link', Time(), 'cup', then, 'base_link')", expect='seen from the robot as it stood then'),
    Mutant('robot_of_then', breaks='robot-now',
           old="found = self.buffer.lookup_transform_full('base_link', Time(), 'cup', then, 'map')",
           new="found = self.buffer.lookup_transform('base_link', 'cup', then)",
           expect='seen from the robot as it stood then'),
    Mutant('swapped', breaks='then', also=('far',), old="'base_link', Time(), 'cup', then,",
           new="'cup', then, 'base_link', Time(),", expect='target and source are swapped'),
    Mutant('ten_seconds', breaks='far', also=('then',), old='(Duration(seconds=31))', new='()',
           expect='How long does a buffer keep what it hears?'),
    Mutant('always_the_same', breaks='then', also=('too-long', 'far', 'none', 'robot-now'),
           old='now() - Duration(seconds=seconds)', new='now() - Duration(seconds=0.4)', expect='gave ('),
    Mutant('before_the_newest', breaks='then', also=('too-long', 'far'),
           old='then = self.get_clock().now() - Duration(seconds=seconds)', new="""
        try:
            newest = self.buffer.get_latest_common_time('map', 'cup')
        except TransformException:
            return None
        then = Time(nanoseconds=newest.nanoseconds - round(seconds * 1e9), clock_type=newest.clock_type)
        """, expect='gave ('),
    Mutant('no_height', breaks='point', also=('then', 'far'), old='place.x, place.y, place.z', new='place.x, place.y, 0.0',
           expect='gave ('),
    Mutant('stamp_of_now', breaks='stamp', old='point = PointStamped(header=found.header)', new="""
        point = PointStamped(header=found.header)
        point.header.stamp = self.get_clock().now().to_msg()
        """, expect='has the stamp'),
    Mutant('other_frame', breaks='point', old='point = PointStamped(header=found.header)', new="""
        point = PointStamped(header=found.header)
        point.header.frame_id = 'cup'
        """, expect='has the frame_id'),
    Mutant('other_name', breaks='name', old="'cup_finder'", new="'finder'", expect='Your node is called'),
    Mutant('plain_point', breaks='point', also=('then', 'far'), old='return point', new='return place',
           expect='expected a PointStamped'),
    Mutant('zeros_when_unknown', breaks='none', also=('too-long', 'far'), old='return None',
           new='return PointStamped()', expect='No transforms have come'),
    Mutant('twenty_seconds', breaks='far', old='(seconds=31)', new='(seconds=20)',
           expect='How long does a buffer keep what it hears?'),
    Mutant('stamp_of_the_cup', old='point = PointStamped(header=found.header)', new="""
        point = PointStamped(header=found.header)
        point.header.stamp = self.buffer.lookup_transform('map', 'cup', Time()).header.stamp
        """, expect='has the stamp', breaks='stamp'),
    Mutant('twenty_nine_seconds', breaks='far', old='(seconds=31)', new='(seconds=29.5)', expect='30 s are wanted'),
    Mutant('not_for_zero', breaks='then', old='then = self.get_clock().now() - Duration(seconds=seconds)', new="""
        if not seconds:
            return None
        then = self.get_clock().now() - Duration(seconds=seconds)
        """, expect='0 is a number of seconds like any other'),
    Mutant('tenths_of_a_second', breaks='then', old='Duration(seconds=seconds)',
           new='Duration(seconds=round(seconds, 1))', expect='expected ('),
    Mutant('nothing_below_a_tenth', breaks='then', old='then = self.get_clock().now() - Duration(seconds=seconds)', new="""
        if 0 < seconds < 0.1:
            return None
        then = self.get_clock().now() - Duration(seconds=seconds)
        """, expect='gave None'),
    Mutant('error_beyond_thirty', breaks='too-long', old='then = self.get_clock().now() - Duration(seconds=seconds)', new="""
        if seconds > 30:
            raise ValueError('too long ago')
        then = self.get_clock().now() - Duration(seconds=seconds)
        """, expect='raised ValueError'),
    Mutant('thirty_for_more', breaks='too-long', old='Duration(seconds=seconds)', new='Duration(seconds=min(seconds, 30.0))',
           expect='Do not take another time instead'),
    Mutant('answers_are_kept', breaks='then', edits=(
           ('then = self.get_clock().now() - Duration(seconds=seconds)', """
            self.known = getattr(self, 'known', {})
            if seconds in self.known:
                return self.known[seconds]
            then = self.get_clock().now() - Duration(seconds=seconds)
            """), ('return point', """
            self.known[seconds] = point
            return point
            """)), expect='expected ('),
    Mutant('newest_for_what_is_to_come', breaks='then', old="""
        except TransformException:
            return None
        """, new="""
        except TransformException:
            if seconds > 0.2 or not self.buffer.can_transform('base_link', 'cup', Time()):
                return None
            found = self.buffer.lookup_transform('base_link', 'cup', Time())
        """, expect='So late a transform of the cup has not come yet'),
    Mutant('only_a_robot_of_this_second', breaks='robot-now', old='point = PointStamped(header=found.header)', new="""
        if self.get_clock().now() - Time.from_msg(found.header.stamp) > Duration(seconds=1.0):
            return None
        point = PointStamped(header=found.header)
        """, expect='take the newest transform there is, however old it is', also='far'),
]
