from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('done_callbacks', source='''
import rclpy.task
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from std_srvs.srv import Trigger


class StatusPanel(Node):
    """Awaits one future of its own, which the last answer completes."""

    def __init__(self):
        super().__init__('status_panel')
        self.names = ('battery', 'lidar')
        self.parts = [self.create_client(Trigger, f'{name}/check', callback_group=MutuallyExclusiveCallbackGroup())
                      for name in self.names]
        self.create_service(Trigger, 'status', self.on_status,
                            callback_group=MutuallyExclusiveCallbackGroup())

    async def on_status(self, request, response):
        answers, complete = {}, rclpy.task.Future()

        def keep(name, future):
            answers[name] = future.result()
            if len(answers) == 2:
                complete.set_result(True)

        for name, client in zip(self.names, self.parts):
            client.call_async(Trigger.Request()).add_done_callback(lambda future, name=name: keep(name, future))
        await complete
        response.success = answers['battery'].success and answers['lidar'].success
        response.message = f"battery: {answers['battery'].message}; lidar: {answers['lidar'].message}"
        return response
'''),
    Alternative('reentrant', edits=(('import MutuallyExclusiveCallbackGroup', 'import ReentrantCallbackGroup'),
            ('''
            group = MutuallyExclusiveCallbackGroup()
            self.battery = self.create_client(Trigger, 'battery/check', callback_group=group)
            self.lidar = self.create_client(Trigger, 'lidar/check', callback_group=group)
            self.create_service(Trigger, 'status', self.on_status)
            ''', '''
            self.group = ReentrantCallbackGroup()
            self.parts = {name: self.create_client(Trigger, f'{name}/check', callback_group=self.group)
                          for name in ('battery', 'lidar')}
            self.create_service(Trigger, 'status', self.on_status, callback_group=self.group)
            '''),
            ('''
            futures = [client.call_async(Trigger.Request()) for client in (self.battery, self.lidar)]
            battery, lidar = [await future for future in futures]
            response.success = battery.success and lidar.success
            response.message = f'battery: {battery.message}; lidar: {lidar.message}'
            ''', '''
            futures = {name: client.call_async(Trigger.Request()) for name, client in self.parts.items()}
            answers = {name: await future for name, future in futures.items()}
            response.success = all(answer.success for answer in answers.values())
            response.message = '; '.join(f'{name}: {answer.message}' for name, answer in answers.items())
            '''))),
]
