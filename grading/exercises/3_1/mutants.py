from grading.variants import Mutant

TEXT = "String(data=f'alive {self.count}')"

MUTANTS = [
    Mutant('absolute_topic', old=", 'beacon',", new=", '/beacon',", expect='a relative name has no leading slash',
           breaks='topic'),
    Mutant('all_at_once', old='self.timer = self.create_timer(0.25, self.on_timer)', new='''
        for _ in range(8):
            self.on_timer()
        ''', expect='timer', breaks='rate', also=('first', 'own-count')),  # on a busy machine all of it is heard
    Mutant('at_most_eight', old='def on_timer(self):', new='''
        def on_timer(self):
            if self.count == 8:
                return
        ''', expect='at 4 Hz there are', breaks='rate', also=('own-count', 'texts')),
    Mutant('best_effort', old="(String, 'beacon', 10)", new="(String, 'beacon', qos_profile_sensor_data)",
           imports='from rclpy.qos import qos_profile_sensor_data', expect='BEST_EFFORT', breaks='qos'),
    Mutant('capital_letter', old="f'alive", new="f'Alive", expect="is 'Alive 1', expected 'alive 1'", breaks='texts'),
    Mutant('counter_in_class', source='''
class Beacon(Node):
    count = 0

    def __init__(self):
        super().__init__('beacon')
        self.publisher = self.create_publisher(String, 'beacon', 10)
        self.timer = self.create_timer(0.25, self.on_timer)

    def on_timer(self):
        Beacon.count += 1
        self.publisher.publish(String(data=f'alive {Beacon.count}'))
''', expect='share one counter', breaks='own-count'),
    Mutant('counts_from_zero',
           edits=(('self.count += 1', "self.publisher.publish(String(data=f'alive {self.count}'))"),
                  ("self.publisher.publish(String(data=f'alive {self.count}'))", 'self.count += 1')),
           expect='the count must begin at 1', breaks='texts'),
    Mutant('deeper', old="'beacon', 10)", new="'beacon', 100)", expect='has the depth 100, expected 10', breaks='qos'),
    Mutant('depth_1', old="'beacon', 10)", new="'beacon', 1)", expect='has the depth 1, expected 10', breaks='qos'),
    Mutant('every_constructor_starts_anew', edits=(('self.count = 0', 'Beacon.count = 0'),
                                                   ('self.count += 1', 'Beacon.count += 1')),
           expect='A second beacon in the same program begins with', breaks='own-count'),
    Mutant('greets_in_constructor', old="self.publisher = self.create_publisher(String, 'beacon', 10)", new='''
        self.publisher = self.create_publisher(String, 'beacon', 10)
        self.publisher.publish(String(data='alive 1'))
        ''', expect='publishes', breaks='first'),
    Mutant('half_a_second', old='.create_timer(0.25, self', new='.create_timer(0.5, self', expect='at 4 Hz there are',
           breaks='rate', also=('own-count',)),
    Mutant('latched', old="(String, 'beacon', 10)",
           new="(String, 'beacon', QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL))",
           imports='from rclpy.qos import DurabilityPolicy, QoSProfile', expect='TRANSIENT_LOCAL', breaks='qos'),
    Mutant('name_with_a_capital', old="super().__init__('beacon')", new="super().__init__('Beacon')",
           expect="the name 'Beacon', expected 'beacon'", breaks='node'),
    Mutant('never_counts', edits=(('self.count = 0', 'self.count = 1'), ('self.count += 1', '')),
           expect='The text never changes', breaks='texts', also=('own-count',)),
    Mutant('no_number', old=TEXT, new="String(data='alive')", expect="'alive'", breaks='texts', also=('own-count',)),
    Mutant('other_topic', old=", 'beacon',", new=", 'chatter',", expect='no publisher on the topic beacon',
           breaks='topic', also=('rate', 'own-count')),
    Mutant('other_type',
           edits=(('create_publisher(String', 'create_publisher(Header'), ('(String(data=', '(Header(frame_id=')),
           imports='from std_msgs.msg import Header', expect='must carry std_msgs/msg/String', breaks='topic'),
    Mutant('publishes_at_once', old="self.publisher = self.create_publisher(String, 'beacon', 10)", new='''
        self.publisher = self.create_publisher(String, 'beacon', 10)
        self.on_timer()
        ''', expect='Publish in the timer only', breaks='first'),
    Mutant('publishes_str', old=TEXT, new="f'alive {self.count}'", expect='Expected <class', breaks='texts'),
    Mutant('rate_as_period', old='.create_timer(0.25, self', new='.create_timer(4, self',
           expect='wants the period, not the rate', breaks='rate', also=('own-count',)),
    Mutant('spins_in_constructor', old='self.count = 0', new='''
        self.count = 0
        rclpy.spin_once(self, timeout_sec=0.1)
        ''', expect='The constructor sleeps or spins', breaks='at-once'),
    Mutant('sleeps_in_constructor', old='self.timer = self.create_timer(0.25, self.on_timer)', new='''
        while True:
            self.on_timer()
            time.sleep(0.25)
        ''', imports='import time', expect='did not return', breaks='at-once'),
    Mutant('twice_each', old="self.publisher.publish(String(data=f'alive {self.count}'))", new='''
        self.publisher.publish(String(data=f'alive {self.count}'))
        self.count += 1
        self.publisher.publish(String(data=f'alive {self.count}'))
        ''', expect='at 4 Hz there are', breaks='rate', also=('own-count',)),
    Mutant('two_publishers', old="self.publisher = self.create_publisher(String, 'beacon', 10)", new='''
        self.publisher = self.create_publisher(String, 'beacon', 10)
        self.create_publisher(String, 'beacon', 10)
        ''', expect='2 publishers', breaks='topic'),
    Mutant('publisher_in_callback', old=f"self.publisher.publish({TEXT})",
           new=f"self.create_publisher(String, 'beacon', 10).publish({TEXT})",
           expect='publishers on the topic beacon, expected one', breaks='topic'),
    Mutant('short_life', old="'beacon', 10)", new="'beacon', QoSProfile(depth=10, lifespan=Duration(seconds=1)))",
           imports='from rclpy.duration import Duration\nfrom rclpy.qos import QoSProfile', expect='policy lifespan 1 s',
           breaks='qos'),
    Mutant('own_namespace', old="super().__init__('beacon')", new="super().__init__('beacon', namespace='robot')",
           expect="gives itself the namespace 'robot'", breaks='topic'),
    Mutant('only_if_somebody_listens', old='self.count += 1', new="""
        if not self.publisher.get_subscription_count():
            return
        self.count += 1
        """, expect='whether somebody listens or not', breaks='rate'),
    Mutant('counts_the_clock', old='self.count += 1', new='self.count = self.get_clock().now().nanoseconds // 250_000_000',
           expect='begins with', breaks='own-count', also='texts'),
    Mutant('forty_texts', edits=(('self.count = 0', "self.texts = [f'alive {number}' for number in range(1, 41)]"),
                                 ('self.count += 1', "if not self.texts:\n    return"),
                                 (TEXT, 'String(data=self.texts.pop(0))')), expect='without end', breaks='texts',
           also=('rate',)),
    Mutant('periods_since_the_start', edits=(('self.count = 0', 'self.start = self.get_clock().now()'),
                                             ('self.count += 1', """
            passed = self.get_clock().now() - self.start
            self.count = round(passed.nanoseconds / 250_000_000)
            """)), expect='do not compute it from the time', breaks='texts'),
    Mutant('one_publisher_for_all', old="self.publisher = self.create_publisher(String, 'beacon', 10)", new="""
            if not hasattr(Beacon, 'publisher'):
                Beacon.publisher = self.create_publisher(String, 'beacon', 10)
            """, expect='Each constructor makes its own', breaks='topic'),
    Mutant('hundred_numbers', old='self.count += 1', new='self.count = self.count % 100 + 1', expect='without end',
           breaks='texts'),
    Mutant('number_of_a_byte', old='self.count += 1', new='self.count = (self.count + 1) % 256', expect='without end',
           breaks='texts'),
    Mutant('waits_for_a_listener', old='self.timer = self.create_timer(0.25, self.on_timer)', new="""
            self.timer = self.create_timer(0.25, self.on_timer)
            end = time.monotonic() + 1.0
            while not self.publisher.get_subscription_count() and time.monotonic() < end:
                time.sleep(0.02)
            """, imports='import time', expect='The constructor sleeps', breaks='at-once'),
    Mutant('callback_sleeps', edits=(('0.25', '0.01'), ('self.count += 1', """
            time.sleep(0.25)
            self.count += 1
            """)), imports='import time', expect='A callback sleeps', breaks='rate', also=('first',)),
    Mutant('publisher_in_the_class', edits=(('self.publisher =', 'Beacon.publisher ='),), breaks='topic',
           expect='what is kept in the class, or outside of it'),
    Mutant('topic_from_the_name', old="(String, 'beacon', 10)", new='(String, self.get_name(), 10)', breaks='topic',
           expect='whatever the node is called'),
]
