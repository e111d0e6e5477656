from grading.variants import Mutant

WAIT = 'self.get_clock().sleep_for(Duration(seconds=0.5))'
LOOK = '''
if goal.is_cancel_requested or goal is not self.newest:
    goal.canceled() if goal.is_cancel_requested else goal.abort()
    return Fibonacci.Result(sequence=numbers)
'''
COUNT = '''
numbers.append(len(numbers) + 1)
goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))
'''
ONE = 'test_one_goal'
NEWEST = 'test_newest_wins'
OTHERS = ('newest', 'aborted', 'stops', 'rejected', 'cancel', 'names')

MUTANTS = [
    Mutant('one_result_object', breaks='aborted', also=('newest', 'stops'), edits=(("super().__init__('newest_wins')", '''
            super().__init__('newest_wins')
            self.result = Fibonacci.Result()
            '''), ('''
            goal.canceled() if goal.is_cancel_requested else goal.abort()
            return Fibonacci.Result(sequence=numbers)
            ''', '''
            goal.canceled() if goal.is_cancel_requested else goal.abort()
            self.result.sequence = numbers
            return self.result
            '''), ('''
            goal.succeed()
            return Fibonacci.Result(sequence=numbers)
            ''', '''
            goal.succeed()
            self.result.sequence = numbers
            return self.result
            ''')), expect='make a new Result in each execute'),
    Mutant('accepted_and_forgotten', breaks='count', also=(*OTHERS, 'succeeds'), old='''
            self.newest = goal
            goal.execute()
        ''', new='self.newest = goal', expect='must call goal.execute()'),
    Mutant('no_cancel_when_late', breaks='cancel', edits=(
           ('cancel_callback=lambda goal: CancelResponse.ACCEPT)', 'cancel_callback=self.on_cancel)'),
           ('def on_accepted(self, goal):', '''
            def on_cancel(self, goal):
                return CancelResponse.ACCEPT if getattr(goal, 'count', 0) < 10 else CancelResponse.REJECT

            def on_accepted(self, goal):
            '''), ('numbers.append(len(numbers) + 1)', '''
            numbers.append(len(numbers) + 1)
            goal.count = len(numbers)
            ''')), expect='The cancel request was answered: rejected'),
    Mutant('keeps_on_when_late', breaks='aborted', also=('stops', 'newest'),
           old='if goal.is_cancel_requested or goal is not self.newest:',
           new='if goal.is_cancel_requested or (goal is not self.newest and len(numbers) < 10):',
           expect='the first goal goes on beside the second one'),
    Mutant('feedback_of_the_last_numbers', breaks='feedback',
           old='goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))',
           new='goal.publish_feedback(Fibonacci.Feedback(sequence=numbers[-20:]))', expect='the feedback number 21'),
    Mutant('no_feedback_when_late', breaks='feedback',
           old='goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))', new='''
           if len(numbers) < 30:
               goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))
           ''', expect='sent 29 feedback messages'),
    Mutant('cancel_request_clears_newest', breaks='newest', also='cancel', edits=(
           ('cancel_callback=lambda goal: CancelResponse.ACCEPT)', 'cancel_callback=self.on_cancel)'),
           ('def on_accepted(self, goal):', '''
            def on_cancel(self, goal):
                self.newest = None
                return CancelResponse.ACCEPT

            def on_accepted(self, goal):
            ''')), expect='as aborted'),
    Mutant('ends_only_while_a_newer_one_runs', breaks='aborted', also=('newest', 'stops'),
           old='if goal.is_cancel_requested or goal is not self.newest:',
           new='if goal.is_cancel_requested or (goal is not self.newest and self.newest.is_active):',
           expect='expected aborted and succeeded'),
    Mutant('cancelled_goal_clears_newest', breaks='newest', old='''
        goal.canceled() if goal.is_cancel_requested else goal.abort()
        ''', new='''
        if goal.is_cancel_requested:
            goal.canceled()
            self.newest = None
        else:
            goal.abort()
        ''', expect='had been cancelled, and before that one had ended'),
    Mutant('newest_of_all_servers', breaks='newest', edits=((
           'self.newest = None', ''), ('self.newest = goal', 'NewestWins.newest = goal')),
           expect='in no variable of the class or of the module'),
    Mutant('absolute_name', breaks='names', old="'count', self.execute", new="'/count', self.execute",
           expect='without a leading slash'),
    Mutant('accepts_0', breaks='orders', also=('rejected',), old='request.order >= 1', new='request.order >= 0',
           expect='The order 0 was accepted'),
    Mutant('aborts_the_cancelled', breaks='cancel', also='newest',
           old='goal.canceled() if goal.is_cancel_requested else goal.abort()', new='goal.abort()',
           expect='it is aborted, expected canceled'),
    Mutant('canceled_without_request', breaks='aborted', also='newest',
           old='goal.canceled() if goal.is_cancel_requested else goal.abort()', new='goal.canceled()',
           expect='attempted invalid transition'),
    Mutant('compares_orders', breaks='aborted',
           edits=(('self.newest = goal', 'self.newest = goal.request.order'),
            ('goal is not self.newest', 'goal.request.order != self.newest')), expect='goes on beside the second one'),
    Mutant('decides_in_goal_callback', breaks='rejected', also='newest',
           edits=(('self.newest = None', 'self.newest, self.number, self.mine = None, 0, {}'),
            ('def on_goal(self, request):', '''
            def on_goal(self, request):
                self.number += 1
            '''),
            ('self.newest = goal', 'self.mine[bytes(goal.goal_id.uuid)] = self.number'),
            ('goal is not self.newest', 'self.mine[bytes(goal.goal_id.uuid)] != self.number')),
           expect='Goals came in the meantime that were rejected'),
    Mutant('flag_is_kept', breaks='newest', also=OTHERS,
           edits=(('self.newest = None', 'self.newest, self.stop = None, False'),
            ('def on_accepted(self, goal):', '''
            def on_accepted(self, goal):
                self.stop = self.stop or self.newest is not None and self.newest.is_active
            '''),
            ('goal is not self.newest', 'self.stop')), expect='The goal of order'),
    Mutant('flag_stays', breaks='newest', also=('aborted', 'stops', 'names'),
           edits=(('self.newest = None', 'self.newest, self.stop = None, False'),
            ('def on_accepted(self, goal):', '''
            def on_accepted(self, goal):
                self.stop = self.newest is not None and self.newest.is_active
            '''),
            ('goal is not self.newest', 'self.stop')), expect='The goal of order'),
    Mutant('forgets_succeed', breaks='succeeds', also=OTHERS, old='goal.succeed()', new='',
           expect='ended as aborted, expected succeeded'),
    Mutant('from_0', breaks='count', also=OTHERS, old='numbers.append(len(numbers) + 1)',
           new='numbers.append(len(numbers))', expect='has the result [0, 1'),
    Mutant('larger_goal_wins', breaks='aborted', also=('newest', 'stops'), old='self.newest = goal', new='''
        if self.newest is None or not self.newest.is_active or goal.request.order <= self.newest.request.order:
            self.newest = goal
        ''', expect='of order'),
    Mutant('last_step_goes_on', breaks='stops', also=('aborted', 'cancel'),
           old='if goal.is_cancel_requested or goal is not self.newest:', new='''
        replaced = goal.is_cancel_requested or goal is not self.newest
        if replaced and len(numbers) < goal.request.order - 1:
        ''', expect='then it went on'),
    Mutant('newest_when_it_executes', breaks='newest', edits=(('self.newest = goal', ''),
           ('numbers = []', 'numbers, self.newest = [], goal')), expect='not when its execute callback begins'),
    Mutant('deaf_after_three_numbers', old='goal.is_cancel_requested or', new='goal.is_cancel_requested and len(numbers) < 3 or',
           expect='0.5 s later it is', breaks='cancel'),
    Mutant('no_cancel_at_first', breaks='cancel', also=('newest',),
           edits=(('numbers = []', 'numbers = self.numbers = []'), ('cancel_callback=lambda goal: CancelResponse.ACCEPT)',
            'cancel_callback=lambda goal: CancelResponse.ACCEPT if self.numbers else CancelResponse.REJECT)')),
           expect='The cancel request was answered: rejected'),
    Mutant('no_cancel_callback', breaks='cancel', also='newest', old='''
        handle_accepted_callback=self.on_accepted,
        cancel_callback=lambda goal: CancelResponse.ACCEPT)
        ''', new='handle_accepted_callback=self.on_accepted)', expect='The cancel request was answered: rejected'),
    Mutant('no_feedback', breaks='feedback', also=OTHERS,
           old='goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))', new='',
           expect='sent 0 feedback messages'),
    Mutant('feedback_of_one_number', breaks='feedback',
           old='goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))',
           new='goal.publish_feedback(Fibonacci.Feedback(sequence=numbers[-1:]))', expect='expected all numbers so far'),
    Mutant('numbered_in_execute', breaks='aborted', also='newest',
           edits=(('self.newest = None', 'self.latest = 0'), ('self.newest = goal', 'self.latest += 1'),
                  ('numbers = []', 'numbers, mine = [], self.latest'), ('goal is not self.newest', 'mine < self.latest')),
           expect='Three goals came at one moment'),
    Mutant('no_numbers_when_aborted', breaks='aborted', also='cancel', old=LOOK, new='''
        if goal.is_cancel_requested or goal is not self.newest:
            if goal.is_cancel_requested:
                goal.canceled()
                return Fibonacci.Result(sequence=numbers)
            goal.abort()
            return Fibonacci.Result()
        ''', expect='expected what it had'),
    Mutant('numbers_in_self', breaks='newest', also=(*OTHERS, 'count', 'feedback'), old='numbers = []', new='''
        numbers = self.numbers = getattr(self, 'numbers', [])
        if len(numbers) >= goal.request.order or not self.server:
            numbers.clear()
        ''', expect='of order'),
    Mutant('old_one_succeeds', breaks='aborted', old='goal.abort()', new='goal.succeed()',
           expect='expected aborted: a newer one has taken its place'),
    Mutant('one_more', breaks='stops', also=('aborted', 'cancel'), edits=((WAIT, ''), (LOOK + COUNT.lstrip('\n'),
           LOOK + WAIT + COUNT)), expect='then it went on'),
    Mutant('one_too_many', breaks='count', also=(*OTHERS, 'feedback', 'succeeds'),
           old='while len(numbers) < goal.request.order:', new='while len(numbers) <= goal.request.order:',
           expect='The goal of order'),
    Mutant('other_name', breaks='names', old="super().__init__('newest_wins')", new="super().__init__('newest')",
           expect='Your node is called'),
    Mutant('queue', breaks='newest', also=OTHERS, edits=(('self.newest = None', 'self.newest, self.goals = None, []'),
            ('''
            self.newest = goal
            goal.execute()
            ''', '''
            self.goals.append(goal)
            if len(self.goals) == 1:
                goal.execute()
            '''),
            ('numbers = []', '''
            numbers = []
            while self.goals[0] is not goal:
                self.get_clock().sleep_for(Duration(seconds=0.1))
            '''),
            ('if goal.is_cancel_requested or goal is not self.newest:', 'if goal.is_cancel_requested:'),
            ('goal.succeed()', '''
            goal.succeed()
            self.goals.pop(0)
            if self.goals:
                self.goals[0].execute()
            ''')), expect='the second one has not begun'),
    Mutant('refuses', breaks='newest', also=('aborted',), old='= 1 else GoalResponse.',
           new='= 1 and (self.newest is None or not self.newest.is_active) else GoalResponse.',
           expect='the second goal was rejected'),
    Mutant('refuses_48', breaks='orders', also=('cancel',), old='request.order >= 1', new='1 <= request.order <= 47',
           expect='Every order from 1 is accepted'),
    Mutant('side_by_side', breaks='aborted', also=('newest', 'stops'),
           edits=(('if goal.is_cancel_requested or goal is not self.newest:', 'if goal.is_cancel_requested:'),
            ('goal.canceled() if goal.is_cancel_requested else goal.abort()', 'goal.canceled()')),
           expect='the first goal goes on beside the second one'),
    Mutant('slow', breaks='count', also=(*OTHERS, 'feedback', 'succeeds'), old=WAIT,
           new='self.get_clock().sleep_for(Duration(seconds=1.0))', expect='The goal of order'),
    Mutant('old_one_goes_on_after_a_cancel', breaks='newest', old=LOOK, new='''
        if goal.is_cancel_requested:
            if goal is self.newest:
                self.newest = None
            goal.canceled()
            return Fibonacci.Result(sequence=numbers)
        if self.newest is not None and goal is not self.newest:
            goal.abort()
            return Fibonacci.Result(sequence=numbers)
        ''', expect='whatever becomes of the newer one'),
    Mutant('large_orders_go_on', breaks='aborted', also=('newest', 'stops'), old='goal is not self.newest',
           new='goal is not self.newest and goal.request.order <= 30', expect='goes on'),
    Mutant('forgets_the_newest_at_its_end', breaks='newest', old='goal.succeed()', new="""
        self.newest = None
        goal.succeed()
        """, expect='leaves alone what was noted of a newer one'),
    Mutant('looks_and_forgets_the_newest', breaks='newest', old='goal.succeed()', new="""
        if self.newest is goal:
            self.newest = None
        goal.succeed()
        """, expect='leaves alone what was noted of a newer one'),
]
