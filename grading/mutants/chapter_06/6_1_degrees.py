# expect: The tilt was taken for radians
# rejected by: test_camera
# Exercise 6.1: a sensor mast
class SensorMast(Node):
    def __init__(self, height=1.0, tilt=20.0):
        super().__init__('sensor_mast')
        self.broadcaster = StaticTransformBroadcaster(self)
        self.broadcaster.sendTransform([
            transform('base_link', 'mast', x=-0.1, z=0.3),
            transform('mast', 'lidar', z=height, roll=math.pi),
            transform('mast', 'camera', x=0.05, z=height - 0.1, pitch=tilt),
            transform('camera', 'camera_optical', roll=-math.pi / 2, yaw=-math.pi / 2),
        ])
