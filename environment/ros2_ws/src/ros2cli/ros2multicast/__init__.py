"""UDP multicast between machines; the command is `ros2cli.command.multicast`."""
