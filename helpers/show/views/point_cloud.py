"""The display of a point cloud."""

import numpy as np

from helpers.show.views.shapes import Points
from helpers.show.views.topic_display import StampedDisplay

_PACKED = ('rgb', 'rgba')


class PointCloud2(StampedDisplay):
    """The points of a cloud (sensor_msgs/PointCloud2) with fields x, y, z.

    :param topic: name of the topic.
    :param colour: ``'rgb'`` (the cloud's own colours), the name of a field such as ``'intensity'`` or ``'z'`` (from
        blue for the least value to red for the greatest), or a colour: red, green, blue from 0 to 1. None: its own
        colours if it has any, else its intensity, else z.
    :param size: of a point in m.
    :param most: points that are shown of one cloud; of a larger one so many, by chance.
    :param qos: QoS or depth; None: as in RViz, reliable.
    """

    def __init__(self, topic: str = '/points', colour=None, size: float = 0.02, most: int = 50_000, qos=None):
        super().__init__(topic, qos)
        self.colour, self.size, self.most = colour, size, most
        self._complaint = ''
        self._chosen: tuple = (0, None)  # size of a cloud, and which of its points are shown

    def message_type(self):
        from sensor_msgs.msg import PointCloud2

        return PointCloud2

    def update(self, fixed_frame, time) -> None:
        super().update(fixed_frame, time)
        self.problem = self.problem or self._complaint

    def draw(self, message) -> None:
        self._complaint = ''
        fields = {field.name for field in message.fields}
        if not {'x', 'y', 'z'} <= fields:
            self._complaint = f'the cloud on [{self.topic}] has no fields x, y, z'
            self.scene.set('message', None)
            return
        data = self._read(message)
        points = np.column_stack([data[name] for name in 'xyz']).astype(np.float32, copy=False)
        known = np.isfinite(points).all(axis=1)
        if not known.all():
            points, data = points[known], data[known]
        self.scene.set('message', Points(points, self._colours(data, fields), self.size))

    def _read(self, message) -> np.ndarray:
        """The points as a structured array, thinned out to at most `most`."""
        from sensor_msgs_py import point_cloud2

        data = point_cloud2.read_points(message).reshape(-1)
        if len(data) <= self.most:
            return data
        if self._chosen[0] != len(data):
            self._chosen = len(data), np.random.default_rng(0).permutation(len(data))[: self.most]
        return data[self._chosen[1]]

    def _colours(self, data: np.ndarray, fields: set[str]) -> np.ndarray:
        colour = self.colour
        if colour is None:
            colour = next((name for name in (*_PACKED, 'intensity') if name in fields), 'z')
        if not isinstance(colour, str):
            return np.array(colour, dtype=np.float32)
        if colour in _PACKED:
            packed = next((name for name in _PACKED if name in fields), None)
            if packed is not None:
                return _unpacked(data[packed])
        if colour not in fields:
            self._complaint = f'the cloud on [{self.topic}] has no field {colour!r}; it has {", ".join(sorted(fields))}'
            colour = 'z'
        return _rainbow(data[colour])


def _unpacked(packed: np.ndarray) -> np.ndarray:
    """Colours of three bytes, 0xRRGGBB in a float32 or uint32, as N x 3."""
    numbers = np.ascontiguousarray(packed).view(np.uint32)
    return np.column_stack([(numbers >> shift) & 255 for shift in (16, 8, 0)]).astype(np.float32) / 255


def _rainbow(values: np.ndarray) -> np.ndarray:
    """Colours from blue for the least value to red for the greatest, as N x 3."""
    values = np.asarray(values, dtype=np.float32)
    known = values[np.isfinite(values)]
    if len(known) == 0:
        return np.zeros((1, 3), dtype=np.float32)
    least, span = known.min(), float(np.ptp(known)) or 1.0
    # As in RViz: blue, cyan, green, yellow, red, each a quarter of the way from the one before.
    way = 4 * np.nan_to_num(np.clip((values - least) / span, 0, 1))
    colours = np.column_stack((way - 2, np.minimum(way, 4 - way), 2 - way))
    return 0.85 * np.clip(colours, 0, 1)
