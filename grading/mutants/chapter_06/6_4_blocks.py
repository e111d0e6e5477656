# expect: A look-up that gives up, or that blocks
# rejected by: test_transform_comes_later
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
        when = Time.from_msg(scan.header.stamp)
        try:
            timeout = Duration(seconds=0.3)
            self.publish(cloud, self.buffer.lookup_transform('map', scan.header.frame_id, when, timeout))
        except TransformException as error:
            self.get_logger().warning(str(error))

    def publish(self, cloud, laser_in_map):
        self.publisher.publish(do_transform_cloud(cloud, laser_in_map))
