from grading.variants import Mutant

WAIT = 'self.get_clock().sleep_for(Duration(seconds=0.5))'
LOOP = '''
if goal.is_cancel_requested:
    goal.canceled()
    return Fibonacci.Result(sequence=numbers)
numbers.append(sum(numbers[-2:]) if len(numbers) > 1 else len(numbers))
goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))
'''
NUMBERS = 'test_numbers'
CANCEL = 'test_cancel'

MUTANTS = [
    Mutant('feedback_of_the_last_numbers', breaks='feedback',
           old='goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))',
           new='goal.publish_feedback(Fibonacci.Feedback(sequence=numbers[-9:]))', expect='Order 47: when 10 numbers'),
    Mutant('slower_from_the_tenth_on', breaks='rate', also=('numbers', 'feedback', 'end', 'partial', 'cancel'),
           old='self.get_clock().sleep_for(Duration(seconds=0.5))',
           new='self.get_clock().sleep_for(Duration(seconds=0.5 if len(numbers) < 9 else 0.51))',
           expect='The goal of order 47 did not end'),
    Mutant('no_cancel_when_late', breaks='cancel', edits=(
           ('cancel_callback=lambda goal: CancelResponse.ACCEPT)', 'cancel_callback=self.on_cancel)'),
           ('def on_goal(self, request):', '''
        def on_cancel(self, goal):
            return CancelResponse.ACCEPT if getattr(goal, 'steps', 0) < 10 else CancelResponse.REJECT

        def on_goal(self, request):
           '''),
           ('goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))', '''
            goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))
            goal.steps = len(numbers)
           ''')), expect='The cancel request was answered: rejected'),
    Mutant('looks_no_more_when_late', breaks='cancel', also='partial', old='if goal.is_cancel_requested:',
           new='if goal.is_cancel_requested and len(numbers) < 10:', expect='It did not end at the next step'),
    Mutant('absolute_name', breaks='names', old="'fibonacci', self.execute", new="'/fibonacci', self.execute",
           expect='without a leading slash'),
    Mutant('aborts', breaks='cancel', also='goals', old='goal.canceled()', new='goal.abort()',
           expect='ended as aborted, expected canceled'),
    Mutant('every_second_step', breaks='cancel', old='if goal.is_cancel_requested:',
           new='if goal.is_cancel_requested and len(numbers) % 2 == 0:', also=('partial', 'goals'),
           expect='look at is_cancel_requested in every step'),
    Mutant('feedback_at_end', breaks='feedback', also=('goals', 'partial'),
           old='goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))', new='''
        if len(numbers) == goal.request.order:
            goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))
        ''', expect='expected one for each number'),
    Mutant('feedback_of_one_number', breaks='feedback', also='goals',
           old='goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))',
           new='goal.publish_feedback(Fibonacci.Feedback(sequence=numbers[-1:]))',
           expect='expected all numbers so far'),
    Mutant('flag_in_self', breaks='goals', also=('cancel', 'partial', 'end'), edits=((
           'cancel_callback=lambda goal: CancelResponse.ACCEPT)', 'cancel_callback=self.on_cancel)'),
           ('def on_goal(self, request):', '''
            def on_cancel(self, goal):
                self.stop = True
                return CancelResponse.ACCEPT

            def on_goal(self, request):
            '''), ('numbers = []', '''
            numbers = []
            self.stop = False
            '''), ('''
            if goal.is_cancel_requested:
                goal.canceled()
            ''', '''
            if self.stop:
                goal.canceled() if goal.is_cancel_requested else goal.abort()
            ''')), expect='keep no flag of your own'),
    Mutant('float_formula', breaks='numbers', old='sum(numbers[-2:]) if len(numbers) > 1 else len(numbers)',
           new='round(1.6180339887 ** len(numbers) / 5 ** 0.5)', expect='is not exact when the numbers are large'),
    Mutant('forgets_succeed', breaks='end', also=('goals', 'orders', 'numbers', 'cancel', 'names'),
           old='goal.succeed()', new='', expect='Call succeed() before you return the result'),
    Mutant('looks_too_early', breaks='partial', also=('cancel', 'end'), edits=((WAIT, ''), (LOOP, f'''
if goal.is_cancel_requested:
    goal.canceled()
    return Fibonacci.Result(sequence=numbers)
{WAIT}
numbers.append(sum(numbers[-2:]) if len(numbers) > 1 else len(numbers))
goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))
''')), expect='went on after the cancel request'),
    Mutant('lucas', breaks='numbers', also=('goals', 'feedback', 'partial', 'names', 'rate'),
           old='len(numbers) > 1 else len(numbers))', new='len(numbers) > 1 else 1)', expect='expected the first'),
    Mutant('never_looks', breaks='cancel', also=('goals', 'partial', 'end'), old='''
        if goal.is_cancel_requested:
            goal.canceled()
            return Fibonacci.Result(sequence=numbers)
        ''', new='', expect='is_cancel_requested in every step'),
    Mutant('no_cancel_callback', breaks='cancel', also=('goals', 'end'), old='''
        self, Fibonacci, 'fibonacci', self.execute, goal_callback=self.on_goal,
        cancel_callback=lambda goal: CancelResponse.ACCEPT)
        ''', new="self, Fibonacci, 'fibonacci', self.execute, goal_callback=self.on_goal)",
           expect='The default cancel callback refuses all'),
    Mutant('no_partial_result', breaks='partial', old='''
        goal.canceled()
        return Fibonacci.Result(sequence=numbers)
        ''', new='''
        goal.canceled()
        return Fibonacci.Result()
        ''', expect='expected the numbers so far'),
    Mutant('number_before_wait', breaks='rate', also=('cancel', 'partial', 'goals', 'end'),
           edits=((WAIT, ''), (LOOP, f'''
if goal.is_cancel_requested:
    goal.canceled()
    return Fibonacci.Result(sequence=numbers)
numbers.append(sum(numbers[-2:]) if len(numbers) > 1 else len(numbers))
goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))
{WAIT}
''')), expect='one number every 0.5 s'),
    Mutant('numbers_in_self', breaks='goals', edits=(("super().__init__('fibonacci_server')", '''
            super().__init__('fibonacci_server')
            self.numbers = []
            '''),
            ('numbers = []', '''
            numbers = self.numbers
            numbers.clear()
            ''')), also=('partial', 'cancel', 'end', 'rate'),
           expect='Keep what belongs to one goal in variables of execute'),
    Mutant('numbers_stay', breaks='goals', edits=(("super().__init__('fibonacci_server')", '''
            super().__init__('fibonacci_server')
            self.numbers = []
            '''), ('numbers = []', 'numbers = self.numbers')), also=('partial', 'cancel', 'end', 'rate', 'numbers'),
           expect='Order 0 gave'),
    Mutant('one_cancelled_goal', breaks='goals', also='cancel', edits=(
           ('cancel_callback=lambda goal: CancelResponse.ACCEPT)', 'cancel_callback=self.on_cancel)'),
           ('def on_goal(self, request):', '''
            def on_cancel(self, goal):
                self.cancelled = goal
                return CancelResponse.ACCEPT

            def on_goal(self, request):
            '''), ('if goal.is_cancel_requested:', "if goal is getattr(self, 'cancelled', None):")),
           expect='two of them were cancelled, both between two steps'),
    Mutant('one_too_many', breaks='numbers', also=('goals', 'end', 'feedback', 'partial', 'cancel', 'names', 'rate'),
           old='while len(numbers) < goal.request.order:', new='while len(numbers) <= goal.request.order:',
           expect='expected the first'),
    Mutant('other_name', breaks='names', old="super().__init__('fibonacci_server')",
           new="super().__init__('fibonacci')", expect='Your node is called'),
    Mutant('overflow', breaks='orders', old='order <= 47 else GoalResponse.', new='order <= 48 else GoalResponse.',
           expect='The order 48 was accepted'),
    Mutant('refuses_while_busy', breaks='goals', also=('orders', 'end', 'cancel', 'partial'), edits=(('numbers = []', '''
            numbers = []
            self.running = goal
            '''), ('return GoalResponse.ACCEPT if 0 <= request.order <= 47 else GoalResponse.REJECT', '''
            if getattr(self, 'running', None) is not None and self.running.is_active:
                return GoalResponse.REJECT
            return GoalResponse.ACCEPT if 0 <= request.order <= 47 else GoalResponse.REJECT
            ''')), expect='ran at the same time'),
    Mutant('one_result_object', breaks='goals', also='partial', edits=(("super().__init__('fibonacci_server')", '''
            super().__init__('fibonacci_server')
            self.result = Fibonacci.Result()
            '''), ('''
            goal.succeed()
            return Fibonacci.Result(sequence=numbers)
            ''', '''
            self.result.sequence = numbers
            goal.succeed()
            return self.result
            ''')), expect='make a new Result in each execute'),
    Mutant('ten_at_a_time', breaks='goals', also=('orders', 'rate', 'cancel'), edits=(
        ("super().__init__('fibonacci_server')", '''
            super().__init__('fibonacci_server')
            self.places = threading.Semaphore(10)
            '''), ('def execute(self, goal):', '''
            def execute(self, goal):
                with self.places:
                    return self.count(goal)

            def count(self, goal):
            ''')), expect='No goal waits for another one'),
    Mutant('four_at_a_time', breaks='goals', also=('orders', 'rate', 'cancel'), edits=(
        ('return GoalResponse.ACCEPT if 0 <= request.order <= 47 else GoalResponse.REJECT', '''
            self.running = getattr(self, 'running', 0)
            if not 0 <= request.order <= 47 or self.running >= 4:
                return GoalResponse.REJECT
            self.running += 1
            return GoalResponse.ACCEPT
            '''), ('goal.canceled()', '''
            self.running -= 1
            goal.canceled()
            '''), ('goal.succeed()', '''
            self.running -= 1
            goal.succeed()
            ''')), expect='ran at the same time'),
    Mutant('refuses_47', breaks='orders', old='order <= 47 else GoalResponse.', new='order < 47 else GoalResponse.',
           expect='The order 47 was rejected'),
    Mutant('refuses_nothing', breaks='orders', also='numbers', old='GoalResponse.ACCEPT if 0 <= request.order <= 47',
           new='GoalResponse.ACCEPT if request.order <= 47', expect='The order -1 was accepted'),
    Mutant('slow', breaks='rate', also=('goals', 'numbers', 'cancel', 'partial', 'end', 'feedback', 'names', 'orders'),
           old=WAIT, new='self.get_clock().sleep_for(Duration(seconds=1.0))', expect='did not end within'),
    Mutant('wall_clock', breaks='rate', also=('goals', 'numbers', 'cancel', 'partial', 'end', 'feedback', 'names'),
           old=WAIT, new='''
        import time
        time.sleep(0.001)
        ''', expect="Wait on the node's clock"),
    Mutant('waits_for_order_0', breaks='end', also='goals', old='numbers = []', new='''
        numbers = []
        if not goal.request.order:
            self.get_clock().sleep_for(Duration(seconds=0.5))
        ''', expect='The goal of order 0 ended 0.5 s after its start'),
    Mutant('looks_at_the_newest_goal', breaks='goals', also=('cancel', 'partial'), edits=(('numbers = []', """
        numbers = []
        self.newest = goal
        """), ('if goal.is_cancel_requested:', 'if self.newest.is_cancel_requested and goal.is_cancel_requested:')),
           expect='two of them were cancelled, both between two steps'),
    Mutant('one_feedback_for_all', breaks='goals', edits=(("super().__init__('fibonacci_server')", """
        super().__init__('fibonacci_server')
        self.feedback = Fibonacci.Feedback()
        """), ('goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))', """
        self.feedback.sequence = numbers
        goal.publish_feedback(self.feedback)
        """)), expect='Make a new Feedback in execute'),
    Mutant('newest_numbers_in_self', breaks='goals', old='goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))',
           new="""
        self.numbers = numbers
        goal.publish_feedback(Fibonacci.Feedback(sequence=self.numbers))
        """, expect='Make a new Feedback in execute'),
]
