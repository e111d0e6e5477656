# Exercise 6.4: a scan on the map
class ScanToMap(Node):
    """A timer tries again; after a second a scan is given up."""

    def __init__(self):
        super().__init__('scan_to_map')
        self.buffer, self.pending = Buffer(), []
        self.listener = TransformListener(self.buffer, self)
        self.publisher = self.create_publisher(PointCloud2, 'points', 10)
        self.create_subscription(LaserScan, 'scan', self.pending.append, 10)
        self.create_timer(0.02, self.work)

    def work(self):
        now = self.get_clock().now()
        waiting = []
        for scan in self.pending:
            when = Time.from_msg(scan.header.stamp, clock_type=self.get_clock().clock_type)
            if self.buffer.can_transform('map', scan.header.frame_id, when):
                self.send(scan, self.buffer.lookup_transform('map', scan.header.frame_id, when))
            elif now - when < Duration(seconds=1.0):
                waiting.append(scan)
        self.pending[:] = waiting

    def send(self, scan, laser_in_map):
        ranges = np.array(scan.ranges)
        angles = scan.angle_min + scan.angle_increment * np.arange(len(ranges))
        good = np.isfinite(ranges) & (ranges >= scan.range_min) & (ranges <= scan.range_max)
        points = np.column_stack([ranges * np.cos(angles), ranges * np.sin(angles), 0 * ranges])[good]
        self.publisher.publish(do_transform_cloud(create_cloud_xyz32(scan.header, points), laser_in_map))
