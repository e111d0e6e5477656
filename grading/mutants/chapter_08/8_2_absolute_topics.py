# expect: A governor in a namespace
# rejected by: test_two_robots
# Exercise 8.2: a governor
class Governor(Node):
    def __init__(self, **options):
        super().__init__('governor', **options)
        self.command, self.timer = Twist(), None
        self.publisher = self.create_publisher(Twist, '/cmd_vel', 10)
        self.create_subscription(Twist, 'cmd_vel_in', lambda command: setattr(self, 'command', command), 10)
        self.add_on_set_parameters_callback(self.check)
        self.add_post_set_parameters_callback(self.react)
        self.declare_parameter('max_linear', 0.5, bounded('Limit of linear.x in m/s', 0.0, 2.0))
        self.declare_parameter('slow_linear', 0.2, bounded('The same in the mode slow', 0.0, 2.0))
        self.declare_parameter('rate', 10.0, bounded('Commands per second', 1.0, 50.0))
        self.declare_parameter('mode', 'normal', ParameterDescriptor(description='normal, slow or stop'))

    def check(self, parameters):
        new = {'max_linear': 2.0, 'slow_linear': 0.0, 'mode': 'normal'}
        new.update({name: self.get_parameter(name).value for name in new if self.has_parameter(name)})
        new.update({parameter.name: parameter.value for parameter in parameters})
        if new['mode'] not in ('normal', 'slow', 'stop'):
            return SetParametersResult(successful=False, reason='mode must be normal, slow or stop')
        good = new['slow_linear'] <= new['max_linear']
        return SetParametersResult(successful=good, reason='' if good else 'slow_linear must not be above max_linear')

    def react(self, parameters):
        if 'rate' in [parameter.name for parameter in parameters]:
            self.destroy_timer(self.timer) if self.timer else None
            self.timer = self.create_timer(1 / self.get_parameter('rate').value, self.on_timer)

    def on_timer(self):
        mode = self.get_parameter('mode').value
        limit = self.get_parameter('slow_linear' if mode == 'slow' else 'max_linear').value
        command = Twist()
        if mode != 'stop':
            command.linear.x = max(-limit, min(limit, self.command.linear.x))
            command.angular.z = self.command.angular.z
        self.publisher.publish(command)
