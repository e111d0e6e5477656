"""A server that adds two numbers, and its clients, as the C++ demos have them."""

from demo_nodes_py.running import run
from demo_nodes_py.services import (
    IntrospectedClient,
    IntrospectedServer,
    add_two_ints_server,  # noqa: F401 - the same program
)
from demo_nodes_py.services import add_two_ints_client_async as add_two_ints_client  # noqa: F401 - logs as C++ does


def introspection_service(args: list[str] | None = None) -> None:
    """Run a server whose calls can be watched: `ros2 service echo /add_two_ints`."""
    run(IntrospectedServer, args)


def introspection_client(args: list[str] | None = None) -> None:
    """Run a client whose calls can be watched."""
    run(IntrospectedClient, args)
