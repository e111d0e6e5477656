from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('awaits', source='''
from rclpy.callback_groups import ReentrantCallbackGroup
from std_msgs.msg import Header
from tf_transformations import euler_matrix


class ScanToMap(Node):
    """A coroutine for each scan; in a reentrant group, so that several may wait."""

    def __init__(self):
        super().__init__('scan_to_map')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.publisher = self.create_publisher(PointCloud2, 'points', 10)
        self.create_subscription(LaserScan, 'scan', self.on_scan, 10, callback_group=ReentrantCallbackGroup())

    async def on_scan(self, scan):
        when = Time.from_msg(scan.header.stamp)
        found = await self.buffer.lookup_transform_async('map', scan.header.frame_id, when)
        place, turn = found.transform.translation, found.transform.rotation
        roll, pitch, yaw = euler_from_quaternion([turn.x, turn.y, turn.z, turn.w])
        matrix = euler_matrix(roll, pitch, yaw)
        points, angle = [], scan.angle_min
        for distance in scan.ranges:
            if not math.isnan(distance) and not distance < scan.range_min and not distance > scan.range_max:
                x, y, z, _ = matrix @ (distance * math.cos(angle), distance * math.sin(angle), 0.0, 1.0)
                points.append((x + place.x, y + place.y, z + place.z))
            angle += scan.angle_increment
        header = Header(frame_id='map', stamp=scan.header.stamp)
        self.publisher.publish(create_cloud_xyz32(header, points))
'''),
    Alternative('tries_again', source='''
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
'''),
]
