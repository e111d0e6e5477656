# expect: every caller gets fresh answers
# rejected by: test_fresh_answers
# Exercise 4.3: one question, two sources
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from std_srvs.srv import Trigger


class StatusPanel(Node):
    def __init__(self):
        super().__init__('status_panel')
        group = MutuallyExclusiveCallbackGroup()
        self.battery = self.create_client(Trigger, 'battery/check', callback_group=group)
        self.lidar = self.create_client(Trigger, 'lidar/check', callback_group=group)
        self.create_service(Trigger, 'status', self.on_status)

    async def on_status(self, request, response):
        if not hasattr(self, 'futures'):
            self.futures = [client.call_async(Trigger.Request()) for client in (self.battery, self.lidar)]
        battery, lidar = [await future for future in self.futures]
        response.success = battery.success and lidar.success
        response.message = f'battery: {battery.message}; lidar: {lidar.message}'
        return response
