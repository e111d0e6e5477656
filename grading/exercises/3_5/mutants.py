from grading.variants import Mutant

DEADLINE = "if (offered['deadline'] or float('inf')) > (requested['deadline'] or float('inf')):"
STRENGTH = 'strength[offered[key]] < strength[requested[key]]'

MUTANTS = [
    Mutant('callback_changed', old='distance < 0.5', new='distance <= 0.5', expect='The callback was right',
           breaks='rest'),
    Mutant('deadline_always_counts', old=DEADLINE, new="if offered['deadline'] != requested['deadline']:",
           expect='The offered period must not be longer', breaks='deadline', also=('no-deadline',)),
    Mutant('deadline_equal_is_too_long', old=DEADLINE,
           new="if requested['deadline'] and (offered['deadline'] or float('inf')) >= requested['deadline']:",
           expect='The offered period must not be longer', breaks='deadline', also=('no-deadline',)),
    Mutant('deadline_other_way_round', old="float('inf')) > (requested['deadline']",
           new="float('inf')) < (requested['deadline']", expect='The offered period must not be longer',
           breaks='deadline', also=('no-deadline', 'all')),
    Mutant('depth_counts', old='return reasons', new='''
        if offered['depth'] < requested['depth']:
            reasons.append('depth')
        return reasons
        ''', expect='Depth is a private matter', breaks='depth'),
    Mutant('durability_equal_or_not', old=STRENGTH, new='(offered[key] != requested[key] if key == "durability" else '
           + STRENGTH + ')', expect='Different is not incompatible', breaks='durability'),
    Mutant('durability_forgotten', old="for key in ('reliability', 'durability') if",
           new="for key in ('reliability',) if", expect='at least as strong', breaks='durability', also=('all',)),
    Mutant('equal_or_not', old=STRENGTH, new='offered[key] != requested[key]', expect='Different is not incompatible',
           breaks='reliability', also=('durability',)),
    Mutant('first_reason_only', old='return reasons', new='return reasons[:1]', expect='Name every key', breaks='all'),
    Mutant('joined_text', old='return reasons', new="return ', '.join(reasons)", expect='must return a list',
           breaks='list'),
    Mutant('names_by_letters', old='if offered[key] != requested[key]]',
           new='if offered[key].lower() != requested[key].lower()]', expect='letter by letter', breaks='names'),
    Mutant('names_may_end_otherwise', old='if offered[key] != requested[key]]',
           new='if offered[key] not in requested[key]]', expect='only if they are equal', breaks='names',
           also=('all',)),
    Mutant('none_when_all_fits', old='return reasons', new='return reasons or None', expect='gives None, expected []',
           breaks='list'),
    Mutant('nothing_when_the_topic_differs', old='return reasons',
           new="return ['topic'] if 'topic' in reasons else reasons", expect='Name every key', breaks='all'),
    Mutant('one_profile_for_both', old="(LaserScan, 'scan', self.on_scan, sensor)",
           new="(LaserScan, 'scan', self.on_scan, command)", expect='Ask for no more than is offered', breaks='scan'),
    Mutant('other_way_round', old=STRENGTH, new=STRENGTH.replace('<', '>'), expect='at least as strong',
           breaks='reliability', also=('durability', 'all')),
    Mutant('reliability_forgotten', old="for key in ('reliability', 'durability') if",
           new="for key in ('durability',) if", expect='at least as strong', breaks='reliability', also=('all',)),
    Mutant('renamed_node', old="super().__init__('safety_stop')", new="super().__init__('stop')",
           expect="expected 'safety_stop'", breaks='rest'),
    Mutant('scan_latched', old="(LaserScan, 'scan', self.on_scan, sensor)",
           new="(LaserScan, 'scan', self.on_scan, QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT, "
               'durability=DurabilityPolicy.TRANSIENT_LOCAL))', expect='requests TRANSIENT_LOCAL', breaks='scan'),
    Mutant('scan_reliable', old="(LaserScan, 'scan', self.on_scan, sensor)",
           new="(LaserScan, 'scan', self.on_scan, 5)", expect='requests RELIABLE', breaks='scan'),
    Mutant('sorted_by_name', old='return reasons', new='return sorted(reasons)', expect='Keep the order',
           breaks='order'),
    Mutant('stop_best_effort', old=', durability=', new=', reliability=ReliabilityPolicy.BEST_EFFORT, durability=',
           expect='offers BEST_EFFORT', breaks='stop'),
    Mutant('stop_deep', old='QoSProfile(depth=1', new='QoSProfile(depth=10', expect='The depth of stop was 1',
           breaks='rest'),
    Mutant('stop_volatile', old="(Bool, 'stop', command)", new="(Bool, 'stop', 1)", expect='offers VOLATILE',
           breaks='stop'),
    Mutant('type_forgotten', old="for key in ('topic', 'type')", new="for key in ('topic',)",
           expect='only if they are equal', breaks='names', also=('all',)),
    Mutant('zero_deadline_is_shortest', old=DEADLINE, new="if offered['deadline'] > requested['deadline']:",
           expect='0.0 is an endless period', breaks='no-deadline', also=('all',)),
    Mutant('zero_deadline_of_the_offer', old=DEADLINE,
           new="if offered['deadline'] > (requested['deadline'] or float('inf')):", expect='0.0 is an endless period',
           breaks='no-deadline', also=('all',)),
    Mutant('zero_deadline_of_the_request', old=DEADLINE,
           new="if (offered['deadline'] or float('inf')) > requested['deadline']:", expect='0.0 is an endless period',
           breaks='no-deadline'),
    Mutant('set_of_reasons', old='return reasons', new='return set(reasons)', expect='gives a set', breaks='list'),
    Mutant('slashes_do_not_count', old='if offered[key] != requested[key]]',
           new="if offered[key].strip('/') != requested[key].strip('/')]", expect='only if they are equal', breaks='names'),
    Mutant('tuple_of_reasons', old='return reasons', new='return tuple(reasons)', expect='gives a tuple', breaks='list'),
    Mutant('deadlines_in_tenths', old=DEADLINE, new='''
        first, second = (int(one['deadline'] * 10) or float('inf') for one in (offered, requested))
        if first > second:
        ''', expect='must not be longer', breaks='deadline', also='no-deadline'),
    Mutant('ten_seconds_are_endless', old=DEADLINE, new="if (offered['deadline'] or 10) > (requested['deadline'] or 10):",
           expect='0.0 is an endless period', breaks='no-deadline'),
    Mutant('a_large_number_is_endless', count=2, old="float('inf')", new='1e6', expect='0.0 is an endless period',
           breaks='no-deadline'),
    Mutant('deadlines_in_milliseconds', old="(offered['deadline'] or float('inf')) > (requested['deadline'] or float('inf'))",
           new="round(offered['deadline'] or 1e99, 3) > round(requested['deadline'] or 1e99, 3)",
           expect='must not be longer', breaks='deadline'),
    Mutant('nearest_distance', old='any(distance < 0.5 for distance in scan.ranges)', new='min(scan.ranges) < 0.5',
           expect='raised ValueError', breaks='rest'),
    Mutant('only_what_the_lidar_can_see', old='distance < 0.5 for', new='scan.range_min <= distance < 0.5 for',
           expect='The callback was right', breaks='rest'),
    Mutant('says_it_again', old="self.publisher = self.create_publisher(Bool, 'stop', command)", new="""
        self.publisher = self.create_publisher(Bool, 'stop', command)
        self.create_timer(1.0, lambda: self.publisher.publish(Bool(data=False)))
        """, expect='No scan came for a minute', breaks='rest', also=('scan', 'stop')),
    Mutant('short_life', old='depth=1, durability', new='depth=1, lifespan=Duration(seconds=10), durability',
           imports='from rclpy.duration import Duration', expect='has the lifespan 10 s', breaks='stop'),
    Mutant('scan_best_available', old="self.on_scan, sensor)",
           new="self.on_scan, QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_AVAILABLE))",
           expect='BEST_AVAILABLE', breaks='scan'),
    Mutant('reasons_of_earlier_calls', edits=(
                                                  ('def why_no_data(offered, requested):',
                                                   'def why_no_data(offered, requested, reasons=[]):'),
                                                  ("reasons = [key for key in ('topic', 'type')",
                                                   "reasons += [key for key in ('topic', 'type')")),
           expect='why_no_data changes its argument `reasons`', breaks='list'),
    Mutant('stops_for_ever', old='self.publisher.publish(Bool(data=any(distance < 0.5 for distance in scan.ranges)))', new="""
            self.near = getattr(self, 'near', False) or any(distance < 0.5 for distance in scan.ranges)
            self.publisher.publish(Bool(data=self.near))
            """, expect='The callback was right', breaks='rest'),
    Mutant('depth_0_keeps_nothing', old='return reasons', new="""
            if not offered['depth']:
                reasons.append('depth')
            return reasons
        """, expect='never a reason', breaks='depth'),
    Mutant('limit_of_its_own', old='distance < 0.5', new='distance < 0.48', expect='callback was right', breaks='rest'),
    Mutant('larger_limit', old='distance < 0.5', new='distance < 0.502', expect='callback was right', breaks='rest'),
    Mutant('front_only', old='in scan.ranges)', new='in list(scan.ranges)[:360])', expect='callback was right', breaks='rest'),
    Mutant('same_scan_once', old='def on_scan(self, scan):', new="""
        def on_scan(self, scan):
            if list(scan.ranges) == getattr(self, 'last', None):
                return
            self.last = list(scan.ranges)
        """, expect='equal to the one before', breaks='rest'),
    Mutant('fifty_scans_at_most', old='def on_scan(self, scan):', new="""
        def on_scan(self, scan):
            self.count = getattr(self, 'count', 0) + 1
            if self.count > 50:
                return
        """, expect='however many there were before', breaks='rest'),
    Mutant('publisher_in_the_class', edits=(('self.publisher =', 'SafetyStop.publisher ='),), breaks='rest',
           expect='what is kept in the class, or outside of it'),
    Mutant('scan_with_a_deadline', old='self.on_scan, sensor)', breaks='scan', expect='requests the policy deadline',
           new='self.on_scan, QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT, deadline=Duration(seconds=1)))',
           imports='from rclpy.duration import Duration'),
    Mutant('scan_with_a_liveliness', old='self.on_scan, sensor)', breaks='scan', expect='requests the policy liveliness',
           new='self.on_scan, QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT, '
               'liveliness=LivelinessPolicy.MANUAL_BY_TOPIC))', imports='from rclpy.qos import LivelinessPolicy'),
    Mutant('stops_for_listeners_only',
           old='self.publisher.publish(Bool(data=any(distance < 0.5 for distance in scan.ranges)))', new="""
        if self.publisher.get_subscription_count():
            self.publisher.publish(Bool(data=any(distance < 0.5 for distance in scan.ranges)))
        """, expect='when no driver listened yet', breaks='stop'),
]
