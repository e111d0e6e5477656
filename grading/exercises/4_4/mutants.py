from grading.variants import Mutant

ASK = 'answer = await self.lock.call_async(SetBool.Request(data=False))'
LEAVE = 'self.inside = max(0, self.inside - 1)'
ONE = 'test_one_after_the_other'
ALL = 'test_all_at_once'
NEVER = ('names', 'capacity', 'welcome', 'open', 'locked', 'full', 'leave')

MUTANTS = [
    Mutant('one_count_for_all_guards', breaks='full', edits=(
        ('self.capacity, self.inside = capacity, 0', 'self.capacity = capacity'),
        ('class DoorGuard(Node):', '''
         class DoorGuard(Node):
             inside = 0

         '''), ('self.inside += answer.success', 'DoorGuard.inside += answer.success'),
        (LEAVE, 'DoorGuard.inside = max(0, self.inside - 1)')), expect='Each guard counts for itself'),
    Mutant('each_guard_empties_all_rooms', breaks='full', edits=(
        ('self.capacity, self.inside = capacity, 0', '''
         self.capacity = capacity
         DoorGuard.inside = 0
         '''), ('self.inside += answer.success', 'DoorGuard.inside += answer.success'),
        (LEAVE, 'DoorGuard.inside = max(0, self.inside - 1)')), expect='Each guard counts for itself'),
    Mutant('one_capacity_for_all_guards', breaks='full', edits=(
        ('self.capacity, self.inside = capacity, 0', 'DoorGuard.capacity, self.inside = capacity, 0'),
        ('class DoorGuard(Node):', '''
         class DoorGuard(Node):
             capacity = 2

         ''')), expect='a capacity of its own'),
    Mutant('absolute_lock', breaks='names', also=('one-thread', 'capacity'), old="SetBool, 'lock', callback_group",
           new="SetBool, '/lock', callback_group", expect='without a leading slash'),
    Mutant('absolute_leave', breaks='names', old="Trigger, 'leave'", new="Trigger, '/leave'",
           expect='without a leading slash'),
    Mutant('all_reentrant', breaks='capacity', also=('full', 'open'), old='''
        self.lock = self.create_client(
            SetBool, 'lock', callback_group=MutuallyExclusiveCallbackGroup())
        self.create_service(Trigger, 'enter', self.on_enter)
        self.create_service(Trigger, 'leave', self.on_leave)
        ''', new='''
        group = ReentrantCallbackGroup()
        self.lock = self.create_client(SetBool, 'lock', callback_group=group)
        self.create_service(Trigger, 'enter', self.on_enter, callback_group=group)
        self.create_service(Trigger, 'leave', self.on_leave, callback_group=group)
        ''', expect='enter must stay in a mutually exclusive group'),
    Mutant('two_for_none', breaks='full', old='self.capacity, self.inside = capacity, 0',
           new='self.capacity, self.inside = capacity or 2, 0', expect='Capacity 0, nobody inside'),
    Mutant('asks_the_lock_first', breaks='full', also=('capacity', 'leave', 'locked'),
           edits=(('async def on_enter(self, request, response):', '''
            async def on_enter(self, request, response):
                answer = await self.lock.call_async(SetBool.Request(data=False))
            '''), (ASK, '')), expect='the lock was asked although the room is full'),
    Mutant('blocking_call', breaks='one-thread', also=NEVER, edits=(('async def on_enter', 'def on_enter'),
           ('await self.lock.call_async', 'self.lock.call')), expect='A callback waits for an answer'),
    Mutant('counts_before', breaks='locked', also='open', edits=((ASK, 'self.inside += 1'),
           ('self.inside += answer.success', ASK)), expect='the lock refuses, and has refused'),
    Mutant('full_above_capacity', breaks='full', also=('capacity', 'locked', 'leave', 'open'),
           old='if self.inside >= self.capacity:', new='if self.inside > self.capacity:',
           expect="expected (False, 'full')"),
    Mutant('hands_on_what_the_lock_says', breaks='welcome', also=('locked', 'leave', 'capacity', 'open'),
           old="'welcome' if answer.success", new="(answer.message or 'welcome') if answer.success",
           expect="expected (True, 'welcome')"),
    Mutant('leaves_below_zero', breaks='leave', old=LEAVE, new='self.inside -= 1', expect='An empty room stays at 0'),
    Mutant('gives_up_a_slow_lock', breaks='welcome', old=ASK, new='''
        future = self.lock.call_async(SetBool.Request(data=False))
        limit = self.create_timer(2.0, future.cancel, callback_group=self.lock.callback_group)
        answer = await future or SetBool.Response()
        self.destroy_timer(limit)
        ''', expect='the lock answers after'),
    Mutant('gives_up_after_a_minute', breaks='welcome', old=ASK, new='''
        future = self.lock.call_async(SetBool.Request(data=False))
        limit = self.create_timer(60.0, future.cancel, callback_group=self.lock.callback_group)
        answer = await future or SetBool.Response()
        self.destroy_timer(limit)
        ''', expect='the lock answers after'),
    Mutant('leaves_without_success', breaks='leave', old='''
        self.inside = max(0, self.inside - 1)
        response.success = True
        ''', new='''
        response.success = self.inside > 0
        self.inside = max(0, self.inside - 1)
        ''', expect='leave gives success=False'),
    Mutant('locks_the_door', breaks='open', old='(SetBool.Request(data=False))', new='(SetBool.Request(data=True))',
           expect='with False, which means open'),
    Mutant('never_counts', breaks='full', also=('capacity', 'locked', 'leave', 'open'),
           old='self.inside += answer.success', new='', expect="expected (False, 'full')"),
    Mutant('no_answer_when_refused', breaks='locked', also=('open', 'one-thread', 'capacity', 'welcome'), old='''
        response.message = 'welcome' if answer.success else 'locked'
        return response
        ''', new='''
        if answer.success:
            response.message = 'welcome'
            return response
        ''', expect='the callback of the service returned nothing (None)'),
    Mutant('no_welcome', breaks='welcome', also=('locked', 'leave', 'capacity', 'open', 'names'),
           old="response.message = 'welcome' if answer.success else 'locked'",
           new="response.message = answer.message if answer.success else 'locked'",
           expect="expected (True, 'welcome')"),
    Mutant('other_name', breaks='names', old="super().__init__('door_guard')", new="super().__init__('guard')",
           expect='your node is called'),
    Mutant('refused_is_full', breaks='locked', also=('open', 'capacity'), old="else 'locked'", new="else 'full'",
           expect="expected (False, 'locked')"),
    Mutant('reserves_a_place', breaks='open', also=('locked', 'capacity'), edits=(('''
        self.lock = self.create_client(
            SetBool, 'lock', callback_group=MutuallyExclusiveCallbackGroup())
        self.create_service(Trigger, 'enter', self.on_enter)
        self.create_service(Trigger, 'leave', self.on_leave)
        ''', '''
        group = ReentrantCallbackGroup()
        self.lock = self.create_client(SetBool, 'lock', callback_group=group)
        self.create_service(Trigger, 'enter', self.on_enter, callback_group=group)
        self.create_service(Trigger, 'leave', self.on_leave, callback_group=group)
        '''), (ASK, f'''
        self.inside += 1
        {ASK}
        '''), ('self.inside += answer.success', 'self.inside -= not answer.success')), expect='when nobody was inside'),
    Mutant('still_one_group', breaks='one-thread', also=NEVER, old='''
        self.lock = self.create_client(
            SetBool, 'lock', callback_group=MutuallyExclusiveCallbackGroup())
        ''', new="self.lock = self.create_client(SetBool, 'lock')",
           expect='Give the client a callback group of its own'),
    Mutant('spins_in_callback', breaks='one-thread', also=NEVER, edits=(('async def on_enter', 'def on_enter'), (ASK, '''
        future = self.lock.call_async(SetBool.Request(data=False))
        rclpy.spin_until_future_complete(self, future)
        answer = future.result()
        ''')), expect='A callback spins'),
    Mutant('looks_again_after_the_lock', breaks='full', edits=((
           "self.create_service(Trigger, 'enter', self.on_enter)",
           "self.create_service(Trigger, 'enter', self.on_enter, callback_group=ReentrantCallbackGroup())"),
           (ASK, f'''
        {ASK}
        if self.inside >= self.capacity:
            response.message = 'full'
            return response
        ''')), expect='The lock was asked'),
    Mutant('locks_when_somebody_leaves', old=LEAVE, new=f'''
        {LEAVE}
        self.lock.call_async(SetBool.Request(data=True))
        ''', expect='leave has asked the lock', breaks='leave'),
    Mutant('a_refusal_takes_one_out', breaks='locked', old='self.inside += answer.success', new="""
        self.inside = self.inside + 1 if answer.success else max(0, self.inside - 1)
        """, expect='the lock has refused some before', also=('leave',)),
    Mutant('tired_after_forty', breaks='welcome', also=('leave', 'full'), old=ASK, new=f"""
        self.visits = getattr(self, 'visits', 0) + 1
        if self.visits > 40:
            response.message = 'locked'
            return response
        {ASK}
        """, expect="40 people inside: enter gives (False, 'locked'), expected (True, 'welcome')"),
    Mutant('believes_words', breaks='welcome', old='response.success = answer.success',
           new='response.success = answer.success and bool(answer.message)', also=('capacity', 'full', 'leave', 'locked', 'names', 'one-thread', 'open'),
           expect="'welcome'"),
    Mutant('writes_back_an_old_number', breaks='leave', edits=(
           ("self.create_service(Trigger, 'leave', self.on_leave)",
            "self.create_service(Trigger, 'leave', self.on_leave, callback_group=ReentrantCallbackGroup())"),
           ('answer = await self.lock.call_async(SetBool.Request(data=False))', """
            before = self.inside
            answer = await self.lock.call_async(SetBool.Request(data=False))
            """), ('self.inside += answer.success', 'self.inside = before + answer.success')),
           expect='left while the lock was slow'),
    Mutant('three_places_by_default', breaks='capacity', old='capacity=2', new='capacity=3', also=('full', 'locked'),
           expect='without an argument `capacity` is 2'),
    Mutant('lock_in_the_class', old='self.lock = ', new='DoorGuard.lock = ', breaks='names',
           expect='came on /other/lock'),
    Mutant('ten_refusals_are_enough', breaks='open', also='locked', old=ASK, new=f"""
        if getattr(self, 'refused', 0) >= 10:
            response.message = 'locked'
            return response
        {ASK}
        self.refused = 0 if answer.success else getattr(self, 'refused', 0) + 1
        """, expect='the lock got requests with data = []'),
]
