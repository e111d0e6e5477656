from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('one_by_one', source='''
class SensorMast(Node):
    """One broadcaster for each frame, and quaternions by hand."""

    def __init__(self, height=1.0, tilt=20.0):
        super().__init__('sensor_mast')
        half = math.radians(tilt) / 2
        self.send('base_link', 'mast', (-0.1, 0.0, 0.3), (0.0, 0.0, 0.0, 1.0))
        self.send('mast', 'lidar', (0.0, 0.0, height), (1.0, 0.0, 0.0, 0.0))
        self.send('mast', 'camera', (0.05, 0.0, height - 0.1), (0.0, math.sin(half), 0.0, math.cos(half)))
        self.send('camera', 'camera_optical', (0.0, 0.0, 0.0), (-0.5, 0.5, -0.5, 0.5))

    def send(self, parent, child, place, turn):
        message = TransformStamped(child_frame_id=child)
        message.header.frame_id = parent
        message.header.stamp = self.get_clock().now().to_msg()
        (message.transform.translation.x, message.transform.translation.y, message.transform.translation.z) = place
        x, y, z, w = turn
        message.transform.rotation = Quaternion(x=x, y=y, z=z, w=w)
        StaticTransformBroadcaster(self).sendTransform(message)
'''),
    Alternative('row_by_row', source='''
class SensorMast(Node):
    """One broadcaster, one call for each row of the table; it repeats all that it has sent before."""

    def __init__(self, height=1.0, tilt=20.0):
        super().__init__('sensor_mast')
        quarter = math.pi / 2
        rows = [
            ('base_link', 'mast', dict(x=-0.1, z=0.3)),
            ('mast', 'lidar', dict(z=height, roll=-math.pi)),
            ('mast', 'camera', dict(x=0.05, z=height - 0.1, pitch=tilt / 180 * math.pi)),
            ('camera', 'camera_optical', dict(roll=-quarter, yaw=-quarter)),
        ]
        broadcaster = StaticTransformBroadcaster(self)
        for parent, child, numbers in rows:
            broadcaster.sendTransform(transform(parent, child, **numbers))
'''),
]
