"""
The turtle simulator.

``world`` is the simulation, ``canvas`` the paper the turtles draw on, ``svg`` and ``window`` show it: none of
these imports ROS. ``simulator``, ``teleop``, ``draw_square`` and ``mimic`` are the nodes. The interfaces live
in the Python package ``turtlesim``.
"""
