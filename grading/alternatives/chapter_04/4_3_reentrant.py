# Exercise 4.3: one question, two sources
from rclpy.callback_groups import ReentrantCallbackGroup
from std_srvs.srv import Trigger


class StatusPanel(Node):
    def __init__(self):
        super().__init__('status_panel')
        self.group = ReentrantCallbackGroup()
        self.parts = {name: self.create_client(Trigger, f'{name}/check', callback_group=self.group)
                      for name in ('battery', 'lidar')}
        self.create_service(Trigger, 'status', self.on_status, callback_group=self.group)

    async def on_status(self, request, response):
        futures = {name: client.call_async(Trigger.Request()) for name, client in self.parts.items()}
        answers = {name: await future for name, future in futures.items()}
        response.success = all(answer.success for answer in answers.values())
        response.message = '; '.join(f'{name}: {answer.message}' for name, answer in answers.items())
        return response
