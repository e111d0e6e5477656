# expect: two calls share what belongs to one of them
# rejected by: test_two_callers
# Exercise 4.3: one question, two sources
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from std_srvs.srv import Trigger


class StatusPanel(Node):
    def __init__(self):
        super().__init__('status_panel')
        group = MutuallyExclusiveCallbackGroup()
        self.battery = self.create_client(Trigger, 'battery/check', callback_group=group)
        self.lidar = self.create_client(Trigger, 'lidar/check', callback_group=group)
        self.create_service(Trigger, 'status', self.on_status, callback_group=rclpy.callback_groups.ReentrantCallbackGroup())

    async def on_status(self, request, response):
        self.futures = [client.call_async(Trigger.Request()) for client in (self.battery, self.lidar)]
        lidar = await self.futures[1]
        battery = await self.futures[0]
        response.success = battery.success and lidar.success
        response.message = f'battery: {battery.message}; lidar: {lidar.message}'
        return response
