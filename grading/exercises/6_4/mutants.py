from grading.variants import Mutant

SCANS = 'test_scans'

MUTANTS = [
    Mutant('always_laser', breaks='frame', also=('one-cloud', 'later', 'hopeless', 'range'), seen_by=SCANS,
           old='scan.header.frame_id', new="'laser'", expect='not of the frame in the header of the scan',
           rejected_by='test_hits'),
    Mutant('blocks', breaks='later', also=('hopeless',), seen_by=SCANS, old='''
        future = self.buffer.wait_for_transform_async('map', scan.header.frame_id, when)
        future.add_done_callback(lambda future: self.publish(cloud, future.result()))
        ''', new='''
        try:
            timeout = Duration(seconds=0.3)
            self.publish(cloud, self.buffer.lookup_transform('map', scan.header.frame_id, when, timeout))
        except TransformException as error:
            self.get_logger().warning(str(error))
        ''', expect='do not block', rejected_by='test_transform_comes_later'),
    Mutant('counts_hits', breaks='place', seen_by=SCANS,
           old='scan.ranges', new='r for r in scan.ranges if scan.range_min <= r <= scan.range_max',
           expect='The first hit of the scan', rejected_by='test_no_hits'),
    Mutant('gives_up', breaks='later', also=('hopeless',), seen_by=SCANS, old='''
        future = self.buffer.wait_for_transform_async('map', scan.header.frame_id, when)
        future.add_done_callback(lambda future: self.publish(cloud, future.result()))
        ''', new='''
        try:
            self.publish(cloud, self.buffer.lookup_transform('map', scan.header.frame_id, when))
        except TransformException as error:
            self.get_logger().warning(str(error))
        ''', expect='do not block', rejected_by='test_transform_comes_later'),
    Mutant('in_a_row', breaks='hopeless', seen_by=SCANS, edits=(('def on_scan', 'async def on_scan'),
            ('''
            future = self.buffer.wait_for_transform_async('map', scan.header.frame_id, when)
            future.add_done_callback(lambda future: self.publish(cloud, future.result()))
            ''', "self.publish(cloud, await self.buffer.wait_for_transform_async('map', scan.header.frame_id, when))")),
           expect='it waits behind the others', rejected_by='test_hopeless'),
    Mutant('keeps_all', breaks='range', seen_by=SCANS, old='''
        if scan.range_min <= distance <= scan.range_max:
            points.append((distance * math.cos(angle), distance * math.sin(angle), 0.0))
        ''', new='points.append((distance * math.cos(angle), distance * math.sin(angle), 0.0))',
           expect='gave a cloud of 12 points', rejected_by='test_no_hits'),
    Mutant('newest', breaks='time', also=('hopeless', 'place', 'later'), seen_by=SCANS,
           old='when = Time.from_msg(scan.header.stamp)', new='when = Time()',
           expect='This is the newest transform', rejected_by='test_time_of_the_scan'),
    Mutant('only_the_name', breaks='place', seen_by=SCANS,
           old='self.publisher.publish(do_transform_cloud(cloud, laser_in_map))', new='''
        cloud.header.frame_id = 'map'
        self.publisher.publish(cloud)
        ''', expect='only the name of the frame has changed', rejected_by='test_hits'),
    Mutant('stamp_of_now', breaks='stamp', seen_by=SCANS, old='''
        cloud = create_cloud_xyz32(scan.header, points)
        when = Time.from_msg(scan.header.stamp)
        ''', new='''
        scan.header.stamp, measured = self.get_clock().now().to_msg(), scan.header.stamp
        cloud = create_cloud_xyz32(scan.header, points)
        when = Time.from_msg(measured)
        ''', expect='A stamp says when it was measured', rejected_by='test_hits'),
    Mutant('swapped', breaks='place', seen_by=SCANS,
           edits=(("'map', scan.header.frame_id", "scan.header.frame_id, 'map'"),
            ('def publish(self, cloud, laser_in_map):', '''
            def publish(self, cloud, laser_in_map):
                laser_in_map.header.frame_id = 'map'
            ''')), expect='target and source are swapped', rejected_by='test_hits'),
    Mutant('base_link', breaks='frame', seen_by=SCANS,
           old='scan.header.frame_id',
           new="'base_link'", expect='not of the frame in the header of the scan', rejected_by='test_hits'),
    Mutant('own_limits', breaks='range', seen_by=SCANS, old='scan.range_min <= distance <= scan.range_max',
           new='0.1 <= distance <= 12.0', expect='gave a cloud of', rejected_by='test_limits'),
    Mutant('limits_left_out', breaks='range', seen_by=SCANS, old='scan.range_min <= distance <= scan.range_max',
           new='scan.range_min < distance < scan.range_max', expect='gave a cloud of', rejected_by='test_limits'),
    Mutant('only_inf', breaks='range', seen_by=SCANS, old='scan.range_min <= distance <= scan.range_max',
           new='math.isfinite(distance)', expect='gave a cloud of', rejected_by='test_no_hits'),
    Mutant('backwards', breaks='order', also=('range',), seen_by=SCANS, old='points.append((', new='points.insert(0, (',
           expect='their order is not that of the scan', rejected_by='test_hits'),
    Mutant('to_the_right', breaks='place', also=('time', 'later', 'range', 'hopeless'), seen_by=SCANS,
           old='scan.angle_min + number', new='scan.angle_min - number',
           expect='The first hit of the scan', rejected_by='test_hits'),
    Mutant('from_zero', breaks='place', also=('time', 'later', 'range', 'hopeless'), seen_by=SCANS,
           old='scan.angle_min + number', new='number', expect='The first hit of the scan', rejected_by='test_hits'),
    Mutant('one_per_hit', breaks='one-cloud', also=('range', 'time', 'later', 'hopeless'), seen_by=SCANS,
           old='self.publisher.publish(do_transform_cloud(cloud, laser_in_map))', new="""
        for _ in range(2):
            self.publisher.publish(do_transform_cloud(cloud, laser_in_map))
        """, expect='expected one', rejected_by='test_hits'),
    Mutant('other_name', breaks='name', seen_by=SCANS, old="'scan_to_map'", new="'scan2map'",
           expect='Your node is called', rejected_by='test_hits'),
    Mutant('other_topic', breaks='topics', also=('one-cloud', 'later', 'hopeless', 'range'), seen_by=SCANS,
           old="'points'", new="'cloud'",
           expect='has no publisher on /points', rejected_by='test_hits'),
    Mutant('only_the_last_waits', breaks='later', also=('hopeless',), seen_by=SCANS, edits=(
           ('when = Time.from_msg(scan.header.stamp)', """
           self.last = cloud
           when = Time.from_msg(scan.header.stamp)
           """), ('lambda future: self.publish(cloud, future.result())',
                  'lambda future: cloud is self.last and self.publish(cloud, future.result())')),
           expect='each scan waits for its own transform', rejected_by='test_several_wait'),
    Mutant('whole_seconds', breaks='time', also=('later', 'hopeless', 'one-cloud', 'frame'), seen_by=SCANS,
           old='Time.from_msg(scan.header.stamp)', new='Time(seconds=scan.header.stamp.sec)',
           expect='count the nanoseconds, too', rejected_by='test_time_of_the_scan'),
]
