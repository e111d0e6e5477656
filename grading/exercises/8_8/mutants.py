from grading.variants import Mutant

AGE = 'if self.get_clock().now() - Time.from_msg(found.header.stamp) > Duration(seconds=0.5):'
RETURN = 'return place.x, place.y, math.remainder(2 * math.atan2(turn.z, turn.w), math.tau)'
ASKED = "self.buffer.lookup_transform('map', 'base_footprint', Time())"

MUTANTS = [
    Mutant('drives_backwards', old='= linear, angular', new='= -linear, angular', expect='`drive` is given',
           breaks='given'),
    Mutant('no_faster_than_1_m_s', old='= linear, angular', new='= max(-1.0, min(linear, 1.0)), angular',
           expect='`drive` is given', breaks='given'),
    Mutant('drives_without_turning', old='command.linear.x, command.angular.z = linear, angular',
           new='command.linear.x = linear', expect='`drive` is given', breaks='given'),
    Mutant('other_topic_of_the_motor', old="'cmd_vel'", new="'motor'", expect='nothing new', breaks='given'),
    Mutant('no_station_keeper', edits=(('class Courier(StationKeeper)', 'class Courier(Node)'),
           ('__init__(**options)', "__init__('delivery_robot', **options)")), expect='place', breaks='given'),
    Mutant('no_options', old='super().__init__(**options)', new='super().__init__()', expect='hands **options on',
           breaks='given'),
    Mutant('in_odom', old=".lookup_transform('map', '", new=".lookup_transform('odom', '",
           expect='In which frame did you ask', breaks='place', also=('unknown', 'old', 'again')),
    Mutant('swapped', old="map', 'base_footprint", new="base_footprint', 'map", expect='target and source are swapped',
           breaks='place', also='again'),
    Mutant('x_twice', old='place.x, place.y', new='place.x, place.x', expect='In which frame did you ask',
           breaks='place', also='again'),
    Mutant('outside_of_pi', old=RETURN, new='return place.x, place.y, 2 * math.atan2(turn.z, turn.w)',
           expect='from -π to π', breaks='yaw'),
    Mutant('z_is_no_angle', old=RETURN, new='return place.x, place.y, turn.z', expect='from -π to π', breaks='yaw',
           also=('again', 'place')),
    Mutant('half_the_angle', old='2 * math.atan2(turn.z, turn.w)', new='math.atan2(turn.z, turn.w)',
           expect='That is half of it', breaks='yaw', also='again'),
    Mutant('degrees', old=RETURN, new=RETURN.replace('math.remainder(', 'math.degrees(').replace(', math.tau)', ')'),
           expect='in degrees: the yaw is in radians', breaks='yaw', also='again'),
    Mutant('from_0_to_2_pi', old=RETURN, new='return place.x, place.y, 2 * math.atan2(turn.z, turn.w) % math.tau',
           expect='from -π to π', breaks='yaw'),
    Mutant('first_answer_for_ever', edits=(('try:', """
        if getattr(self, 'known', None):
            return self.known
        try:
        """), (RETURN, RETURN.replace('return', 'self.known =') + '\nreturn self.known\n')),
           expect='There it was before', breaks='newest', also='old'),
    Mutant('as_it_was_before', old=ASKED, new=ASKED.replace(
        'Time()', "self.get_clock().now() - Duration(seconds=0.2)"), expect='tf2 was told so', breaks='place',
           also=('old', 'newest', 'again', 'at-once')),
    Mutant('raises', old=f"""
        try:
            found = {ASKED}
        except TransformException:
            return None
        """, new=f'found = {ASKED}', expect='Exception', breaks='at-once'),
    Mutant('only_unknown_frames', old='except TransformException:', new='except LookupException:',
           imports='from tf2_ros import LookupException', expect='Exception', breaks='at-once'),
    Mutant('waits', old=ASKED, new=ASKED.replace('Time()', 'Time(), Duration(seconds=1.0)'), expect='It must not wait',
           breaks='at-once'),
    Mutant('the_origin_if_unknown', old="""
        except TransformException:
            return None
        """, new="""
        except TransformException:
            return 0.0, 0.0, 0.0
        """, expect='No transform has come', breaks='unknown', also='old'),
    Mutant('believes_old_ones', old=f"""
        {AGE}
            return None
        """, new='', expect='still says', breaks='old'),
    Mutant('five_seconds', old='seconds=0.5', new='seconds=5.0', expect='still says', breaks='old'),
    Mutant('too_strict', old='seconds=0.5', new='seconds=0.3', expect='That is good enough', breaks='old'),
    Mutant('whole_seconds', old=AGE, new='if self.get_clock().now().to_msg().sec - found.header.stamp.sec > 0.5:',
           expect='0', breaks='old', also=('place', 'again', 'newest', 'yaw')),
    Mutant('parts_of_seconds', old=AGE,
           new='if self.get_clock().now().to_msg().nanosec - found.header.stamp.nanosec > 5e8:', expect='still says',
           breaks='old', also=('again', 'place')),
    Mutant('only_the_wheels', old=AGE, new="""
        wheels = self.buffer.lookup_transform('odom', 'base_footprint', Time())
        if self.get_clock().now() - Time.from_msg(wheels.header.stamp) > Duration(seconds=0.5):
        """, expect='base_footprint in odom is new', breaks='old'),
    Mutant('only_the_localiser', old=AGE, new="""
        told = self.buffer.lookup_transform('map', 'odom', Time())
        if self.get_clock().now() - Time.from_msg(told.header.stamp) > Duration(seconds=0.5):
        """, expect='odom in map is new', breaks='old'),
    Mutant('forgets_after_a_fifth_of_a_second', old='Buffer()', new='Buffer(cache_time=Duration(seconds=0.2))',
           expect='so the place is 0.4 s old', breaks='old'),
    Mutant('each_transform_once', old=AGE, new="""
        before, self.before = getattr(self, 'before', None), found.header.stamp
        if before == found.header.stamp:
            return None
        """ + AGE, expect='asked once more', breaks='old'),
    Mutant('lost_for_ever', old=f"""
        {AGE}
            return None
        """, new=f"""
        {AGE}
            self.lost = True
        if getattr(self, 'lost', False):
            return None
        """, expect='After a pause the transforms came again', breaks='again'),
    Mutant('a_little_more', old='seconds=0.5', new='seconds=0.516', expect='compare without rounding', breaks='old'),
    Mutant('not_quite_half_a_second', old=AGE, new=AGE.replace('>', '>='), expect='Up to 0.5 s they are good',
           breaks='old'),
    Mutant('future_is_old', old=AGE,
           new='if abs((self.get_clock().now() - Time.from_msg(found.header.stamp)).nanoseconds) > 5e8:',
           expect='ahead of the clock', breaks='old'),
    Mutant('place_of_before', edits=(('''
        except TransformException:
            return None
        ''', '''
        except TransformException:
            return getattr(self, 'known', None)
        '''), (RETURN, RETURN.replace('return', 'self.known =') + '\nreturn self.known\n')),
           expect='Do not return a place of before', breaks='old'),
    Mutant('no_common_time', old='except TransformException:', new='except (LookupException, ConnectivityException):',
           imports='from tf2_ros import ConnectivityException, LookupException', expect='Exception', breaks='at-once'),
    Mutant('corrections_only_at_first', old='place, turn = found.transform.translation, found.transform.rotation', new="""
        self.first = getattr(self, 'first', None) or self.buffer.lookup_transform('map', 'odom', Time())
        there = self.buffer.lookup_transform('odom', 'base_footprint', Time()).transform
        point = Point(x=there.translation.x, y=there.translation.y)
        there = do_transform_pose(Pose(position=point, orientation=there.rotation), self.first)
        place, turn = there.position, there.orientation
        """, imports='from geometry_msgs.msg import Point, Pose\nfrom tf2_geometry_msgs import do_transform_pose',
           expect='The localiser has corrected where odom is in map', breaks='newest', also=('yaw', 'place', 'again')),
    Mutant('one_turn_to_one_side', old=RETURN, new="""
        yaw = 2 * math.atan2(turn.z, turn.w)
        return place.x, place.y, yaw + math.tau if yaw < -math.pi else yaw
        """, expect='from -π to π', breaks='yaw'),
    Mutant('zero_is_nowhere', old=RETURN, new=f"""
        if not (place.x and place.y):
            return None
        {RETURN}
        """, expect='0 is a number like any other', breaks='place'),
    Mutant('hundred_metres_at_most', breaks='place', old='return place.x, place.y',
           new='return max(-100.0, min(100.0, place.x)), place.y', expect='and where() is'),
    Mutant('buffer_of_the_class', breaks='unknown', old='self.buffer = Buffer()', new="""
        if 'buffer' not in Courier.__dict__:
            Courier.buffer = Buffer()
        """, expect='Another one, to which nobody speaks, says'),
    Mutant('one_listener_for_all', breaks='place', old='self.listener = TransformListener(self.buffer, self)', new="""
        if 'listener' not in Courier.__dict__:
            Courier.listener = TransformListener(self.buffer, self)
        """, expect='belong to the object (self)'),
    Mutant('asked_once_a_moment', breaks='newest', old='def where(self):', new="""
        def where(self):
            now = self.get_clock().now()
            if getattr(self, 'asked', None) != now:
                self.asked, self.said = now, self.ask()
            return self.said

        def ask(self):
        """, expect='That is the answer of before'),
    Mutant('asked_ten_times_a_second', breaks='newest', also='old', old='def where(self):', new="""
        def where(self):
            now = self.get_clock().now()
            if not hasattr(self, 'asked') or now - self.asked > Duration(seconds=0.09):
                self.asked, self.said = now, self.ask()
            return self.said

        def ask(self):
        """, expect='That is the answer of before'),
    Mutant('says_that_it_is_lost', breaks='given', old="""
        except TransformException:
            return None
        """, new="""
        except TransformException:
            self.state = 'lost'
            return None
        """, expect='where() says where the robot is, and changes nothing'),
    Mutant('a_state_of_its_own', breaks='given', old='self.buffer = Buffer()',
           new="self.buffer, self.state = Buffer(), 'waiting'", expect="self.state is 'waiting'"),
    Mutant('waits_for_a_newer_one', breaks='at-once', old=AGE, new=f"""
        {AGE}
            time.sleep(0.1)
        {AGE}
        """, imports='import time', expect='While the place is too old, where() takes'),
    Mutant('waits_in_any_case', breaks='at-once', old=RETURN, new=f"""
        time.sleep(0.1)
        {RETURN}
        """, imports='import time', expect='While the place is known, where() takes'),
    Mutant('stands_when_it_is_asked', breaks='given', old='def where(self):', new="""
        def where(self):
            self.drive(0.0, 0.0)
        """, expect='and a command came on /cmd_vel'),
    Mutant('stricter_once_it_was_lost', breaks='again', old=f"""
        {AGE}
            return None
        """, new="""
        limit = 0.2 if getattr(self, 'lost', False) else 0.5
        self.lost = self.get_clock().now() - Time.from_msg(found.header.stamp) > Duration(seconds=limit)
        if self.lost:
            return None
        """, expect='whatever was before'),
]
