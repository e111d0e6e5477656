# Exercise 4.4: find the bugs
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
