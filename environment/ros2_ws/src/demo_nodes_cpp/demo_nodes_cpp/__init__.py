"""In Python: programs of demo_nodes_cpp that the official tutorials run, such as `ros2 run demo_nodes_cpp talker`."""
