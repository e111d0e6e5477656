"""Visible tests of exercise 4.2, a careful camera."""

import pytest
from rclpy.qos import DurabilityPolicy, QoSProfile
from sensor_msgs.msg import CameraInfo
from sensor_msgs.srv import SetCameraInfo

from helpers.runner import expect

pytestmark = pytest.mark.exercise('4.2')

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
GOOD = {'width': 640, 'height': 480, 'distortion_model': 'plumb_bob', 'd': [0.1, -0.2, 0.0, 0.0, 0.05],
        'k': [500.0, 0.0, 320.0, 0.0, 510.0, 240.0, 0.0, 0.0, 1.0]}


def test_good_calibration(learner):
    """A good calibration is accepted, and published once on camera_info.

    Set success, and publish request.camera_info as it came.
    """
    heard = learner.listen('/camera_info', CameraInfo, LATCHED)
    learner.start('Camera')
    answer = learner.client('/set_camera_info', SetCameraInfo).call(camera_info=CameraInfo(**GOOD))
    expect(answer.success, f'A good calibration was refused with {answer.status_message!r}.')
    expect(answer.status_message == '', f'A good calibration got the message {answer.status_message!r}, expected none.')
    expect(heard.messages, 'The calibration was accepted, and nothing was published on /camera_info.')
    expect(heard.messages == [CameraInfo(**GOOD)], 'What was published on /camera_info is not the calibration as it '
                                                   'came, once.')


def test_width_zero(learner):
    """A width of 0 is refused with the word size.

    Set success to False and status_message to the word, and return the response.
    """
    learner.start('Camera')
    answer = learner.client('/set_camera_info', SetCameraInfo).call(camera_info=CameraInfo(**GOOD | {'width': 0}))
    expect(not answer.success, 'A calibration with the width 0 was accepted.')
    expect(answer.status_message == 'size', f"The width 0 gave {answer.status_message!r}, expected 'size'.")
