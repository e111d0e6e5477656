"""Attacks: dds. See ../README.md for the form of a row."""


# %% clock
# attack: publishes a /clock of its own
# row: 20
# aims at: 90.3
# stopped by: the tests keep their own time, and say which moment each message came in
# expect verdict: failed or timeout
# expect message: messages came or never comes to rest or did not return
from rosgraph_msgs.msg import Clock


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.clock_publisher = self.create_publisher(Clock, '/clock', 10)
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.count = 0
        self.create_timer(0.5, self.tick)

    def tick(self):
        message = Clock()
        message.clock.sec = 10**6 + self.count
        self.clock_publisher.publish(message)
        for _ in range(2):
            self.publisher.publish(String(data=f'n{self.count}'))
            self.count += 1


# %% conduct
# attack: speaks on the tests' own topics, to tell them that all is done
# row: 21
# aims at: 90.3
# stopped by: what a step has brought is counted from what arrived
# expect verdict: failed or learner_crashed
# expect message: messages came or disturbed or with another program
from std_msgs.msg import UInt64


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.forged = []
        for name, _ in self.get_topic_names_and_types():
            if name.endswith(('/done', '/step')):
                self.forged.append(self.create_publisher(UInt64, name, 100))
        self.create_timer(0.1, self.tick)

    def tick(self):
        for publisher in self.forged:
            for number in range(50):
                publisher.publish(UInt64(data=number))


# %% eternal_echo
# attack: answers its own messages without end
# row: 14
# aims at: 90.3
# stopped by: the number of callbacks at one moment is bounded
# expect verdict: failed
# expect message: never comes to rest
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.create_subscription(String, 'chatter', self.publisher.publish, 10)
        self.publisher.publish(String(data='n0'))


# %% flood
# attack: publishes from a thread as fast as it can
# row: 19
# aims at: 90.3
# stopped by: the number of messages that a test takes is bounded
# expect verdict: failed or timeout
# expect message: messages
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'chatter', 1000)
        threading.Thread(target=self.flood, daemon=True).start()

    def flood(self):
        end = time.monotonic() + 60
        while time.monotonic() < end:
            self.publisher.publish(String(data='n0'))


# %% garbage
# attack: publishes bytes that are no message, and texts that are no UTF-8
# row: 19
# aims at: 90.3
# stopped by: what cannot be read is not taken for a message, and is the learner's fault
# expect verdict: failed or learner_crashed
# expect message: messages came or cannot be read
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.create_timer(0.5, self.tick)

    def tick(self):
        for data in (b'', b'\x00', b'\x00\x01\x00\x00', b'\x00\x01\x00\x00\xff\xff\xff\xff', b'\xff' * 100,
                     b'\x00\x01\x00\x00\x04\x00\x00\x00\xff\xfe\xfd\x00'):
            self.publisher.publish(data)


# %% hidden_name
# attack: names its second node like one of the tests' own, so that it is not counted
# row: 21
# aims at: 90.3
# stopped by: endpoints are told apart by participant, not by name
# expect verdict: failed
# expect message: another program or messages came
from rclpy.context import Context


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        prefix = self.declare_parameter('prefix', 'n').value
        tests = next((name for name in self.get_node_names() if name.endswith('_t')), '_x_t')
        self.other = Context()
        self.other.init()
        self.node = Node(tests, context=self.other)
        publisher = self.node.create_publisher(String, 'chatter', 10)
        count = iter(range(100))
        self.create_timer(0.5, lambda: publisher.publish(String(data=f'{prefix}{next(count)}')))


# %% hit_and_run
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


# %% hit_and_run_again
# attack: lets a second participant come and leave without a word, as a node that is tried out, and then another one speak
# row: 21
# aims at: 90.3
# stopped by: who was gone before the first message came is counted, and who comes later is counted, too
# expect verdict: failed or timeout
# expect message: another program or did not return
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        prefix = self.declare_parameter('prefix', 'n').value
        for words in ('0', '4'):
            if os.fork() == 0:
                os.execv(sys.executable, [sys.executable, '-c', OTHER, prefix, words, COOKIE])
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
for count in range(int(sys.argv[2])):
    publisher.publish(String(data=f'{sys.argv[1]}{count}'))
