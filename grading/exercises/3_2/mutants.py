from grading.variants import Mutant

SOLUTION = '''
        msg.range /= 100
        msg.min_range /= 100
        msg.max_range /= 100
        msg.variance /= 100**2
        self.publisher.publish(msg)
        '''
COPY = '''
        out = Range(range=msg.range / 100, min_range=msg.min_range / 100, max_range=msg.max_range / 100,
                    variance=msg.variance / 100**2, %s)
        self.publisher.publish(out)
        '''
SUBSCRIPTION = "self.subscription = self.create_subscription(Range, 'sonar_cm', self.on_range, 10)"

MUTANTS = [
    Mutant('sleeps_before', breaks='at-once', old='self.publisher.publish(msg)', new='''
        time.sleep(0.05)
        self.publisher.publish(msg)
        ''', imports='import time', expect='Your callback sleeps, or waits in a loop'),
    Mutant('absolute_input', old=", 'sonar_cm',", new=", '/sonar_cm',", expect='a relative name has no leading slash',
           breaks='topics'),
    Mutant('absolute_topics', edits=((", 'sonar',", ", '/sonar',"), (", 'sonar_cm',", ", '/sonar_cm',")),
           expect='a relative name has no leading slash', breaks='topics'),
    Mutant('best_effort_output', old="(Range, 'sonar', 10)", new="(Range, 'sonar', qos_profile_sensor_data)",
           imports='from rclpy.qos import qos_profile_sensor_data', expect='BEST_EFFORT', breaks='qos'),
    Mutant('constant_variance', old='msg.variance /= 100**2', new='msg.variance = 0.0004', expect='The variance',
           breaks='variance'),
    Mutant('depth_1', old='self.on_range, 10)', new='self.on_range, 1)', expect='has the depth 1, expected 10',
           breaks='qos', also=('one-each', 'at-once')),
    Mutant('depth_1_out', old="(Range, 'sonar', 10)", new="(Range, 'sonar', 1)", expect='has the depth 1, expected 10',
           breaks='qos'),
    Mutant('drops_inf', old='def on_range(self, msg):', new='''
        def on_range(self, msg):
            if msg.range == float('inf'):
                return
        ''', expect='do not drop messages', breaks='inf'),
    Mutant('only_the_first_four', old='def on_range(self, msg):', new='''
        def on_range(self, msg):
            self.seen = getattr(self, 'seen', 0) + 1
            if self.seen > 4:
                return
        ''', expect='only 4 came out', breaks='one-each'),
    Mutant('drops_the_unchanged', old='self.publisher.publish(msg)', new='''
        if msg.range != getattr(self, 'last', None):
            self.publisher.publish(msg)
        self.last = msg.range
        ''', expect='did not come out, such as', breaks='one-each', also=('inf',)),
    Mutant('frame_only', old=SOLUTION, new=COPY % '''
                    header=Header(frame_id=msg.header.frame_id), radiation_type=msg.radiation_type,
                    field_of_view=msg.field_of_view'''.strip(), imports='from std_msgs.msg import Header',
           expect='header.stamp has changed', breaks='header'),
    Mutant('header_lost', old=SOLUTION,
           new=COPY % 'radiation_type=msg.radiation_type, field_of_view=msg.field_of_view',
           expect='the header is lost', breaks='header'),
    Mutant('inf_becomes_max', old='msg.range /= 100', new='msg.range = min(msg.range, msg.max_range) / 100',
           expect='inf must stay inf', breaks='inf', also=('distances',)),
    Mutant('inf_becomes_zero', old='msg.range /= 100',
           new="msg.range = 0.0 if msg.range == float('inf') else msg.range / 100", expect='inf must stay inf',
           breaks='inf'),
    Mutant('multiplies', old='msg.range /= 100', new='msg.range *= 100', expect='divide by 100', breaks='distances'),
    Mutant('no_field_of_view', old=SOLUTION, new=COPY % 'header=msg.header, radiation_type=msg.radiation_type',
           expect='field_of_view was', breaks='others'),
    Mutant('no_radiation_type', old=SOLUTION, new=COPY % 'header=msg.header, field_of_view=msg.field_of_view',
           expect='radiation_type was', breaks='others'),
    Mutant('no_variance', old='msg.variance /= 100**2', new='', expect='The variance', breaks='variance'),
    Mutant('old_name', old="super().__init__('range_to_metres')", new="super().__init__('range_to_meters')",
           expect="expected 'range_to_metres'", breaks='node'),
    Mutant('only_max_range', old='msg.min_range /= 100', new='', expect='min_range:', breaks='distances'),
    Mutant('only_range', old='''
        msg.min_range /= 100
        msg.max_range /= 100
        ''', new='', expect='Convert all three distances', breaks='distances'),
    Mutant('publishes_in_timer', source='''
from sensor_msgs.msg import Range


class RangeToMetres(Node):
    def __init__(self):
        super().__init__('range_to_metres')
        self.publisher = self.create_publisher(Range, 'sonar', 10)
        self.waiting = []
        self.create_timer(0.1, self.on_timer)
        self.subscription = self.create_subscription(Range, 'sonar_cm', self.on_range, 10)

    def on_range(self, msg):
        msg.range /= 100
        msg.min_range /= 100
        msg.max_range /= 100
        msg.variance /= 100**2
        self.waiting.append(msg)

    def on_timer(self):
        while self.waiting:
            self.publisher.publish(self.waiting.pop(0))
''', expect='none came out at once', breaks='at-once', also=('inf',)),
    Mutant('repeats_in_timer', source='''
from sensor_msgs.msg import Range


class RangeToMetres(Node):
    def __init__(self):
        super().__init__('range_to_metres')
        self.publisher = self.create_publisher(Range, 'sonar', 10)
        self.last = None
        self.create_timer(1.0, self.on_timer)
        self.subscription = self.create_subscription(Range, 'sonar_cm', self.on_range, 10)

    def on_range(self, msg):
        msg.range /= 100
        msg.min_range /= 100
        msg.max_range /= 100
        msg.variance /= 100**2
        self.last = msg
        self.publisher.publish(msg)

    def on_timer(self):
        if self.last:
            self.publisher.publish(self.last)
''', expect='Publish exactly once for each', breaks='one-each'),
    Mutant('one_behind', old='self.publisher.publish(msg)', new='''
        self.before, out = msg, getattr(self, 'before', None)
        if out:
            self.publisher.publish(out)
        ''', expect='none came out at once', breaks='at-once', also=('one-each', 'inf')),
    Mutant('stamped_again', old='msg.variance /= 100**2', new='''
        msg.variance /= 100**2
        msg.header.stamp = self.get_clock().now().to_msg()
        ''', expect='header.stamp has changed', breaks='header'),
    Mutant('subscribes_to_own_topic', old="'sonar_cm'", new="'sonar'", expect='no subscription on the topic sonar_cm',
           breaks='topics'),
    Mutant('topics_exchanged', edits=(("'sonar_cm'", "'sonar'"), ("(Range, 'sonar', 10)", "(Range, 'sonar_cm', 10)")),
           expect='no subscription on the topic sonar_cm', breaks='topics'),
    Mutant('two_of_each', old='self.publisher.publish(msg)', new='''
        self.publisher.publish(msg)
        self.publisher.publish(msg)
        ''', expect='Publish exactly once for each', breaks='one-each'),
    Mutant('variance_times_factor', old='msg.variance /= 100**2', new='msg.variance /= 100', expect='It is a square',
           breaks='variance'),
    Mutant('whole_centimetres', old='msg.range /= 100', new='msg.range = round(msg.range, -2) / 100',
           expect='Convert all three distances', breaks='distances'),
    Mutant('large_numbers_are_metres', old='msg.max_range /= 100',
           new='msg.max_range /= 100 if msg.max_range < 10_000 else 1', expect='max_range: ', breaks='distances'),
    Mutant('published_by_the_constructor', old="self.publisher = self.create_publisher(Range, 'sonar', 10)", new='''
        self.publisher = self.create_publisher(Range, 'sonar', 10)
        self.publisher.publish(Range())
        ''', expect='published before it had received anything', breaks='one-each'),
    Mutant('drops_zero', old='def on_range(self, msg):', new='''
        def on_range(self, msg):
            if not msg.range:
                return
        ''', expect='Publish', breaks='one-each'),
    Mutant('drops_the_very_near', old='def on_range(self, msg):', new='''
        def on_range(self, msg):
            if msg.range < msg.min_range:
                return
        ''', expect='out', breaks='one-each'),
    Mutant('drops_nan', old='def on_range(self, msg):', new='''
        def on_range(self, msg):
            if msg.range != msg.range:
                return
        ''', expect='out', breaks='one-each'),
    Mutant('no_negative_range', old='msg.range /= 100', new='msg.range = 0.0 if msg.range < 0 else msg.range / 100',
           expect='Convert all three distances', breaks='distances'),
    Mutant('fills_an_empty_header', old='msg.range /= 100', new='''
        msg.range /= 100
        msg.header.frame_id = msg.header.frame_id or 'sonar'
        ''', expect='the header is lost', breaks='header'),
    Mutant('minus_infinity', old='msg.range /= 100', new='msg.range = abs(msg.range) if abs(msg.range) > 1e9 else msg.range / 100',
           expect='-inf must stay -inf', breaks='distances'),
    Mutant('never_twice_the_same', old='msg.range /= 100', new="""
        if msg == getattr(self, 'last', None):
            return
        self.last = copy.deepcopy(msg)
        msg.range /= 100
        """, imports='import copy', expect='the second of two that are alike', breaks='one-each'),
    Mutant('small_numbers_are_metres', old='msg.range /= 100', new="""
        if msg.max_range < 10:
            self.publisher.publish(msg)
            return
        msg.range /= 100
        """, expect='Convert all three distances', breaks='distances'),
    Mutant('frame_without_slash', old='msg.range /= 100', new="""
        msg.header.frame_id = msg.header.frame_id.lstrip('/')
        msg.range /= 100
        """, expect='header.frame_id was', breaks='header'),
    Mutant('stamp_as_a_float', old='msg.range /= 100', new="""
        stamp = msg.header.stamp
        msg.header.stamp = Time(seconds=stamp.sec + stamp.nanosec / 1e9).to_msg()
        msg.range /= 100
        """, imports='from rclpy.time import Time', expect='header.stamp has changed', breaks='header'),
    Mutant('says_it_again_later', edits=(
        ("self.publisher = self.create_publisher(Range, 'sonar', 10)", """
        self.publisher = self.create_publisher(Range, 'sonar', 10)
        self.create_timer(5.0, lambda: self.publisher.publish(self.last) if hasattr(self, 'last') else None)
        """), ('self.publisher.publish(msg)', """
        self.last = msg
        self.publisher.publish(msg)
        """)), expect='Publish exactly once for each', breaks='one-each'),
    Mutant('one_more_topic', edits=(
        ("self.publisher = self.create_publisher(Range, 'sonar', 10)", """
        self.publisher = self.create_publisher(Range, 'sonar', 10)
        self.raw = self.create_publisher(Range, 'sonar_raw', 10)
        """), ('self.publisher.publish(msg)', """
        self.raw.publish(msg)
        self.publisher.publish(msg)
        """)), expect='one topic too many', breaks='one-each'),
    Mutant('smaller_limit_first', old='msg.variance /= 100**2', new="""
        msg.variance /= 100**2
        msg.min_range, msg.max_range = sorted((msg.min_range, msg.max_range))
        """, expect='min_range', breaks='distances'),
    Mutant('short_life', old="'sonar', 10)", new="'sonar', QoSProfile(depth=10, lifespan=Duration(seconds=1)))",
           imports='from rclpy.duration import Duration\nfrom rclpy.qos import QoSProfile', expect='policy lifespan 1 s',
           breaks='qos'),
    Mutant('one_kind_of_radiation', old='msg.variance /= 100**2', new="""
        msg.variance /= 100**2
        msg.radiation_type = Range.INFRARED
        """, expect='radiation_type was', breaks='others'),
    Mutant('publisher_in_the_class', edits=(('self.publisher =', 'RangeToMetres.publisher ='),), breaks='topics',
           expect='what is kept in the class, or outside of it'),
]
