# attack: spins in the constructor
# row: 14
# aims at: 90.3
# stopped by: each start is waited for within a bound
# expect verdict: timeout
# expect message: leave them to the program that runs it
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        rclpy.spin(self)
