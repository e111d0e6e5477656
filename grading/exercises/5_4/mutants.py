from grading.variants import Mutant

WAIT = 'self.get_clock().sleep_for(Duration(seconds=0.1))'
STEER = 'distance, command = steer(self.pose, goal.request.x, goal.request.y)'
FEEDBACK = '''
if step % 2 == 0:
    goal.publish_feedback(DriveTo.Feedback(distance=distance))
'''
STANDS = 'test_standing_robot'
DRIVES = 'test_simulated_robot'

MUTANTS = [
    Mutant('rounds_go_on_after_a_success', breaks='give-up', edits=(
        ('self.pose, self.busy = None, False', 'self.pose, self.busy, self.rounds = None, False, 0'),
        ('for step in range(1, 201):', 'for step in range(1 + self.rounds, 201):'), ('''
        self.motor.publish(Twist())
        self.busy = False
        ''', '''
        self.rounds = step if distance < 0.1 else 0
        self.motor.publish(Twist())
        self.busy = False
        ''')), expect='each goal has 20 s of its own'),
    Mutant('free_after_a_goal_outside', breaks='busy', old='''
        if self.busy or self.pose is None or not inside:
            return GoalResponse.REJECT
        ''', new='''
        if not inside:
            self.busy = False
            return GoalResponse.REJECT
        if self.busy or self.pose is None:
            return GoalResponse.REJECT
        ''', expect='only the end of the goal that runs sets the robot free'),
    *[Mutant(f'no_pose_where_{name}_is_0', breaks='no-pose', also=('next', 'arrive'), old='self.pose is None or',
             new=f'not self.pose or not self.pose.{name} or', expect='A coordinate 0.0 counts as False')
      for name in 'xy'],
    Mutant('one_result_object', breaks='result', edits=(
           ('self.pose, self.busy = None, False', 'self.pose, self.busy, self.left = None, False, DriveTo.Result()'),
           ('return DriveTo.Result(distance=distance)', '''
           self.left.distance = distance
           return self.left
           ''')), expect='make a new Result in each execute'),
    Mutant('no_cancel_after_10_s', breaks='cancel', also=('zeros', 'result', 'next'),
           old='if goal.is_cancel_requested or distance < 0.1:',
           new='if goal.is_cancel_requested and step <= 100 or distance < 0.1:', expect='A goal was cancelled 1'),
    Mutant('no_feedback_near_the_place', breaks='feedback', old='if step % 2 == 0:',
           new='if step % 2 == 0 and distance > 0.35:', expect='also near the place'),
    Mutant('no_cancel_at_the_right_wall', old='lambda goal: CancelResponse.ACCEPT',
           new='lambda goal: CancelResponse.ACCEPT if self.pose.x < 9 else CancelResponse.REJECT',
           expect='the cancel request was refused', breaks='cancel'),
    Mutant('box_around_the_place', breaks='arrive', also='result', edits=((
           'distance, command = steer(self.pose, goal.request.x, goal.request.y)', '''
            distance, command = steer(self.pose, goal.request.x, goal.request.y)
            there = max(abs(self.pose.x - goal.request.x), abs(self.pose.y - goal.request.y)) < 0.1
            '''), ('if goal.is_cancel_requested or distance < 0.1:', 'if goal.is_cancel_requested or there:'),
           ('goal.succeed if distance < 0.1 else', 'goal.succeed if there else')),
           expect='the same way in x and in y'),
    Mutant('forgets_the_pose', breaks='next', also=('no-pose', 'give-up', 'arrive', 'busy', 'zeros', 'field'),
           old='self.busy = False', new='self.busy, self.pose = False, None',
           expect='the newest pose stays'),
    Mutant('no_feedback_while_it_turns', breaks='feedback', old='if step % 2 == 0:',
           new='if step % 2 == 0 and command.linear.x:', expect='also while the robot only turns'),
    Mutant('no_zeros_without_a_move', breaks='zeros', old='self.motor.publish(Twist())', new='''
        if step > 1:
            self.motor.publish(Twist())
        ''', expect='They come before every end'),
    Mutant('rounds_go_on_after_a_cancel', breaks='give-up', edits=(
        ('self.pose, self.busy = None, False', 'self.pose, self.busy, self.rounds = None, False, 0'),
        ('for step in range(1, 201):', 'for step in range(1 + self.rounds, 201):'), ('''
        self.motor.publish(Twist())
        self.busy = False
        ''', '''
        self.rounds = step if goal.is_cancel_requested else 0
        self.motor.publish(Twist())
        self.busy = False
        ''')), expect='each goal has 20 s of its own'),
    Mutant('free_when_asked_to_cancel', breaks='busy', edits=(
        ('cancel_callback=lambda goal: CancelResponse.ACCEPT)', 'cancel_callback=self.on_cancel)'),
        ('def on_pose(self, pose):', '''
        def on_cancel(self, goal):
            self.busy = False
            return CancelResponse.ACCEPT

        def on_pose(self, pose):
        ''')), expect='not when somebody has asked for its end'),
    Mutant('absolute_action', breaks='names', old="'drive_to', self.execute", new="'/drive_to', self.execute",
           expect='without a leading slash'),
    Mutant('absolute_pose', breaks='names', old="'turtle1/pose'", new="'/turtle1/pose'",
           expect='without a leading slash'),
    Mutant('accepts_everywhere', breaks='field', old='inside = 0 <= request.x <= 11 and 0 <= request.y <= 11',
           new='inside = True', expect='No turtle can get there'),
    Mutant('accepts_nan', breaks='field', old='inside = 0 <= request.x <= 11 and 0 <= request.y <= 11',
           new='inside = min(request.x, request.y) >= 0 and max(request.x, request.y) <= 11',
           expect='The goal (5, nan) was accepted'),
    Mutant('arrives_early', breaks='arrive', also='result',
           edits=(('distance < 0.1:', 'distance < 0.3:'), ('if distance < 0.1 else', 'if distance < 0.3 else')),
           expect='expected to go on until the distance is below 0.1 m'),
    Mutant('arrives_a_centimetre_early', breaks='arrive', also='result',
           edits=(('distance < 0.1:', 'distance < 0.11:'), ('if distance < 0.1 else', 'if distance < 0.11 else')),
           expect='expected to go on until the distance is below 0.1 m'),
    Mutant('arrives_a_centimetre_late', breaks='arrive', also=('result', 'zeros', 'next'),
           edits=(('distance < 0.1:', 'distance < 0.09:'), ('if distance < 0.1 else', 'if distance < 0.09 else')),
           expect='m from the place; 0.3 s later the goal is still running'),
    Mutant('busy_for_ever', breaks='next', also=('cancel', 'field'), old='self.busy = False', new='',
           expect='A goal that came after a cancelled one was rejected'),
    Mutant('commands_after_end', breaks='zeros', also=('cancel', 'result'), edits=((
           "self.server = ActionServer(", '''
           self.create_timer(0.1, lambda: self.busy or self.pose and self.motor.publish(Twist()))
           self.server = ActionServer(
           '''),), expect='commands'),
    Mutant('one_border_is_outside', breaks='field', old='0 <= request.x <= 11 and 0 <= request.y <= 11',
           new='0 <= request.x <= 11 and 0 <= request.y < 11', expect='The goal (0, 11) was rejected'),
    Mutant('corner_is_outside', breaks='field', old='0 <= request.x <= 11 and 0 <= request.y <= 11',
           new='0 < request.x < 11 and 0 < request.y < 11', expect='The goal (11, 0) was rejected'),
    Mutant('first_pose', breaks='steer', also=('arrive', 'feedback', 'result', 'zeros', 'cancel'),
           old='self.pose = pose', new='self.pose = self.pose or pose', expect='use the newest pose'),
    Mutant('pose_before_the_wait', breaks='steer', also='feedback', edits=(
           (WAIT, f'pose = self.pose\n{WAIT}'), (STEER, STEER.replace('self.pose', 'pose'))), expect='as for an older pose'),
    Mutant('floods', breaks='feedback', old=FEEDBACK, new='''
           goal.publish_feedback(DriveTo.Feedback(distance=distance))
           ''', expect='expected 2 to 5'),
    Mutant('never_gives_up', breaks='give-up', old='range(1, 201):', new='range(1, 100001):',
           expect='the goal still runs after 20.5 s'),
    Mutant('near_is_enough_in_the_end', breaks='give-up', old='if distance < 0.1 else goal.abort',
           new='if distance < 1.0 else goal.abort', expect='ended as succeeded, expected aborted'),
    Mutant('gives_up_after_10_s', breaks='give-up', also=('feedback', 'steer'), old='range(1, 201):',
           new='range(1, 101):', expect='expected 20 s'),
    Mutant('never_looks', breaks='cancel', old='if goal.is_cancel_requested or distance < 0.1:',
           new='if distance < 0.1:', expect='expected canceled'),
    Mutant('no_pose_needed', breaks='no-pose', old='self.pose, self.busy = None, False',
           new='self.pose, self.busy = Pose(), False', also=('next', 'steer'),
           expect='No pose had come yet, and a goal was accepted'),
    Mutant('no_result', breaks='result', old='return DriveTo.Result(distance=distance)', new='return DriveTo.Result()',
           expect='the distance in the result is 0.000 m'),
    Mutant('no_stop', breaks='zeros', old='self.motor.publish(Twist())', new='',
           expect='the last command still drives', also='arrive'),
    Mutant('no_stop_after_cancel', breaks='zeros', old='self.motor.publish(Twist())', new='''
        if not goal.is_cancel_requested:
            self.motor.publish(Twist())
        ''', expect='the last command still drives'),
    Mutant('other_name', breaks='names', old="super().__init__('driver')", new="super().__init__('drive')",
           expect='Your node is called'),
    Mutant('rare_feedback', breaks='feedback', old='if step % 2 == 0:', new='if step % 10 == 0:',
           expect='expected 2 to 5'),
    Mutant('slow_rounds', breaks='steer', also=('give-up', 'feedback', 'cancel', 'arrive'), old=WAIT,
           new='self.get_clock().sleep_for(Duration(seconds=0.2))', expect='expected one every 0.1 s'),
    Mutant('succeeds_when_given_up', breaks='give-up', old='goal.succeed if distance < 0.1 else goal.abort',
           new='goal.succeed', expect='expected aborted'),
    Mutant('two_at_a_time', breaks='busy', old='self.busy = True', new='', also='arrive',
           expect='Two goals came at one moment'),
    Mutant('busy_when_it_executes', breaks='busy', also='arrive', edits=(('self.busy = True', ''), (
        'def execute(self, goal):', 'def execute(self, goal):\n    self.busy = True\n')),
           expect='Two goals came at one moment'),
    Mutant('place_of_the_last_request', breaks='busy', also=('arrive', 'give-up'), edits=(
        ('def on_goal(self, request):', 'def on_goal(self, request):\n    self.place = request\n'),
        (STEER, 'distance, command = steer(self.pose, self.place.x, self.place.y)')),
           expect='Take the place from the goal that you execute'),
    Mutant('feedback_begins_late', breaks='feedback', old='if step % 2 == 0:', new='if step % 2 == 0 and step > 8:',
           expect='no feedback came while'),
    Mutant('two_zeros', breaks='zeros', old='self.motor.publish(Twist())', new='''
        self.motor.publish(Twist())
        self.motor.publish(Twist())
        ''', expect='2 commands of zeros came, expected one'),
    Mutant('zeros_after_end', breaks='zeros', edits=(('''
        self.motor.publish(Twist())
        self.busy = False
        ''', 'self.busy = False'), ('end()', '''
        end()
        self.create_timer(0.3, lambda: self.motor.publish(Twist()))
        ''')), also=('cancel', 'steer', 'arrive', 'busy'), expect='commands came after the goal had ended'),
    Mutant('zeros_directly_after_end', breaks='zeros', edits=(('''
        self.motor.publish(Twist())
        self.busy = False
        ''', 'self.busy = False'), ('end()', '''
        end()
        self.motor.publish(Twist())
        ''')), expect='published only after the goal had ended'),
    Mutant('arrives_only_when_it_stands', breaks='arrive', also=('next', 'result', 'zeros'),
           edits=(('goal.is_cancel_requested or distance < 0.1:',
                   'goal.is_cancel_requested or (distance < 0.1 and abs(self.pose.linear_velocity) < 0.001):'),),
           expect='still running'),
    Mutant('looks_at_each_fifth_step', breaks='cancel', also=('busy', 'next', 'zeros'),
           edits=(('goal.is_cancel_requested or distance < 0.1:',
                   '(goal.is_cancel_requested and step % 5 == 0) or distance < 0.1:'),), expect='0.2 s later it is'),
    Mutant('feedback_of_the_way_in_x', breaks='feedback', old='DriveTo.Feedback(distance=distance)',
           new='DriveTo.Feedback(distance=abs(goal.request.x - self.pose.x))', expect='m away from'),
    Mutant('a_little_outside', breaks='field', old='0 <= request.x <= 11', new='0 <= request.x <= 11.08',
           expect='No turtle can get there'),
    Mutant('taken_in_the_class', breaks='busy', edits=(
        ('self.pose, self.busy = None, False', 'self.pose, Driver.busy = None, False'),
        ('self.busy = True', 'Driver.busy = True'), ('self.busy = False', 'Driver.busy = False')),
           expect='which the second one could take'),
    Mutant('pose_in_the_class', breaks='no-pose', edits=(
        ('self.pose, self.busy = None, False', 'self.busy = False'), ('self.pose = pose', 'Driver.pose = pose'),
        ('def on_pose(self, pose):', 'pose = None\n\ndef on_pose(self, pose):')), expect='only the first one could take a goal'),
    Mutant('old_pose_is_no_pose', breaks='next', also=('zeros',), edits=(
           ('self.pose = pose', 'self.pose, self.came = pose, self.get_clock().now()'),
           ('self.pose is None or',
            'self.pose is None or self.get_clock().now() - self.came > Duration(seconds=5.0) or')), expect='however old it is'),
    Mutant('feedback_of_the_round_before', breaks='feedback', old=FEEDBACK, new="""
           if step % 2 == 0:
               goal.publish_feedback(DriveTo.Feedback(distance=before))
           before = distance
           """, expect='not one of the round before'),
    Mutant('feedback_before_the_wait', breaks='feedback', edits=((FEEDBACK, ''), (WAIT, f"""
           told = steer(self.pose, goal.request.x, goal.request.y)[0]
           {WAIT}
           if step % 3 == 0:
               goal.publish_feedback(DriveTo.Feedback(distance=told))
           """)), expect='not one of the round before'),
    Mutant('rounds_go_on_after_an_abort', breaks='give-up', edits=(
        ('self.pose, self.busy = None, False', 'self.pose, self.busy, self.rounds = None, False, 0'),
        ('for step in range(1, 201):', 'for step in range(1 + self.rounds, 201):'), ("""
        self.motor.publish(Twist())
        self.busy = False
        """, """
        self.rounds = 20 if step == 200 else 0
        self.motor.publish(Twist())
        self.busy = False
        """)), expect='A goal was given up after 20 s. The next one'),
    Mutant('no_cancel_in_the_first_rounds', breaks='cancel', also=('zeros', 'no-pose', 'next'),
           old='if goal.is_cancel_requested or distance < 0.1:',
           new='if goal.is_cancel_requested and step > 5 or distance < 0.1:',
           expect='was cancelled at the moment when it came'),
    Mutant('feedback_of_0_at_the_end', breaks='feedback', old='self.motor.publish(Twist())', new="""
        self.motor.publish(Twist())
        goal.publish_feedback(DriveTo.Feedback(distance=0.0))
        """, expect='the last feedback says 0.000 m'),
]
