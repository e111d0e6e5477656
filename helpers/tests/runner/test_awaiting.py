"""An `await` that its own callback group makes endless is named first, and none that will end."""

import pytest

from helpers.tests.runner.test_mistakes import judge

HEAD = """\
from rclpy.action import ActionClient
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.task import Future
from example_interfaces.action import Fibonacci
from std_srvs.srv import Trigger
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.own = MutuallyExclusiveCallbackGroup()
        self.client = self.create_client(Trigger, 'ask'{group})
        self.action = ActionClient(self, Fibonacci, 'count'{group})
        self.timer = self.create_timer(0.5, self.tick)

    def end(self, future):
        self.destroy_timer(self.one_shot)
        future.set_result(None)

    async def ask(self):
        return await self.client.call_async(Trigger.Request())

    async def tick(self):
        self.timer.cancel()
"""
# How the sentence begins, and what it says.
ASKED = 'A deadlock at Exercise', 'the answer waits in the same group, so it is never taken'
DUE = 'A callback awaits at Exercise', 'a timer of the same group is due and cannot run'
ONE_SHOT = """\
        future = Future()
        self.one_shot = self.create_timer(0.2, lambda: self.end(future){group})
        await future
"""
WAITS = {
    'service': ('        await self.client.call_async(Trigger.Request())\n', ASKED),
    'coroutine': ('        for _ in range(2):\n            await self.ask()\n', ASKED),
    'task': ('        await self.executor.create_task(self.ask())\n', ASKED),
    'goal': ('        await self.action.send_goal_async(Fibonacci.Goal(order=3))\n', ASKED),
    'timer': (ONE_SHOT, DUE),
}
RUN = '''
def test_run(learner):
    """It runs."""
    from example_interfaces.action import Fibonacci
    from std_srvs.srv import Trigger
    learner.serve('/ask', Trigger, {'success': True}, 0.1)
    learner.action_server('/count', Fibonacci, lambda goal: [(0.1, Fibonacci.Result())])
    learner.start('Talker')
    learner.run(1.2)
    expect(False, 'It came to its end.')
'''


@pytest.mark.parametrize('name', WAITS)
def test_a_wait_for_the_own_group_is_the_first_thing_said(tmp_path, name):
    wait, (begins, said) = WAITS[name]
    result = judge(tmp_path, (HEAD + wait).replace('{group}', ''), RUN)
    first, *_, last = result.message.splitlines()
    assert first.startswith(begins), result.message
    assert 'await ' in first
    assert said in first
    assert first.endswith('callback group of its own.')
    assert last == 'It came to its end.'


@pytest.mark.parametrize('group', ['self.own', 'ReentrantCallbackGroup()'])
@pytest.mark.parametrize('name', WAITS)
def test_a_wait_for_another_group_is_none(tmp_path, name, group):
    result = judge(tmp_path, (HEAD + WAITS[name][0]).replace('{group}', f', callback_group={group}'), RUN)
    assert result.message == 'It came to its end.'


def test_tasks_that_await_each_other_are_looked_at_once(tmp_path):
    """Nobody ends such a wait; the test goes on."""
    circle = (
        HEAD.replace('{group}', '')
        + '        self.first = self.executor.create_task(self.one)\n'
        + """\
        self.second = self.executor.create_task(self.two)
        await self.first

    async def one(self):
        await self.second

    async def two(self):
        await self.first
"""
    )
    assert judge(tmp_path, circle, RUN).message == 'It came to its end.'


def test_what_ends_later_is_none(tmp_path):
    """The answer comes when the callback group is free, and after the test."""
    wait = '        self.client.call_async(Trigger.Request()).add_done_callback(print)\n'
    slow = RUN.replace('0.1)\n    learner.action', '9.0)\n    learner.action')
    assert judge(tmp_path, (HEAD + wait).replace('{group}', ''), slow).message == 'It came to its end.'
    own = HEAD.replace('{group}', ', callback_group=self.own') + '        await self.ask()\n'
    assert judge(tmp_path, own, slow).message == 'It came to its end.'
