# Exercise 6.4: a scan on the map
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
