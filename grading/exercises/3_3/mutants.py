from grading.variants import Mutant

RESET = '''
        def on_reset(self, msg):
            self.seconds = 0
        '''

MUTANTS = [
    Mutant('asks_the_clock_again_and_again', breaks='no-wait', old='self.seconds += 1', new='''
        end = time.monotonic() + 0.01
        while time.monotonic() < end:
            pass
        self.seconds += 1
        ''', imports='import time', expect='The timers do the waiting'),
    Mutant('counts_in_callback', breaks='no-wait', old='self.lit = not self.lit', new='''
        for _ in range(1_000_000):
            pass
        self.lit = not self.lit
        ''', expect='A callback sleeps, or waits in a loop'),
    Mutant('counts_in_constructor', breaks='no-wait', old='self.lit = False', new='''
        for _ in range(10_000_000):
            pass
        self.lit = False
        ''', expect='The constructor waits in a loop'),
    Mutant('waits_for_an_event', breaks='no-wait', old='self.seconds += 1', new='''
        threading.Event().wait(0.01)
        self.seconds += 1
        ''', imports='import threading', expect='The timers do the waiting'),
    Mutant('own_namespace', breaks='topics', old="super().__init__('heartbeat')",
           new="super().__init__('heartbeat', namespace='robot')", expect="gives itself the namespace 'robot'"),
    Mutant('absolute_reset', old="'reset'", new="'/reset'", expect='a relative name has no leading slash',
           breaks='topics', also='reset'),
    Mutant('best_effort_led', old="(Bool, 'led', 10)", new="(Bool, 'led', qos_profile_sensor_data)",
           imports='from rclpy.qos import qos_profile_sensor_data', expect='BEST_EFFORT', breaks='qos'),
    Mutant('counts_from_zero', old='''
        def on_second(self):
            self.seconds += 1
            self.uptime.publish(Int32(data=self.seconds))
        ''', new='''
        def on_second(self):
            self.uptime.publish(Int32(data=self.seconds))
            self.seconds += 1
        ''', expect='The uptimes of the first', breaks='uptime', also=('reset',)),
    Mutant('depth_1', old="'reset', self.on_reset, 10)", new="'reset', self.on_reset, 1)",
           expect='has the depth 1, expected 10', breaks='qos'),
    Mutant('first_reset_only', old=RESET, new='''
        def on_reset(self, msg):
            if not hasattr(self, 'was_reset'):
                self.seconds = 0
            self.was_reset = True
        ''', expect='the next one must be 1', breaks='reset'),
    Mutant('led_begins_off', old='self.lit = False', new='self.lit = True', expect='begins with True', breaks='led'),
    Mutant('led_every_half_second', old='self.create_timer(0.25, self', new='self.create_timer(0.5, self',
           expect='Every 0.25 s gives', breaks='led-rate', also=('led', 'own-state')),
    Mutant('led_in_class', edits=(('self.lit = False', 'Heartbeat.lit = False'),
                                  ('self.lit = not self.lit', 'Heartbeat.lit = not Heartbeat.lit')),
           expect='share state', breaks='own-state'),
    Mutant('led_stays_on', old='self.lit = not self.lit', new='self.lit = True', expect='it must change with every',
           breaks='led', also=('reset-only', 'own-state')),
    Mutant('resets_all', breaks='own-state', old='self.lit = False', new='''
        self.lit = False
        self.everyone.append(self)
        ''', edits=((RESET, '''
        everyone = []

        def on_reset(self, msg):
            for heartbeat in self.everyone:
                heartbeat.seconds = 0
        '''),), expect='the first one heard a reset'),
    Mutant('no_reset', old=RESET, new='''
        def on_reset(self, msg):
            pass
        ''', expect='changes nothing', breaks='reset'),
    Mutant('other_name', old="super().__init__('heartbeat')", new="super().__init__('Heartbeat')",
           expect="expected 'heartbeat'", breaks='node'),
    Mutant('reset_by_local_name', old=RESET, new='''
        def on_reset(self, msg):
            seconds = 0
        ''', expect='changes nothing', breaks='reset'),
    Mutant('reset_makes_a_new_timer', edits=(('self.create_timer(1', 'self.timer = self.create_timer(1'),
            ('def on_reset(self, msg):', '''
            def on_reset(self, msg):
                self.destroy_timer(self.timer)
                self.timer = self.create_timer(1.0, self.on_second)
            ''')), expect='must not restart or stop a timer', breaks='reset-only'),
    Mutant('reset_publishes', old=RESET, new='''
        def on_reset(self, msg):
            self.seconds = 0
            self.uptime.publish(Int32(data=0))
        ''', expect='The reset itself published', breaks='reset-only', also=('reset',)),
    Mutant('reset_restarts_both', edits=(('self.create_timer(1', 'self.timer = self.create_timer(1'),
            ('self.create_timer(0.25', 'self.blink = self.create_timer(0.25'),
            ('def on_reset(self, msg):', '''
            def on_reset(self, msg):
                self.timer.reset()
                self.blink.reset()
            ''')), expect='must not restart or stop a timer', breaks='reset-only'),
    Mutant('reset_restarts_led_timer', edits=(('self.create_timer(0.25', 'self.blink = self.create_timer(0.25'),
            ('def on_reset(self, msg):', '''
            def on_reset(self, msg):
                self.blink.reset()
            ''')), expect='its timer must go on', breaks='reset-only'),
    Mutant('reset_restarts_timer', edits=(('self.create_timer(1', 'self.timer = self.create_timer(1'),
            ('def on_reset(self, msg):', '''
            def on_reset(self, msg):
                self.timer.reset()
            ''')), expect='must not restart or stop a timer', breaks='reset-only'),
    Mutant('reset_to_one', old=RESET, new='''
        def on_reset(self, msg):
            self.seconds = 1
        ''', expect='the next one must be 1', breaks='reset'),
    Mutant('reset_touches_led', old='def on_reset(self, msg):', new='''
        def on_reset(self, msg):
            self.lit = not self.lit
        ''', expect='the reset must not touch it', breaks='reset-only'),
    Mutant('reset_turns_led_off', old='def on_reset(self, msg):', new='''
        def on_reset(self, msg):
            self.lit = False
        ''', expect='the reset must not touch it', breaks='reset-only'),
    Mutant('seconds_in_led_callback', edits=(('self.create_timer(1.0, self.on_second)', ''),
            ('self.led.publish(Bool(data=self.lit))', '''
            self.led.publish(Bool(data=self.lit))
            self.calls = getattr(self, 'calls', 0) + 1
            if self.calls % 5 == 0:
                self.on_second()
            ''')), expect='The uptimes came at', breaks='uptime-rate', also=('reset-only', 'own-state')),
    Mutant('sleeps_in_callback', old='self.lit = not self.lit', new='''
        self.lit = not self.lit
        time.sleep(0.01)
        ''', imports='import time', expect='A callback sleeps', breaks='no-wait'),
    Mutant('sleeps_in_loop', edits=(('self.create_timer(0.25, self.on_blink)', ''),
            ('def on_second(self):', '''
            def on_second(self):
                for _ in range(4):
                    time.sleep(0.02)
                    self.on_blink()
            ''')), imports='import time', expect='A callback sleeps', breaks='no-wait',
           also=('led-rate', 'own-state', 'reset-only')),
    Mutant('state_in_class', edits=(('''
            class Heartbeat(Node):
                def __init__(self):
            ''', '''
            class Heartbeat(Node):
                seconds = 0

                def __init__(self):
            '''),
            ('''
            self.lit = False
            self.seconds = 0
            ''', 'self.lit = False'),
            ('self.seconds += 1', 'Heartbeat.seconds += 1'),
            ('data=self.seconds', 'data=Heartbeat.seconds'),
            (RESET, '''
            def on_reset(self, msg):
                Heartbeat.seconds = 0
            ''')), expect='share state', breaks='own-state'),
    Mutant('uptime_in_half_seconds', old='self.create_timer(1.0', new='self.create_timer(0.5',
           expect='The uptimes came at', breaks='uptime-rate', also=('own-state', 'uptime', 'reset', 'reset-only')),
    Mutant('waits_for_ever', old='self.create_timer(1.0, self.on_second)', new='''
        while True:
            time.sleep(0.25)
            self.on_blink()
        ''', imports='import time', expect='did not return', breaks='no-wait'),
    Mutant('rounded_time', edits=(('''
            self.lit = False
            self.seconds = 0
            ''', '''
            self.lit = False
            self.start = self.get_clock().now()
            '''),
            ('''
            self.seconds += 1
            self.uptime.publish(Int32(data=self.seconds))
            ''', '''
            seconds = (self.get_clock().now() - self.start).nanoseconds / 1e9
            self.uptime.publish(Int32(data=round(seconds)))
            '''),
            (RESET, '''
            def on_reset(self, msg):
                self.start = self.get_clock().now()
            ''')), expect='the next one must be 1, then 2', breaks='reset'),
    Mutant('minute_wraps', old='Int32(data=self.seconds)', new='Int32(data=self.seconds % 60)',
           expect='also after a minute', breaks='uptime'),
    Mutant('with_a_deadline', breaks='qos', old="(Bool, 'led', 10)",
           new="(Bool, 'led', QoSProfile(depth=10, deadline=Duration(seconds=1)))",
           imports='from rclpy.duration import Duration\nfrom rclpy.qos import QoSProfile', expect='policy deadline 1 s'),
    Mutant('forty_resets', breaks='reset', old='''
        def on_reset(self, msg):
            self.seconds = 0
        ''', new='''
        def on_reset(self, msg):
            self.resets = getattr(self, 'resets', 0) + 1
            self.seconds = 0 if self.resets <= 40 else self.seconds
        ''', expect='the next one must be 1, then 2'),
    Mutant('light_by_the_clock', old='self.lit = not self.lit',
           new='self.lit = round(self.get_clock().now().nanoseconds / 250_000_000) % 2 == 1',
           expect='whenever it starts', breaks='led', also=('own-state',)),
    Mutant('one_reset_in_half_a_second', breaks='reset', old=RESET, new='''
        def on_reset(self, msg):
            now = self.get_clock().now().nanoseconds
            if now - getattr(self, 'last', 0) > 500_000_000:
                self.seconds, self.last = 0, now
        ''', expect='the next one must be 1'),
    Mutant('late_reset_lost', old=RESET, new="""
        def on_reset(self, msg):
            if self.seconds < 30:
                self.seconds = 0
        """, expect='however far it has counted', breaks='reset'),
    Mutant('counts_for_listeners_only', old='self.seconds += 1', new="""
        if not self.uptime.get_subscription_count():
            return
        self.seconds += 1
        """, expect='the seconds are counted also if nobody listens', breaks='uptime'),
    Mutant('blinks_for_listeners_only', old='self.lit = not self.lit', new="""
        if not self.led.get_subscription_count():
            return
        self.lit = not self.lit
        """, expect='also if nobody listens', breaks='led'),
]
