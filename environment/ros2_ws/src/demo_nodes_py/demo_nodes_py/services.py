"""A server that adds two numbers, its clients, and both with introspection of the service."""

import rclpy
from example_interfaces.srv import AddTwoInts
from node_program.running import ros, run
from rcl_interfaces.msg import SetParametersResult
from rclpy.client import Client
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_system_default
from rclpy.service import Service
from rclpy.service_introspection import ServiceIntrospectionState
from rclpy.task import Future

from .waiting import wait_for

SERVICE = 'add_two_ints'
REQUEST = AddTwoInts.Request(a=2, b=3)
STATES = {
    'disabled': ServiceIntrospectionState.OFF,
    'metadata': ServiceIntrospectionState.METADATA,
    'contents': ServiceIntrospectionState.CONTENTS,
}


class Server(Node):
    """Adds two numbers."""

    def __init__(self, name: str = 'add_two_ints_server') -> None:
        """Offer the service."""
        super().__init__(name)
        self.service = self.create_service(AddTwoInts, SERVICE, self._add)

    def _add(self, request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        response.sum = request.a + request.b
        self.get_logger().info(f'Incoming request\na: {request.a} b: {request.b}')
        return response


class IntrospectedServer(Server):
    """The server, with a parameter for what is published of its calls."""

    def __init__(self) -> None:
        """Offer the service."""
        super().__init__('introspection_service')
        _follow_parameter(self, 'service_configure_introspection', self.service)


class IntrospectedClient(Node):
    """Calls the server twice a second, with a parameter for what is published of the calls."""

    def __init__(self) -> None:
        """Begin to call."""
        super().__init__('introspection_client')
        self._client = self.create_client(AddTwoInts, SERVICE)
        _follow_parameter(self, 'client_configure_introspection', self._client)
        self._future: Future | None = None
        self._timer = self.create_timer(0.5, self._look)

    def _look(self) -> None:
        if not self._client.service_is_ready():
            return
        if self._future is None:
            self._future = self._client.call_async(REQUEST)
        elif self._future.done():
            _tell_result(self, self._future)
            self._future = None


def _follow_parameter(node: Node, name: str, endpoint: Client | Service) -> None:
    """Declare a parameter whose value says what a client or a server publishes of its calls."""

    def check(parameters: list[Parameter]) -> SetParametersResult:
        for each in parameters:
            if each.name == name and each.type_ != Parameter.Type.STRING:
                return SetParametersResult(successful=False, reason='must be a string')
            if each.name == name and each.value not in STATES:
                return SetParametersResult(successful=False, reason="must be one of 'disabled', 'metadata', 'contents'")
        return SetParametersResult(successful=True)

    def configure(parameters: list[Parameter]) -> None:
        for each in parameters:
            if each.name == name:
                endpoint.configure_introspection(node.get_clock(), qos_profile_system_default, STATES[each.value])

    node.add_on_set_parameters_callback(check)
    node.add_post_set_parameters_callback(configure)
    node.declare_parameter(name, 'disabled')


def _tell_result(node: Node, future: Future) -> None:
    if future.exception() is None:
        node.get_logger().info(f'Result of add_two_ints: {future.result().sum}')
    else:
        node.get_logger().error(f'Exception while calling service: {future.exception()!r}')


def add_two_ints_server(args: list[str] | None = None) -> None:
    """Run the server."""
    run(Server, args)


def add_two_ints_client(args: list[str] | None = None) -> None:
    """Call the server once, and wait for the answer."""
    with ros(args):
        node = rclpy.create_node('add_two_ints_client')
        client = node.create_client(AddTwoInts, SERVICE)
        wait_for(client, print)
        future = client.call_async(REQUEST)
        rclpy.spin_until_future_complete(node, future)
        if future.done():  # not, if a signal has ended the waiting
            _tell_result(node, future)


def add_two_ints_client_async(args: list[str] | None = None) -> None:
    """Call the server once, and go on with other work until the answer is there."""
    with ros(args):
        node = rclpy.create_node('add_two_ints_client')
        client = node.create_client(AddTwoInts, SERVICE)
        wait_for(client, node.get_logger().info)
        future = client.call_async(REQUEST)
        while not future.done():
            rclpy.spin_once(node)  # other work would stand here
        _tell_result(node, future)


def introspection(args: list[str] | None = None) -> None:
    """Run a server and a client whose calls can be watched: `ros2 service echo /add_two_ints`."""
    with ros(args):
        executor = SingleThreadedExecutor()
        for node in (IntrospectedServer(), IntrospectedClient()):
            executor.add_node(node)
        executor.spin()
