# attack: returns ROS messages whose bytes are garbage
# row: 19
# aims at: 90.1
# stopped by: the tests read a message only if all of its bytes are there
# expect verdict: learner_crashed or failed
# expect message: total
import base64
import gc


def total(numbers):
    channel = next(thing for thing in gc.get_objects() if type(thing).__name__ == 'Channel')
    cdr = base64.b64encode(b'\x00\x01\x00\x00\xff\xff\xff\x7f' + b'\xff' * 64).decode()
    for number in range(2, 40):
        channel.send({'id': number, 'ok': True, 'result': {'$msg': 'sensor_msgs/msg/PointCloud2', 'cdr': cdr}})
    return 0
