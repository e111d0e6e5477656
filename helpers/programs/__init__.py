"""What runs beside the kernel: child processes, workspaces of ROS packages, the simulated world and staged faults."""
