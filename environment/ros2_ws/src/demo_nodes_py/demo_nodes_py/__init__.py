"""The Python programs that the demos of the official documentation run: `ros2 run demo_nodes_py talker`."""
