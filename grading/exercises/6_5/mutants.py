from grading.variants import Mutant

LIFE = 'test_life'
ALL = ('rate', 'place', 'newest', 'old', 'again', 'no-wait')
LOOKUP = '(self.me, self.leader, Time())'
TIMER = 'self.create_timer(0.1, self.tick)'

MUTANTS = [
    Mutant('one_more_when_old', breaks='rate', old='''
        if age <= Duration(seconds=0.5):
            command = chase(found.transform.translation.x, found.transform.translation.y)
        ''', new='''
        if age <= Duration(seconds=0.5):
            command = chase(found.transform.translation.x, found.transform.translation.y)
        else:
            self.motor.publish(Twist())
        ''', expect='and no others'),
    Mutant('two_trees', breaks='unknown', also=ALL, old='except TransformException:',
           new='except (tf2_ros.LookupException, tf2_ros.ExtrapolationException):', imports='import tf2_ros',
           expect='ConnectivityException'),
    Mutant('asks_for_now', breaks='newest', also=ALL + ('unknown',), old='(self.me, self.leader, Time())',
           new='(self.me, self.leader, self.get_clock().now())', expect='ask for the newest'),
    Mutant('blind', breaks='old', old='''
        if age <= Duration(seconds=0.5):
            command = chase(found.transform.translation.x, found.transform.translation.y)
        ''', new='command = chase(found.transform.translation.x, found.transform.translation.y)',
           expect='gives the newest transform, however old it is'),
    Mutant('does_not_catch', breaks='unknown', also=ALL, old='''
        try:
            found = self.buffer.lookup_transform(self.me, self.leader, Time())
            age = self.get_clock().now() - Time.from_msg(found.header.stamp)
            if age <= Duration(seconds=0.5):
                command = chase(found.transform.translation.x, found.transform.translation.y)
        except TransformException:
            pass
        ''', new='''
        found = self.buffer.lookup_transform(self.me, self.leader, Time())
        age = self.get_clock().now() - Time.from_msg(found.header.stamp)
        if age <= Duration(seconds=0.5):
            command = chase(found.transform.translation.x, found.transform.translation.y)
        ''', expect='LookupException'),
    Mutant('in_the_world', breaks='place', also=('unknown', 'old'), old='.lookup_transform(self.me, self',
           new=".lookup_transform('world', self", expect='where the leader is in the world'),
    Mutant('names_of_the_lesson', breaks='topic', old="super().__init__('follower')", new='''
        super().__init__('follower')
        leader, me = 'turtle1', 'turtle2'
        ''', expect='has no publisher on'),
    Mutant('silent', breaks='unknown', also='no-wait', old='pass', new='return',
           expect='Then, too, publish a Twist of zeros'),
    Mutant('silent_when_old', breaks='old', edits=(('me = leader, me', 'me, self.stood = leader, me, False'),
            ('if age <= Duration(seconds=0.5):', '''
            if age > Duration(seconds=0.5):
                if self.stood:
                    return
                self.stood = True
            else:
                self.stood = False
            ''')), expect='Publish zeros: a robot goes on with its last command'),
    Mutant('swapped', breaks='place', old='me, self.leader', new='leader, self.me',
           expect='target and source are swapped'),
    Mutant('too_strict', breaks='old', old='(seconds=0.5):', new='(seconds=0.15):', expect='good enough'),
    Mutant('waits', breaks='unknown', also=('no-wait', 'rate'), old='(self.me, self.leader, Time())',
           new='(self.me, self.leader, Time(), Duration(seconds=1))', expect='do not wait for a transform'),
    Mutant('asks_for_earlier', breaks='newest', also=ALL + ('unknown',), old=LOOKUP,
           new='(self.me, self.leader, self.get_clock().now() - Duration(seconds=0.5))', expect='sk for the newest'),
    Mutant('awaits', breaks='unknown', also=ALL, edits=(('def tick', 'async def tick'),
           ('self.buffer.lookup_transform(self.me, self.leader, Time())',
            'await self.buffer.lookup_transform_async(self.me, self.leader, Time())')),
           expect='Then, too, publish a Twist of zeros'),
    Mutant('no_name', breaks='topic', old="f'{me}/cmd_vel'", new="'cmd_vel'", expect='has no publisher on'),
    Mutant('drives_the_leader', breaks='topic', old="f'{me}/cmd_vel'", new="f'{leader}/cmd_vel'",
           expect='has no publisher on'),
    Mutant('gives_up', breaks='again', also='old', old='if age <= Duration(seconds=0.5):', new="""
        self.lost = getattr(self, 'lost', False) or age > Duration(seconds=0.5)
        if not self.lost:
        """, expect='the follower still stands'),
    Mutant('half_the_rate', breaks='rate', also=('no-wait', 'old'), old=TIMER, new='self.create_timer(0.2, self.tick)',
           expect='expected one every 0.1 s'),
    Mutant('other_name', breaks='name', old="__init__('follower')", new="__init__('chaser')",
           expect='Your node is called'),
    Mutant('seconds_only', breaks='old', old='if age <= Duration(seconds=0.5):',
           new='if self.get_clock().now().to_msg().sec - found.header.stamp.sec <= 0.5:',
           expect='count the nanoseconds, too'),
    Mutant('second_is_enough', breaks='old', old='(seconds=0.5):', new='(seconds=0.7):',
           expect='and the command drives'),
    Mutant('age_of_the_leader', breaks='old', old='age = self.get_clock().now() - Time.from_msg(found.header.stamp)',
           new="""
        seen = self.buffer.lookup_transform('world', self.leader, Time())
        age = self.get_clock().now() - Time.from_msg(seen.header.stamp)
        """, expect='the transform of the follower'),
    Mutant('waits_a_little', breaks='no-wait', also=('unknown', 'rate'), old=LOOKUP,
           new='(self.me, self.leader, Time(), Duration(seconds=0.05))', expect='It must not wait'),
    Mutant('depth_of_one', old="cmd_vel', 10)", new="cmd_vel', 1)", expect='has the depth 1, expected 10', breaks='topic'),
    Mutant('always_to_the_left', old='found.transform.translation.y)', new='abs(found.transform.translation.y))',
           expect='chase says something else', breaks='place'),
    Mutant('half_a_second_is_too_old', old='age <= Duration', new='age < Duration', expect='0.5 s is not',
           breaks='old'),
    Mutant('names_of_the_class', breaks='place', edits=(
           ('self.leader, self.me = leader, me', 'Follower.leader, Follower.me = leader, me'),),
           expect='belong to the object (self)'),
    Mutant('newer_than_the_clock_is_old', breaks='old', old='age <= Duration(seconds=0.5)',
           new='abs(age.nanoseconds) <= 5 * 10**8', expect='later than the time of the clock'),
    Mutant('stops_twice', breaks='rate', old='self.motor.publish(command)', new="""
        self.motor.publish(command)
        if command == Twist():
            self.motor.publish(command)
        """, expect='one after the other', also=('no-wait', 'unknown')),
    Mutant('no_common_time', old='except TransformException:', new='except (LookupException, ConnectivityException):',
           imports='from tf2_ros import ConnectivityException, LookupException', breaks='unknown',
           expect='ExtrapolationException'),
    Mutant('way_in_space', breaks='place', expect='for the way in space',
           old='command = chase(found.transform.translation.x, found.transform.translation.y)', new="""
           place = found.transform.translation
           share = math.hypot(place.x, place.y, place.z) / max(1e-9, math.hypot(place.x, place.y))
           command = chase(place.x * share, place.y * share)
           """),
    Mutant('lost_once_is_lost', breaks='again', edits=(
           ('age = self.get_clock().now() - Time.from_msg(found.header.stamp)', """
            self.known = True
            age = self.get_clock().now() - Time.from_msg(found.header.stamp)
            """), ('pass', "self.lost = getattr(self, 'known', False)"),
           ('if age <= Duration', "if not getattr(self, 'lost', False) and age <= Duration")),
           expect='The transforms have come again, and the follower still stands'),
    Mutant('goes_on_with_the_last', breaks='unknown', edits=(
           ('pass', "command = getattr(self, 'last', command)"),
           ('self.motor.publish(command)', """
            self.last = command
            self.motor.publish(command)
            """)), expect='A command drives all the same'),
    Mutant('stops_saying_zeros_when_unknown', breaks='unknown', edits=(('pass', 'self.misses += 1'),
           ('age = self.get_clock()', 'self.misses, age = 0, self.get_clock()'),
           ('self.motor.publish(command)', 'self.misses > 80 or self.motor.publish(command)'),
           ('self.leader, self.me = leader, me', 'self.leader, self.me, self.misses = leader, me, 0')),
           expect='however long it takes'),
    Mutant('stops_saying_zeros_when_old', breaks='old', edits=(('pass', 'self.missed = 0'), (
           'age = self.get_clock().now() - Time.from_msg(found.header.stamp)', """
            age = self.get_clock().now() - Time.from_msg(found.header.stamp)
            self.missed = 0 if age <= Duration(seconds=0.5) else self.missed + 1
            """), ('self.motor.publish(command)', 'self.missed > 80 or self.motor.publish(command)'),
           ('self.leader, self.me = leader, me', 'self.leader, self.me, self.missed = leader, me, 0')),
           expect='however long it takes'),
    Mutant('zeros_in_the_constructor', breaks='rate', old='self.create_timer(0.1, self.tick)', new="""
        self.create_timer(0.1, self.tick)
        self.motor.publish(Twist())
        """, expect='went out in the constructor'),
    Mutant('lost_from_8_m_on', breaks='place', old='if age <= Duration(seconds=0.5):',
           new='if age <= Duration(seconds=0.5) and found.transform.translation.x < 8:', expect='and chase says'),
    Mutant('hardly_turns_is_not_at_all', breaks='place', old='command = chase(found.transform.translation.x, found.transform.translation.y)', new="""
           command = chase(found.transform.translation.x, found.transform.translation.y)
           if abs(command.angular.z) < 0.05:
               command.angular.z = 0.0
           """, expect='and chase says'),
    Mutant('hardly_drives_is_not_at_all', breaks='place', old='command = chase(found.transform.translation.x, found.transform.translation.y)', new="""
           command = chase(found.transform.translation.x, found.transform.translation.y)
           if command.linear.x < 0.03:
               command.linear.x = 0.0
           """, expect='and chase says'),
    Mutant('publisher_of_the_class', breaks='topic', old='self.motor = self.create_publisher(', expect='and before it was made',
           new='Follower.motor = self.create_publisher('),
]
