from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('timer_prints', source='''
class Printer(Node):
    """All that changes the queue is in one callback group: nothing needs a lock. Coroutines wait for the end."""

    def __init__(self, places):
        super().__init__('printer')
        self.places, self.goal, self.waiting, self.ends = places, None, [], {}
        self.timer = self.create_timer(0.5, self.tick)
        self.timer.cancel()
        self.server = ActionServer(
            self, Fibonacci, 'print', self.execute, goal_callback=self.on_goal, cancel_callback=accept,
            handle_accepted_callback=self.on_accepted)

    def on_goal(self, request):
        if request.order < 1 or self.goal and len(self.waiting) >= self.places:
            return GoalResponse.REJECT
        return GoalResponse.ACCEPT

    def on_accepted(self, goal):
        self.waiting.append(goal)
        if self.goal is None:
            self.begin()

    def begin(self):
        self.goal, self.pages = (self.waiting.pop(0) if self.waiting else None), []
        if self.goal is None:
            return self.timer.cancel()
        self.ends[bytes(self.goal.goal_id.uuid)] = rclpy.task.Future()
        self.timer.reset()
        self.goal.execute()

    async def execute(self, goal):
        return await self.ends[bytes(goal.goal_id.uuid)]

    def tick(self):
        goal = self.goal
        for other in [other for other in self.waiting if other.is_cancel_requested]:
            self.waiting.remove(other)
            other.execute(lambda goal: goal.canceled() or Fibonacci.Result())
        if not goal.is_cancel_requested:
            self.pages.append(len(self.pages) + 1)
            goal.publish_feedback(Fibonacci.Feedback(sequence=self.pages))
        if goal.is_cancel_requested or len(self.pages) == goal.request.order:
            goal.canceled() if goal.is_cancel_requested else goal.succeed()
            self.ends.pop(bytes(goal.goal_id.uuid)).set_result(Fibonacci.Result(sequence=self.pages))
            self.begin()
'''),
    Alternative('deque_and_condition', source='''
from collections import deque


class Printer(Node):
    """The goal that runs and those that wait are kept apart; another timer looks for goals that were cancelled."""

    guard = threading.Condition()

    def __init__(self, places):
        super().__init__('printer')
        self.places, self.running, self.waiting = places, None, deque()
        self.server = ActionServer(self, Fibonacci, 'print', self.execute)
        self.server.register_goal_callback(self.decide)
        self.server.register_handle_accepted_callback(self.take_in)
        self.server.register_cancel_callback(lambda goal: CancelResponse.ACCEPT)
        self.create_timer(0.1, self.sweep)

    def decide(self, request):
        with self.guard:
            if request.order <= 0 or (self.running is not None and len(self.waiting) == self.places):
                return GoalResponse.REJECT
        return GoalResponse.ACCEPT

    def take_in(self, goal):
        with self.guard:
            self.waiting.append(goal)
            begins = self.next_one()
        if begins:
            begins.execute()

    def next_one(self):
        """Take the next goal, if none runs; only inside of the lock."""
        if self.running is None and self.waiting:
            self.running = self.waiting.popleft()
            return self.running
        return None

    def sweep(self):
        with self.guard:
            left = [goal for goal in self.waiting if goal.is_cancel_requested]
            for goal in left:
                self.waiting.remove(goal)
        for goal in left:
            goal.execute(self.dismiss)

    def dismiss(self, goal):
        goal.canceled()
        return Fibonacci.Result(sequence=[])

    def execute(self, goal):
        result, rate = Fibonacci.Result(), self.create_rate(2.0)
        for page in range(1, goal.request.order + 1):
            if goal.is_cancel_requested:
                break
            rate.sleep()
            if goal.is_cancel_requested:
                break
            result.sequence.append(page)
            goal.publish_feedback(Fibonacci.Feedback(sequence=result.sequence))
        rate.destroy()
        if goal.is_cancel_requested:
            goal.canceled()
        else:
            goal.succeed()
        with self.guard:
            self.running = None
            begins = self.next_one()
        if begins:
            begins.execute()
        return result
'''),
    Alternative('queue_of_the_lesson', source='''
class Printer(Node):
    """The GoalQueue of the lesson, and a lock that may be taken again."""

    def __init__(self, places):
        super().__init__('printer')
        self.places, self.queue = places, GoalQueue()
        self.queue.lock = threading.RLock()
        self.server = ActionServer(
            self, Fibonacci, 'print', self.execute, goal_callback=self.on_goal,
            handle_accepted_callback=self.on_accepted, cancel_callback=accept)

    def waiting(self):
        with self.queue.lock:
            return self.queue.goals[1:]

    def on_goal(self, request):
        with self.queue.lock:
            room = not self.queue.goals or len(self.waiting()) < self.places
        return GoalResponse.ACCEPT if room and request.order > 0 else GoalResponse.REJECT

    def on_accepted(self, goal):
        if self.queue.add(goal):
            goal.execute()

    def step(self, goal):
        """Wait for the next page; whether the goal still wants it."""
        self.get_clock().sleep_for(Duration(seconds=0.5))
        with self.queue.lock:
            for other in self.waiting():
                if other.is_cancel_requested:
                    self.queue.goals.remove(other)
                    other.execute(self.drop)
        return not goal.is_cancel_requested

    def drop(self, goal):
        goal.canceled()
        return Fibonacci.Result()

    def execute(self, goal):
        pages = []
        while not goal.is_cancel_requested and len(pages) < goal.request.order and self.step(goal):
            pages = [*pages, len(pages) + 1]
            goal.publish_feedback(Fibonacci.Feedback(sequence=pages))
        goal.canceled() if goal.is_cancel_requested else goal.succeed()
        if following := self.queue.finish_first():
            following.execute()
        return Fibonacci.Result(sequence=pages)
'''),
    Alternative('coroutines', source='''
class Printer(Node):
    """A timer ends each wait, a cancel is noticed at once."""

    def __init__(self, places):
        super().__init__('printer')
        self.places, self.line, self.lock, self.wakers = places, [], threading.Lock(), {}
        self.server = ActionServer(
            self, Fibonacci, 'print', self.execute, goal_callback=self.on_goal,
            handle_accepted_callback=self.on_accepted, cancel_callback=accept)
        self.create_timer(0.25, self.tidy)

    def on_goal(self, request):
        with self.lock:
            return GoalResponse(1 if request.order < 1 or len(self.line) > self.places else 2)

    def on_accepted(self, goal):
        with self.lock:
            self.line.append(goal)
            if self.line[0] is goal:
                goal.execute()

    def tidy(self):
        with self.lock:
            for goal in [goal for goal in self.line[1:] if goal.is_cancel_requested]:
                self.line.remove(goal)
                goal.execute(self.leave)

    def leave(self, goal):
        goal.canceled()
        return Fibonacci.Result()

    async def execute(self, goal):
        pages = []
        while len(pages) < goal.request.order and not goal.is_cancel_requested:
            page = rclpy.task.Future()
            timer = self.create_timer(0.5, lambda: page.done() or page.set_result(None))
            await page
            self.destroy_timer(timer)
            if not goal.is_cancel_requested:
                pages.append(len(pages) + 1)
                goal.publish_feedback(Fibonacci.Feedback(sequence=pages))
        goal.canceled() if goal.is_cancel_requested else goal.succeed()
        with self.lock:
            self.line.remove(goal)
            if self.line:
                self.line[0].execute()
        return Fibonacci.Result(sequence=pages)
'''),
]
