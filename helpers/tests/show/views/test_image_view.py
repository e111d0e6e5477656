"""Pictures of a topic: the encodings, and the view in its whole life."""

import io

import numpy as np
import pytest
import rclpy
from PIL import Image as Picture
from sensor_msgs.msg import Image

from helpers import wait_for
from helpers.show.views import ImageView
from helpers.show.views.image_view import pixels

RED, GREEN, BLUE = (255, 0, 0), (0, 255, 0), (0, 0, 255)


def image(encoding: str, array, **fields) -> Image:
    array = np.asarray(array)
    step = array[0].nbytes
    return Image(
        **{
            'encoding': encoding,
            'height': array.shape[0],
            'width': array.shape[1],
            'step': step,
            'data': array.tobytes(),
            **fields,
        }
    )


@pytest.mark.parametrize(
    ('message', 'expected'),
    [
        (image('rgb8', np.array([[RED, GREEN]], np.uint8)), [[RED, GREEN]]),
        (image('bgr8', np.array([[BLUE, GREEN]], np.uint8)), [[RED, GREEN]]),
        (image('rgba8', np.array([[(*RED, 9), (*BLUE, 9)]], np.uint8)), [[RED, BLUE]]),
        (image('bgra8', np.array([[(*RED, 9)]], np.uint8)), [[BLUE]]),
        (image('mono8', np.array([[1, 2], [3, 4]], np.uint8)), [[1, 2], [3, 4]]),
        (image('16UC1', np.array([[1000, 3000, 2000]], '<u2')), [[0, 255, 127]]),
        (image('mono16', np.array([[1000, 3000, 2000]], '>u2'), is_bigendian=1), [[0, 255, 127]]),
        (image('32FC1', np.array([[1.0, np.nan, np.inf, 3.0]], '<f4')), [[0, 0, 0, 255]]),
    ],
    ids=lambda value: getattr(value, 'encoding', ''),
)
def test_encodings(message, expected):
    assert pixels(message).tolist() == [[list(p) if isinstance(p, tuple) else p for p in row] for row in expected]


def test_rows_may_be_longer_than_the_picture():
    data = np.array([[1, 2, 99], [3, 4, 99]], np.uint8)
    assert pixels(image('mono8', data, width=2)).tolist() == [[1, 2], [3, 4]]


@pytest.mark.parametrize(
    ('message', 'says'),
    [
        (image('yuv422', np.zeros((1, 4), np.uint8)), "encoding 'yuv422' is not supported; there are rgb8"),
        (image('rgb8', np.zeros((2, 2, 3), np.uint8), height=3), 'are too few for 2 x 3 pixels of rgb8'),
        (image('rgb8', np.zeros((2, 2, 3), np.uint8), width=4), 'too few for 4 x 2 pixels'),
    ],
)
def test_bad_pictures(message, says):
    with pytest.raises(ValueError, match=says):
        pixels(message)


def test_view(ros):
    publisher = rclpy.create_node('camera').create_publisher(Image, '/front/image', 10)
    with ImageView('/front/image', width=100) as view:
        assert view.image is None
        wait_for(publisher.get_subscription_count)
        publisher.publish(image('rgb8', np.full((150, 300, 3), RED, np.uint8)))
        wait_for(lambda: view.image is not None)
        wait_for(lambda: view.status() == '')
    assert repr(view) == '/front/image: 300 x 150 pixels, rgb8'
    content, about = view._repr_mimebundle_()
    assert about == {'image/png': {'width': 100, 'height': 50}}
    shown = Picture.open(io.BytesIO(content['image/png']))
    assert shown.size == (200, 100) and shown.getpixel((0, 0)) == RED
    assert publisher.get_subscription_count() == 0


def test_view_says_what_is_wrong(ros):
    publisher = rclpy.create_node('camera').create_publisher(Image, '/image', 10)
    with ImageView(qos=rclpy.qos.qos_profile_sensor_data) as view, ImageView('/rear') as rear:
        wait_for(lambda: rear.status() == 'no publisher on [/rear]')
        odd = image('bayer_rggb8', np.zeros((2, 2), np.uint8))
        said = "/image: encoding 'bayer_rggb8' is not supported"
        # Nobody sends again what is lost, and the view may find the publisher later than the publisher finds it.
        wait_for(lambda: publisher.publish(odd) or said in view.status())
    assert view._repr_mimebundle_() == {'text/plain': view.status()}
    view.stop()
