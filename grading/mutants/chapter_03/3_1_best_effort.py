# expect: BEST_EFFORT
# rejected by: test_first_message
# Exercise 3.1: a beacon
from rclpy.qos import qos_profile_sensor_data


class Beacon(Node):
    def __init__(self):
        super().__init__('beacon')
        self.count = 0
        self.publisher = self.create_publisher(String, 'beacon', qos_profile_sensor_data)
        self.timer = self.create_timer(0.25, self.on_timer)

    def on_timer(self):
        self.count += 1
        self.publisher.publish(String(data=f'alive {self.count}'))
