from grading.variants import Mutant

ROUND = "distance, *velocity = steer(*pose, *place, self.value('max_linear'), self.value('max_angular'))"
FEEDBACK = '''
if step % 4 == 0:
    goal.publish_feedback(GoToStation.Feedback(distance=distance))
'''
LOST = '''
elif pose is None:
    end, why = goal.abort, 'the robot is lost'
'''
LATE = '''
elif 0.1 * step >= self.value('timeout'):
    end, why = goal.abort, 'it took too long'
'''
CANCELLED = '''
if goal.is_cancel_requested:
    end, why = goal.canceled, 'cancelled'
elif pose is None:
'''
RESULT = 'return GoToStation.Result(distance=distance, message=why)'
END = '''
self.drive(0.0, 0.0)
self.state = 'idle'
end()
'''
DRIVE, BOTH = 'test_drive', 'test_lost_and_late'

MUTANTS = [
    Mutant('not_lost_when_late', breaks='lost', old='elif pose is None:', new='elif pose is None and step < 80:',
           expect='and the localiser fell silent'),
    Mutant('no_feedback_when_late', breaks='feedback', old='if step % 4 == 0:', new='if step % 4 == 0 and step < 80:',
           expect='feedback'),
    Mutant('no_feedback_near_the_station', breaks='feedback', old='if step % 4 == 0:',
           new='if step % 4 == 0 and distance > 0.3:', expect='no feedback came'),
    Mutant('small_tolerance_is_five_cm', breaks='succeeds', old="distance < self.value('tolerance')",
           new="distance < max(0.05, self.value('tolerance'))", expect='m away from the station, and the goal is'),
    Mutant('not_slower_than_a_decimetre_a_second', breaks='rhythm', old='self.drive(*velocity)',
           new='self.drive(max(0.1, velocity[0]) if velocity[0] else 0.0, velocity[1])',
           expect='Drive with the result of steer, as it is'),
    Mutant('centimetres_in_the_result', breaks='result', old=RESULT,
           new='return GoToStation.Result(distance=round(distance, 2), message=why)',
           expect='It is the distance of steer, as it is'),
    Mutant('eight_seconds_at_most', breaks='timeout', also=('feedback', 'lost', 'cancel'), old=">= self.value('timeout')",
           new=">= min(8.0, self.value('timeout'))", expect='expected to go on'),
    Mutant('goes_to_the_moon', old='.place(request.station) is None or self.where', new='.where',
           expect='The goal moon was accepted', breaks='rejects-unknown', alone=True),
    Mutant('a_part_of_the_name', edits=(
           ('self.place(request.station) is None', 'not any(name.startswith(request.station) for name in self.stations)'),
           ('self.place(goal.request.station),',
            'next(it for name, it in self.stations.items() if name.startswith(goal.request.station)),')),
           expect='Nobody has set this station', breaks='rejects-unknown', alone=True),
    Mutant('origin_is_no_station', old='self.place(request.station) is None', new='not any(self.place(request.station) or ())',
           expect='to the station at (0, 0)', breaks='next', alone=True),
    Mutant('idle_after_each_rejection', old='            return GoalResponse.REJECT', new="""
            if self.place(request.station) is None:
                self.state = 'idle'
            return GoalResponse.REJECT
            """, expect='was accepted', breaks='single', also='state', alone=True),
    Mutant('accepts_while_lost', old=' or self.where() is None:', new=':', expect='does not know where it is',
           breaks='rejects-lost', alone=True),
    Mutant('two_at_a_time', old=".state != 'idle' or self.place", new='.place', expect='both were accepted',
           breaks='single', alone=True),
    Mutant('taken_when_it_executes', edits=(("self.state = f'driving to {request.station}'", ''),
            ('def execute(self, goal):',
             "def execute(self, goal):\n    self.state = f'driving to {goal.request.station}'\n")),
           expect='execute comes too late', breaks='single', alone=True),
    Mutant('tolerance_of_the_start', edits=(("distance < self.value('tolerance')", 'distance < near'),
            ('def execute(self, goal):', "def execute(self, goal):\n    near = self.value('tolerance')\n")),
           expect='expected succeeded', breaks='succeeds', also='timeout', alone=True),
    Mutant('five_times_a_second', old='sleep_for(Duration(seconds=0.1))', new='sleep_for(Duration(seconds=0.2))',
           expect='from one command to the next', breaks='rhythm', also='timeout', alone=True),
    Mutant('looks_every_second_round', edits=(
        ('step, pose = step + 1, self.where()', 'step, pose = step + 1, self.where() if step % 2 == 0 else pose'),
        ("step, distance, end = self.place(goal.request.station), 0, -1.0, None",
         "step, distance, end, pose = self.place(goal.request.station), 0, -1.0, None, None")),
           expect='ask where() and steer() every 0.1 s', breaks='rhythm', alone=True),
    Mutant('parameters_read_once', edits=(('super().__init__(**options)', """
            super().__init__(**options)
            self.limits = self.value('max_linear'), self.value('max_angular')
            """),
            ("self.value('max_linear'), self.value('max_angular')", '*self.limits')), expect='max_angular was set to',
           breaks='limits', alone=True),
    Mutant('limits_of_the_card', old=ROUND, new='distance, *velocity = steer(*pose, *place, 0.5, 1.0)',
           expect='max_angular was set to', breaks='limits', also='rhythm', alone=True),
    Mutant('limits_exchanged', old=ROUND, new=ROUND.replace('max_linear', 'MAX').replace('max_angular', 'max_linear')
           .replace('MAX', 'max_angular'), expect='expected 1.0 (max_angular)', breaks='limits',
           also=('rhythm', 'result', 'timeout'), alone=True),
    Mutant('floods', old=FEEDBACK, new='goal.publish_feedback(GoToStation.Feedback(distance=distance))',
           expect='feedback messages came in a second', breaks='feedback', alone=True),
    Mutant('silent', old=FEEDBACK, new='', expect='no feedback came', breaks='feedback', alone=True),
    Mutant('once_a_second', old='step % 4', new='step % 10', expect='feedback messages came in a second',
           breaks='feedback', alone=True),
    Mutant('never_without_way', old='self.drive(*velocity)', new='self.drive(max(0.05, velocity[0]), velocity[1])',
           expect='as they are', breaks='rhythm', alone=True),
    Mutant('yaw_is_rounded', old='steer(*pose,', new='steer(pose[0], pose[1], round(pose[2], 1),', expect='as they are',
           breaks='rhythm', alone=True),
    Mutant('late_only_while_it_drives', old="elif 0.1 * step >= self.value('timeout'):",
           new="elif velocity[0] and 0.1 * step >= self.value('timeout'):", expect='whatever the robot does',
           breaks='timeout', alone=True),
    Mutant('looks_there_too', old="distance < self.value('tolerance')",
           new="distance < self.value('tolerance') and abs(velocity[1]) < 0.6", expect='looked to 2.5 rad',
           breaks='succeeds', alone=True),
    Mutant('nothing_left', old=RESULT, new=RESULT.replace('=distance', "=0.0 if why == 'arrived' else distance"),
           expect='in its result is 0', breaks='result', alone=True),
    Mutant('message_is_the_station', old=RESULT, new=RESULT.replace('=why', '=goal.request.station'),
           expect='how the drive ended', breaks='result', alone=True),
    Mutant('feedback_of_nothing', old='GoToStation.Feedback(distance=distance)', new='GoToStation.Feedback()',
           expect='The last feedback says', breaks='feedback', alone=True),
    Mutant('tolerance_of_its_own', old="distance < self.value('tolerance')", new='distance < 0.1',
           expect='expected succeeded', breaks='succeeds', alone=True),
    Mutant('arrives_early', old="distance < self.value('tolerance')", new="distance < 3 * self.value('tolerance')",
           expect='With tolerance = 0.1', breaks='succeeds', also='stands', alone=True),
    Mutant('arrives_at_the_tolerance', old="distance < self.value('tolerance')", new="distance <= self.value('tolerance')",
           expect='is below the tolerance', breaks='succeeds', alone=True),
    Mutant('arrives_never', old="distance < self.value('tolerance')", new='distance == 0.0',
           expect='the goal is still running', breaks='succeeds', also='timeout', alone=True),
    Mutant('aborts_on_arrival', old='end, why = goal.succeed,', new='end, why = goal.abort,',
           expect='the goal is aborted, expected succeeded', breaks='succeeds', alone=True),
    Mutant('does_not_listen', old=CANCELLED, new='if pose is None:', expect='the goal is still running',
           breaks='cancel', alone=True),
    Mutant('refuses_to_cancel', old='CancelResponse.ACCEPT', new='CancelResponse.REJECT',
           expect='The cancel request was not accepted', breaks='cancel', alone=True),
    Mutant('cancelled_is_aborted', old='end, why = goal.canceled', new='end, why = goal.abort',
           expect='the goal is aborted, expected canceled', breaks='cancel', alone=True),
    Mutant('looks_now_and_then', old='if goal.is_cancel_requested:',
           new='if goal.is_cancel_requested and step % 10 == 0:', expect='after a', breaks='cancel', alone=True),
    Mutant('drives_blind', old=LOST, new='', expect='and the goal runs on', breaks='lost', alone=True),
    Mutant('lost_is_canceled', old="end, why = goal.abort, 'the robot is lost'",
           new="end, why = goal.succeed, 'the robot is lost'", expect='expected aborted', breaks='lost', alone=True),
    Mutant('waits_for_ever', old=LATE, new='', expect='the goal still runs after', breaks='timeout', alone=True),
    Mutant('a_minute', old="0.1 * step >= self.value('timeout')", new='0.1 * step >= 60.0',
           expect='the goal still runs after', breaks='timeout', alone=True),
    Mutant('rounds_for_seconds', old='elif 0.1 * step >=', new='elif step >=', expect='Each goal has that time',
           breaks='timeout', also=('lost', 'succeeds', 'single', 'rhythm', 'next'), alone=True),
    Mutant('one_time_for_all_goals', edits=(
        ('step, pose = step + 1, self.where()', 'self.steps = getattr(self, "steps", 0) + 1\nstep, pose = step + 1, self.where()\n'),
        ('0.1 * step >=', '0.1 * self.steps >=')), expect='Each goal has that time for itself', breaks='timeout',
           also='succeeds', alone=True),
    Mutant('drives_on', old='self.drive(0.0, 0.0)', new='', expect='Before every end', breaks='stands', alone=True),
    Mutant('stands_only_at_the_station', old='self.drive(0.0, 0.0)',
           new="self.drive(0.0, 0.0) if why == 'arrived' else None", expect='Before every end', breaks='stands',
           alone=True),
    Mutant('stands_three_times', old='self.drive(0.0, 0.0)', new="""
        for _ in range(3):
            self.drive(0.0, 0.0)
        """, expect='more than once to stand', breaks='stands', alone=True),
    Mutant('stands_after_the_end', old=END, new='''
end()
self.drive(0.0, 0.0)
self.state = 'idle'
''', expect='published only after the goal had ended', breaks='stands', alone=True),
    Mutant('no_message', old=RESULT, new='return GoToStation.Result(distance=distance)', expect='is empty',
           breaks='result', alone=True),
    Mutant('one_message', old=RESULT, new="return GoToStation.Result(distance=distance, message='ended')",
           expect='It says how the drive ended', breaks='result', alone=True),
    Mutant('no_distance', old=RESULT, new='return GoToStation.Result(message=why)', expect='has the distance 0.00 m',
           breaks='result', alone=True),
    Mutant('distance_unknown_when_lost', old='if pose:', new='distance = -1.0\nif pose:\n', expect='It was known last',
           breaks='result', alone=True),
    Mutant('drives_without_a_name', old="self.state = f'driving to {request.station}'", new="self.state = 'driving'",
           expect="self.state is 'driving'", breaks='state', alone=True),
    Mutant('says_where_it_went', edits=(("self.state != 'idle' or", "self.state.startswith('driving') or"),
            ("self.state = 'idle'", "self.state = why")), expect="expected 'idle'", breaks='state', alone=True),
    Mutant('place_of_the_last_request', edits=((
        'def on_goal(self, request):', 'def on_goal(self, request):\n    self.wanted = request.station\n'),
        ('steer(*pose, *place,', 'steer(*pose, *(self.place(self.wanted) or place),')),
           expect='Take the station from the goal that you execute', breaks='single', alone=True),
    Mutant('idle_when_it_rejects', old='return GoalResponse.REJECT', new="self.state = 'idle'\nreturn GoalResponse.REJECT\n",
           expect="expected 'driving to", breaks='state', alone=True),
    Mutant('idle_near_the_station', old='if goal.is_cancel_requested:', new="""
        if pose and distance < 0.4:
            self.state = 'idle'
        if goal.is_cancel_requested:
        """, expect='to its end', breaks='state', alone=True),
    Mutant('never_idle_again', old="self.state = 'idle'", new="""
        if not goal.is_cancel_requested:
            self.state = 'idle'
        """, expect="expected 'idle'", breaks='state', also='next', alone=True),
    Mutant('distance_of_no_round', old='step, distance, end = self.place(goal.request.station), 0, -1.0, None',
           new='step, end = self.place(goal.request.station), 0, None', breaks='lost', expect='distance'),
    Mutant('lost_once_lost_for_ever',
           edits=(("if self.state != 'idle' or", "if self.state != 'idle' or self.given_up or"),
            ('super().__init__(**options)', 'super().__init__(**options)\nself.given_up = False\n'),
            ('end()', "end()\nself.given_up = why == 'the robot is lost'\n")),
           expect='the robot knows again where it is', breaks='next', alone=True),
    Mutant('absolute_name', old="'go_to_station', self.execute", new="'/go_to_station', self.execute",
           expect='/go_to_station', breaks='action', alone=True),
    Mutant('never_faster_than_half_a_metre', old=ROUND, new=ROUND.replace("self.value('max_linear')", "min(0.5, self.value('max_linear'))"),
           expect='max_linear was set to', breaks='limits', alone=True),
    Mutant('silent_while_it_turns', edits=((FEEDBACK, FEEDBACK.replace('== 0:', '== 0 and velocity[0]:')),),
           expect='has turned on the spot, and no feedback came', breaks='feedback', alone=True),
    Mutant('looks_twice_a_second', old='if goal.is_cancel_requested:',
           new='if goal.is_cancel_requested and step % 5 == 0:', expect='after a', breaks='cancel',
           alone=True),
    Mutant('one_message_for_late_and_there', old=RESULT,
           new="return GoToStation.Result(distance=distance, message='cancelled' if why == 'cancelled' else 'ended')",
           expect='with the same message', breaks='result', alone=True),
    Mutant('one_arrival_only', edits=(("if self.state != 'idle' or", "if self.state != 'idle' or self.arrived or"),
            ('super().__init__(**options)', 'super().__init__(**options)\nself.arrived = False\n'),
            ('end()', "end()\nself.arrived = why == 'arrived'\n")),
           expect='A goal has succeeded, and this is the next one', breaks='next', alone=True),
    Mutant('goal_callbacks_side_by_side', old='cancel_callback=lambda goal: CancelResponse.ACCEPT)', new="""
        cancel_callback=lambda goal: CancelResponse.ACCEPT,
        callback_group=__import__('rclpy.callback_groups').callback_groups.ReentrantCallbackGroup())
        """, expect='a lock must hold from the look at self.state', breaks='single', alone=True),
    Mutant('seven_goals_at_most', edits=(('super().__init__(**options)', 'super().__init__(**options)\nself.left = 7\n'),
            ("if self.state != 'idle' or", 'if self.left == 0 or self.state != \'idle\' or'),
            ("self.state = f'driving to {request.station}'", "self.left -= 1\nself.state = f'driving to {request.station}'\n")),
           expect='goals have ended, two came after that', breaks='next', alone=True),
    Mutant('one_state_for_all_robots', edits=(('super().__init__(**options)', """
            super().__init__(**options)
            DeliveryRobot.state = self.__dict__.pop('state')
            """), ("self.state = f'driving to {request.station}'", "DeliveryRobot.state = f'driving to {request.station}'"),
            ("self.state = 'idle'", "DeliveryRobot.state = 'idle'")),
           expect='Two robots are in one program', breaks='state', also='single', alone=True),
    Mutant('arrives_when_it_has_stayed', edits=(("distance < self.value('tolerance')", 'calm == 3'),
            ('if goal.is_cancel_requested:',
             "calm = calm + 1 if distance < self.value('tolerance') else 0\nif goal.is_cancel_requested:"),
            ('step, distance, end = self.place(goal.request.station), 0, -1.0, None',
             'step, distance, end, calm = self.place(goal.request.station), 0, -1.0, None, 0')),
           expect='in the round in which the distance is below', breaks='succeeds', alone=True),
    Mutant('arrives_in_a_square', old="distance < self.value('tolerance')",
           new="max(abs(pose[0] - place[0]), abs(pose[1] - place[1])) < self.value('tolerance')",
           expect='What counts is the distance', breaks='succeeds', also='result', alone=True),
    Mutant('stands_if_it_has_driven', old='self.drive(0.0, 0.0)', new='self.drive(0.0, 0.0) if step > 1 else None',
           expect='also where the robot has not driven', breaks='stands', alone=True),
    Mutant('patient_when_lost', edits=((LOST, LOST.replace('pose is None', 'lost == 4') + '''
elif pose is None:
    pass
'''), ('if goal.is_cancel_requested:', 'lost = lost + 1 if pose is None else 0\nif goal.is_cancel_requested:'),
            ('step, distance, end = self.place(goal.request.station), 0, -1.0, None',
             'step, distance, end, lost = self.place(goal.request.station), 0, -1.0, None, 0')),
           expect='it ends in the round in which where() is None', breaks='lost', alone=True),
    Mutant('small_letters', old="f'driving to {request.station}'", new="f'driving to {request.station.lower()}'",
           expect='self.state is', breaks='state', alone=True),
    Mutant('twenty_letters_of_a_name', breaks='state', old="f'driving to {request.station}'",
           new="f'driving to {request.station[:20]}'", expect='self.state is'),
    Mutant('goes_on_if_it_is_near', breaks='cancel', old='if goal.is_cancel_requested:',
           new='if goal.is_cancel_requested and distance > 0.3:', expect='a goal 0.28 m away was sent'),
    Mutant('silent_at_the_end', breaks='feedback', old='if step % 4 == 0:', new='if step % 4 == 0 and distance > 0.5:',
           expect='to the end'),
    Mutant('rounded_distances', breaks='feedback', old='Feedback(distance=distance)', new='Feedback(distance=round(distance, 1))',
           expect='all of them are rounded'),
    Mutant('twice_at_first', breaks='rhythm', old='self.drive(*velocity)', new="""
        self.drive(*velocity)
        if step == 1:
            self.drive(*velocity)
        """, expect='two commands came within'),
    Mutant('feedback_of_x', breaks='feedback', old='Feedback(distance=distance)',
           new='Feedback(distance=abs(pose[0] - place[0]) if pose else distance)', expect='It is the distance of steer'),
    Mutant('result_of_x', breaks='result', old='Result(distance=distance', new='Result(distance=abs(pose[0] - place[0]) if pose else distance',
           expect='It is the distance of steer'),
    Mutant('stands_when_it_rejects', breaks='single', old='return GoalResponse.REJECT', new="""
        self.drive(0.0, 0.0)
        return GoalResponse.REJECT
        """, also='stands', expect='it was told to stand'),
    Mutant('nearest_so_far', breaks='feedback', edits=(('Feedback(distance=distance)', 'Feedback(distance=nearest)'),
           ('if step % 4 == 0:', """
           nearest = distance if step == 1 else min(nearest, distance)
           if step % 4 == 0:
           """)), expect='then it was carried away'),
    Mutant('idle_when_it_is_called_back', breaks='state', also='single', alone=True, edits=(
           ('cancel_callback=lambda goal: CancelResponse.ACCEPT', 'cancel_callback=self.on_cancel'),
           ('def execute(self, goal):', """
           def on_cancel(self, goal):
               self.state = 'idle'
               return CancelResponse.ACCEPT

           def execute(self, goal):
           """)), expect='A cancel request came, and the goal'),
    Mutant('drives_before_it_says_so', breaks='state', alone=True, edits=(
           ("if self.state != 'idle' or", 'if self.taken or'),
           ("self.state = f'driving to {request.station}'", 'self.taken = True'),
           ('super().__init__(**options)', """
           super().__init__(**options)
           self.taken = False
           """),
           ('step, pose = step + 1, self.where()', """
           self.state = f'driving to {goal.request.station}'
           step, pose = step + 1, self.where()
           """),
           ("self.state = 'idle'", "self.taken, self.state = False, 'idle'")),
           expect='and no time has passed'),
    Mutant('idle_a_moment_later', breaks='state', alone=True, edits=(
           ("if self.state != 'idle' or", 'if self.taken or'),
           ("self.state = f'driving to {request.station}'", "self.taken, self.state = True, f'driving to {request.station}'"),
           ('super().__init__(**options)', """
           super().__init__(**options)
           self.taken = False
           """),
           ("self.state = 'idle'", """
           self.taken = False
           self.later = self.create_timer(0.1, self.rest)
           """),
           ('def execute(self, goal):', """
           def rest(self):
               self.later.cancel()
               self.state = self.state if self.taken else 'idle'

           def execute(self, goal):
           """)), expect='s after its end the status was'),
    Mutant('a_quarter_of_a_second_early', breaks='timeout', alone=True, old="0.1 * step >= self.value('timeout')",
           new="0.1 * step >= self.value('timeout') - 0.25", expect='Each goal has that time for itself'),
    Mutant('tolerance_of_the_beginning', breaks='succeeds', alone=True, expect='was set to 0.', edits=(
        ("distance < self.value('tolerance')", "distance < min(near, self.value('tolerance'))"),
        ('def execute(self, goal):', "def execute(self, goal):\n    near = self.value('tolerance')\n"))),
]
