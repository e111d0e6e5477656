"""Containers and their components; the command is `ros2cli.command.component`."""
