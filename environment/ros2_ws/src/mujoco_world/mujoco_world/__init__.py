"""A world with a robot in it: MuJoCo's physics, without ROS in `world`, as a ROS node in `node`."""

import os

# Before MuJoCo is imported: a camera needs OpenGL without a screen.
os.environ.setdefault('MUJOCO_GL', 'egl')
