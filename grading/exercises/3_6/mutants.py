from grading.variants import Mutant

STATE = 'self.max_gap, self.count, self.newest = max_gap, 0, None'
GAP = 'self.gap.publish(Float64(data=gap))'
RATE = 'self.rate.publish(Float64(data=float(self.count)))'
STAMP = 'stamp = Time.from_msg(scan.header.stamp)'
NEWEST = 'self.newest = stamp if gap >= 0 else self.newest'

MUTANTS = [
    Mutant('absolute_report', old="'scan_rate'", new="'/scan_rate'", expect='a relative name has no leading slash',
           breaks='topics'),
    Mutant('best_effort_report', old="(Float64, 'scan_rate', 10)", new="(Float64, 'scan_rate', sensor)",
           expect='BEST_EFFORT', breaks='qos'),
    Mutant('count_in_class', edits=((STATE, 'self.max_gap, RateMonitor.count, self.newest = max_gap, 0, None'),
                                    ('self.count += 1', 'RateMonitor.count += 1'),
                                    ('self.count = 0', 'RateMonitor.count = 0'),
                                    ('float(self.count)', 'float(RateMonitor.count)')),
           expect='What they count belongs to the object', breaks='own-state'),
    Mutant('default_a_little_longer', old='max_gap=0.5', new='max_gap=0.51', expect='max_gap is 0.5 then', breaks='limit'),
    Mutant('reports_in_the_constructor', old='self.create_timer(1.0, self.on_second)', new='''
        self.create_timer(1.0, self.on_second)
        self.rate.publish(Float64())
        ''', expect='went out in the constructor', breaks='report', also=('silent', 'own-state')),
    Mutant('default_of_one_second', old='max_gap=0.5', new='max_gap=1.0', expect='max_gap is 0.5 then', breaks='limit',
           also=('gap',)),
    Mutant('depth_1', old="(Float64, 'scan_gap', 10)", new="(Float64, 'scan_gap', 1)",
           expect='has the depth 1, expected 10', breaks='qos'),
    Mutant('each_gap_twice', old=GAP, new='''
        self.gap.publish(Float64(data=gap))
        self.gap.publish(Float64(data=gap))
        ''', expect='each gap is told once', breaks='gap', also=('own-state', 'limit')),
    Mutant('fixed_threshold', old='if gap > self.max_gap:', new='if gap > 0.5:',
           expect='Only a difference of more than max_gap', breaks='limit', also=('own-state',)),
    Mutant('stamps_as_floats', edits=((STAMP, 'stamp = scan.header.stamp.sec + scan.header.stamp.nanosec / 1e9'),
           ('gap = (stamp - (self.newest or stamp)).nanoseconds / 1e9', 'gap = stamp - (stamp if self.newest is None else self.newest)')),
           expect='subtract whole nanoseconds', breaks='limit'),
    Mutant('gap_at_the_limit', old='gap > self.', new='gap >= self.', expect='Only a difference of more than max_gap',
           breaks='limit'),
    Mutant('gap_before_first', old='or stamp))', new='or Time(clock_type=stamp.clock_type)))',
           expect='there is nothing before it', breaks='first', also=('gap', 'limit', 'old', 'own-state', 'at-once')),
    Mutant('gap_in_report', edits=((STATE, '''
            self.max_gap, self.count, self.newest = max_gap, 0, None
            self.gaps = []
            '''),
            (GAP, 'self.gaps.append(gap)'),
            (RATE, '''
            self.rate.publish(Float64(data=float(self.count)))
            for gap in self.gaps:
                self.gap.publish(Float64(data=gap))
            self.gaps.clear()
            ''')), expect='told only later', breaks='at-once', also=('gap', 'own-state', 'limit')),
    Mutant('gap_only_once', old=GAP, new='''
        if not hasattr(self, 'told'):
            self.gap.publish(Float64(data=gap))
        self.told = True
        ''', expect='nothing came on scan_gap', breaks='gap', also=('own-state',)),
    Mutant('latched_report', old="(Float64, 'scan_rate', 10)",
           new="(Float64, 'scan_rate', QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL))",
           expect='TRANSIENT_LOCAL', breaks='qos'),
    Mutant('limit_in_class', edits=((STATE, 'RateMonitor.max_gap, self.count, self.newest = max_gap, 0, None'),),
           expect='takes over that max_gap', breaks='own-state'),
    Mutant('never_starts_again', old='self.count = 0', new='', expect='count from zero again', breaks='report',
           also=('silent', 'own-state', 'old')),
    Mutant('newest_in_class', edits=(('(self.newest or stamp)', '(RateMonitor.newest or stamp)'),
            (NEWEST, 'RateMonitor.newest = stamp if gap >= 0 else RateMonitor.newest'),
            ('def __init__(self, max_gap=0.5):', '''
            newest = None

            def __init__(self, max_gap=0.5):
            ''')), expect='The newest stamp belongs to the object', breaks='own-state'),
    Mutant('no_report_before_the_first', old=RATE, new='''
        if self.newest is not None:
            self.rate.publish(Float64(data=float(self.count)))
        ''', expect='A silent sensor calls no callback', breaks='silent'),
    Mutant('old_scan_is_a_gap', old='if gap > self.max_gap:', new='if abs(gap) > self.max_gap:',
           expect='a scan that is older than the newest one makes no gap', breaks='old'),
    Mutant('old_scan_is_not_counted', edits=(('self.count += 1', ''),
                                             (NEWEST, '''
            self.count += gap >= 0
            self.newest = stamp if gap >= 0 else self.newest
            ''')), expect='they count, too', breaks='old'),
    Mutant('old_scan_moves_back', old=NEWEST, new='self.newest = stamp', expect='must not move the newest stamp back',
           breaks='old'),
    Mutant('other_name', old="'rate_monitor'", new="'monitor'", expect="expected 'rate_monitor'", breaks='node'),
    Mutant('report_every_tenth', old='float(self.count)', new='self.count / 10', expect='scan_rate says',
           breaks='report', also=('silent', 'old', 'own-state')),
    Mutant('scan_latched', old="self.create_subscription(LaserScan, 'scan', self.on_scan, sensor)",
           new="self.create_subscription(LaserScan, 'scan', self.on_scan, QoSProfile(depth=5, reliability="
               'ReliabilityPolicy.BEST_EFFORT, durability=DurabilityPolicy.TRANSIENT_LOCAL))',
           expect='requests TRANSIENT_LOCAL', breaks='any-lidar'),
    Mutant('scan_reliable', old="self.create_subscription(LaserScan, 'scan', self.on_scan, sensor)",
           new="self.create_subscription(LaserScan, 'scan', self.on_scan, 10)", expect='requests RELIABLE',
           breaks='any-lidar'),
    Mutant('silent_when_silent', old=RATE, new='''
        if self.count:
            self.rate.publish(Float64(data=float(self.count)))
        ''', expect='A silent sensor calls no callback', breaks='silent', also=('report',)),
    Mutant('tells_the_surplus', old='data=gap)', new='data=gap - self.max_gap)', expect='the difference of the',
           breaks='gap', also=('limit', 'own-state')),
    Mutant('time_of_arrival', old=STAMP, new='stamp = self.get_clock().now()', expect='nothing came on scan_gap',
           breaks='gap', also=('limit', 'own-state', 'old')),
    Mutant('wall_clock', edits=(('''
            from sensor_msgs.msg import LaserScan
            from std_msgs.msg import Float64
            ''', '''
            from sensor_msgs.msg import LaserScan
            import time

            from std_msgs.msg import Float64
            '''),
            ('self.create_timer(1.0, self.on_second)', 'self.began = time.time()'),
            ('self.count += 1', '''
            self.count += 1
            if time.time() - self.began >= 1.0:
                self.on_second()
                self.began = time.time()
            ''')), expect='report in a timer', breaks='silent', also=('report', 'own-state', 'old')),
    Mutant('whole_seconds_only', edits=(('from sensor_msgs.msg import LaserScan', '''
            from sensor_msgs.msg import LaserScan
            from rclpy.clock import ClockType
            '''),
            (STAMP, 'stamp = Time(seconds=scan.header.stamp.sec, clock_type=ClockType.ROS_TIME)')), expect='scan_gap',
           breaks='gap', also=('limit', 'own-state', 'old')),
    Mutant('stamp_zero_is_none', edits=((STAMP, 'stamp = scan.header.stamp.sec * 10**9 + scan.header.stamp.nanosec'),
           ('gap = (stamp - (self.newest or stamp)).nanoseconds / 1e9', 'gap = (stamp - (self.newest or stamp)) / 1e9')),
           expect='nothing came on scan_gap', breaks='gap', also=('limit',)),
    Mutant('silence_is_a_gap', old='def on_second(self):', new='''
        def on_second(self):
            if self.newest is not None and not self.count:
                self.gap.publish(Float64(data=1.0))
        ''', expect='silence alone makes no gap', breaks='gap', also=('at-once', 'own-state', 'limit')),
    Mutant('as_the_first_publisher', old="(LaserScan, 'scan', self.on_scan, sensor)",
           new="(LaserScan, 'scan', self.on_scan, qos_profile_best_available)",
           imports='from rclpy.qos import qos_profile_best_available', expect='requests RELIABLE', breaks='any-lidar',
           also='limit'),
    Mutant('without_the_scan_itself', breaks='gap', also=('limit', 'own-state', 'first', 'old'), old='.nanoseconds / 1e9', new='.nanoseconds / 1e9 - scan.scan_time',
           expect='scan_gap'),
    Mutant('zero_means_default', old='self.max_gap, self.count, self.newest = max_gap, 0, None',
           new='self.max_gap, self.count, self.newest = max_gap or 0.5, 0, None', expect='like any other', breaks='limit'),
    Mutant('divided_by_the_time', edits=(('self.create_timer(1.0, self.on_second)', """
            self.last = self.get_clock().now()
            self.create_timer(1.0, self.on_second)
            """), (RATE, """
            now = self.get_clock().now()
            passed, self.last = (now - self.last).nanoseconds / 1e9, now
            self.rate.publish(Float64(data=round(self.count / passed, 3) if passed else 0.0))
            """)), expect='Do not divide by the time', breaks='report'),
    Mutant('sorts_the_stamps', edits=(('max_gap, 0, None', 'max_gap, 0, []'),
                                      ('gap = (stamp - (self.newest or stamp)).nanoseconds / 1e9', """
            self.newest = sorted([*self.newest, stamp.nanoseconds])[-2:]
            gap = (self.newest[-1] - self.newest[0]) / 1e9
            """), (NEWEST, '')), expect='older than the newest one makes no gap', breaks='old'),
    Mutant('divided_from_the_second_report_on', edits=(('self.create_timer(1.0, self.on_second)', """
            self.last = None
            self.create_timer(1.0, self.on_second)
            """), (RATE, """
            now = self.get_clock().now()
            passed = (now - self.last).nanoseconds / 1e9 if self.last else 1.0
            self.last = now
            self.rate.publish(Float64(data=self.count / passed))
            """)), expect='Do not divide by the time', breaks='report'),
    Mutant('at_most_twenty', old='data=float(self.count)', new='data=float(min(self.count, 20))', expect='scans came in these seconds',
           breaks='report'),
    Mutant('tires_of_silence', edits=(('self.max_gap, self.count, self.newest = max_gap, 0, None', """
            self.max_gap, self.count, self.newest = max_gap, 0, None
            self.quiet = 0
            """), (RATE, """
            self.quiet = 0 if self.count else self.quiet + 1
            if self.quiet < 6:
                self.rate.publish(Float64(data=float(self.count)))
            """)), expect='also without scans', breaks='silent'),
    Mutant('same_gap_once', edits=(('self.max_gap, self.count, self.newest = max_gap, 0, None', """
            self.max_gap, self.count, self.newest = max_gap, 0, None
            self.told = None
            """), ('if gap > self.max_gap:', """
            if gap > self.max_gap and gap != self.told:
                self.told = gap
            """)), expect='nothing came on scan_gap', breaks='gap'),
    Mutant('requests_a_deadline', old='self.on_scan, sensor)',
           new='self.on_scan, QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT, deadline=Duration(seconds=0.5)))',
           imports='from rclpy.duration import Duration', expect='asks for the policy deadline', breaks='any-lidar'),
    Mutant('long_gaps_do_not_count', old='if gap > self.max_gap:', new='if self.max_gap < gap < 60.5:', expect='nothing came on scan_gap',
           breaks='gap'),
    Mutant('tolerant_limit', old='if gap > self.max_gap:', new='if gap > self.max_gap + 1e-6:', expect='if only by nanoseconds',
           breaks='limit'),
    Mutant('limits_up_to_one', old='self.max_gap, self.count, self.newest = max_gap, 0, None',
           new='self.max_gap, self.count, self.newest = min(max_gap, 1.0), 0, None', expect='Only a difference of more than max_gap',
           breaks='limit', also=('old', 'gap')),
    Mutant('very_old_is_a_new_beginning', old='if gap >= 0 else self.newest', new='if gap >= 0 or gap < -5 else self.newest',
           expect='scan_gap', breaks='old'),
    Mutant('first_lidar_only', old='stamp = Time.from_msg(scan.header.stamp)', new="""
        self.frame = getattr(self, 'frame', scan.header.frame_id)
        if scan.header.frame_id != self.frame:
            return
        stamp = Time.from_msg(scan.header.stamp)
        """, expect='on scan_gap', breaks='gap', also=('limit', 'own-state', 'at-once', 'old')),
    Mutant('hundred_scans_at_most', old='float(self.count)', new='float(min(self.count, 100))', expect='and scan_rate says',
           breaks='report'),
    Mutant('reports_for_half_a_minute', old='    def on_second(self):', new="""
           def on_second(self):
               self.reports = getattr(self, 'reports', 0) + 1
               if self.reports > 30:
                   return
           """, breaks='silent', expect='expected one every 1.0 s'),
    Mutant('publisher_of_gaps_in_the_class', old='self.gap = ', new='RateMonitor.gap = ', breaks='own-state',
           expect='came on /other/scan_gap'),
    Mutant('publisher_of_rates_in_the_class', old='self.rate = ', new='RateMonitor.rate = ', breaks='own-state',
           expect='came on /other/scan_rate'),
    Mutant('minutes_back_is_a_new_beginning', old='if gap >= 0 else', new='if gap >= 0 or gap < -600 else', breaks='old',
           expect='it must not move the newest stamp back'),
    Mutant('an_hour_back_is_a_new_beginning', old='if gap >= 0 else', new='if gap >= 0 or gap < -3600 else', breaks='old',
           expect='it must not move the newest stamp back'),
    Mutant('subscription_of_depth_1', old='self.on_scan, sensor)', breaks='report', also=('gap', 'old', 'own-state', 'limit'),
           new='self.on_scan, QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT))',
           expect='The depth of a subscription says how many messages it keeps'),
    Mutant('counts_in_a_byte', old='self.count += 1', new='self.count = (self.count + 1) % 256', breaks='report',
           expect='and scan_rate says'),
    Mutant('first_report_is_zero', old=RATE, breaks='report', also='own-state', new="""
        self.rate.publish(Float64(data=float(self.count if hasattr(self, 'going') else 0)))
        self.going = True
        """, expect='also the first report says'),
    Mutant('three_old_ones_are_a_new_beginning', breaks='old', old=NEWEST, new="""
        self.olds = getattr(self, 'olds', 0) + 1 if gap < 0 else 0
        self.newest = stamp if gap >= 0 or self.olds == 3 else self.newest
        """, expect='on scan_gap'),
    Mutant('gaps_of_ten_days_at_most', breaks='gap', old='if gap > self.max_gap:', new='if self.max_gap < gap < 864_000:',
           expect='nothing came on scan_gap'),
    Mutant('rounded_to_milliseconds', old=GAP, new='self.gap.publish(Float64(data=round(gap, 3)))',
           expect='publish the difference without rounding', breaks='gap', also=('limit',)),
    Mutant('not_from_the_gap_on', old=GAP, new="""
        self.gap.publish(Float64(data=gap))
        return
        """, expect='the newest one from then on, also after a gap', breaks='gap', also=('own-state', 'limit', 'old', 'first')),
    Mutant('reports_to_listeners_only', old=RATE, new=f"""
        if not self.rate.get_subscription_count():
            return
        {RATE}
        """, expect='also if nobody listens', breaks='report'),
    Mutant('counts_for_listeners_only', old='self.count += 1', new='self.count += self.rate.get_subscription_count() > 0',
           expect='also if nobody listens', breaks='report'),
]
