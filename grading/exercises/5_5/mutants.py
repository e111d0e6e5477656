from grading.variants import Mutant

SLEEP = 'self.get_clock().sleep_for(Duration(seconds=0.5))'
FEEDBACK = 'goal.publish_feedback(Fibonacci.Feedback(sequence=pages))'
FULL = 'full = len(self.goals) > self.places  # the first one runs'
ACCEPTED = '''
with self.lock:
    self.goals.append(goal)
    alone = len(self.goals) == 1
'''
NEXT = '''
with self.lock:
    self.goals.pop(0)
    following = self.goals[:1]
for other in following:
    other.execute()
'''
LOOK = '''
with self.lock:
    gone = [goal for goal in self.goals[1:] if goal.is_cancel_requested]
    self.goals = [goal for goal in self.goals if goal not in gone]
'''
LEAVE = '''
def leave(self, goal):
    goal.canceled()
'''

MUTANTS = [
    Mutant('executes_every_goal', breaks='queue', old='if alone:', new='if True:',
           also=('orders', 'pages', 'places', 'cancel', 'cancel-waiting', 'others', 'at-once', 'lock', 'end', 'names'),
           expect='execute() is called once for each goal'),
    Mutant('places_in_the_class', breaks='places', edits=(
           ('self.places, self.goals, self.lock = places, [], threading.Lock()',
            'Printer.places, self.goals, self.lock = places, [], threading.Lock()'),),
           expect='Keep the number of places in self'),
    Mutant('one_result_object', breaks='end', edits=(("super().__init__('printer')", '''
            super().__init__('printer')
            self.result = Fibonacci.Result()
            '''), ('return Fibonacci.Result(sequence=pages)', '''
            self.result.sequence = pages
            return self.result
            ''')), expect='make a new Result in each execute'),
    Mutant('no_cancel_when_late', breaks='cancel', edits=(
           ('cancel_callback=accept)', 'cancel_callback=self.on_cancel)'),
           ('def on_accepted(self, goal):', '''
           def on_cancel(self, goal):
               return CancelResponse.ACCEPT if getattr(goal, 'pages', 0) < 10 else CancelResponse.REJECT

           def on_accepted(self, goal):
           '''), ('pages.append(len(pages) + 1)', '''
           pages.append(len(pages) + 1)
           goal.pages = len(pages)
           ''')), expect='was to be cancelled; the request was answered: rejected'),
    Mutant('looks_at_the_others_early_only', breaks='cancel-waiting', also='others',
           old='self.look_at_the_others()', new='''
           if len(pages) < 10:
               self.look_at_the_others()
           ''', expect='look at all goals that wait'),
    Mutant('no_look_at_the_last_page', breaks='cancel-waiting', old='self.look_at_the_others()', new='''
        if len(pages) < goal.request.order:
            self.look_at_the_others()
        ''', expect='somebody must look at all goals that wait'),
    Mutant('occupied_after_a_cancel', breaks='others', also=('cancel', 'lock'), edits=(
        ('self.places, self.goals, self.lock = places, [], threading.Lock()',
         'self.places, self.goals, self.lock, self.occupied = places, [], threading.Lock(), False'),
        ('alone = len(self.goals) == 1', '''
         alone = not self.occupied
         self.occupied = True
         '''), ('following = self.goals[:1]', '''
         following = self.goals[:1]
         if not following and len(pages) == goal.request.order:
             self.occupied = False
         ''')), expect='never began'),
    Mutant('absolute_name', breaks='names', also='queue', old="'print', self.execute", new="'/print', self.execute",
           expect='without a leading slash'),
    Mutant('other_name', breaks='names', old="super().__init__('printer')", new="super().__init__('print')",
           expect='Your node is called'),
    Mutant('accepts_0', breaks='orders', old='request.order < 1', new='request.order < 0',
           expect='there is no such number of pages'),
    Mutant('accepts_less_than_0', breaks='orders', old='request.order < 1', new='request.order == 0',
           expect='there is no such number of pages'),
    Mutant('accepts_all', breaks='orders', old='full or request.order < 1', new='full',
           expect='there is no such number of pages'),
    Mutant('from_0', breaks='pages', also=('lock', 'cancel'),
           old='pages.append(len(pages) + 1)', new='pages.append(len(pages))',
           expect='has the result [0'),
    Mutant('slow', breaks='pages', also=('lock',), old=SLEEP, new='self.get_clock().sleep_for(Duration(seconds=0.6))',
           expect='had pages at'),
    Mutant('first_page_late', breaks='pages', also=('lock',), old='pages = []', new='''
        pages = []
        self.get_clock().sleep_for(Duration(seconds=0.1))
        ''', expect='had pages at'),
    Mutant('pages_in_self', breaks='pages', also=('end', 'lock', 'others'), old='pages = []',
           new='pages = self.pages = []', edits=(
           ('while len(pages) <', 'while len(self.all_pages) <'), ('pages.append(len(pages) + 1)', '''
            self.all_pages.append(len(self.all_pages) + 1)
            pages.append(len(self.all_pages))
            '''), ('self.places, self.goals, self.lock = places, [], threading.Lock()',
            'self.places, self.goals, self.lock, self.all_pages = places, [], threading.Lock(), []')),
           expect='has the result'),
    Mutant('no_feedback', breaks='feedback', also=('lock',), old=FEEDBACK, new='', expect='had 0 feedback messages'),
    Mutant('only_the_new_page', breaks='feedback', old=FEEDBACK,
           new='goal.publish_feedback(Fibonacci.Feedback(sequence=pages[-1:]))', expect='expected its pages so far'),
    Mutant('feedback_of_another_goal', breaks='feedback', also=('lock', 'cancel'), old=FEEDBACK,
           new='self.goals[-1].publish_feedback(Fibonacci.Feedback(sequence=pages))', expect='feedback messages'),
    Mutant('forgets_succeed', breaks='end', also=('others', 'lock'), old='''
        goal.canceled() if goal.is_cancel_requested else goal.succeed()
        ''', new='''
        if goal.is_cancel_requested:
            goal.canceled()
        ''', expect='ended as aborted, expected succeeded'),
    Mutant('no_result', breaks='end', also=('lock',), old='return Fibonacci.Result(sequence=pages)',
           new='return Fibonacci.Result(sequence=pages if goal.is_cancel_requested else [])',
           expect='has the result [], expected [1'),
    Mutant('side_by_side', breaks='queue', also=('cancel', 'cancel-waiting', 'others', 'lock'),
           old='alone = len(self.goals) == 1', new='alone = True', edits=(
           ('self.goals.pop(0)', 'self.goals.remove(goal)'), ('following = self.goals[:1]', 'following = []')),
           expect='One goal runs at a time'),
    Mutant('last_first', breaks='queue', also=('others',), old='self.goals.append(goal)',
           new='self.goals.insert(1, goal)',
           expect='expected to begin at'),
    Mutant('shortest_first', breaks='queue', also=('others',), old='self.goals.append(goal)', new='''
        self.goals.append(goal)
        self.goals[1:] = sorted(self.goals[1:], key=lambda goal: goal.request.order)
        ''', expect='expected to begin at'),
    Mutant('looks_twice_at_the_request', breaks='lock', old='self.goals = [goal for goal in self.goals if goal not in gone]',
           new='self.goals = self.goals[:1] + [goal for goal in self.goals[1:] if not goal.is_cancel_requested]',
           expect='the cancelled goal was still there'),
    Mutant('waiting_goals_in_the_class', breaks='queue', also=('lock',), edits=(
           ('self.places, self.goals, self.lock = places, [], threading.Lock()', """
            self.places, self.lock, self.running = places, threading.Lock(), False
            """), ('def __init__(self, places=2):', """
            goals = []

            def __init__(self, places=2):
            """), ('full = len(self.goals) > self.places  # the first one runs',
            'full = self.running and len(self.goals) >= self.places'), (ACCEPTED, """
            with self.lock:
                alone = not self.running
                self.running = True
                if not alone:
                    self.goals.append(goal)
            """), (NEXT, """
            with self.lock:
                following = self.goals[:1]
                del self.goals[:1]
                self.running = bool(following)
            for other in following:
                other.execute()
            """), ('gone = [goal for goal in self.goals[1:] if goal.is_cancel_requested]',
            'gone = [goal for goal in self.goals if goal.is_cancel_requested]'),
           ('self.goals = [goal for goal in self.goals if goal not in gone]',
            'self.goals[:] = [goal for goal in self.goals if goal not in gone]')),
           expect='in no variable of the class or of the module'),
    Mutant('queue_in_a_default_argument', breaks='queue', edits=(
           ('def __init__(self, places=2):', 'def __init__(self, places=2, goals=[]):'),
           ('places, [], threading.Lock()', 'places, goals, threading.Lock()'),
           ('self.goals = [goal for goal in self.goals if goal not in gone]',
            'self.goals[:] = [goal for goal in self.goals if goal not in gone]')),
           expect='in no variable of the class or of the module'),
    Mutant('a_timer_begins', breaks='queue', also=('others', 'lock'), edits=(
           ("super().__init__('printer')", '''
            super().__init__('printer')
            self.running = False
            self.create_timer(0.3, self.begin)
            '''), ('''
            if alone:
                goal.execute()
            ''', ''), (NEXT, '''
            with self.lock:
                self.goals.pop(0)
                self.running = False
            '''), ('def on_goal(self, request):', '''
            def begin(self):
                with self.lock:
                    first = [] if self.running else self.goals[:1]
                    self.running = self.running or bool(first)
                for goal in first:
                    goal.execute()

            def on_goal(self, request):
            ''')), expect='expected to begin at'),
    Mutant('forgets_the_next', breaks='queue', also=('others', 'lock'), old='''
        for other in following:
            other.execute()
        ''', new='', expect='never began'),
    Mutant('executes_at_once', breaks='status', also=('cancel', 'cancel-waiting', 'lock'), old='''
        if alone:
            goal.execute()
        ''', new='goal.execute()', edits=(
           ('threading.Lock()', 'threading.Condition()'), (NEXT, '''
            with self.lock:
                self.goals.pop(0)
                self.lock.notify_all()
            '''), ('pages = []', '''
            pages = []
            with self.lock:
                self.lock.wait_for(lambda: self.goals[0] is goal)
            ''')), expect='but it waited until'),
    Mutant('two_for_none', breaks='places', old='self.places, self.goals, self.lock = places,',
           new='self.places, self.goals, self.lock = places or 2,', expect='was accepted, although one goal ran'),
    Mutant('unbounded', breaks='places', also=('cancel-waiting',), old=FULL, new='full = False',
           expect='was accepted, although one goal ran'),
    Mutant('counts_the_one_that_runs', breaks='places', also=('cancel-waiting', 'others', 'lock'), old=FULL,
           new='full = len(self.goals) >= max(1, self.places)', expect='was rejected, although one goal ran'),
    Mutant('one_more', breaks='places', also=('cancel-waiting',), old=FULL,
           new='full = len(self.goals) > self.places + 1', expect='was accepted, although one goal ran'),
    Mutant('places_are_never_free', breaks='places', also=('cancel-waiting', 'lock'), old=FULL,
           new='full = self.count > self.places', edits=(
           ("super().__init__('printer')", '''
            super().__init__('printer')
            self.count = 0
            '''), ('self.goals.append(goal)', '''
            self.goals.append(goal)
            self.count += 1
            ''')), expect='was rejected, although'),
    Mutant('no_cancel_callback', breaks='cancel', also=('cancel-waiting', 'lock', 'others', 'status'), old='''
        handle_accepted_callback=self.on_accepted, cancel_callback=accept)
        ''', new='handle_accepted_callback=self.on_accepted)', expect='the request was answered: rejected'),
    Mutant('does_not_look', breaks='cancel', also=('others', 'lock'), edits=(
           ('while len(pages) < goal.request.order and not goal.is_cancel_requested:',
            'while len(pages) < goal.request.order:'),
           ('if not goal.is_cancel_requested:', 'if True:')), expect='was cancelled while it ran, and'),
    Mutant('one_more_page', breaks='cancel', also=('lock',), old='if not goal.is_cancel_requested:', new='if True:',
           expect='and its result is'),
    Mutant('aborts_the_cancelled', breaks='cancel', also=('lock',), old='goal.canceled() if', new='goal.abort() if',
           expect='ended as aborted, not canceled'),
    Mutant('succeeds_the_cancelled', breaks='cancel', also=('lock',), old='goal.canceled() if', new='goal.succeed() if',
           expect='ended as succeeded, not canceled'),
    Mutant('one_leaves_in_a_step', breaks='cancel-waiting', also='lock',
           old='gone = [goal for goal in self.goals[1:] if goal.is_cancel_requested]',
           new='gone = [goal for goal in self.goals[1:] if goal.is_cancel_requested][:1]',
           expect='look at all goals that wait, in each step'),
    Mutant('looks_before_the_wait', breaks='cancel-waiting', also=('others', 'lock'), edits=((
           'while len(pages) < goal.request.order and not goal.is_cancel_requested:',
           'while len(pages) < goal.request.order:'), ('''
            self.get_clock().sleep_for(Duration(seconds=0.5))
            if not goal.is_cancel_requested:
                pages.append(len(pages) + 1)
                goal.publish_feedback(Fibonacci.Feedback(sequence=pages))
            self.look_at_the_others()
            ''', '''
            self.look_at_the_others()
            self.get_clock().sleep_for(Duration(seconds=0.5))
            if goal.is_cancel_requested:
                break
            pages.append(len(pages) + 1)
            goal.publish_feedback(Fibonacci.Feedback(sequence=pages))
            ''')), expect='look at all goals that wait, in each step'),
    Mutant('nobody_looks_at_those_that_wait', breaks='cancel-waiting', also=('lock', 'others'),
           old='self.look_at_the_others()', new='', expect='somebody must look at all goals that wait'),
    Mutant('aborts_those_that_wait', breaks='cancel-waiting', also=('lock',), old=LEAVE,
           new=LEAVE.replace('canceled', 'abort'), expect='ended as aborted, expected canceled'),
    Mutant('place_is_lost', breaks='cancel-waiting', also=('lock', 'others'), old=LEAVE,
           new=LEAVE + '    self.places -= 1\n',
           expect='gives its place back'),
    Mutant('executes_before_it_leaves', breaks='cancel-waiting', also=('others', 'lock', 'cancel'), edits=(
           ('self.look_at_the_others()', ''),
           ('while len(pages) < goal.request.order and not goal.is_cancel_requested:',
            'while len(pages) < goal.request.order:'),
           ('if not goal.is_cancel_requested:', 'if True:'),
           ('goal.canceled() if', 'goal.succeed() if')), expect='printed all the same'),
    Mutant('all_that_wait_leave', breaks='others', also=('lock', 'cancel-waiting'), edits=(
           ('gone = [goal for goal in self.goals[1:] if goal.is_cancel_requested]', '''
            gone = self.goals[1:] if any(goal.is_cancel_requested for goal in self.goals[1:]) else []
            '''), (LEAVE, '''
            def leave(self, goal):
                goal.canceled() if goal.is_cancel_requested else goal.abort()
            ''')), expect='ended as aborted, expected succeeded'),
    Mutant('order_is_lost', breaks='others', also=('lock', 'queue', 'cancel'),
           old='self.goals = [goal for goal in self.goals if goal not in gone]', new='''
        self.goals = [goal for goal in self.goals if goal not in gone]
        if gone:
            self.goals[1:] = self.goals[:0:-1]
        ''', expect='expected to begin at'),
    Mutant('a_flag_for_all', breaks='others', also=('lock', 'cancel', 'cancel-waiting', 'queue'), edits=(
           ('cancel_callback=accept', 'cancel_callback=self.on_cancel'), ('def on_goal(self, request):', '''
            def on_cancel(self, goal):
                self.stop = True
                return CancelResponse.ACCEPT

            def on_goal(self, request):
            '''), ("super().__init__('printer')", '''
            super().__init__('printer')
            self.stop = False
            '''), ('while len(pages) < goal.request.order and not goal.is_cancel_requested:',
            'while len(pages) < goal.request.order and not self.stop:'),
           ('goal.canceled() if goal.is_cancel_requested else goal.succeed()', '''
            ends = goal.canceled if goal.is_cancel_requested else goal.abort if self.stop else goal.succeed
            ends()
            self.stop = False
            ''')), expect='ended as aborted, expected succeeded'),
    Mutant('holds_the_lock', breaks='at-once', also=('lock',), old=SLEEP, new='''
        with self.lock:
            self.get_clock().sleep_for(Duration(seconds=0.5))
        ''', expect='Does a callback hold the lock'),
    Mutant('thinks_it_over', breaks='at-once', also=('lock',), old='def on_goal(self, request):', new='''
        def on_goal(self, request):
            self.get_clock().sleep_for(Duration(seconds=0.2))
        ''', expect='expected at once'),
    Mutant('no_lock', breaks='lock', old='threading.Lock()', new='contextlib.nullcontext()',
           imports='import contextlib',
           expect='One thread stood still before'),
    Mutant('no_lock_when_a_goal_comes', breaks='lock', old=ACCEPTED, new='''
        self.goals.append(goal)
        alone = len(self.goals) == 1
        ''', expect='One thread stood still before'),
    Mutant('no_lock_when_a_goal_ends', breaks='lock', old=NEXT, new='''
        self.goals.pop(0)
        following = self.goals[:1]
        for other in following:
            other.execute()
        ''', expect='One thread stood still before'),
    Mutant('two_locks_for_one_look', breaks='lock', old=ACCEPTED, new='''
        with self.lock:
            self.goals.append(goal)
        with self.lock:
            alone = len(self.goals) == 1
        ''', expect='One thread stood still before'),
    Mutant('no_lock_when_it_looks_at_the_others', breaks='lock', old=LOOK, new='''
        gone = [goal for goal in self.goals[1:] if goal.is_cancel_requested]
        rest = [goal for goal in self.goals if goal not in gone]
        self.goals = rest
        ''', expect='One thread stood still before'),
    Mutant('two_statements_in_a_line', breaks='lock', old=ACCEPTED, new="""
        self.goals.append(goal); alone = len(self.goals) == 1
        """, expect='One thread stood still before'),
    Mutant('half_of_it_in_the_lock', breaks='lock', old=ACCEPTED, new="""
        with self.lock: self.goals.append(goal)
        with self.lock: alone = len(self.goals) == 1
        """, expect='One thread stood still before'),
    Mutant('the_rest_in_a_line', breaks='lock', old=LOOK, new="""
        gone = [goal for goal in self.goals[1:] if goal.is_cancel_requested]
        self.goals = [goal for goal in self.goals if goal not in gone]
        """, expect='One thread stood still before'),
    Mutant('a_flag_instead', breaks='lock', also=('queue', 'status', 'places'), edits=(
           ("super().__init__('printer')", '''
            super().__init__('printer')
            self.busy = False
            '''), (ACCEPTED, '''
            alone = not self.busy
            self.busy = True
            self.goals.append(goal)
            '''), (NEXT, '''
            self.goals.pop(0)
            following = self.goals[:1]
            self.busy = bool(following)
            for other in following:
                other.execute()
            ''')), expect='One thread stood still before'),
    Mutant('not_the_next_one_leaves', breaks='cancel-waiting', old='for goal in self.goals[1:] if goal.is_cancel',
           new='for goal in self.goals[2:] if goal.is_cancel', expect='while it waited'),
    Mutant('only_the_next_one_leaves', breaks='cancel-waiting', old='for goal in self.goals[1:] if goal.is_cancel',
           new='for goal in self.goals[1:2] if goal.is_cancel', expect='while it waited'),
    Mutant('goal_callbacks_side_by_side', breaks='places', old='cancel_callback=accept)',
           new='cancel_callback=accept, callback_group=ReentrantCallbackGroup())',
           imports='from rclpy.callback_groups import ReentrantCallbackGroup', expect='two goals at one moment'),
    Mutant('deaf_before_its_first_page', breaks='cancel', also=('lock', 'cancel-waiting', 'others'), edits=(
           ('while len(pages) < goal.request.order and not goal.is_cancel_requested:',
            'while len(pages) < goal.request.order and not (goal.is_cancel_requested and pages):'),
           ('if not goal.is_cancel_requested:', 'if not (goal.is_cancel_requested and pages):')),
           expect='Goal A was cancelled when it had [], and its result is'),
    Mutant('no_cancel_before_the_first_page', breaks='cancel', also=('lock', 'cancel-waiting'), edits=(
           ('cancel_callback=accept)', 'cancel_callback=self.on_cancel)'),
           ('def on_accepted(self, goal):', """
           def on_cancel(self, goal):
               there = getattr(self, 'printed', False) or goal is not self.goals[0]
               return CancelResponse.ACCEPT if there else CancelResponse.REJECT

           def on_accepted(self, goal):
           """), ('pages.append(len(pages) + 1)', """
           pages.append(len(pages) + 1)
           self.printed = True
           """)), expect='was to be cancelled; the request was answered: rejected'),
    Mutant('only_three_that_wait_leave', breaks='cancel-waiting', also=('lock', 'others'),
           old='for goal in self.goals[1:] if goal.is_cancel', new='for goal in self.goals[1:4] if goal.is_cancel',
           expect='somebody must look at all goals that wait'),
    Mutant('begins_the_next_before_the_end', breaks='queue', edits=(("""
        goal.canceled() if goal.is_cancel_requested else goal.succeed()
        with self.lock:
            self.goals.pop(0)
        """, """
        with self.lock:
            self.goals.pop(0)
        """), ("""
        for other in following:
            other.execute()
        """, """
        for other in following:
            other.execute()
        goal.canceled() if goal.is_cancel_requested else goal.succeed()
        """)), expect='First end a goal'),
    Mutant('cancelled_ones_take_no_place', breaks='places', also=('cancel-waiting', 'cancel', 'lock'),
           old='full = len(self.goals) >', new='full = len([one for one in self.goals if not one.is_cancel_requested]) >',
           expect='Goal too early was accepted'),
]
