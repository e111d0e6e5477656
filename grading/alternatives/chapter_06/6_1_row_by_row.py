# Exercise 6.1: a sensor mast
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
