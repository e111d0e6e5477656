# expect: This is the newest transform
# rejected by: test_time_of_the_scan
# Exercise 6.4: a scan on the map
class ScanToMap(Node):
    def __init__(self):
        super().__init__('scan_to_map')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.publisher = self.create_publisher(PointCloud2, 'points', 10)
        self.create_subscription(LaserScan, 'scan', self.on_scan, 10)

    def on_scan(self, scan):
        points = []
        for number, distance in enumerate(scan.ranges):
            angle = scan.angle_min + number * scan.angle_increment
            if scan.range_min <= distance <= scan.range_max:
                points.append((distance * math.cos(angle), distance * math.sin(angle), 0.0))
        cloud = create_cloud_xyz32(scan.header, points)
        when = Time()
        future = self.buffer.wait_for_transform_async('map', scan.header.frame_id, when)
        future.add_done_callback(lambda future: self.publish(cloud, future.result()))

    def publish(self, cloud, laser_in_map):
        self.publisher.publish(do_transform_cloud(cloud, laser_in_map))
