"""`ImageView`: the pictures of a topic in the output of a cell, live while it runs, the last one afterwards."""

import io

import numpy as np

from helpers.kernel import journal, nodes
from helpers.kernel.spinning import spinning
from helpers.show.views.topic_display import TopicDisplay

RATE = 5.0  # pictures a second, at most
_views: list['ImageView'] = []

# Encoding -> type of a channel, and which channels make red, green, blue (one alone: grey). The names are those of
# sensor_msgs/image_encodings.hpp.
_ENCODINGS = {
    'rgb8': (np.uint8, 3, (0, 1, 2)),
    'rgba8': (np.uint8, 4, (0, 1, 2)),
    'bgr8': (np.uint8, 3, (2, 1, 0)),
    'bgra8': (np.uint8, 4, (2, 1, 0)),
    '8UC3': (np.uint8, 3, (2, 1, 0)),
    'mono8': (np.uint8, 1, (0,)),
    '8UC1': (np.uint8, 1, (0,)),
    'mono16': (np.uint16, 1, (0,)),
    '16UC1': (np.uint16, 1, (0,)),
    '32FC1': (np.float32, 1, (0,)),
}


def pixels(message) -> np.ndarray:
    """Return the picture of a sensor_msgs/Image as height x width x 3 (grey: height x width) of uint8.

    Pictures of 16 bits or of floats (depths) are stretched: the least value is black, the greatest is white; what is
    not a finite number is black.

    :raises ValueError: the encoding is not supported, or the data do not fit the size; one line.
    """
    if message.encoding not in _ENCODINGS:
        raise ValueError(f'encoding {message.encoding!r} is not supported; there are {", ".join(_ENCODINGS)}')
    kind, channels, order = _ENCODINGS[message.encoding]
    kind = np.dtype(kind).newbyteorder('>' if message.is_bigendian else '<')
    width = message.width * channels * kind.itemsize
    if message.step < width or len(message.data) < message.step * message.height:
        raise ValueError(
            f'{len(message.data)} bytes in rows of {message.step} are too few for {message.width} x '
            f'{message.height} pixels of {message.encoding}'
        )
    rows = np.frombuffer(message.data, np.uint8, message.step * message.height).reshape(message.height, message.step)
    values = np.ascontiguousarray(rows[:, :width]).view(kind).reshape(message.height, message.width, channels)
    values = values[:, :, order] if len(order) == 3 else values[:, :, 0]
    return values if kind.itemsize == 1 else _stretched(values)


def _stretched(values: np.ndarray) -> np.ndarray:
    known = np.isfinite(values)
    if not known.any():
        return np.zeros(values.shape, np.uint8)
    least, span = float(values[known].min()), float(np.ptp(values[known])) or 1.0
    return np.where(known, (np.where(known, values, least) - least) / span * 255, 0).astype(np.uint8)


class _Images(TopicDisplay):
    """What is received."""

    def __init__(self, topic: str, qos):
        super().__init__(topic, qos)
        self.message = None

    def message_type(self):
        from sensor_msgs.msg import Image

        return Image

    def take(self, message) -> None:
        self.message = message


class ImageView:
    """Watch the pictures of a topic (sensor_msgs/Image) in the output of this cell.

    ::

        with ImageView('/image') as camera:
            wait_for(lambda: camera.image is not None)

        camera = ImageView('/image')    # goes on after the cell, until stop() or helpers.ros.stop()
        camera.stop()

    It is a node of this process that spins in the background. A view of the same topic in a later cell replaces it.

    :param topic: name of the topic.
    :param width: of the picture in the notebook, in pixels.
    :param qos: QoS or depth; None: as in RViz, reliable.
    :raises RuntimeError: ROS is not started.
    """

    def __init__(self, topic: str = '/image', width: int = 320, qos=None):
        import rclpy

        if not rclpy.ok():
            raise RuntimeError('ROS is not started: run helpers.ros.start() first')
        self._images, self._width = _Images(topic, qos), width
        self._drawn = None  # what the output shows: a message, or a text
        self._problem = ''
        self._output = None
        name = f'_image_view_{topic.strip("/").replace("/", "_")}'
        self._node = rclpy.create_node(name, enable_rosout=False, start_parameter_services=False)
        try:
            self._images.start(self._node, None, None)
        except BaseException:
            nodes.destroy(self._node)
            raise
        self._node.create_timer(1 / RATE, self._update)
        _views.append(self)
        self._show()
        self._spinning = spinning(self._node)

    @property
    def image(self) -> np.ndarray | None:
        """The last picture, height x width x 3 or height x width, uint8; None while there is none.

        :raises ValueError: it cannot be shown; see `pixels`.
        """
        return None if self._images.message is None else pixels(self._images.message)

    def status(self) -> str:
        """Return what is wrong, such as ``no publisher on [/image]``; '' if nothing is."""
        return self._problem

    def stop(self) -> None:
        """Stop watching; the last picture stays. Idempotent."""
        if self not in _views:
            return
        _views.remove(self)
        self._spinning.let_go(self._node)
        if self._node.context.ok():
            self._update()
        self._images.stop()
        nodes.destroy(self._node)

    def __enter__(self) -> 'ImageView':
        return self

    def __exit__(self, kind, error, tb) -> None:
        self.stop()

    def __repr__(self) -> str:
        message = self._images.message
        if self._problem or message is None:
            return self._problem or f'no picture on {self._images.topic} so far'
        return f'{self._images.topic}: {message.width} x {message.height} pixels, {message.encoding}'

    def _repr_mimebundle_(self, include=None, exclude=None):
        if self._problem or self._images.message is None:
            return {'text/plain': repr(self)}
        picture = self.image
        size = {'width': self._width, 'height': round(self._width * picture.shape[0] / picture.shape[1])}
        return {'image/png': png(picture, 2 * self._width), 'text/plain': repr(self)}, {'image/png': size}

    def _update(self) -> None:
        problem, message = self._images.silence(), self._images.message
        if not problem and message is not None:
            try:
                pixels(message)
            except ValueError as error:
                problem = f'{self._images.topic}: {error}'
        self._problem, now = problem, problem or message
        same = now is self._drawn or (isinstance(now, str) and isinstance(self._drawn, str) and now == self._drawn)
        if not same and self._output is not None:
            self._drawn = now
            self._output.update(self)

    def _show(self) -> None:
        if journal.in_kernel():
            from IPython.display import display

            self._output = display(self, display_id=True)


def png(picture: np.ndarray, most: int) -> bytes:
    """Return a picture (uint8, height x width x 3 or height x width) as a PNG file, at most so many pixels wide."""
    from PIL import Image

    file, image = io.BytesIO(), Image.fromarray(np.ascontiguousarray(picture))
    image.thumbnail((most, most))
    image.save(file, 'png')
    return file.getvalue()


def _on_destroy(node) -> None:
    for view in _views.copy():
        if view._node is node:
            view.stop()


nodes.before_destroy.append(_on_destroy)
