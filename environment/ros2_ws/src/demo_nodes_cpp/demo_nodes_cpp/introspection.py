"""A server that adds two numbers, and its client, each in a program of its own; `ros2 service echo` shows the calls."""

from demo_nodes_py.services import IntrospectedClient, IntrospectedServer
from node_program.running import run


def service(args: list[str] | None = None) -> None:
    """Run the server."""
    run(IntrospectedServer, args)


def client(args: list[str] | None = None) -> None:
    """Run the client."""
    run(IntrospectedClient, args)
