# expect: It waits for an answer, which only another callback can receive
# rejected by: test_slow_lock
# Exercise 4.4: find the bugs
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from std_srvs.srv import SetBool, Trigger


class DoorGuard(Node):
    def __init__(self, capacity=2):
        super().__init__('door_guard')
        self.capacity, self.inside = capacity, 0
        self.lock = self.create_client(
            SetBool, 'lock', callback_group=MutuallyExclusiveCallbackGroup())
        self.create_service(Trigger, 'enter', self.on_enter)
        self.create_service(Trigger, 'leave', self.on_leave)

    def on_enter(self, request, response):
        if self.inside >= self.capacity:
            response.message = 'full'
            return response
        answer = self.lock.call(SetBool.Request(data=False))
        self.inside += answer.success
        response.success = answer.success
        response.message = 'welcome' if answer.success else 'locked'
        return response

    def on_leave(self, request, response):
        self.inside = max(0, self.inside - 1)
        response.success = True
        return response