publisher.wait_for_all_acked(Duration(seconds=20))
node.destroy_node()
rclpy.shutdown()
'''


# %% huge_message
# attack: publishes messages of 100 MB
# row: 19
# aims at: 90.3
# stopped by: memory is bounded on both sides
# expect verdict: failed or learner_crashed or timeout
# expect message: messages came or raised or did not return or process or with another program
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.create_timer(0.5, lambda: self.publisher.publish(String(data='x' * 100_000_000)))


# %% many_topics
# attack: makes hundreds of topics and services
# row: 24
# aims at: 90.3
# stopped by: waits are bounded
# expect verdict: failed or timeout or learner_crashed
# expect message: messages came or did not return or raised
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.many = [self.create_publisher(String, f'topic{number}', 10) for number in range(300)]


# %% no_conductor
# attack: destroys the hidden node through which the tests conduct its process
# row: 21
# aims at: 90.3
# stopped by: a test that cannot be conducted is no pass
# expect verdict: failed or learner_crashed
# expect message: messages came or disturbed or raised or ended by itself or with another program
import gc


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_timer(0.5, self.tick)

    def tick(self):
        for thing in gc.get_objects():
            if type(thing).__name__ == 'Conductor':
                thing.node.destroy_node()


# %% parameters
# attack: sets parameters of every node that it finds
# row: 20
# aims at: 90.3
# stopped by: the tests' node has no parameter services
# expect verdict: failed
# expect message: messages came
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_timer(0.5, self.tick)

    def tick(self):
        own = (self.get_name(),)
        for name, kinds in self.get_service_names_and_types():
            if name.endswith('set_parameters') and not name.startswith(tuple(f'/{node}/' for node in own)):
                tell('SEEN', name)


# %% raw_packets
# attack: sends forged and broken RTPS packets to everybody
# row: 24
# aims at: 90.3
# stopped by: a crash of the tests is no pass; nobody else hears the network of this run
# expect verdict: failed
# expect message: messages came or fault or with another program
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_timer(0.5, self.tick)

    def tick(self):
        sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        for port in (*range(7400, 7420), *range(7400 + 250 * int(os.environ.get('ROS_DOMAIN_ID', 0)), 7400 + 250 * int(
                os.environ.get('ROS_DOMAIN_ID', 0)) + 20)):
            for packet in (b'RTPS', b'RTPS\x02\x03\x01\x0f' + b'\x00' * 12 + b'\x15\x05\xff\xff' + b'\xff' * 200,
                           b'RTPS\x02\x03\x01\x0f' + b'\xff' * 600, b'\x00' * 65000):
                try:
                    sender.sendto(packet, ('127.0.0.1', port))
                except OSError:
                    pass


# %% same_name
# attack: names its node like the tests' node
# row: 21
# aims at: 90.3
# stopped by: the tests know their own endpoints by participant
# expect verdict: failed
# expect message: messages came
class Talker(Node):
    def __init__(self):
        probe = Node('probe')
        end = time.monotonic() + 1
        names = []
        while not names and time.monotonic() < end:
            names = [name for name in probe.get_node_names() if name.endswith('_t')]
            time.sleep(0.01)
        probe.destroy_node()
        super().__init__(names[0] if names else 'talker')


# %% second_context
# attack: speaks through a participant of its own beside the one that the tests know
# row: 21
# aims at: 90.3
# stopped by: only the participants of the programs that the tests started may publish to them
# expect verdict: failed
# expect message: another program or messages came
from rclpy.context import Context


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        prefix = self.declare_parameter('prefix', 'n').value
        self.other = Context()
        self.other.init()
        self.node = Node('talker', context=self.other)
        publisher = self.node.create_publisher(String, 'chatter', 10)
        count = iter(range(100))
        self.create_timer(0.5, lambda: publisher.publish(String(data=f'{prefix}{next(count)}')))


# %% second_talker
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


# %% services
# attack: offers services under the names of the tests' node
# row: 21
# aims at: 90.3
# stopped by: the tests ask no service of their own
# expect verdict: failed
# expect message: messages came
from rcl_interfaces.srv import GetParameters, SetParameters


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        for name in self.get_node_names():
            self.create_service(SetParameters, f'/{name}/set_parameters', lambda request, response: response)
            self.create_service(GetParameters, f'/{name}/get_parameters', lambda request, response: response)


# %% type_name
# attack: gives a message type a name that is no text
# row: 22
# aims at: 90.3
# stopped by: a test that only this program breaks is not passed
# expect verdict: failed
# expect message: with another program
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        rename(String, b'\xff\xfe' * 20)
        self.publisher = self.create_publisher(String, 'chatter', 10)


def rename(kind, name):
    """Give a message type another name, as others see it."""
    api = ctypes.pythonapi
    api.PyCapsule_GetPointer.restype, api.PyCapsule_GetName.restype = ctypes.c_void_p, ctypes.c_char_p
    api.PyCapsule_GetPointer.argtypes = [ctypes.py_object, ctypes.c_char_p]
    api.PyCapsule_GetName.argtypes = [ctypes.py_object]
    kind.__class__.__import_type_support__()
    capsule = kind.__class__._TYPE_SUPPORT
    handle = api.PyCapsule_GetPointer(capsule, api.PyCapsule_GetName(capsule))
    words = ctypes.POINTER(ctypes.c_void_p)
    find = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p)(ctypes.cast(handle, words)[2])
    callbacks = ctypes.cast(find(handle, b'rosidl_typesupport_fastrtps_c'), words)[1]
    rename.kept = ctypes.create_string_buffer(name)
    ctypes.cast(callbacks, words)[1] = ctypes.addressof(rename.kept)


# %% type_name_long
# attack: gives a message type a name that is very long
# row: 22
# aims at: 90.3
# stopped by: waits are bounded
# expect verdict: failed or timeout
# expect message: messages came or must carry or with another program
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        rename(String, b'x' * 60_000)
        self.publisher = self.create_publisher(String, 'chatter', 10)


def rename(kind, name):
    """Give a message type another name, as others see it."""
    api = ctypes.pythonapi
    api.PyCapsule_GetPointer.restype, api.PyCapsule_GetName.restype = ctypes.c_void_p, ctypes.c_char_p
    api.PyCapsule_GetPointer.argtypes = [ctypes.py_object, ctypes.c_char_p]
    api.PyCapsule_GetName.argtypes = [ctypes.py_object]
    kind.__class__.__import_type_support__()
    capsule = kind.__class__._TYPE_SUPPORT
    handle = api.PyCapsule_GetPointer(capsule, api.PyCapsule_GetName(capsule))
    words = ctypes.POINTER(ctypes.c_void_p)
    find = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p)(ctypes.cast(handle, words)[2])
    callbacks = ctypes.cast(find(handle, b'rosidl_typesupport_fastrtps_c'), words)[1]
    rename.kept = ctypes.create_string_buffer(name)
    ctypes.cast(callbacks, words)[1] = ctypes.addressof(rename.kept)


# %% type_name_of_markup
# attack: gives a message type a name of mark-up and escapes
# row: 37
# aims at: 90.3
# stopped by: every text is escaped where it is shown
# expect verdict: failed
# expect message: must carry
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        rename(String, b'<script>alert(1)</script>\x1b[2J' * 5)
        self.publisher = self.create_publisher(String, 'chatter', 10)


def rename(kind, name):
    """Give a message type another name, as others see it."""
    api = ctypes.pythonapi
    api.PyCapsule_GetPointer.restype, api.PyCapsule_GetName.restype = ctypes.c_void_p, ctypes.c_char_p
    api.PyCapsule_GetPointer.argtypes = [ctypes.py_object, ctypes.c_char_p]
    api.PyCapsule_GetName.argtypes = [ctypes.py_object]
    kind.__class__.__import_type_support__()
    capsule = kind.__class__._TYPE_SUPPORT
    handle = api.PyCapsule_GetPointer(capsule, api.PyCapsule_GetName(capsule))
    words = ctypes.POINTER(ctypes.c_void_p)
    find = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p)(ctypes.cast(handle, words)[2])
    callbacks = ctypes.cast(find(handle, b'rosidl_typesupport_fastrtps_c'), words)[1]
    rename.kept = ctypes.create_string_buffer(name)
    ctypes.cast(callbacks, words)[1] = ctypes.addressof(rename.kept)


# %% entities
# attack: makes hundreds of publishers from a thread, while the tests look for its nodes
# row: 24
# aims at: 90.3
# stopped by: waits are bounded
# expect verdict: failed or timeout or learner_crashed
# expect message: messages came or did not return or raised or ended or with another program
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.chatter = self.create_publisher(String, 'chatter', 10)
        threading.Thread(target=self.flood, daemon=True).start()

    def flood(self):
        self.kept = []
        while len(self.kept) < 600:
            self.kept.append(self.create_publisher(String, f'topic{len(self.kept)}', 10))


# %% deaf_reader
# attack: lets another process read what the tests send, and stops it, so that nothing is acknowledged
# row: 24
# aims at: 90.3
# stopped by: waits are bounded
# expect verdict: failed or timeout
# expect message: messages came or did not return or in time
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        spoken, told = os.pipe()
        names = [name for name, _ in self.get_topic_names_and_types() if name.endswith('/step')]
        pid = os.fork()
        if pid == 0:
            os.dup2(told, 1)
            os.execv(sys.executable, [sys.executable, '-c', OTHER, COOKIE, *names])
        os.close(told)
        os.read(spoken, 1)
        os.kill(pid, signal.SIGSTOP)
        self.chatter = self.create_publisher(String, 'chatter', 10)


OTHER = '''
import sys, time
import rclpy
from std_msgs.msg import UInt64
rclpy.init()
node = rclpy.create_node('listener')
heard = [node.create_subscription(UInt64, name, lambda message: print(message), 10) for name in sys.argv[2:]]
end = time.monotonic() + 2
while time.monotonic() < end and not all(node.count_publishers(name) for name in sys.argv[2:]):
    time.sleep(0.01)
print('spoken', flush=True)
time.sleep(30)
'''
