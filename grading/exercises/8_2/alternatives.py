from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('stores_after_setting', source='''
class Governor(Node):
    NUMBERS = {'max_linear': (0.5, 0.0, 2.0), 'slow_linear': (0.2, 0.0, 2.0), 'rate': (10.0, 1.0, 50.0)}

    def __init__(self, **options):
        super().__init__('governor', **options)
        self.newest = (0.0, 0.0)
        self.values = {}
        self.timer = None
        self.out = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_subscription(Twist, 'cmd_vel_in', self.on_command, 10)
        self.add_on_set_parameters_callback(self.check)
        self.declare_parameter('mode', 'normal', ParameterDescriptor(description='How it drives'))
        for name, (default, low, high) in self.NUMBERS.items():
            self.declare_parameter(name, default, bounded(f'The value of {name}', low, high))
        self.add_post_set_parameters_callback(self.store)
        self.store(self.get_parameters(['mode', *self.NUMBERS]))

    def on_command(self, msg):
        self.newest = msg.linear.x, msg.angular.z

    def check(self, parameters):
        wanted = {one.name: one.value for one in parameters}

        def value(name):
            return wanted[name] if name in wanted else self.get_parameter(name).value if self.has_parameter(name) else None

        if value('mode') not in ('normal', 'slow', 'stop'):
            return SetParametersResult(successful=False, reason=f'mode {value("mode")!r} is unknown')
        low, high = value('slow_linear'), value('max_linear')
        if low is not None and high is not None and low > high:
            return SetParametersResult(successful=False, reason=f'slow_linear {low} is above max_linear {high}')
        return SetParametersResult(successful=True)

    def store(self, parameters):
        changed = {one.name: one.value for one in parameters}
        self.values.update(changed)
        if 'rate' in changed:
            if self.timer is None:
                self.timer = self.create_timer(1 / changed['rate'], self.tick)
            self.timer.timer_period_ns = round(1e9 / changed['rate'])
            self.timer.reset()

    def tick(self):
        limit = {'normal': self.values['max_linear'], 'slow': self.values['slow_linear'], 'stop': 0.0}
        linear, angular = self.newest
        msg = Twist()
        msg.linear.x = min(max(linear, -limit[self.values['mode']]), limit[self.values['mode']])
        msg.angular.z = 0.0 if self.values['mode'] == 'stop' else angular
        self.out.publish(msg)
'''),
    Alternative('new_period_of_the_same_timer', old="""
        self.destroy_timer(self.timer) if self.timer else None
        self.timer = self.create_timer(1 / self.get_parameter('rate').value, self.on_timer)
        """, new="""
        if self.timer:
            self.timer.timer_period_ns = round(1e9 / self.get_parameter('rate').value)
            self.timer.reset()
        else:
            self.timer = self.create_timer(1 / self.get_parameter('rate').value, self.on_timer)
        """),
]
