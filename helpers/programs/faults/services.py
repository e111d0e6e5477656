"""`waiting`: a client says that it waits, and never stops waiting."""

from helpers.programs.faults import words
from helpers.programs.faults.fault import START, Fault, Verdict

SERVER = """\
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from {package}.srv import Trigger


class Server(Node):
    def __init__(self):
        super().__init__('{node}')
        self.create_service(Trigger, '{service}', self.on_request)
        self.get_logger().info('ready')

    def on_request(self, request, response):
        response.success = True
        response.message = '{answer}'
        return response


rclpy.init()
try:
    rclpy.spin(Server())
except (KeyboardInterrupt, ExternalShutdownException):
    pass
"""
CLIENT = """\
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from {package}.srv import Trigger


def main(node):
    client = node.create_client(Trigger, '{service}')
    while not client.wait_for_service(timeout_sec=0.3):
        node.get_logger().info('service not available, waiting')
    future = client.call_async(Trigger.Request())
    rclpy.spin_until_future_complete(node, future, timeout_sec=5.0)
    node.get_logger().info(f'answer: {{future.result().message}}' if future.done() else 'no answer')


rclpy.init()
try:
    main(Node('{node}'))
except (KeyboardInterrupt, ExternalShutdownException):
    pass
"""


class Waiting(Fault):
    """The client waits for its service for ever.

    Kinds: ``no_server`` (nobody started it), ``name`` (misspelt service), ``namespace`` (the server is in one, the
    client is not), ``type`` (a type of the same name from another package).
    """

    name, title = 'waiting', 'the client prints "waiting" and does not stop'
    kinds = ('no_server', 'name', 'namespace', 'type')

    def plan(self) -> None:
        draw = self.random
        service, server, client = draw.choice(words.SERVICES)
        robot, wrong = draw.choice(words.ROBOTS), words.misspelt(service, draw)
        packages = draw.sample(['std_srvs', 'example_interfaces'], 2)
        number = draw.randrange(100, 1000)
        offered = {'node': server, 'service': service, 'package': packages[0], 'answer': f'done, job {number}'}
        wanted = {'node': client, 'service': service, 'package': packages[0]}
        start = f'python3 {server}.py\npython3 {client}.py\n'
        sound = {f'{server}.py': SERVER.format(**offered), f'{client}.py': CLIENT.format(**wanted), START: start}
        self.files, names, where = dict(sound), [f'/{service}'] * 2, f'{client}.py'
        if self.kind == 'no_server':
            self.files[START], where = f'# python3 {server}.py\npython3 {client}.py\n', START
        elif self.kind == 'namespace':
            self.files[START], where = start.replace('.py\n', f'.py --ros-args -r __ns:=/{robot}\n', 1), START
            names[0] = f'/{robot}/{service}'
        else:
            key, value = {'name': ('service', wrong), 'type': ('package', packages[1])}[self.kind]
            self.files[where] = CLIENT.format(**wanted | {key: value})
            names[1] = f'/{wrong}' if self.kind == 'name' else names[1]
        self.repaired = {where: sound[where]}
        self.server, self.client = server, client
        self.task = f'{client}.py should ask the service of {server}.py, print the answer, and end.'
        client_package = packages[1] if self.kind == 'type' else packages[0]
        types = f'{packages[0]}/srv/Trigger', f'{client_package}/srv/Trigger'
        cause = {'no_server': 'nobody', 'type': 'type'}.get(self.kind, 'name')
        self.diagnose(where, cause, {'nobody': '', 'name': names[0], 'type': types[0]}[cause])
        self.facts = {
            'server': server,
            'client': client,
            'server_service': names[0],
            'client_service': names[1],
            'server_type': types[0],
            'client_type': types[1],
        }

    def works(self, timeout: float) -> Verdict:
        def answered() -> bool:
            # The client asked before the server was connected to the client's reader.
            if 'no answer' in '\n'.join(self.lines(self.client)):
                self.start()
            return any('answer: done' in line for line in self.lines(self.client))

        got = self.watch(answered, timeout, ends=(self.client,))
        return Verdict(got, f'{self.client} {"has" if got else "has not"} got its answer')

    def show_symptom(self) -> None:
        self.watch(lambda: len(self.lines(self.client)) >= 3, self.patience)
        self.show_programs()
