from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('reentrant_with_a_queue', source='''
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.task import Future
from std_srvs.srv import SetBool, Trigger


class DoorGuard(Node):
    """All in a reentrant group; who enters waits until the one before has been told."""

    def __init__(self, capacity=2):
        super().__init__('door_guard', namespace='')
        self.capacity, self.inside, self.last = capacity, 0, None
        group = ReentrantCallbackGroup()
        self.lock = self.create_client(SetBool, 'lock', callback_group=group)
        self.create_service(Trigger, 'enter', self.on_enter, callback_group=group)
        self.create_service(Trigger, 'leave', self.on_leave, callback_group=group)

    async def on_enter(self, request, response):
        before, self.last = self.last, Future()
        mine = self.last
        if before is not None:
            await before
        response.success, response.message = await self.let_in()
        mine.set_result(None)
        return response

    async def let_in(self):
        if self.inside >= self.capacity:
            return False, 'full'
        answer = await self.lock.call_async(SetBool.Request(data=False))
        if answer.success:
            self.inside += 1
        return answer.success, 'welcome' if answer.success else 'locked'

    def on_leave(self, request, response):
        self.inside -= self.inside > 0
        response.success = True
        return response
'''),
    Alternative('reserved_place', source='''
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from std_srvs.srv import SetBool, Trigger


class DoorGuard(Node):
    """Asks and leaves in groups of their own: leaving need not wait for the lock."""

    def __init__(self, capacity=2):
        super().__init__('door_guard')
        self.capacity, self.inside = capacity, 0
        groups = [MutuallyExclusiveCallbackGroup() for _ in range(3)]
        self.lock = self.create_client(SetBool, 'lock', callback_group=groups[0])
        self.create_service(Trigger, 'enter', self.on_enter, callback_group=groups[1])
        self.create_service(Trigger, 'leave', self.on_leave, callback_group=groups[2])

    async def on_enter(self, request, response):
        if self.inside >= self.capacity:
            return Trigger.Response(success=False, message='full')
        opened = (await self.lock.call_async(SetBool.Request())).success
        if not opened:
            return Trigger.Response(success=False, message='locked')
        self.inside += 1
        return Trigger.Response(success=True, message='welcome')

    def on_leave(self, request, response):
        if self.inside:
            self.inside -= 1
        return Trigger.Response(success=True)
'''),
    Alternative('a_line_at_the_door', source='''
from collections import deque

from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.task import Future
from std_srvs.srv import SetBool, Trigger


class DoorGuard(Node):
    """Who finds somebody at the door waits, in any order: the second to come may be told last."""

    def __init__(self, capacity=2):
        super().__init__('door_guard')
        self.capacity, self.inside = capacity, 0
        self.line, self.occupied = deque(), False
        all_of_them = ReentrantCallbackGroup()
        self.lock = self.create_client(SetBool, 'lock', callback_group=all_of_them)
        self.create_service(Trigger, 'enter', self.on_enter, callback_group=all_of_them)
        self.create_service(Trigger, 'leave', self.on_leave, callback_group=all_of_them)

    async def on_enter(self, request, response):
        while self.occupied and self.inside < self.capacity:
            turn = Future()
            self.line.append(turn)
            await turn
        if self.inside >= self.capacity:
            response.message = 'full'
            while self.line:
                self.line.popleft().set_result(None)
            return response
        self.occupied = True
        answer = await self.lock.call_async(SetBool.Request())
        self.occupied = False
        if answer.success:
            self.inside += 1
        while self.line:
            self.line.popleft().set_result(None)
        return Trigger.Response(success=answer.success, message=('locked', 'welcome')[answer.success])

    def on_leave(self, request, response):
        self.inside -= self.inside > 0
        response.success = True
        return response
'''),
]
