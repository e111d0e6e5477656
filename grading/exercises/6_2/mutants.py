from grading.variants import Mutant

MUTANTS = [
    Mutant('falls_silent', breaks='rate', edits=(
           ('self.radius, self.period = radius, period', 'self.radius, self.period, self.calls = radius, period, 0'),
           ('self.broadcaster.sendTransform(message)', '''
            self.calls += 1
            if self.calls <= 100:
                self.broadcaster.sendTransform(message)
            ''')), expect='0 transforms came'),
    Mutant('first_one_at_once', breaks='rate', old='self.create_timer(0.05, self.tick)', new='''
        self.create_timer(0.05, self.tick)
        self.tick()
        ''', expect='went out in the constructor'),
    Mutant('seconds_of_seven_digits', breaks='time', also='face', old='(now.nanoseconds / 1e9)',
           new="float(np.float32(now.nanoseconds / 1e9))", imports='import numpy as np', expect='the moon is at'),
    Mutant('stamp_of_milliseconds', breaks='stamp', old='message.header.stamp = now.to_msg()', new='''
           message.header.stamp = Time(nanoseconds=now.nanoseconds // 1_000_000 * 1_000_000).to_msg()
           ''', expect='the stamp is'),
    Mutant('adds_up_the_period', breaks='time', also='face', edits=(
           ('period = radius, period', 'period, self.seconds = radius, period, None'),
           ('angle = 2 * math.pi * (now.nanoseconds / 1e9) / self.period', '''
            begin = now.nanoseconds / 1e9 if self.seconds is None else self.seconds
            self.seconds = begin if self.seconds is None else begin + 0.05
            angle = 2 * math.pi * self.seconds / self.period
            ''')), expect='some calls were left out'),
    Mutant('w_is_never_negative', breaks='face', old='message.header.stamp = now.to_msg()', new='''
           message.header.stamp = now.to_msg()
           z = math.sin((angle + math.pi) / 2)
           message.transform.rotation = Quaternion(z=z, w=math.sqrt(max(0.0, 1 - z * z)))
           ''', expect='expected to the planet'),
    Mutant('angle_as_quaternion', breaks='face', old="message = transform('planet', 'moon', x=x, y=y, yaw=angle + math.pi)", new='''
        message = transform('planet', 'moon', x=x, y=y)
        message.transform.rotation = Quaternion(z=angle + math.pi, w=1.0)
        ''', expect='An angle is not a part of a quaternion'),
    Mutant('clock_of_the_wall', breaks='stamp', edits=(('def tick(self):', '''
            def tick(self):
                from rclpy.clock import Clock
            '''),
            ('= now.to_msg', '= Clock().now().to_msg')), expect='the time of the wall'),
    Mutant('clockwise', breaks='circle', also='face', old='self.radius * math.sin(angle)', new='self.radius * -math.sin(angle)',
           expect='It goes round to the right'),
    Mutant('counts_ticks', breaks='time', also='face', edits=(('period = radius, period', 'period, self.ticks = radius, period, 0'),
            ('''
            now = self.get_clock().now()
            angle = 2 * math.pi * (now.nanoseconds / 1e9) / self.period
            ''', '''
            self.ticks += 1
            now = self.get_clock().now()
            angle = 2 * math.pi * (0.05 * self.ticks) / self.period
            ''')), expect='It started on the x axis when the node was made'),
    Mutant('degrees', breaks='face', old='angle + math.pi', new='math.degrees(angle) + 180', expect='in degrees'),
    Mutant('never_turns', breaks='face', old='y, yaw=angle + math.pi)', new='y)', expect='It never turns.'),
    Mutant('no_stamp', breaks='stamp', old='message.header.stamp = now.to_msg()', new='', expect='it was not filled in'),
    Mutant('period_is_a_rate', breaks='rate', old='(0.05, self', new='(0.2, self', expect='transforms came in'),
    Mutant('static', breaks='frames', old='TransformBroadcaster', new='StaticTransformBroadcaster',
           expect='Transforms came on /tf_static.'),
    Mutant('swapped', breaks='frames', old="planet', 'moon", new="moon', 'planet", expect='Parent and child are swapped'),
    Mutant('another_name', breaks='name', old="super().__init__('moon')", new="super().__init__('planet')",
           expect='expected /moon'),
    Mutant('radius_of_the_example', breaks='circle', old='self.radius, self.period = radius,',
           new='self.radius, self.period = 3.0,', expect='m from the planet'),
    Mutant('period_of_the_example', breaks='time', old='= radius, period', new='= radius, 8.0', expect='the moon is at'),
    Mutant('looks_away', breaks='face', old='angle + math.pi', new='angle', expect='half a turn is missing'),
    Mutant('whole_seconds', breaks='time', old='(now.nanoseconds / 1e9)', new='now.seconds_nanoseconds()[0]',
           expect='the moon is at'),
    Mutant('stamp_of_the_start', breaks='stamp', edits=(("super().__init__('moon')", '''
           super().__init__('moon')
           self.begin = self.get_clock().now()
           '''), ('= now.to_msg()', '= self.begin.to_msg()')), expect='the stamp is'),
    Mutant('one_turn_only', old='(now.nanoseconds / 1e9) / self.period',
           new='min(now.nanoseconds / 1e9, self.period) / self.period', expect='expected', breaks='time', also='circle'),
    Mutant('stamps_are_counted', old='message.header.stamp = now.to_msg()', new="""
           self.stamp = self.stamp + Duration(seconds=0.05) if hasattr(self, 'stamp') else now
           message.header.stamp = self.stamp.to_msg()
           """, expect='the stamp is', breaks='stamp'),
    Mutant('a_metre_at_least', breaks='circle', old='self.radius, self.period = radius,',
           new='self.radius, self.period = max(radius, 1.0),', expect='m from the planet'),
    Mutant('two_seconds_at_least', breaks='time', also='face', old='= radius, period', new='= radius, max(period, 2.0)',
           expect='the moon is at'),
    Mutant('a_second_at_least', breaks='time', also='face', old='= radius, period', new='= radius, max(period, 1.0)',
           expect='the moon is at'),
    Mutant('a_minute_at_most', breaks='time', old='= radius, period', new='= radius, min(period, 60.0)',
           expect='the second one is at'),
    Mutant('a_second_look_for_the_stamp', breaks='stamp', old='= now.to_msg()', new='= self.get_clock().now().to_msg()',
           expect='Ask the clock once in each callback'),
    Mutant('a_second_look_for_the_turn', breaks='face', edits=(("message = transform('planet', 'moon', x=x, y=y, yaw=angle + math.pi)", """
           later = 2 * math.pi * (self.get_clock().now().nanoseconds / 1e9) / self.period
           message = transform('planet', 'moon', x=x, y=y, yaw=later + math.pi)
           """),), expect='and the moon is turned as at another one'),
    Mutant('period_in_the_class', breaks='time', old='self.radius, self.period = radius, period',
           new='self.radius, Moon.period = radius, period', expect='the first one is at'),
]
