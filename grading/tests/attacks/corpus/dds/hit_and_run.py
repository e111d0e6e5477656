# attack: lets a second participant give the right answers and disappear politely at once
# row: 21
# aims at: 90.3
# stopped by: publishers that were ever connected are counted
# expect verdict: failed or timeout
# expect message: another program or did not return
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        prefix = self.declare_parameter('prefix', 'n').value
        if os.fork() == 0:
            os.execv(sys.executable, [sys.executable, '-c', OTHER, prefix, COOKIE])
        os.wait()


OTHER = '''
import sys, time
import rclpy
from rclpy.duration import Duration
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node('talker')
publisher = node.create_publisher(String, 'chatter', 10)
end = time.monotonic() + 20
while publisher.get_subscription_count() == 0 and time.monotonic() < end:
    time.sleep(0.01)
for count in range(4):
    publisher.publish(String(data=f'{sys.argv[1]}{count}'))
publisher.wait_for_all_acked(Duration(seconds=20))
node.destroy_node()
rclpy.shutdown()
'''
