from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('early_returns', source='''
import math

import sensor_msgs.msg as msg
import sensor_msgs.srv as srv
from rclpy.qos import QoSDurabilityPolicy, QoSProfile


class Camera(rclpy.node.Node):
    def __init__(self):
        super().__init__('camera')
        qos = QoSProfile(depth=1)
        qos.durability = QoSDurabilityPolicy.TRANSIENT_LOCAL
        self.pub = self.create_publisher(msg.CameraInfo, 'camera_info', qos)
        self.srv = self.create_service(srv.SetCameraInfo, 'set_camera_info', self.set)

    def set(self, request, response):
        problem = self.problem(request.camera_info)
        if problem:
            response.status_message = problem
            return response
        self.pub.publish(request.camera_info)
        response.success = True
        return response

    def problem(self, info):
        if info.width < 1 or info.height < 1:
            return 'size'
        for f in (info.k[0], info.k[4]):
            if not math.isfinite(f) or f <= 0:
                return 'focal length'
        for c, most in ((info.k[2], info.width), (info.k[5], info.height)):
            if math.isnan(c) or c < 0 or c > most:
                return 'principal point'
        if info.distortion_model != 'plumb_bob' or len(info.d) != 5:
            return 'distortion'
        return None
'''),
    Alternative('new_response', source='''
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
'''),
]
