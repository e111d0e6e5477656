from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('ask_rclpy', edits=(('''
            def why_no_data(offered, requested):
                strength = {'BEST_EFFORT': 0, 'RELIABLE': 1, 'VOLATILE': 0, 'TRANSIENT_LOCAL': 1}
                reasons = [key for key in ('topic', 'type') if offered[key] != requested[key]]
                reasons += [key for key in ('reliability', 'durability') if strength[offered[key]] < strength[requested[key]]]
                if (offered['deadline'] or float('inf')) > (requested['deadline'] or float('inf')):
                    reasons.append('deadline')
                return reasons
            ''', '''
            def policy_fits(key, offered, requested):
                enum = {'reliability': ReliabilityPolicy, 'durability': DurabilityPolicy}[key]
                profiles = [QoSProfile(depth=1, **{key: enum[side[key]]}) for side in (offered, requested)]
                return qos_check_compatible(*profiles)[0] != QoSCompatibility.ERROR


            def why_no_data(offered, requested):
                period = lambda side: side['deadline'] if side['deadline'] > 0 else math.inf
                checks = {
                    'topic': offered['topic'] == requested['topic'],
                    'type': offered['type'] == requested['type'],
                    'reliability': policy_fits('reliability', offered, requested),
                    'durability': policy_fits('durability', offered, requested),
                    'deadline': period(offered) <= period(requested),
                }
                return [key for key, fits in checks.items() if not fits]
            '''),
            ('''
            command = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
            self.publisher = self.create_publisher(Bool, 'stop', command)
            self.subscription = self.create_subscription(LaserScan, 'scan', self.on_scan, sensor)
            ''', '''
            latched = QoSProfile(depth=1, reliability=ReliabilityPolicy.RELIABLE,
                                 durability=DurabilityPolicy.TRANSIENT_LOCAL)
            lidar = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
            self.publisher = self.create_publisher(Bool, 'stop', latched)
            self.subscription = self.create_subscription(LaserScan, 'scan', self.on_scan, lidar)
            '''),
            ('any(distance < 0.5 for distance in scan.ranges)', 'min(scan.ranges, default=math.inf) < 0.5')),
                imports='''
        import math
        from rclpy.qos import QoSCompatibility, QoSProfile, qos_check_compatible
        '''),
    Alternative('plain_ifs', edits=(('''
            strength = {'BEST_EFFORT': 0, 'RELIABLE': 1, 'VOLATILE': 0, 'TRANSIENT_LOCAL': 1}
            reasons = [key for key in ('topic', 'type') if offered[key] != requested[key]]
            reasons += [key for key in ('reliability', 'durability') if strength[offered[key]] < strength[requested[key]]]
            if (offered['deadline'] or float('inf')) > (requested['deadline'] or float('inf')):
                reasons.append('deadline')
            return reasons
            ''', '''
            result = []
            if offered['topic'] != requested['topic']:
                result += ['topic']
            if offered['type'] != requested['type']:
                result += ['type']
            if requested['reliability'] == 'RELIABLE' and offered['reliability'] == 'BEST_EFFORT':
                result += ['reliability']
            if requested['durability'] == 'TRANSIENT_LOCAL' and offered['durability'] == 'VOLATILE':
                result += ['durability']
            if requested['deadline'] != 0 and (offered['deadline'] == 0 or offered['deadline'] > requested['deadline']):
                result += ['deadline']
            return result
            '''),
            ('''
            super().__init__('safety_stop')
            command = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
            self.publisher = self.create_publisher(Bool, 'stop', command)
            self.subscription = self.create_subscription(LaserScan, 'scan', self.on_scan, sensor)
            ''', '''
            Node.__init__(self, 'safety_stop')
            keep = QoSProfile(depth=1)
            keep.durability = DurabilityPolicy.TRANSIENT_LOCAL
            self.stop = self.create_publisher(Bool, 'stop', qos_profile=keep)
            self.create_subscription(LaserScan, 'scan', callback=self.on_scan, qos_profile=qos_profile_sensor_data)
            '''),
            ('self.publisher.publish(Bool(data=any(distance < 0.5 for distance in scan.ranges)))', '''
            near = [distance for distance in scan.ranges if distance < 0.5]
            self.stop.publish(Bool(data=bool(near)))
            ''')), imports='from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data'),
]
