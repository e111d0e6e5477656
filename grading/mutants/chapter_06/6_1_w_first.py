# expect: In which order does a Quaternion have x, y, z and w?
# rejected by: test_lidar
# Exercise 6.1: a sensor mast
def placed(parent, child, roll=0.0, pitch=0.0, yaw=0.0, **place):
    message = transform(parent, child, **place)
    x, y, z, w = map(float, quaternion_from_euler(roll, pitch, yaw))
    message.transform.rotation = Quaternion(x=w, y=x, z=y, w=z)
    return message


class SensorMast(Node):
    def __init__(self, height=1.0, tilt=20.0):
        super().__init__('sensor_mast')
        self.broadcaster = StaticTransformBroadcaster(self)
        self.broadcaster.sendTransform([
            placed('base_link', 'mast', x=-0.1, z=0.3),
            placed('mast', 'lidar', z=height, roll=math.pi),
            placed('mast', 'camera', x=0.05, z=height - 0.1, pitch=math.radians(tilt)),
            placed('camera', 'camera_optical', roll=-math.pi / 2, yaw=-math.pi / 2),
        ])
