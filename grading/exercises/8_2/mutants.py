from grading.variants import Mutant

MODE = "self.declare_parameter('mode', 'normal', ParameterDescriptor(description='normal, slow or stop'))"
CLAMP = 'command.linear.x = max(-limit, min(limit, self.command.linear.x))'
PAIR = "good = new['slow_linear'] <= new['max_linear']"
LISTENS = "self.create_subscription(Twist, 'cmd_vel_in', lambda command: setattr(self, 'command', command), 10)"
HEARD = "lambda command: setattr(self, 'command', command)"

MUTANTS = [
    Mutant('new_timer_while_it_checks', old=PAIR, new=f"""
        rates = [parameter.value for parameter in parameters if parameter.name == 'rate']
        if rates and self.timer:
            self.destroy_timer(self.timer)
            self.timer = self.create_timer(1 / rates[0], self.on_timer)
        {PAIR}
        """, expect='was refused, and yet the node works in another way', breaks='refused'),
    Mutant('sleeps_in_the_timer', breaks='rhythm', old='def on_timer(self):', new='''
        def on_timer(self):
            time.sleep(0.005)
        ''', imports='import time', expect='the timer alone gives the rhythm'),
    Mutant('any_type', breaks='defaults', old="ParameterDescriptor(description='normal, slow or stop')",
           new="ParameterDescriptor(description='normal, slow or stop', dynamic_typing=True)",
           expect='leave dynamic_typing out'),
    Mutant('absolute_topic', old=", 'cmd_vel',", new=", '/cmd_vel',", expect='has no publisher on', breaks='names',
           also=('limit', 'rhythm', 'at-once', 'defaults', 'pair', 'at-start')),
    Mutant('absolute_input', old="(Twist, 'cmd_vel_in'", new="(Twist, '/cmd_vel_in'", expect='has no subscription on',
           breaks='names'),
    Mutant('another_name', old="__init__('governor'", new="__init__('Governor'", expect='your node is called',
           breaks='names'),
    Mutant('callback_after_declaring', edits=(('self.add_on_set_parameters_callback(self.check)', ''),
            (MODE, f'{MODE}\nself.add_on_set_parameters_callback(self.check)\n')),
           expect='is the callback added before', breaks='at-start'),
    Mutant('defaults_while_declaring', old="new = {'max_linear': 2.0, 'slow_linear': 0.0, 'mode': 'normal'}",
           new="new = {'max_linear': 0.5, 'slow_linear': 0.2, 'mode': 'normal'}", expect='InvalidParameterValue',
           breaks='at-start', also='limit'),
    Mutant('each_value_against_the_old', old=PAIR, new='''
        old = {name: self.get_parameter_or(name, Parameter(name, value=new[name])).value for name in new}
        good = old['slow_linear'] <= new['max_linear'] and new['slow_linear'] <= old['max_linear']
        ''', expect='Judge the values as they would be', breaks='pair',
           also=('at-start', 'bounds', 'limit', 'names', 'at-once')),
    Mutant('only_max_is_checked', old=PAIR,
           new="good = not any(one.name == 'max_linear' for one in parameters) or new['slow_linear'] <= new['max_linear']",
           expect='Judge the values as they would be', breaks='pair', also='at-start'),
    Mutant('equal_is_refused', old=PAIR, new=PAIR.replace('<=', '<'), expect='Equal values are good', breaks='pair',
           also=('at-start', 'names')),
    Mutant('any_mode', old="if new['mode'] not in ('normal', 'slow', 'stop'):", new='if False:', expect='was accepted',
           breaks='unknown-mode', also=('at-start', 'refused')),
    Mutant('modes_in_any_letters', old="new['mode'] not in", new="new['mode'].lower().strip() not in",
           expect='was accepted', breaks='unknown-mode', also=('at-start', 'refused')),
    Mutant('no_reason_for_the_pair', old="reason='' if good else 'slow_linear must not be above max_linear'",
           new="reason='' if good else 'this does not fit'", expect='does not name slow_linear', breaks='reason'),
    Mutant('no_reason_for_the_mode', old="reason='mode must be normal, slow or stop'", new="reason=''",
           expect='does not name mode', breaks='reason'),
    Mutant('integer_rate', old="10.0, bounded('Commands per second', 1.0, 50.0)",
           new="10, ParameterDescriptor(description='Commands per second')", expect='write 10.0', breaks='defaults',
           also=('names', 'rhythm', 'new-rate', 'at-once', 'at-start')),
    Mutant('another_default', old="'slow_linear', 0.2,", new="'slow_linear', 0.1,", expect='expected 0.2',
           breaks='defaults', also='at-start'),
    Mutant('no_bounds', old="bounded('Commands per second', 1.0, 50.0",
           new="ParameterDescriptor(description='Commands per second'", expect='has the bounds []', breaks='bounds'),
    Mutant('other_bounds', old="in the mode slow', 0.0, 2.0", new="in the mode slow', 0.0, 1.0",
           expect='The descriptor of slow_linear', breaks='bounds', also='at-start'),
    Mutant('no_description', old="ParameterDescriptor(description='normal, slow or stop')",
           new='ParameterDescriptor()', expect='mode has no description', breaks='description'),
    Mutant('old_timer_runs_on', old='self.destroy_timer(self.timer) if self.timer else None', new='',
           expect='Does the old timer still run', breaks='new-rate'),
    Mutant('publishes_in_the_constructor', old=MODE, new=f'{MODE}\nself.on_timer()\n',
           expect='went out in the constructor', breaks='rhythm', also=('before',)),
    Mutant('notes_the_mode_while_checking', edits=(
        ("if new['mode'] not in ('normal', 'slow', 'stop'):",
         "self.mode = new['mode']\nif new['mode'] not in ('normal', 'slow', 'stop'):\n"),
        ("mode = self.get_parameter('mode').value", 'mode = self.mode')), breaks='refused',
           expect='works in another way since then'),
    Mutant('publishes_at_a_change', old='def react(self, parameters):', new='''
        def react(self, parameters):
            self.publisher.publish(Twist())
''', breaks='new-rate', also=('at-once', 'pair', 'bounds', 'rhythm', 'before', 'at-start'),
           expect='was set. The timer publishes'),
    Mutant('deaf_in_the_mode_stop', old=LISTENS, new="""
        self.create_subscription(
            Twist, 'cmd_vel_in',
            lambda one: self.get_parameter('mode').value == 'stop' or setattr(self, 'command', one), 10)
""", breaks='newest', expect='it came during the mode stop'),
    Mutant('rate_counts_at_the_start', old="if 'rate' in [parameter.name for parameter in parameters]:",
           new='if not self.timer and self.has_parameter("rate"):', expect='messages came after',
           breaks='new-rate'),
    Mutant('new_timer_at_each_change', old="if 'rate' in [parameter.name for parameter in parameters]:",
           new='if self.has_parameter("rate"):', expect='Only a new rate begins with a new period', breaks='new-rate'),
    Mutant('one_direction', old=CLAMP, new='command.linear.x = min(limit, self.command.linear.x)', expect='linear.x -',
           breaks='limit', also='modes'),
    Mutant('absolute_speed', old=CLAMP, new='command.linear.x = min(limit, abs(self.command.linear.x))',
           expect='linear.x -', breaks='limit', also='modes'),
    Mutant('always_as_fast_as_it_may', old=CLAMP, new='''
           speed = self.command.linear.x
           command.linear.x = math.copysign(limit, speed) if speed else 0.0
           ''', imports='import math', expect='and it is not too fast', breaks='limit'),
    Mutant('cut_off_when_it_comes', old=CLAMP, new='''
           self.command.linear.x = max(-limit, min(limit, self.command.linear.x))
           command.linear.x = self.command.linear.x
           ''', expect='Keep the command as it came', breaks='at-once', also='newest'),
    Mutant('stop_forgets', old='self.publisher.publish(command)',
           new="self.publisher.publish(command)\nself.command = Twist() if mode == 'stop' else self.command\n",
           expect='it came before the mode stop', breaks='newest'),
    Mutant('a_part_of_a_mode', old="('normal', 'slow', 'stop'):", new="'normal, slow, stop':", expect='was accepted',
           breaks='unknown-mode'),
    Mutant('limit_of_the_card',
           old="limit = self.get_parameter('slow_linear' if mode == 'slow' else 'max_linear').value",
           new="limit = self.get_parameter('slow_linear').value if mode == 'slow' else 0.5",
           expect='With max_linear = ', breaks='limit', also='at-once'),
    Mutant('limits_the_turn', old='command.angular.z = self.command.angular.z',
           new='command.angular.z = max(-limit, min(limit, self.command.angular.z))', expect='It stays as it is',
           breaks='other-fields', also=('modes', 'at-once')),
    Mutant('passes_everything', edits=(('''
            command = Twist()
            if mode != 'stop':
            ''', '''
            command = Twist()
            if mode != 'stop':
                command.linear.y, command.angular.x = self.command.linear.y, self.command.angular.x
            '''),), expect='Publish a new Twist', breaks='other-fields'),
    Mutant('slow_is_normal', old="'slow_linear' if mode == 'slow' else 'max_linear'", new="'max_linear'",
           expect='Started with mode', breaks='modes', also='at-once'),
    Mutant('stop_still_turns', edits=(("if mode != 'stop':", "if mode == 'stop':\n    limit = 0.0\nif True:\n"),),
           expect="Started with mode = 'stop'", breaks='modes', also='at-once'),
    Mutant('waits_for_a_command',
           edits=(('self.command, self.timer = Twist(), None', 'self.command, self.timer = None, None'),
            ('self.publisher.publish(command)', 'self.publisher.publish(command)'),
            ("mode = self.get_parameter('mode').value", """
            if self.command is None:
                return
            mode = self.get_parameter('mode').value
            """))[::2], expect='Before the first command, zeros are expected', breaks='before'),
    Mutant('each_command_once', old='self.publisher.publish(command)',
           new='self.publisher.publish(command)\nself.command = Twist()\n', expect='The newest one is',
           breaks='newest', also='refused'),
    Mutant('zeros_are_no_command', old=LISTENS, new=LISTENS.replace(
           "lambda command: setattr(self, 'command', command)",
           "lambda command: command == Twist() or setattr(self, 'command', command)"),
           expect='else the robot never stands', breaks='newest', also=('modes', 'limit')),
    Mutant('hardly_new', old=LISTENS, new=LISTENS.replace(
           "lambda command: setattr(self, 'command', command)",
           "lambda command: abs(command.linear.x - self.command.linear.x) > 1e-3 and setattr(self, 'command', command)"),
           expect='differs by little', breaks='newest', also=('other-fields', 'limit', 'modes', 'before')),
    Mutant('begins_again_when_it_refuses', old="if new['mode'] not in ('normal', 'slow', 'stop'):",
           new="if new['mode'] not in ('normal', 'slow', 'stop') and self.timer:\n    self.timer.reset()\n"
           "if new['mode'] not in ('normal', 'slow', 'stop'):", expect='leave the timer alone', breaks='refused'),
    Mutant('zeros_at_once', old=LISTENS, new=LISTENS.replace(
           "lambda command: setattr(self, 'command', command)",
           "lambda command: setattr(self, 'command', command) or command == Twist() and self.on_timer()"),
           expect='when the command 0 m/s came', breaks='rhythm'),
    Mutant('period_in_hundredths', old="1 / self.get_parameter('rate').value",
           new="round(1 / self.get_parameter('rate').value, 2)", expect='expected one every', breaks='rhythm',
           also=('new-rate', 'refused')),
    Mutant('two_of_a_request', old='for parameter in parameters})', new='for parameter in parameters[:2]})',
           expect='was accepted', breaks='pair'),
    Mutant('first_command_for_ever', old=LISTENS, new=LISTENS.replace(
        "setattr(self, 'command', command)", "self.command == Twist() and setattr(self, 'command', command)"),
           expect='The newest one is', breaks='newest', also=('limit', 'modes')),
    Mutant('oldest_first',
           edits=((LISTENS, "self.queue = []\nself.create_subscription(Twist, 'cmd_vel_in', self.queue.append, 10)\n"),
            ("mode = self.get_parameter('mode').value", """
            if self.queue:
                self.command = self.queue.pop(0)
            mode = self.get_parameter('mode').value
            """)), expect='The newest one is', breaks='newest'),
    Mutant('ten_times_a_second', old="1 / self.get_parameter('rate').value", new='0.1', expect='With rate = ',
           breaks='rhythm', also=('new-rate', 'at-start', 'at-once', 'before')),
    Mutant('rate_is_a_period', old="1 / self.get_parameter('rate').value", new="self.get_parameter('rate').value",
           expect='With rate = ', breaks='rhythm', also=('before', 'new-rate', 'at-start', 'at-once', 'limit')),
    Mutant('publishes_when_it_comes', source='''
class Governor(Node):
    def __init__(self, **options):
        super().__init__('governor', **options)
        self.command, self.timer = Twist(), None
        self.publisher = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_subscription(Twist, 'cmd_vel_in', self.on_command, 10)
        self.add_on_set_parameters_callback(self.check)
        self.add_post_set_parameters_callback(self.react)
        self.declare_parameter('max_linear', 0.5, bounded('Limit of linear.x in m/s', 0.0, 2.0))
        self.declare_parameter('slow_linear', 0.2, bounded('The same in the mode slow', 0.0, 2.0))
        self.declare_parameter('rate', 10.0, bounded('Commands per second', 1.0, 50.0))
        self.declare_parameter('mode', 'normal', ParameterDescriptor(description='normal, slow or stop'))

    def on_command(self, command):
        self.command = command
        self.on_timer()

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
''', expect='A message went out at once', breaks='rhythm'),
    Mutant('read_in_constructor', edits=((MODE, f"{MODE}\nself.mode = self.get_parameter('mode').value\n"),
            ("mode = self.get_parameter('mode').value", 'mode = self.mode')), expect='The mode was changed to stop',
           breaks='at-once'),
    Mutant('limit_read_in_constructor',
           edits=((MODE, f"{MODE}\nself.limit = self.get_parameter('max_linear').value\n"),
            ("limit = self.get_parameter('slow_linear' if mode == 'slow' else 'max_linear').value",
             "limit = self.get_parameter('slow_linear').value if mode == 'slow' else self.limit")),
           expect='read the parameter when you publish', breaks='at-once'),
    Mutant('stores_while_checking', edits=(('timer = Twist(), None', 'timer, self.values = Twist(), None, {}'),
            ('def check(self, parameters):', '''
            def check(self, parameters):
                self.values.update({parameter.name: parameter.value for parameter in parameters})
            '''),
            ("mode = self.get_parameter('mode').value", "mode = self.values['mode']"),
            ("limit = self.get_parameter('slow_linear' if mode == 'slow' else 'max_linear').value",
             "limit = self.values['slow_linear' if mode == 'slow' else 'max_linear']")),
           expect='While you check, store and change nothing', breaks='refused'),
    Mutant('zero_is_no_limit', old='command.linear.x = max(-limit, min(limit, self.command.linear.x))', new="""
           speed = self.command.linear.x
           command.linear.x = max(-limit, min(limit, speed)) if limit else speed
           """, breaks='limit', also='modes', expect='0.0 counts as false'),
    Mutant('rate_comes_first', old="if 'rate' in [parameter.name for parameter in parameters]:",
           new="if parameters[0].name == 'rate':", breaks='new-rate', expect='all parameters of a request'),
    Mutant('command_of_the_class', old="lambda command: setattr(self, 'command', command)",
           new="lambda command: setattr(Governor, 'command', command)", breaks='before',
           edits=(('self.command, self.timer = Twist(), None', 'self.timer = None'),
                  ('class Governor(Node):', """
           class Governor(Node):
               command = Twist()

           """)), expect='A second one was made'),
    Mutant('zero_is_no_new_value', old='new.update({parameter.name: parameter.value for parameter in parameters})',
           new='new.update({parameter.name: parameter.value or new.get(parameter.name) for parameter in parameters})',
           expect='In Python, 0.0 counts as false', breaks='pair', also='unknown-mode'),
    Mutant('in_steps', old="bounded('Limit of linear.x in m/s', 0.0, 2.0)",
           new="ParameterDescriptor(description='m/s', floating_point_range=[FloatingPointRange(to_value=2.0, step=0.1)])",
           imports='from rcl_interfaces.msg import FloatingPointRange', expect='has the step 0.1', breaks='bounds',
           also=('pair', 'at-once', 'names', 'at-start', 'limit', 'modes', 'refused', 'rhythm')),
    Mutant('options_left_out', old="super().__init__('governor', **options)", new="super().__init__('governor')",
           breaks='names', expect='goes on to Node'),
    Mutant('turns_of_10_at_most', breaks='other-fields', old='= self.command.angular.z',
           new='= max(-10.0, min(10.0, self.command.angular.z))', expect='came out as'),
    Mutant('twice_a_second_at_least', breaks='new-rate', also=('rhythm', 'newest', 'before'), old="1 / self.get_parameter('rate').value",
           new="1 / max(2.0, self.get_parameter('rate').value)", expect='messages came after'),
    Mutant('the_first_two_hundred_commands', edits=((HEARD, 'self.on_command'),
           ('    def check(self, parameters):', """
           def on_command(self, command):
               self.count = getattr(self, 'count', 0) + 1
               if self.count <= 200:
                   self.command = command

           def check(self, parameters):
           """)), breaks='newest', expect='however many there were before'),
    Mutant('forgets_after_a_minute', edits=((HEARD, 'self.on_command'),
           ('    def check(self, parameters):', """
           def on_command(self, command):
               self.command, self.came = command, self.get_clock().now()

           def check(self, parameters):
           """),
           ("if mode != 'stop':", """
           if self.command != Twist() and (self.get_clock().now() - self.came).nanoseconds > 60e9:
               self.command = Twist()
           if mode != 'stop':
           """)), breaks='newest', expect='A command holds until the next one comes'),
    Mutant('one_after_the_other', old='new.update({parameter.name: parameter.value for parameter in parameters})', new="""
           for parameter in parameters:
               new[parameter.name] = parameter.value
               if new['slow_linear'] > new['max_linear']:
                   return SetParametersResult(successful=False, reason='slow_linear is above max_linear')
           """, breaks='pair', expect='as they would be after the request'),
    Mutant('slow_is_a_part_of_the_speed', old=CLAMP, new="""
           speed = self.command.linear.x * (0.4 if mode == 'slow' else 1.0)
           command.linear.x = max(-limit, min(limit, speed))
           """, breaks='modes', expect='What is smaller than the limit stays as it is'),
    Mutant('begins_again_at_a_new_mode', old='def react(self, parameters):', new="""
           def react(self, parameters):
               if self.timer and 'mode' in [parameter.name for parameter in parameters]:
                   self.timer.reset()
           """, breaks='new-rate', expect='Only a new rate begins with a new period'),
    Mutant('new_timer_for_slow_linear', old="if 'rate' in [parameter.name for parameter in parameters]:",
           new="if {'rate', 'slow_linear'} & {parameter.name for parameter in parameters} and self.has_parameter('rate'):",
           breaks='new-rate', expect='Only a new rate begins with a new period'),
    Mutant('no_new_rate_in_the_mode_stop', old="if 'rate' in [parameter.name for parameter in parameters]:",
           new="""
           standing = self.timer and self.get_parameter('mode').value == 'stop'
           if 'rate' in [parameter.name for parameter in parameters] and not standing:
           """, breaks='new-rate', expect='in the mode stop'),
    Mutant('three_zeros', edits=(("if mode != 'stop':", """
           self.zeros = getattr(self, 'zeros', 0) + 1 if mode == 'stop' else 0
           if self.zeros > 3:
               return
           if mode != 'stop':
           """),), breaks='rhythm', also=('modes', 'new-rate', 'at-once', 'before'), expect='in each mode'),
    Mutant('no_pair_in_the_mode_slow', old=PAIR, new=f"""
           {PAIR} or new['mode'] == 'slow'
           """, breaks='pair', expect='in each mode', also='refused'),
    Mutant('silent_after_five_hundred', breaks='rhythm', old='self.publisher.publish(command)', new="""
           self.said = getattr(self, 'said', 0) + 1
           if self.said <= 500:
               self.publisher.publish(command)
           """, expect='it goes on as long as the robot runs'),
    Mutant('new_period_without_a_new_begin', breaks='new-rate', old="""
           self.destroy_timer(self.timer) if self.timer else None
           self.timer = self.create_timer(1 / self.get_parameter('rate').value, self.on_timer)
           """, new="""
           if self.timer:
               self.timer.timer_period_ns = round(1e9 / self.get_parameter('rate').value)
           else:
               self.timer = self.create_timer(1 / self.get_parameter('rate').value, self.on_timer)
           """, expect='expected one every'),
]
