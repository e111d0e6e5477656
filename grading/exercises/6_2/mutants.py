from grading.variants import Mutant

MUTANTS = [
    Mutant('angle_as_quaternion', old="message = transform('planet', 'moon', x=x, y=y, yaw=angle + math.pi)", new='''
        message = transform('planet', 'moon', x=x, y=y)
        message.transform.rotation = Quaternion(z=angle + math.pi, w=1.0)
        ''', expect='An angle is not a part of a quaternion'),
    Mutant('clock_of_the_wall', edits=(('def tick(self):', '''
            def tick(self):
                from rclpy.clock import Clock
            '''),
            ('= now.to_msg', '= Clock().now().to_msg')), expect='the time of the wall'),
    Mutant('clockwise', old='self.radius * math.sin(angle)', new='self.radius * -math.sin(angle)',
           expect='It goes round to the right'),
    Mutant('counts_ticks', edits=(('period = radius, period', 'period, self.ticks = radius, period, 0'),
            ('''
            now = self.get_clock().now()
            angle = 2 * math.pi * (now.nanoseconds / 1e9) / self.period
            ''', '''
            self.ticks += 1
            now = self.get_clock().now()
            angle = 2 * math.pi * (0.05 * self.ticks) / self.period
            ''')), expect='It started on the x axis when the node was made'),
    Mutant('degrees', old='angle + math.pi', new='math.degrees(angle) + 180', expect='in degrees'),
    Mutant('never_turns', old='y, yaw=angle + math.pi)', new='y)', expect='It never turns.'),
    Mutant('no_stamp', old='message.header.stamp = now.to_msg()', new='', expect='it was not filled in'),
    Mutant('period_is_a_rate', old='(0.05, self', new='(0.2, self', expect='transforms came in 3 s, expected 60'),
    Mutant('static', old='TransformBroadcaster', new='StaticTransformBroadcaster',
           expect='Transforms came on /tf_static.'),
    Mutant('swapped', old="planet', 'moon", new="moon', 'planet", expect='Parent and child are swapped'),
]
