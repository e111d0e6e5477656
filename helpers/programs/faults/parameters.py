"""`no_parameter`: a parameter was written into a file, and the node has another value."""

import re

from helpers.programs.faults import words
from helpers.programs.faults.fault import START, Fault, Verdict

FILE = 'params.yaml'
_DRIVER = '''\
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class Driver(Node):
    """Drives along x, as fast as the parameter says."""

    def __init__(self):
        super().__init__('{node}')
        self.declare_parameter('{parameter}', 0.0)
        self.x = {first}
        self.create_timer(0.25, self.on_timer)

    def on_timer(self):
        self.x += 0.25 * self.get_parameter('{parameter}').value
        self.get_logger().info(f'x = {{self.x:.2f}} m')


rclpy.init()
try:
    rclpy.spin(Driver())
except (KeyboardInterrupt, ExternalShutdownException):
    pass
'''
_PARAMETERS = '{node}:\n  ros__parameters:\n    {parameter}: {value}  # m/s\n'


class NoParameter(Fault):
    """A node runs with the default of a parameter, not with what the file says.

    Kinds: ``node`` (the file is for a node with another name), ``name`` (the parameter is misspelt there), ``file``
    (nobody gives the file to the node).
    """

    name, title = 'no_parameter', 'a node does not do what its parameters say'
    kinds = ('node', 'name', 'file')

    def plan(self) -> None:
        draw = self.random
        self.node, parameter = draw.choice(words.ROBOTS), draw.choice(['speed', 'velocity', 'max_speed'])
        values = {'node': self.node, 'parameter': parameter, 'value': draw.randrange(3, 10) / 10}
        wrong = {
            'node': {'node': words.misspelt(self.node, draw)},
            'name': {'parameter': words.misspelt(parameter, draw)},
            'file': {},
        }[self.kind]
        start = f'python3 {self.node}.py --ros-args --params-file {FILE}\n'
        sound = {START: start, FILE: _PARAMETERS.format(**values)}
        self.files = {
            f'{self.node}.py': _DRIVER.format(node=self.node, parameter=parameter, first=draw.randrange(1, 9)),
            FILE: _PARAMETERS.format(**values | wrong),
            START: f'python3 {self.node}.py\n' if self.kind == 'file' else start,
        }
        where = START if self.kind == 'file' else FILE
        self.repaired = {where: sound[where]}
        self.diagnose(where, 'parameter', '0.0')
        self.facts = {'node': f'/{self.node}', 'parameter': parameter, 'value': values['value']}
        self.task = f'{self.node}.py should drive ahead with {values["value"]} m/s, as {FILE} says: x grows.'

    def places(self) -> list[float]:
        """What the program has printed: where it is, in m."""
        return [float(found[1]) for line in self.lines(self.node) if (found := re.search(r'x = ([\d.]+) m', line))]

    def works(self, timeout: float) -> Verdict:
        grows = self.watch(lambda: len(self.places()) > 1 and self.places()[-1] > self.places()[-2], timeout)
        return Verdict(grows, f'{self.node} {"drives ahead" if grows else "stays where it is"}')

    def show_symptom(self) -> None:
        self.watch(lambda: len(self.places()) >= 4, self.patience)
        self.show_programs()
