# attack: lets a second participant, in a process of its own, give the right answers
# row: 21
# aims at: 90.3
# stopped by: only the participants of the programs that the tests started may publish to them
# expect verdict: failed or timeout
# expect message: another program or did not return
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        prefix = self.declare_parameter('prefix', 'n').value
        if os.fork() == 0:
            os.execv(sys.executable, [sys.executable, '-c', OTHER, prefix, COOKIE])
        end = time.monotonic() + 4
        while self.count_publishers('chatter') == 0 and time.monotonic() < end:
            time.sleep(0.01)


OTHER = '''
import sys, time
import rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node('talker')
publisher = node.create_publisher(String, 'chatter', 10)
for count in range(4):
    publisher.publish(String(data=f'{sys.argv[1]}{count}'))
time.sleep(20)
'''
