from grading.variants import Mutant

MUTANTS = [
    Mutant('own_domain_hears_always', old='return sorted(heard)', new='return sorted(heard | ({speaker} & set(listeners)))',
           breaks='measures', expect="the speaker's own domain, too"),
    Mutant('own_domain_is_not_asked', old='heard = set()', new='heard = {speaker} & set(listeners)', breaks='measures',
           expect="the speaker's own domain, too"),
    Mutant('newest_text_in_a_timer', old="""
        self.create_subscription(String, 'chatter', self.publisher.publish, 10)
        """, new="""
        newest = []

        def carry():
            if newest:
                self.publisher.publish(newest.pop())
            newest.clear()

        self.create_subscription(String, 'chatter', newest.append, 10)
        self.create_timer(0.1, carry)
        """, breaks='carries', expect='once and in order'),
    Mutant('both_directions', old='''
        def __init__(self, other_domain):
            super().__init__('bridge')
            self.other_side = join(other_domain, 'bridge')
            self.publisher = self.other_side.create_publisher(String, 'chatter', 10)
            self.create_subscription(String, 'chatter', self.publisher.publish, 10)
        ''', new='''
        def __init__(self, other_domain):
            super().__init__('bridge')
            self.other_side = join(other_domain, 'bridge')
            self.there = self.other_side.create_publisher(String, 'chatter', 10)
            self.here = self.create_publisher(String, 'chatter', 10)
            self.seen = set()
            self.create_subscription(String, 'chatter', self.carry, 10)
            self.other_side.create_subscription(String, 'chatter', self.carry_back, 10)
            self.spinning = spinning(self.other_side)

        def carry(self, msg):
            if msg.data not in self.seen:
                self.there.publish(msg)

        def carry_back(self, msg):
            if msg.data.startswith('echo'):
                self.seen.add(msg.data)
                self.here.publish(msg)
        ''', expect='direction only', breaks='one-way'),
    Mutant('bridge_on_one_side', old='''
        self.other_side = join(other_domain, 'bridge')
        self.publisher = self.other_side.create_publisher(String, 'chatter', 10)
        ''', new="self.publisher = self.create_publisher(String, 'chatter', 10)",
           expect='No node of yours is in domain', breaks='bridge'),
    Mutant('carries_a_copy_of_itself', old="(String, 'chatter', self.publisher.publish, 10)",
           new="(String, 'chatter', lambda msg: [self.publisher.publish(msg) for _ in range(2)], 10)",
           expect='in the other domain came', breaks='carries'),
    Mutant('compares_numbers', source='''
def who_hears(speaker, listeners, seconds=3.0):
    source = join(speaker, 'speaker')
    publisher = source.create_publisher(String, 'roll_call', 10)
    for _ in range(20):
        publisher.publish(String(data='hello'))
        time.sleep(0.02)
    leave(source)
    return sorted(domain for domain in listeners if domain == speaker)


class Bridge(Node):
    def __init__(self, other_domain):
        super().__init__('bridge')
        self.other_side = join(other_domain, 'bridge')
        self.publisher = self.other_side.create_publisher(String, 'chatter', 10)
        self.create_subscription(String, 'chatter', self.publisher.publish, 10)
''', expect='does it compare numbers', breaks='measures', also=('in-time',)),
    Mutant('default_context', edits=(("source = join(speaker, 'speaker')", '''
            rclpy.init(domain_id=speaker)
            source = rclpy.create_node('speaker')
            '''),
            ('for node in [source, *nodes.values()]:', '''
            source.destroy_node()
            for node in nodes.values():
            ''')), expect='No speaker', breaks='measures', also=('in-time',)),
    Mutant('gives_up_early', old='end = time.monotonic() + seconds', new='end = time.monotonic() + 0.001 * seconds',
           expect='who_hears(', breaks='measures', also=('in-time', 'leaves')),
    Mutant('in_the_order_of_hearing', edits=(('heard = set()', 'heard = []'),
                                             ('heard.add(domain), 10)', 'heard.append(domain), 10)'),
                                             ('len(heard) < len(nodes)', 'len(set(heard)) < len(nodes)'),
                                             ('return sorted(heard)', 'return list(dict.fromkeys(heard))')),
           expect='must be sorted', breaks='sorted'),
    Mutant('late_bound_name', old='lambda msg, domain=domain: heard.add(domain)', new='lambda msg: heard.add(domain)',
           expect='expected', breaks='measures', also=('leaves', 'sorted')),
    Mutant('listeners_stay', old='for node in [source, *nodes.values()]:', new='''
        who_hears.kept = nodes
        for node in [source, nodes[speaker]] if speaker in nodes else [source]:
        ''', expect='these nodes are left', breaks='leaves'),
    Mutant('nodes_stay', old='''
        for node in [source, *nodes.values()]:
            leave(node)
        ''', new='who_hears.nodes = [source, *nodes.values()]', expect='these nodes are left', breaks='leaves'),
    Mutant('other_name', old="super().__init__('bridge')", new="super().__init__('Bridge')",
           expect='The node is called', breaks='bridge'),
    Mutant('publishes_once', old='''
        while len(heard) < len(nodes) and time.monotonic() < end:
            publisher.publish(String(data='hello'))
        ''', new='''
        publisher.publish(String(data='hello'))
        while len(heard) < len(nodes) and time.monotonic() < end:
        ''', expect='what is published before it is lost', breaks='measures', also=('leaves', 'in-time')),
    Mutant('strips_the_text', old="(String, 'chatter', self.publisher.publish, 10)",
           new="(String, 'chatter', lambda msg: self.publisher.publish(String(data=msg.data.strip())), 10)",
           expect='in the other domain came', breaks='carries'),
    Mutant('waits_to_the_end', old='while len(heard) < len(nodes) and time', new='while time', expect='did not return',
           breaks='in-time'),
    Mutant('wrong_direction', edits=(('.other_side.create_publisher', '.create_publisher'),
            ('self.create_subscription(', 'self.other_side.create_subscription(')),
           expect='does not listen on /chatter', breaks='carries', also=('one-way',)),
    Mutant('absolute_topic', old="self.create_subscription(String, 'chatter',",
           new="self.create_subscription(String, '/chatter',", expect='a relative name has no leading slash',
           breaks='carries'),
    Mutant('absolute_topic_there', old="self.other_side.create_publisher(String, 'chatter',",
           new="self.other_side.create_publisher(String, '/chatter',", expect='a relative name has no leading slash there',
           breaks='carries'),
    Mutant('prints_the_list', old='return sorted(heard)', new='print(sorted(heard))', expect='gives None: return',
           breaks='sorted'),
    Mutant('set_of_domains', old='return sorted(heard)', new='return heard', expect='gives a set', breaks='sorted'),
    Mutant('destroys_nodes_only', old='leave(node)', new='node.destroy_node()', expect='contexts are not shut down',
           breaks='leaves'),
    Mutant('speaker_is_forgotten', old='for node in [source, *nodes.values()]:', new='for node in nodes.values():',
           expect='contexts are not shut down', breaks='leaves'),
    Mutant('tuple_of_domains', old='return sorted(heard)', new='return tuple(sorted(heard))', expect='gives a tuple',
           breaks='sorted'),
    Mutant('one_second_whatever_is_given', old='time.monotonic() + seconds', new='time.monotonic() + min(seconds, 0.8)',
           expect='It is done when all have heard, or after `seconds`', breaks='in-time', also=('measures', 'leaves')),
    Mutant('no_time_unless_it_is_given', old='seconds=3.0', new='seconds=0.0', expect='It is done when all have heard',
           breaks='in-time', also='measures'),
    Mutant('three_seconds_whatever_is_given', old='time.monotonic() + seconds', new='time.monotonic() + 3.0',
           expect='It is done', breaks='in-time'),
    Mutant('one_listener_after_the_other', old="""
        while len(heard) < len(nodes) and time.monotonic() < end:
            publisher.publish(String(data='hello'))
            for node in nodes.values():
                spin_for(0.02, node)
        """, new="""
        for domain, node in nodes.items():
            end = time.monotonic() + seconds
            while domain not in heard and time.monotonic() < end:
                publisher.publish(String(data='hello'))
                spin_for(0.02, node)
        """, expect='all of them listen at the same time', breaks='in-time'),
    Mutant('says_nothing_twice', old="(String, 'chatter', self.publisher.publish, 10)",
           new="(String, 'chatter', lambda msg, said=['']: msg.data == said[-1] or said.append(msg.data) or "
               'self.publisher.publish(msg), 10)', expect='for the second time, and in the other domain came', breaks='carries'),
    Mutant('sorted_as_texts', old='return sorted(heard)', new='return sorted(heard, key=str)', expect='and not as texts',
           breaks='sorted'),
    Mutant('one_far_side', edits=(('self.publisher = self.other_side', 'Bridge.out = self.other_side'),
                                  ('self.publisher.publish, 10', 'lambda msg: Bridge.out.publish(msg), 10')),
           expect='a publisher of its own', breaks='carries'),
    Mutant('fifty_messages', old="self.create_subscription(String, 'chatter', self.publisher.publish, 10)", new="""
        left = list(range(50))
        self.create_subscription(
            String, 'chatter', lambda msg: left and (left.pop(), self.publisher.publish(msg)), 10)
        """, expect='each one, once', breaks='carries'),
    Mutant('long_texts_are_cut', old="(String, 'chatter', self.publisher.publish, 10)",
           new="(String, 'chatter', lambda msg: self.publisher.publish(String(data=msg.data[:100])), 10)",
           expect='unchanged, once and in order', breaks='carries'),
    Mutant('says_so_itself', old="self.create_subscription(String, 'chatter', self.publisher.publish, 10)", new="""
            self.create_subscription(String, 'chatter', self.publisher.publish, 10)
            self.status = self.create_publisher(String, 'chatter', 10)
            self.create_timer(0.5, lambda: self.status.publish(String(data='bridge')))
            """, expect='by itself', breaks='carries', also=('one-way',)),
    Mutant('three_listeners_only', old='for domain, node in nodes.items():', new='for domain, node in list(nodes.items())[:3]:',
           expect='a bridge', breaks='measures'),
    Mutant('listeners_are_not_spun', old='spin_for(0.02, node)', new='time.sleep(0.02)', breaks='measures', also='in-time',
           expect='no callback of its own listener was called'),
    Mutant('as_many_as_a_byte_counts', old="self.create_subscription(String, 'chatter', self.publisher.publish, 10)", new="""
        left = list(range(255))
        self.create_subscription(
            String, 'chatter', lambda msg: left and (left.pop(), self.publisher.publish(msg)), 10)
        """, expect='each one, once', breaks='carries'),
    Mutant('best_effort_there', old="self.other_side.create_publisher(String, 'chatter', 10)",
           new="self.other_side.create_publisher(String, 'chatter', qos_profile_sensor_data)",
           imports='from rclpy.qos import qos_profile_sensor_data', expect='BEST_EFFORT', breaks='carries'),
    Mutant('no_empty_texts', old="(String, 'chatter', self.publisher.publish, 10)",
           new="(String, 'chatter', lambda msg: msg.data and self.publisher.publish(msg), 10)",
           expect="was '', an empty one, and in the other domain came only the ones after it", breaks='carries'),
    Mutant('private_topic_there', old="self.other_side.create_publisher(String, 'chatter',",
           new="self.other_side.create_publisher(String, '~/chatter',", expect='Your node there publishes on',
           breaks='carries'),
]
