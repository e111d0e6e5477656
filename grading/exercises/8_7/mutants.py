from grading.variants import Mutant

DECLARED = 'self.declare_parameter(name, default, bounded(description, low, high))'
GOOD = 'response.success = bool(request.name) and math.isfinite(request.x) and math.isfinite(request.y)'
TIMER = "self.create_timer(self.value('status_period'), lambda: self.publisher.publish(String(data=self.state)))"
LATCHED = 'latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)'
PARAMETERS, STATUS = 'test_parameters_and_stations', 'test_status'
TICK = 'lambda: self.publisher.publish(String(data=self.state))'
KEPT = 'self.stations[request.name] = request.x, request.y'

MUTANTS = [
    Mutant('absolute_topic', old=", 'status',", new=", '/status',", expect='your node publishes on /status',
           breaks='names'),
    Mutant('absolute_service', old="'set_station', self", new="'/set_station', self", expect='has no service on',
           breaks='names'),
    Mutant('another_name', old="__init__('delivery_robot'", new="__init__('station_keeper'",
           expect='/delivery_robot', breaks='names'),
    Mutant('four_parameters', old="""
                ('timeout', 60.0, 1.0, 600.0, 'longest time for a drive in s'),
                """, new='', expect='There is no parameter timeout', breaks='parameters'),
    Mutant('integer_timeout', edits=((DECLARED, """
            if name == 'timeout':
                self.declare_parameter(name, 60, ParameterDescriptor(description=description))
            else:
                self.declare_parameter(name, default, bounded(description, low, high))
            """),), expect='write 60.0, and not 60', breaks='parameters'),
    Mutant('another_default', old="'tolerance', 0.1, 0.02", new="'tolerance', 0.2, 0.02", expect='expected 0.1',
           breaks='parameters'),
    Mutant('no_bounds', old=DECLARED,
           new='self.declare_parameter(name, default, ParameterDescriptor(description=description))',
           expect='has the bounds []', breaks='bounds'),
    Mutant('bounds_of_another', old="'max_angular', 1.0, 0.1, 2.0", new="'max_angular', 1.0, 0.05, 1.0",
           expect='The descriptor of max_angular', breaks='bounds', also='parameters'),
    Mutant('no_description', old='bounded(description, low, high)', new="bounded('', low, high)",
           expect='has no description', breaks='description'),
    Mutant('always_idle', old='data=self.state', new="data='idle'", expect='publish it as it is then', breaks='status'),
    Mutant('only_when_it_changes', old=TIMER, new="""
        self.told = None

        def tell():
            if self.told != self.state:
                self.told = self.state
                self.publisher.publish(String(data=self.state))
        self.create_timer(self.value('status_period'), tell)
        """, expect='messages came at', breaks='status-period'),
    Mutant('period_in_tenths', old="self.value('status_period')", new="round(self.value('status_period'), 1)",
           expect='messages came at', breaks='status-period', also='status'),
    Mutant('period_of_its_own', old="self.value('status_period')", new='0.5', expect='messages came at',
           breaks='status-period', also='status'),
    Mutant('the_newest_period', edits=((
           "self.create_timer(self.value('status_period'), lambda: self.publisher.publish(String(data=self.state)))", '''
           self.timer = None
           self.add_post_set_parameters_callback(self.renew)
           self.renew([])
           '''), ('def place(self, name):', '''
           def renew(self, parameters):
               if parameters and 'status_period' not in [parameter.name for parameter in parameters]:
                   return
               self.timer and self.destroy_timer(self.timer)
               self.timer = self.create_timer(
                   self.value('status_period'), lambda: self.publisher.publish(String(data=self.state)))

           def place(self, name):
           ''')), expect='the value at the start counts', breaks='status-period'),
    Mutant('origin_is_no_place', old=GOOD, new=f'{GOOD} and bool(request.x or request.y)', expect='at (0.0, 0.0) was refused',
           breaks='station'),
    Mutant('not_while_it_drives', old=GOOD, new=f"{GOOD} and self.state == 'idle'",
           expect='a station may be set at any time', breaks='station'),
    Mutant('one_name_a_place', old=KEPT, new="""
            place = request.x, request.y
            self.stations = {name: other for name, other in self.stations.items() if other != place}
            self.stations[request.name] = place
            """, expect='is None, expected', breaks='new-place'),
    Mutant('blanks_around_are_nothing', old='return self.stations.get(name)',
           new='return self.stations.get(name, self.stations.get(name.strip()))', expect='nobody has set this station',
           breaks='unknown'),
    Mutant('blanks_are_no_name', old='bool(request.name) and', new='bool(request.name.strip()) and', breaks='station',
           expect='was refused: success is false'),
    Mutant('names_without_blanks', old='self.stations[request.name] =', new='self.stations[request.name.strip()] =',
           expect='After set_station, place(', breaks='station'),
    Mutant('names_in_any_letters', edits=(('return self.stations.get(name)', 'return self.stations.get(name.lower())'),
            ('self.stations[request.name] =', 'self.stations[request.name.lower()] =')),
           expect='nobody has set this station', breaks='unknown'),
    Mutant('a_rate', old="self.value('status_period')", new="1 / self.value('status_period')",
           expect='With status_period = ', breaks='status-period', also='status'),
    Mutant('many_are_kept', old='(depth=1, durability', new='(depth=10, durability',
           expect='expected the newest status', breaks='latched'),
    Mutant('volatile', old=LATCHED, new='latched = 10', expect='offers durability VOLATILE', breaks='latched'),
    Mutant('success_is_forgotten', old=f"""
        {GOOD}
        if response.success:
        """, new='if request.name and math.isfinite(request.x) and math.isfinite(request.y):',
           expect='success is false', breaks='station'),
    Mutant('x_twice', old=KEPT, new='self.stations[request.name] = request.x, request.x', expect='After set_station',
           breaks='station'),
    Mutant('rounded', old=KEPT, new='self.stations[request.name] = round(request.x), round(request.y)',
           expect='After set_station', breaks='station'),
    Mutant('one_station', old=KEPT, new='self.stations = {request.name: (request.x, request.y)}',
           expect='was set, place(', breaks='new-place'),
    Mutant('first_place_stays', old=KEPT, new='self.stations.setdefault(request.name, (request.x, request.y))',
           expect='got a new place, place(', breaks='new-place'),
    Mutant('known_names_are_refused', old=GOOD, new=f'{GOOD} and request.name not in self.stations',
           expect='A new place for', breaks='new-place'),
    Mutant('unknown_is_an_error', old='return self.stations.get(name)', new='return self.stations[name]',
           expect='KeyError', breaks='unknown', also='station'),
    Mutant('unknown_is_the_origin', old='return self.stations.get(name)',
           new='return self.stations.get(name, (0.0, 0.0))', expect='and nobody has set this station',
           breaks='unknown', also='station'),
    Mutant('empty_name', old=GOOD, new='response.success = math.isfinite(request.x) and math.isfinite(request.y)',
           expect='was accepted', breaks='bad-station'),
    Mutant('nan_is_a_number', old='math.isfinite(request.x) and math.isfinite(request.y)',
           new='abs(request.x) != math.inf and abs(request.y) != math.inf', expect='was accepted',
           breaks='bad-station'),
    Mutant('only_nan', old='math.isfinite(request.x) and math.isfinite(request.y)',
           new='not math.isnan(request.x) and not math.isnan(request.y)', expect='was accepted', breaks='bad-station'),
    Mutant('only_x', old=' and math.isfinite(request.y)', new='', expect='was accepted', breaks='bad-station'),
    Mutant('zero_is_no_number', old='math.isfinite(request.x) and math.isfinite(request.y)',
           new='bool(request.x) and bool(request.y) and math.isfinite(request.x) and math.isfinite(request.y)',
           expect='was refused', breaks='new-place', also='station'),
    Mutant('notes_before_it_looks', old='def on_set_station(self, request, response):', new="""
        def on_set_station(self, request, response):
            self.stations[request.name] = request.x, request.y
        """, expect='was refused, and yet it is a station now', breaks='unchanged'),
    Mutant('says_that_it_refused', old="response.message = 'name must not be empty, x and y must be finite'",
           new="response.message = 'bad'\nself.state = 'refused'\n", expect="the status is 'refused' now",
           breaks='unchanged'),
    Mutant('forgets_what_was_refused', old="response.message = 'name must not be empty, x and y must be finite'",
           new="response.message = 'bad'\nself.stations.pop(request.name, None)\n", expect='was refused, and now',
           breaks='unchanged'),
    Mutant('refuses_without_a_word', old="response.message = 'name must not be empty, x and y must be finite'",
           new='response.success = False', expect='was refused without a message', breaks='message'),
    Mutant('stations_of_the_class', old='self.stations = {}  # name: (x, y)', new='self.stations = STATIONS',
           imports='STATIONS = {}', expect='belong to the object', breaks='unknown'),
    Mutant('also_at_the_start', old=TIMER, new=TIMER + '\nself.publisher.publish(String(data=self.state))\n',
           expect='Right after the start', breaks='status-period'),
    Mutant('also_with_each_station', old=KEPT, new=KEPT + '\nself.publisher.publish(String(data=self.state))\n',
           expect='only the timer publishes', breaks='status-period', also='status'),
    Mutant('idle_with_each_station', old=KEPT, new=KEPT + "\nself.state = 'idle'\n", expect='a station was set, and',
           breaks='status', also='latched'),
    Mutant('not_so_far_away', old=GOOD,
           new='response.success = bool(request.name) and abs(request.x) < 100 and abs(request.y) < 100',
           expect='was refused: success is false', breaks='station'),
    Mutant('one_word', old='bool(request.name)', new='request.name.isidentifier()',
           expect='was refused: success is false', breaks='station'),
    Mutant('five_stations', old=KEPT, new=KEPT + """
if len(self.stations) > 5:
    self.stations.pop(next(iter(self.stations)))
""", expect='was set, place(', breaks='new-place', also='unknown'),
    Mutant('ignores_the_start', old=DECLARED, new="""
            override = name == 'status_period'
            self.declare_parameter(name, default, bounded(description, low, high), ignore_override=not override)
            """, expect='The node was started with', breaks='parameters'),
    Mutant('too_far_away', old='math.isfinite(request.x) and math.isfinite(request.y)',
           new='math.isfinite(math.hypot(request.x, request.y))', breaks='station', expect='judge each one by itself'),
    Mutant('names_for_topics', old=GOOD, new=GOOD + " and '/' not in request.name", breaks='station',
           expect='A name is any text that is not empty'),
    Mutant('names_in_one_line', old=GOOD, new=GOOD + ' and request.name.isprintable()', breaks='station',
           expect='A name is any text that is not empty'),
    Mutant('names_in_ascii', old=GOOD, new=GOOD + ' and request.name.isascii()', breaks='station',
           expect='was refused: success is false'),
    Mutant('names_without_digits_first', old=GOOD, new=GOOD + ' and not request.name[0].isdigit()', breaks='station',
           expect='A name is any text that is not empty'),
    Mutant('short_names', old=GOOD, new=GOOD + ' and len(request.name) < 64', breaks='station',
           expect='A name is any text that is not empty'),
    Mutant('accents_are_joined', edits=(('self.stations[request.name] =', "self.stations[normalize('NFC', request.name)] ="),),
           imports='from unicodedata import normalize', breaks='station', also='new-place', expect='is None, expected'),
    Mutant('a_place_is_a_list', old=KEPT, new='self.stations[request.name] = [request.x, request.y]', breaks='station',
           expect='expected the tuple'),
    Mutant('any_type', edits=((DECLARED, """
            descriptor = bounded(description, low, high)
            descriptor.dynamic_typing = True
            self.declare_parameter(name, default, descriptor)
            """),), breaks='parameters', expect='may change its type'),
    Mutant('in_steps', edits=((DECLARED, """
            descriptor = bounded(description, low, high)
            descriptor.floating_point_range[0].step = 0.001
            self.declare_parameter(name, default, descriptor)
            """),), breaks='bounds', expect='has the step 0.001'),
    Mutant('same_place_refused', old='response.success = bool(request.name) and',
           new='response.success = self.place(request.name) != (request.x, request.y) and bool(request.name) and',
           breaks='station', expect='at the place that it has'),
    Mutant('options_left_out', old="super().__init__('delivery_robot', **options)",
           new="super().__init__('delivery_robot')", breaks='names', expect='goes on to Node'),
    Mutant('sum_is_finite', old='math.isfinite(request.x) and math.isfinite(request.y)',
           new='math.isfinite(request.x + request.y)', breaks='station', expect='judge each one by itself'),
    Mutant('micrometres', breaks='station', old='self.stations[request.name] = request.x, request.y',
           new='self.stations[request.name] = round(request.x, 6), round(request.y, 6)', expect='After set_station, place'),
    Mutant('status_of_forty_letters', old='data=self.state)', new='data=self.state[:40])', breaks='status', also='latched',
           expect='publish it as it is then'),
    Mutant('letters_are_put_together', edits=(('self.stations[request.name]', "self.stations[normalize('NFC', request.name)]"),
           ('self.stations.get(name)', "self.stations.get(normalize('NFC', name))")), imports='from unicodedata import normalize',
           breaks='unknown', expect='nobody has set this station'),
    Mutant('silent_after_a_hundred', edits=((TICK, 'self.on_timer'), ('    def value(self, name):', """
           def on_timer(self):
               self.count = getattr(self, 'count', 0) + 1
               if self.count <= 100:
                   self.publisher.publish(String(data=self.state))

           def value(self, name):
           """)), breaks='status-period', expect='it goes on as long as the robot runs'),
    Mutant('the_first_hundred_states', edits=((TICK, 'self.on_timer'), ('    def value(self, name):', """
           def on_timer(self):
               self.count = getattr(self, 'count', 0) + 1
               self.told = self.state if self.count <= 100 else self.told
               self.publisher.publish(String(data=self.told))

           def value(self, name):
           """)), breaks='status', expect='publish it as it is then'),
    Mutant('three_new_places', old='if response.success:', new="""
           self.moved = getattr(self, 'moved', 0) + (request.name in self.stations)
           if response.success and self.moved > 3 and request.name in self.stations:
               return response
           if response.success:
           """, breaks='new-place', expect='After all stations got new places'),
    Mutant('names_of_two_hundred_letters', old='bool(request.name) and', new='0 < len(request.name) <= 200 and',
           breaks='station', expect='A name is any text that is not empty'),
    Mutant('status_expires', edits=(('durability=DurabilityPolicy.TRANSIENT_LOCAL',
           'durability=DurabilityPolicy.TRANSIENT_LOCAL, lifespan=Duration(seconds=3)'),),
           imports='from rclpy.duration import Duration', breaks='latched', expect='has the lifespan'),
    Mutant('status_in_small_letters', old='data=self.state)', new='data=self.state.lower())', breaks='status', also='latched',
           expect='publish it as it is then'),
    Mutant('silent_after_five_hundred', edits=((TICK, 'self.on_timer'), ('    def value(self, name):', """
           def on_timer(self):
               self.count = getattr(self, 'count', 0) + 1
               if self.count <= 500:
                   self.publisher.publish(String(data=self.state))

           def value(self, name):
           """)), breaks='status-period', expect='it goes on as long as the robot runs'),
    Mutant('best_effort', edits=((LATCHED, """
           latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL,
                                reliability=ReliabilityPolicy.BEST_EFFORT)
           """),), imports='from rclpy.qos import ReliabilityPolicy', breaks='latched',
           expect='offers reliability BEST_EFFORT'),
    Mutant('two_seconds_at_most', old="self.value('status_period'), lambda", new="min(2.0, self.value('status_period')), lambda",
           breaks='status-period', expect='The period is the value of the parameter'),
    Mutant('eight_a_second_at_most', old="self.value('status_period'), lambda",
           new="max(0.12, self.value('status_period')), lambda", breaks='status-period',
           expect='The period is the value of the parameter'),
    Mutant('whole_milliseconds', old="self.value('status_period'), lambda",
           new="round(self.value('status_period'), 3), lambda", breaks='status-period',
           expect='The period is the value of the parameter'),
    Mutant('also_when_it_refuses', old="response.message = 'name must not be empty, x and y must be finite'", new="""
           response.message = 'bad'
           self.publisher.publish(String(data=self.state))
           """, breaks='status-period', expect='A station was refused, and at once'),
    Mutant('also_when_it_is_asked', old='return self.stations.get(name)', new="""
           self.publisher.publish(String(data=self.state))
           return self.stations.get(name)
           """, breaks='status-period', expect='place was called, and at once'),
    Mutant('also_with_each_parameter', old=TIMER, new=f"""
           {TIMER}
           self.add_post_set_parameters_callback(lambda _: self.publisher.publish(String(data=self.state)))
           """, breaks='status-period', expect='max_linear was set, and at once'),
    Mutant('begins_again_with_each_station', edits=((TIMER, f'self.timer = {TIMER}'), (KEPT, f"""
           {KEPT}
           self.timer.reset()
           """)), breaks='status-period', expect='no request changes the rhythm'),
    Mutant('begins_again_with_each_parameter', old=TIMER, new=f"""
           self.timer = {TIMER}
           self.add_post_set_parameters_callback(lambda _: self.timer.reset())
           """, breaks='status-period', expect='no request changes the rhythm'),
]
