# Exercise 4.2: a careful camera
from sensor_msgs.msg import CameraInfo
from sensor_msgs.srv import SetCameraInfo
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy


class Camera(Node):
    def __init__(self):
        super().__init__('camera')
        self.info = None
        self.publisher = self.create_publisher(CameraInfo, 'camera_info', QoSProfile(
            depth=1, reliability=ReliabilityPolicy.RELIABLE, durability=DurabilityPolicy.TRANSIENT_LOCAL))
        self.create_service(SetCameraInfo, 'set_camera_info', self.on_set)

    async def on_set(self, request, response):
        try:
            self.examine(request.camera_info)
        except ValueError as error:
            return SetCameraInfo.Response(success=False, status_message=str(error))
        self.info = request.camera_info
        self.publisher.publish(self.info)
        return SetCameraInfo.Response(success=True)

    @staticmethod
    def examine(info):
        fx, _, cx, _, fy, cy, *_ = info.k
        rules = [('size', info.width * info.height >= 1),
                 ('focal length', min(fx, fy) > 0 and fx < float('inf') > fy and fx == fx and fy == fy),
                 ('principal point', cx >= 0 and cy >= 0 and cx <= info.width and cy <= info.height),
                 ('distortion', (info.distortion_model, len(info.d)) == ('plumb_bob', 5))]
        for word, holds in rules:
            if not holds:
                raise ValueError(word)
