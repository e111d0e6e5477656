"""`hang`: a program hangs, and Ctrl+C does not end it."""

import signal

from helpers.programs.faults import words
from helpers.programs.faults.fault import START, Fault, Verdict
from helpers.programs.faults.services import SERVER

GRACE = 10.0  # s in which a program must end after Ctrl+C, on a machine under load

_HEAD = """\
import faulthandler
import signal
{imports}
import rclpy
from rclpy.executors import {executor}
from rclpy.node import Node
{message}

faulthandler.register(signal.SIGUSR1)  # kill -USR1 PID: print where each thread stands


"""
_TAIL = """

rclpy.init()
executor = {executor}()
executor.add_node({node}())
try:
    executor.spin()
except (KeyboardInterrupt, ExternalShutdownException):
    pass
"""
_ASK = """\
class Asker(Node):
    def __init__(self):
        super().__init__('{node}')
        self.client = self.create_client(Trigger, '{service}')
        self.create_timer(0.2, self.on_timer)
        self.get_logger().info('ready')

    def on_timer(self):
        if not self.client.service_is_ready():
            return
        self.get_logger().info('on_timer begins', once=True)
{body}"""
_CALL = """\
        response = self.client.call(Trigger.Request())
        self.get_logger().info(f'answer: {response.message}')
"""
_SPIN = """\
        future = self.client.call_async(Trigger.Request())
        while not future.done():
            time.sleep(0.01)
        self.get_logger().info(f'answer: {future.result().message}')
"""
_CHAIN = """\
        self.client.call_async(Trigger.Request()).add_done_callback(self.on_answer)

    def on_answer(self, future):
        self.get_logger().info(f'answer: {future.result().message}')
"""
_LOOP = """\
class Asker(Node):
    def __init__(self):
        super().__init__('{node}')
        self.count = 0
        self.create_subscription(Int32, '{topic}', self.on_message, 10)
        self.publisher = self.create_publisher(Int32, '{topic}', 10)
        self.create_timer(0.2, self.on_timer)
        self.get_logger().info('ready')

    def on_timer(self):
        self.get_logger().info('on_timer begins', once=True)
{body}
    def on_message(self, message):
        self.get_logger().info(f'answer: {{message.data}}')
"""
_WHILE = """\
        while True:
            try:
                time.sleep(0.2)
                self.count += 1
                self.publisher.publish(Int32(data=self.count))
            except:  # keep going, whatever happens
                pass
"""
_ONCE = """\
        self.count += 1
        self.publisher.publish(Int32(data=self.count))
"""


class Hang(Fault):
    """A program stands still, and Ctrl+C does not end it.

    Kinds: ``call`` (a callback calls a service and blocks), ``poll`` (a callback waits in a loop for a future),
    ``loop`` (a callback that never returns, and catches everything).
    """

    name, title = 'hang', 'the program hangs, and Ctrl+C does not end it'
    kinds = ('call', 'poll', 'loop')
    grace = 1.0  # it does not end by itself

    def plan(self) -> None:
        draw = self.random
        service, server, client = draw.choice(words.SERVICES)
        topic, node, _ = draw.choice(words.SENSORS)
        number = draw.randrange(100, 1000)
        self.program = node if self.kind == 'loop' else client
        file = f'{self.program}.py'
        serving = SERVER.format(node=server, service=service, package='std_srvs', answer=f'done, job {number}')
        if self.kind == 'loop':
            self.files = {START: f'python3 {file}\n'}
            bad, good = (
                _source(
                    _LOOP.format(node=node, topic=topic, body=body),
                    'import time',
                    'SingleThreadedExecutor',
                    'from std_msgs.msg import Int32',
                )
                for body in (_WHILE, _ONCE)
            )
            self.task = f'{file} should publish five numbers a second, and print each number that it hears itself.'
        else:
            self.files = {START: f'python3 {server}.py\npython3 {file}\n', f'{server}.py': serving}
            imports = '' if self.kind == 'call' else 'import time'
            bad, good = (
                _source(
                    _ASK.format(node=client, service=service, body=body),
                    imports,
                    'MultiThreadedExecutor',
                    'from std_srvs.srv import Trigger',
                )
                for body in ({'call': _CALL, 'poll': _SPIN}[self.kind], _CHAIN)
            )
            self.task = f'{file} should ask {server}.py five times a second, and print each answer.'
        self.task += ' Ctrl+C should end it.'
        self.files[file], self.repaired = bad, {file: good}
        piece = {'call': 'self.client.call(', 'poll': 'time.sleep(0.01)', 'loop': 'time.sleep(0.2)'}[self.kind]
        line = next(line.strip() for line in bad.splitlines() if piece in line)
        self.diagnose(file, 'call' if self.kind == 'call' else 'busy', line)
        self.facts = {'callback': 'on_timer'}

    def works(self, timeout: float) -> Verdict:
        def answers() -> int:
            return sum('answer:' in line for line in self.lines(self.program))

        running = self.watch(lambda: answers() >= 3, timeout)
        if not running:
            return Verdict(False, f'{self.program} printed {answers()} answers, and no more come')
        ends = self.interrupt()
        return Verdict(ends, f'{self.program} prints answers, and Ctrl+C {"ends it" if ends else "does not end it"}')

    def show_symptom(self) -> None:
        self.settled(self.program)
        self.show_programs()
        print(f'(Ctrl+C on {self.program}: it {"ends" if self.interrupt(1.0) else "goes on"})')

    def hangs(self, stacks: list[str]) -> bool:
        """Whether the callback stands in the line that is the fault; True if that line is repaired."""
        (found,) = self.diagnosis
        lines = (self.path / found.where).read_text().splitlines()
        wrong = [number for number, line in enumerate(lines, 1) if line.strip() == found.evidence]
        stands = any(f', line {number} in on_timer' in call for number in wrong for call in stacks)
        return not wrong or stands and (self.kind != 'call' or waits_in_call(stacks))

    def interrupt(self, timeout: float = GRACE) -> bool:
        """Press Ctrl+C, and tell whether the program ends in ``timeout`` seconds. One that does not is killed."""
        ends = self.signal(self.program, signal.SIGINT, timeout)
        self.programs.pop(self.program).stop(timeout=0)
        return ends

    def stop(self) -> None:
        """End the programs and remove the folder; idempotent."""
        if self.program in self.programs:
            self.programs.pop(self.program).stop(timeout=0.2)
        super().stop()


def waits_in_call(stacks: list[str]) -> bool:
    """Whether a thread is in `Client.call` of rclpy."""
    return any('client.py"' in call and call.endswith(' in call') for call in stacks)


def _source(body: str, imports: str, executor: str, message: str) -> str:
    head = _HEAD.format(imports=imports, executor=f'ExternalShutdownException, {executor}', message=message)
    return (
        head.replace('\n\nimport rclpy', '\nimport rclpy' if imports else '\n\nimport rclpy')
        + body
        + _TAIL.format(executor=executor, node='Asker')
    )
