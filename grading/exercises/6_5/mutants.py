from grading.variants import Mutant

LIFE = 'test_life'
ALL = ('rate', 'place', 'newest', 'old', 'again', 'no-wait')
LOOKUP = '(self.me, self.leader, Time())'
TIMER = 'self.create_timer(0.1, self.tick)'

MUTANTS = [
    Mutant('asks_for_now', breaks='newest', also=ALL + ('unknown',), seen_by=LIFE, old='(self.me, self.leader, Time())',
           new='(self.me, self.leader, self.get_clock().now())', expect='ask for the newest',
           rejected_by='test_command'),
    Mutant('blind', breaks='old', seen_by=LIFE, old='''
        if age <= Duration(seconds=0.5):
            command = chase(found.transform.translation.x, found.transform.translation.y)
        ''', new='command = chase(found.transform.translation.x, found.transform.translation.y)',
           expect='gives the newest transform, however old it is', rejected_by='test_silence'),
    Mutant('does_not_catch', breaks='unknown', also=ALL, seen_by=LIFE, old='''
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
        ''', expect='LookupException', rejected_by='test_unknown'),
    Mutant('in_the_world', breaks='place', also=('unknown', 'old'), seen_by=LIFE,
           old='.lookup_transform(self.me, self', new=".lookup_transform('world', self",
           expect='where the leader is in the world', rejected_by='test_command'),
    Mutant('names_of_the_lesson', breaks='topic', seen_by=LIFE, old="super().__init__('follower')", new='''
        super().__init__('follower')
        leader, me = 'turtle1', 'turtle2'
        ''', expect='has no publisher on', rejected_by='test_command'),
    Mutant('silent', breaks='unknown', also='no-wait', seen_by=LIFE,
           old='pass', new='return', expect='Then, too, publish a Twist of zeros',
           rejected_by='test_unknown'),
    Mutant('silent_when_old', breaks='old', seen_by=LIFE,
           edits=(('me = leader, me', 'me, self.stood = leader, me, False'),
            ('if age <= Duration(seconds=0.5):', '''
            if age > Duration(seconds=0.5):
                if self.stood:
                    return
                self.stood = True
            else:
                self.stood = False
            ''')), expect='Publish zeros: a robot goes on with its last command', rejected_by='test_silence'),
    Mutant('swapped', breaks='place', seen_by=LIFE,
           old='me, self.leader', new='leader, self.me', expect='target and source are swapped',
           rejected_by='test_command'),
    Mutant('too_strict', breaks='old', seen_by=LIFE, old='(seconds=0.5):', new='(seconds=0.15):', expect='good enough',
           rejected_by='test_follow'),
    Mutant('waits', breaks='unknown', also=('no-wait', 'rate'), seen_by=LIFE,
           old='(self.me, self.leader, Time())', new='(self.me, self.leader, Time(), Duration(seconds=1))',
           expect='do not wait for a transform', rejected_by='test_unknown'),
    Mutant('asks_for_earlier', breaks='newest', also=ALL + ('unknown',), seen_by=LIFE, old=LOOKUP,
           new='(self.me, self.leader, self.get_clock().now() - Duration(seconds=0.5))',
           expect='sk for the newest', rejected_by='test_command'),
    Mutant('awaits', breaks='unknown', also=ALL, seen_by=LIFE, edits=(('def tick', 'async def tick'),
           ('self.buffer.lookup_transform(self.me, self.leader, Time())',
            'await self.buffer.lookup_transform_async(self.me, self.leader, Time())')),
           expect='Then, too, publish a Twist of zeros', rejected_by='test_unknown'),
    Mutant('no_name', breaks='topic', seen_by=LIFE, old="f'{me}/cmd_vel'", new="'cmd_vel'",
           expect='has no publisher on', rejected_by='test_command'),
    Mutant('drives_the_leader', breaks='topic', seen_by=LIFE, old="f'{me}/cmd_vel'", new="f'{leader}/cmd_vel'",
           expect='has no publisher on', rejected_by='test_command'),
    Mutant('gives_up', breaks='again', also='old', seen_by=LIFE, old='if age <= Duration(seconds=0.5):', new="""
        self.lost = getattr(self, 'lost', False) or age > Duration(seconds=0.5)
        if not self.lost:
        """, expect='the follower still stands', rejected_by='test_silence'),
    Mutant('half_the_rate', breaks='rate', also=('no-wait', 'old'), seen_by=LIFE,
           old=TIMER, new='self.create_timer(0.2, self.tick)',
           expect='expected one every 0.1 s', rejected_by='test_command'),
    Mutant('other_name', breaks='name', seen_by=LIFE, old="__init__('follower')", new="__init__('chaser')",
           expect='Your node is called', rejected_by='test_command'),
    Mutant('seconds_only', breaks='old', seen_by=LIFE, old='if age <= Duration(seconds=0.5):',
           new='if self.get_clock().now().to_msg().sec - found.header.stamp.sec <= 0.5:',
           expect='Count the nanoseconds, too', rejected_by='test_age'),
    Mutant('second_is_enough', breaks='old', seen_by=LIFE, old='(seconds=0.5):', new='(seconds=0.7):',
           expect='and the command drives', rejected_by='test_age'),
    Mutant('age_of_the_leader', breaks='old', seen_by=LIFE,
           old='age = self.get_clock().now() - Time.from_msg(found.header.stamp)',
           new="""
        seen = self.buffer.lookup_transform('world', self.leader, Time())
        age = self.get_clock().now() - Time.from_msg(seen.header.stamp)
        """, expect='the transform of the follower', rejected_by='test_age'),
    Mutant('waits_a_little', breaks='no-wait', also=('unknown', 'rate'), seen_by=LIFE, old=LOOKUP,
           new='(self.me, self.leader, Time(), Duration(seconds=0.05))', expect='It must not wait',
           rejected_by='test_unknown'),
]
