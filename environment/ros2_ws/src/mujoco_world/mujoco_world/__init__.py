"""A world with a robot in it: MuJoCo's physics, without ROS in `world`, as a ROS node in `node`."""

import ctypes
import os


def _opengl() -> str:
    """How MuJoCo is to make pictures. It reads this when it is imported, and fails there if what it wants is absent."""
    try:
        ctypes.CDLL('libEGL.so.1')  # OpenGL without a screen
    except OSError:
        return 'disable'
    return 'egl'


if 'MUJOCO_GL' not in os.environ:
    os.environ['MUJOCO_GL'] = _opengl()
