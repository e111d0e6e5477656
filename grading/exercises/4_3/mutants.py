from grading.variants import Mutant

FUTURES = 'futures = [client.call_async(Trigger.Request()) for client in (self.battery, self.lidar)]'
AWAIT = 'battery, lidar = [await future for future in futures]'
STATUS = 'test_status'
CALLERS = 'test_two_callers'
WAITS = ('same-time', 'success', 'message', 'fresh', 'callers', 'names')

MUTANTS = [
    Mutant('answers_in_self', breaks='callers', edits=(("self.create_service(Trigger, 'status', self.on_status)",
           "self.create_service(Trigger, 'status', self.on_status, callback_group=ReentrantCallbackGroup())"),
           ('battery, lidar = [await future for future in futures]', '''
            self.said = {}
            for name, future in zip(('battery', 'lidar'), futures):
                self.said[name] = await future
            battery, lidar = self.said['battery'], self.said['lidar']
            ''')), imports='from rclpy.callback_groups import ReentrantCallbackGroup',
           expect='What belongs to one call must stay in local variables'),
    Mutant('tidies_the_texts', breaks='message', old='{battery.message}; lidar: {lidar.message}',
           new='{battery.message.strip()}; lidar: {lidar.message.strip()}', expect='The message of the status is'),
    Mutant('absolute_part', breaks='names', also=('callers', 'one-thread'), old="'lidar/check'", new="'/lidar/check'",
           expect='without a leading slash'),
    Mutant('any_success', breaks='success', also='callers', old='battery.success and lidar.success',
           new='battery.success or lidar.success', expect='success of the status is True, expected False'),
    Mutant('asks_second_if_first_is_well', breaks='same-time', also=('fresh', 'callers', 'message', 'one-thread'),
           edits=((FUTURES, 'battery = lidar = await self.battery.call_async(Trigger.Request())'),
                  (AWAIT, '''
            if battery.success:
                lidar = await self.lidar.call_async(Trigger.Request())
            ''')), expect='lidar/check was asked'),
    Mutant('asks_twice', breaks='fresh', also=('same-time', 'callers', 'message'), old=FUTURES, new='''
        self.lidar.call_async(Trigger.Request())
        futures = [client.call_async(Trigger.Request()) for client in (self.battery, self.lidar)]
        ''', expect='lidar/check was asked 2 times, expected 1'),
    Mutant('blocking_call', breaks='one-thread', also=WAITS, old='''
        async def on_status(self, request, response):
            futures = [client.call_async(Trigger.Request()) for client in (self.battery, self.lidar)]
            battery, lidar = [await future for future in futures]
        ''', new='''
        def on_status(self, request, response):
            battery, lidar = self.battery.call(Trigger.Request()), self.lidar.call(Trigger.Request())
        ''', expect='A callback waits for an answer'),
    Mutant('comma', breaks='message', old='; lidar:', new=', lidar:', also='callers',
           expect='The message of the status is'),
    Mutant('default_group', breaks='one-thread', also=WAITS,
           edits=(("(Trigger, 'battery/check', callback_group=group)", "(Trigger, 'battery/check')"),
                  ("(Trigger, 'lidar/check', callback_group=group)", "(Trigger, 'lidar/check')")),
           expect='Give the client a callback group of its own'),
    Mutant('does_not_wait', breaks='one-thread', also=WAITS,
           edits=(('async def on_status', 'def on_status'), ('await future', 'future.result()')),
           expect="has no attribute 'success'"),
    Mutant('keeps_answers', breaks='fresh', also='callers', old='''
        futures = [client.call_async(Trigger.Request()) for client in (self.battery, self.lidar)]
        battery, lidar = [await future for future in futures]
        ''', new='''
        if not hasattr(self, 'futures'):
            self.futures = [client.call_async(Trigger.Request()) for client in (self.battery, self.lidar)]
        battery, lidar = [await future for future in self.futures]
        ''', expect='battery/check was asked 1 time, expected 2'),
    Mutant('one_after_the_other', breaks='same-time', also='message',
           edits=((FUTURES, 'battery = await self.battery.call_async(Trigger.Request())'),
                  (AWAIT, 'lidar = await self.lidar.call_async(Trigger.Request())')),
           expect='first two call_async, then two await'),
    Mutant('only_the_lidar', breaks='success', also='callers', old='battery.success and lidar.success',
           new='lidar.success', expect='success of the status is True, expected False'),
    Mutant('order_of_arrival', breaks='message', also='callers', old='''
        battery, lidar = [await future for future in futures]
        response.success = battery.success and lidar.success
        response.message = f'battery: {battery.message}; lidar: {lidar.message}'
        ''', new='''
        texts = []
        for name, future in zip(('battery', 'lidar'), futures):
            future.add_done_callback(lambda f, name=name: texts.append(f'{name}: {f.result().message}'))
        battery, lidar = [await future for future in futures]
        while len(texts) < 2:
            await rclpy.task.Future()
        response.success = battery.success and lidar.success
        response.message = '; '.join(texts)
        ''', expect='The message of the status is'),
    Mutant('other_name', breaks='names', old="super().__init__('status_panel')", new="super().__init__('panel')",
           expect='your node is called'),
    Mutant('shared_between_callers', breaks='callers',
           edits=(("self.create_service(Trigger, 'status', self.on_status)",
                   "self.create_service(Trigger, 'status', self.on_status, "
                   'callback_group=rclpy.callback_groups.ReentrantCallbackGroup())'),
                  (f'\n{FUTURES}\n{AWAIT}\n', '''
            self.futures = [client.call_async(Trigger.Request()) for client in (self.battery, self.lidar)]
            lidar = await self.futures[1]
            battery = await self.futures[0]
            ''')), expect='What belongs to one call must stay in local variables'),
    Mutant('spins_in_callback', breaks='one-thread', also=WAITS, old='''
        async def on_status(self, request, response):
            futures = [client.call_async(Trigger.Request()) for client in (self.battery, self.lidar)]
            battery, lidar = [await future for future in futures]
        ''', new='''
        def on_status(self, request, response):
            futures = [client.call_async(Trigger.Request()) for client in (self.battery, self.lidar)]
            for future in futures:
                rclpy.spin_until_future_complete(self, future)
            battery, lidar = [future.result() for future in futures]
        ''', expect='Only another callback can receive'),
    Mutant('swapped', breaks='message', also=('callers', 'fresh'), old='{battery.message}; lidar: {lidar.message}',
           new='{lidar.message}; lidar: {battery.message}', expect='The message of the status is'),
    Mutant('keeps_answers_for_a_while', breaks='fresh', also=('callers', 'message', 'success'), old='''
        futures = [client.call_async(Trigger.Request()) for client in (self.battery, self.lidar)]
        battery, lidar = [await future for future in futures]
        ''', new='''
        now = self.get_clock().now().nanoseconds
        if now - getattr(self, 'asked', -(10**10)) > 10**9:
            self.asked = now
            self.futures = [client.call_async(Trigger.Request()) for client in (self.battery, self.lidar)]
        battery, lidar = [await future for future in self.futures]
        ''', expect='battery/check was asked 1 time, expected 2'),
    Mutant('stops_at_a_battery_that_is_not_well', breaks='message', also='callers', old=AWAIT, new='''
        battery = await futures[0]
        if not battery.success:
            response.message = f'battery: {battery.message}'
            return response
        lidar = await futures[1]
        ''', expect='The message of the status is'),
    Mutant('gives_up_slow_parts', breaks='message', old=AWAIT, new='''
        ends = [self.create_timer(2.0, future.cancel, callback_group=self.lidar.callback_group) for future in futures]
        battery, lidar = [await future or Trigger.Response(message='no answer') for future in futures]
        for end in ends:
            self.destroy_timer(end)
        ''', expect='Both always answer'),
    Mutant('gives_up_after_a_minute', breaks='message', old=AWAIT, new='''
        ends = [self.create_timer(60.0, future.cancel, callback_group=self.lidar.callback_group) for future in futures]
        battery, lidar = [await future or Trigger.Response(message='no answer') for future in futures]
        for end in ends:
            self.destroy_timer(end)
        ''', expect='Both always answer'),
    Mutant('strips_the_messages', old='{lidar.message}', new='{lidar.message.strip()}', breaks='message',
           edits=(('{battery.message}', '{battery.message.strip()}'),), expect='The message of the status is'),
    Mutant('eight_questions_at_most', edits=(('async def on_status(self, request, response):', '''
            calls = 0

            async def on_status(self, request, response):
                self.calls += 1
                if self.calls > 8:
                    response.success, response.message = self.last
                    return response
            '''), ('        return response', '''
            self.last = response.success, response.message
            return response
            ''')), expect='was asked 8 times, expected 9', breaks='fresh'),
    Mutant('battery_in_the_class', old='self.battery = ', new='StatusPanel.battery = ', breaks='names',
           expect='came on /other/battery/check'),
    Mutant('lidar_in_the_class', old='self.lidar = ', new='StatusPanel.lidar = ', breaks='names',
           expect='came on /other/lidar/check'),
    *[
        Mutant(f'only_{code}', breaks='message', expect='The message of the status is', new=f'''
               response.message = f'battery: {{battery.message}}; lidar: {{lidar.message}}'
               response.message = response.message.encode({encoding!r}, 'ignore').decode({encoding!r})
               ''', old="response.message = f'battery: {battery.message}; lidar: {lidar.message}'")
        for code, encoding in (('ascii', 'ascii'), ('latin', 'latin-1'))
    ],
    Mutant('lidar_with_a_typing_error', old="'lidar/check'", new="'lidar/chek'", breaks='names',
           also=('same-time', 'message', 'success', 'fresh', 'callers', 'one-thread'), expect='letter by letter'),
    Mutant('two_callers_at_most', breaks='callers', edits=(("self.create_service(Trigger, 'status', self.on_status)", """
        self.open = 0
        self.create_service(Trigger, 'status', self.on_status, callback_group=ReentrantCallbackGroup())
        """), (FUTURES, f"""
        if self.open == 2:
            response.message = 'busy'
            return response
        self.open += 1
        {FUTURES}
        """), (AWAIT, f"""
        {AWAIT}
        self.open -= 1
        """)), imports='from rclpy.callback_groups import ReentrantCallbackGroup', expect='also while another one is open'),
    Mutant('joins_a_question_that_is_open', breaks='callers', edits=(("self.create_service(Trigger, 'status', self.on_status)", """
        self.open = None
        self.create_service(Trigger, 'status', self.on_status, callback_group=ReentrantCallbackGroup())
        """), (FUTURES, f"""
        now = self.get_clock().now()
        if self.open and self.open[0] < now:
            futures = self.open[1]
        else:
            {FUTURES}
            self.open = now, futures
        """), (AWAIT, f"""
        {AWAIT}
        self.open = None
        """)), imports='from rclpy.callback_groups import ReentrantCallbackGroup', expect='also while another one is open'),
]
