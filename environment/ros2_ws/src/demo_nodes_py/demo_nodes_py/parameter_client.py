"""A client that sets, lists, reads, loads and deletes the parameters of another node."""

from pathlib import Path

import rclpy
from ament_index_python.packages import get_package_share_directory
from node_program.running import ros
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.parameter import Parameter, parameter_dict_from_yaml_file, parameter_value_to_python
from rclpy.parameter_client import AsyncParameterClient
from rclpy.task import Future

SERVER = 'parameter_blackboard'
SET = [
    Parameter('int_parameter', Parameter.Type.INTEGER, 10),
    Parameter('bool_parameter', Parameter.Type.BOOL, False),
    Parameter('string_parameter', Parameter.Type.STRING, 'Fee Fi Fo Fum'),
]
DELETED = ['other_int_parameter', 'other_string_parameter', 'string_parameter']


class ParameterClient(Node):
    """Tells what each request to the server did."""

    def __init__(self) -> None:
        """Wait for the server's services, at most 3 s."""
        super().__init__('async_param_client')
        self._client = AsyncParameterClient(self, SERVER)
        if not self._client.wait_for_services(3.0):
            if not self.context.ok():
                raise ExternalShutdownException
            raise RuntimeError(
                f'{SERVER} is not available, start parameter blackboard with '
                f'`ros2 run demo_nodes_cpp {SERVER}` before running this demo'
            )

    def demonstrate(self) -> None:
        """Make one request after the other."""
        names = [parameter.name for parameter in SET]
        self._say('Setting parameters:')
        self._say_results(names, self._result(self._client.set_parameters(SET)).results)
        self._say('Listing Parameters:')
        for name in self._result(self._client.list_parameters(names, 10)).result.names:
            self._say(f'    - {name}')
        self._say('Getting parameters:')
        for name, value in zip(names, self._result(self._client.get_parameters(names)).values, strict=True):
            self._say(f'    - {name}: {parameter_value_to_python(value)}')
        self._say('Loading parameters: ')
        path = str(Path(get_package_share_directory('demo_nodes_py'), 'params.yaml'))
        loaded = self._result(self._client.load_parameter_file(path)).results
        values = parameter_dict_from_yaml_file(path, target_nodes=[SERVER])
        self._say_results(
            values, loaded, [f'value: {parameter_value_to_python(each.value)}' for each in values.values()]
        )
        self._say('Deleting parameters: ')
        deleted = self._result(self._client.delete_parameters(DELETED)).results
        self._say_results(DELETED, deleted, [f'reason: {result.reason}' for result in deleted])

    def _result(self, future: Future):
        rclpy.spin_until_future_complete(self, future)
        if not future.done():
            raise ExternalShutdownException
        return future.result()

    def _say(self, text: str) -> None:
        self.get_logger().info(text)

    def _say_results(self, names, results, more: list[str] | None = None) -> None:
        for number, (name, result) in enumerate(zip(names, results, strict=True)):
            self._say(f'    {name}:')
            self._say(f'        successful: {result.successful}')
            if more:
                self._say(f'        {more[number]}')


def main(args: list[str] | None = None) -> None:
    """Run the client once."""
    with ros(args):
        ParameterClient().demonstrate()
