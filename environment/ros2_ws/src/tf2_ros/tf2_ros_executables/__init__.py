"""The programs of the ROS package `tf2_ros`; the Python module `tf2_ros` is in the package `tf2_ros_py`."""
