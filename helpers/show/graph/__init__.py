"""The ROS graph as a picture in a notebook: what rqt_graph shows, with QoS and with what does not fit, in red.

`show_graph()` is a still picture, `GraphView()` a live one. `model` and `links` hold what is known, `reading`
asks rclpy for it, `problems` says what does not fit, `placement` places boxes, `drawing` draws.
"""

from helpers.show.graph.view import GraphView, show_graph

__all__ = ['GraphView', 'show_graph']
