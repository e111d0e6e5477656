# expect: A focal length must be finite
# rejected by: test_numbers_that_are_none
# Exercise 4.2: a careful camera
from math import inf
from rclpy.qos import DurabilityPolicy, QoSProfile
from sensor_msgs.msg import CameraInfo
from sensor_msgs.srv import SetCameraInfo


class Camera(Node):
    def __init__(self):
        super().__init__('camera')
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.publisher = self.create_publisher(CameraInfo, 'camera_info', latched)
        self.create_service(SetCameraInfo, 'set_camera_info', self.on_set)

    def on_set(self, request, response):
        info, k = request.camera_info, request.camera_info.k
        fine = {'size': info.width > 0 and info.height > 0,
                'focal length': 0 < k[0] and 0 < k[4],
                'principal point': 0 <= k[2] <= info.width and 0 <= k[5] <= info.height,
                'distortion': info.distortion_model == 'plumb_bob' and len(info.d) == 5}
        response.status_message = next((word for word in fine if not fine[word]), '')
        response.success = not response.status_message
        if response.success:
            self.publisher.publish(info)
        return response
