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
        spoken, told = os.pipe()
        if os.fork() == 0:
            os.dup2(told, 1)
            os.execv(sys.executable, [sys.executable, '-c', OTHER, prefix, COOKIE])
        os.close(told)
        os.read(spoken, 1)


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
print('spoken', flush=True)
time.sleep(20)
'''
