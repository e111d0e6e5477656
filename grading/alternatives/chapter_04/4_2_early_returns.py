# Exercise 4.2: a careful camera
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
