"""ROS in a Jupyter kernel: starting it, spinning in the background, waiting, and cleaning up."""
