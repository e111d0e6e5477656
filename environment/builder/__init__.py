"""Runs colcon so that building the course's ROS packages does not start hundreds of Python interpreters.

Runs inside of `.venv`. colcon itself decides what is built and what is installed; see `__main__`.
"""
