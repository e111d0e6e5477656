"""Seeing a robot in 3-D in a notebook: frames, robot, scans; live while it runs, a picture afterwards.

A *display* (named after RViz's) turns topics into shapes: `display.Display` is their base class. It writes them into a
*scene* (`scene.Scene`), which knows neither ROS nor a browser. Two renderers show a scene: `live` in meshcat's viewer,
`picture` as an SVG for the saved notebook. `TfView` puts it all into the output of a cell::

    with TfView(RobotModel(), LaserScan('/scan'), fixed_frame='odom') as view:
        …

Displays, each with the topic that it shows unless another is given: `RobotModel` (``/robot_description``), `LaserScan`
(``/scan``), `PointCloud2` (``/points``), `Odometry` (``/odom``), `Marker` (``/visualization_marker``), `MarkerArray`
(``/visualization_marker_array``), `Text`. Their `status`, which is also in ``view.problems``, says why nothing is seen.
Beside the scene, `ImageView` (``/image``) shows a camera's pictures.

Units are metres and radians; colours are (red, green, blue) from 0 to 1; axes are x red, y green, z blue.
"""

import importlib

# Public name -> module that defines it.
_HOME = {
    'Display': 'display',
    'ImageView': 'image_view',
    'LaserScan': 'laser_scan',
    'Marker': 'marker',
    'MarkerArray': 'marker',
    'Odometry': 'odometry',
    'PointCloud2': 'point_cloud',
    'RobotModel': 'robot_model',
    'Text': 'text_display',
    'TfView': 'tf_view',
    'show_frames': 'frames_diagram',
}

__all__ = sorted(_HOME)


def __getattr__(name):
    if name not in _HOME:
        raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    return getattr(importlib.import_module(f'{__name__}.{_HOME[name]}'), name)


def __dir__():
    return sorted({*globals(), *_HOME})
