from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('rate_and_clock', source='''
class DeliveryRobot(Courier):
    def __init__(self, **options):
        super().__init__(**options)
        self.server = ActionServer(self, GoToStation, 'go_to_station', self.execute)
        self.server.register_goal_callback(self.on_goal)
        self.server.register_cancel_callback(lambda goal: CancelResponse.ACCEPT)

    def on_goal(self, request):
        if request.station in self.stations and self.where() and self.state == 'idle':
            self.state = 'driving to ' + request.station
            return GoalResponse.ACCEPT
        return GoalResponse.REJECT

    def execute(self, goal):
        begin, told = self.get_clock().now(), self.get_clock().now()
        rate, result = self.create_rate(10.0), GoToStation.Result(distance=-1.0)
        rate.sleep()
        while not self.round(goal, result, begin):
            if self.get_clock().now() - told >= Duration(seconds=0.3):
                told = self.get_clock().now()
                goal.publish_feedback(GoToStation.Feedback(distance=result.distance))
            rate.sleep()
        self.destroy_rate(rate)
        return result

    def round(self, goal, result, begin):
        where, late = self.where(), (self.get_clock().now() - begin).nanoseconds / 1e9 >= self.value('timeout')
        if where:
            limits = self.value('max_linear'), self.value('max_angular')
            result.distance, linear, angular = steer(*where, *self.place(goal.request.station), *limits)
        there = where and result.distance < self.value('tolerance')
        if not (goal.is_cancel_requested or there or late or not where):
            self.drive(linear, angular)
            return False
        self.drive(0.0, 0.0)
        self.state = 'idle'
        end = goal.canceled if goal.is_cancel_requested else goal.succeed if there else goal.abort
        end()
        result.message = 'there' if there else 'not there: cancelled, lost or late'
        return True
''', alone=True),
    Alternative('side_by_side_with_a_lock', source='''
import threading

from rclpy.callback_groups import ReentrantCallbackGroup


class DeliveryRobot(Courier):
    def __init__(self, **options):
        super().__init__(**options)
        self.lock = threading.Lock()
        ActionServer(self, GoToStation, 'go_to_station', self.execute, callback_group=ReentrantCallbackGroup(),
                     goal_callback=self.on_goal, cancel_callback=lambda goal: CancelResponse.ACCEPT)

    def on_goal(self, request):
        with self.lock:
            free = self.state == 'idle' and self.place(request.station) and self.where()
            if free:
                self.state = f'driving to {request.station}'
            return GoalResponse.ACCEPT if free else GoalResponse.REJECT

    def execute(self, goal):
        clock, result, told = self.get_clock(), GoToStation.Result(), 0
        late = clock.now() + Duration(seconds=self.value('timeout'))
        while not result.message:
            if goal.is_cancel_requested:
                end, result.message = goal.canceled, 'called back'
            elif (here := self.where()) is None:
                end, result.message = goal.abort, 'where am I?'
            else:
                there, limits = self.place(goal.request.station), (self.value('max_linear'), self.value('max_angular'))
                result.distance, linear, angular = steer(*here, *there, *limits)
                if result.distance < self.value('tolerance'):
                    end, result.message = goal.succeed, 'at the station'
                elif clock.now() >= late:
                    end, result.message = goal.abort, 'too slow'
                else:
                    self.drive(linear, angular)
                    told += 1
                    if told % 3 == 1:
                        goal.publish_feedback(GoToStation.Feedback(distance=result.distance))
                    clock.sleep_for(Duration(seconds=0.1))
        self.drive(0.0, 0.0)
        self.state = 'idle'
        end()
        return result
''', alone=True),
]
