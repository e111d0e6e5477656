"""The node that a command takes part in the graph with."""

# Hidden, as every name that begins with an underscore: `ros2 node list` leaves it out.
NODE_NAME_PREFIX = '_ros2cli'
