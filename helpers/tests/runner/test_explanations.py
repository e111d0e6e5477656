"""The sentences on exceptions: the exceptions are those that rclpy and Python really raise."""

import pytest
import rclpy
from rclpy.node import Node

from helpers.runner.explanations import explain

IMPORTS = """
from example_interfaces.action import Fibonacci
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult
from geometry_msgs.msg import TransformStamped, Twist
from nav_msgs.msg import OccupancyGrid
from rclpy.action import ActionClient
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.task import Future
from rclpy.time import Time
from sensor_msgs.msg import LaserScan, Range
from std_msgs.msg import Bool, Float64, Header, Int32, String
from std_srvs.srv import SetBool, Trigger
from tf2_ros import Buffer, StaticTransformBroadcaster
"""


@pytest.fixture
def node(domain):
    context = rclpy.Context()
    rclpy.init(context=context, domain_id=domain)
    node = Node('careless', context=context)
    yield node
    node.destroy_node()
    rclpy.shutdown(context=context)


@pytest.mark.parametrize(
    ('line', 'words'),
    [
        ('with print():\n    pass', 'If it is rclpy.init(): that works from the distribution after Jazzy on'),
        ('node.get_clock().now() > 0.5', 'A number of seconds is no duration'),
        ('Duration(seconds=1) > 0.5', 'write Duration(seconds=…)'),
        ('0.5 < Duration(seconds=1)', 'A number of seconds is no duration'),
        ('node.get_clock().now() + 0.5', 'A number of seconds is no duration'),
        ('node.get_clock().now() - 1', 'A number of seconds is no duration'),
        ('node.get_clock().now() - node.get_clock().now().to_msg()', 'Time.from_msg(stamp) makes a time of rclpy'),
        ('Header(stamp=node.get_clock().now())', 'becomes this message with .to_msg()'),
        ("node.create_client(Trigger, 'ask').call_async('now')", "call_async the service's Request"),
        ("ActionClient(node, Fibonacci, 'count').send_goal_async(5)", 'send_goal_async its Goal'),
        (
            "node.create_client(Trigger, 'ask').call_async(Trigger.Request()).success",
            'future.result() gives the answer',
        ),
        ('Float64(data=2)', 'write 2.0 instead of 2'),
        ('Bool(data=1)', 'Write bool(…) around the value; of a message take the field that holds it.'),
        ('String(data=1)', 'str(…) or an f-string; of a message take the field that holds it. None is no text'),
        ('text = print()\nString(data=text)', 'did a function end without `return`?'),
        ('String(data=None)', 'A text is wanted, and None is no text.'),
        ("Int32(data='#..')", 'len(…) counts a list or a text; of a message take the field that holds it.'),
        ('from geometry_msgs.msg import Pose; Pose().yaw', '`ros2 interface show` prints'),
        ('from geometry_msgs.msg import Pose; Pose().orientatoin', 'there is `orientation`'),
        ('Twist.linear.x = 1.0', 'parentheses are missing, as in Twist()'),
        ('1 + SetBool.Response()', 'take one of its fields'),
        ('Range() < 0.5', 'take one of its fields'),
        ('node.get_name.upper()', 'Parentheses call it'),
        ('Fibonacci.Feedback(sequence=5)', 'something else with parts'),
        (
            'from rclpy.action import CancelResponse; CancelResponse.accept',
            'CancelResponse has `ACCEPT`, and no `accept`',
        ),
        ("node.create_client(Trigger, 'ask', callback_group='own')", 'such as MutuallyExclusiveCallbackGroup()'),
        ("(1, 'a').where", 'numbers, [0], [1] …, and no names'),
        ("from xml.etree import ElementTree; ElementTree.fromstring('<a/>').name", "get('name')"),
        ("from xml.etree import ElementTree; float(ElementTree.fromstring('<a/>'))", "get('value')"),
        ("String('alive')", 'given by their names: String(…=…)'),
        ('Duration(0.5)', 'given by their names: Duration(…=…)'),
        ('Trigger.Request(1)', 'given by their names: Trigger.Request(…=…)'),
        ('Fibonacci.Feedback([1])', 'given by their names: Fibonacci.Feedback(…=…)'),
        ("String(text='alive')", 'The message has no field `text`'),
        ('Twist(linear=1.0)', 'a Vector3: set its fields one by one'),
        ('SetBool(data=True)', 'made by SetBool.Request(…)'),
        ('Fibonacci(order=3)', 'made by Fibonacci.Goal(…)'),
        ("node.create_publisher(String, 'a', 10).publish('alive')", 'a field of it: String(…=…)'),
        ("node.create_publisher(String, 'a', 10).publish(None)", 'nothing to publish yet (None), where a String'),
        ("node.create_publisher(Twist, 'a', 10).publish(1.0, 0.0)", 'It takes one message'),
        ("node.create_publisher(Twist, '{me}/cmd_vel', 10)", "f'{me}/…' puts the value of me into it"),
        ("node.create_subscription(String, 'a', lambda: None, 10)", 'The first parameter of a method is `self`'),
        (
            'class Own:\n    def on_timer():\n        pass\n\nOwn().on_timer()',
            'Is `self` missing, which comes first in a method',
        ),
        (
            'class Own:\n    def on_answer(self):\n        pass\n\nOwn().on_answer(None)',
            'or the parameter for what it is given?',
        ),
        (
            "node.create_client(Trigger, 'ask', callback_group=MutuallyExclusiveCallbackGroup)",
            'A class is given where a group is wanted',
        ),
        ("Buffer().lookup_transform('map', 'base_link')", "lookup_transform('map', 'base_link', Time())"),
        ("node.create_publisher(String, 'a', 10).publish()", 'It takes the message'),
        ("node.declare_parameter('rate', 1.0); float(node.get_parameter('rate'))", 'get_parameter(name).value'),
        ("node.declare_parameter('rate', 1.0); node.get_parameter('rate') * 2", 'get_parameter(name).value'),
        ("node.declare_parameter('rate', 1.0); 2.0 < node.get_parameter('rate')", 'get_parameter(name).value'),
        ("node.create_publisher('String', 'a', 10)", 'A type is the class itself'),
        ('Trigger()', 'As a type it stands without parentheses.'),
        ('Fibonacci()', 'those of an action by ….Goal()'),
        ("node.create_service(Trigger.Request, 'a', print)", 'The type of the service is Trigger itself'),
        ('Trigger.Response().text', 'The message has no field `text`'),
        ('Twist().angle', 'The message has no field `angle`'),
        ('Range().maxrange', 'The message has no field `maxrange`; there is `max_range`.'),
        ('LaserScan().rangs', 'there is `ranges`'),
        ('LaserScan().distances', 'Its fields: header, angle_min'),
        ('TransformStamped().add_done_callback(print)', 'This is the message itself, and no future'),
        ('LaserScan().ranges < 0.5', 'Look at each of them'),
        ('2.0 - Twist.linear', 'A class is given where an object of it is wanted'),
        ('SetParametersResult(False)', 'given by their names: SetParametersResult(…=…)'),
        ('StaticTransformBroadcaster()', 'It takes the node: StaticTransformBroadcaster(self)'),
        ('StaticTransformBroadcaster(node).send_transform(1)', 'there is `sendTransform`'),
        ('StaticTransformBroadcaster(node).sendTransform(1, 2)', 'one transform, or a list'),
        ('Buffer(30.0)', 'write Duration(seconds=…)'),
        ("Buffer().lookup_transform_full('a', Time(), 'b', Time())", 'the source frame and its time'),
        ('node.get_clock().now() - Time(seconds=1)', 'Two times are of different clocks'),
        ('QoSProfile(durability=DurabilityPolicy.VOLATILE)', 'QoSProfile(depth=…, …)'),
        ('import threading\nwith threading.Lock:\n    pass', 'parentheses are missing'),
        ("node.get_name['a']", 'parentheses, not with brackets'),
        ("node.declare_parameter('a', ParameterDescriptor())", 'its default value, and then its descriptor'),
        ("node.declare_parameters('', [('a', 1.0, 'fast')])", 'and a ParameterDescriptor'),
        ("node.declare_parameter('a', 1.0); node.get_parameter('a').double_value", 'get_parameter(name).value'),
        ("{'node': 1}.node", "It is a dictionary: write …['node']."),
        ("offered = {'key': 1}\noffered.key", "It is a dictionary: write offered['key']."),
        (
            "offered = {'key': 1}\nfor key in offered: offered.key",
            "write offered[key], or offered['key'] for the entry",
        ),
        ('faults = {}\nfaults.append(1)', 'A dictionary has no `append`: write faults[name] = value.'),
        ("self = node\nself.seen = {}\nself.seen.add('x')", 'write self.seen[name] = value. (An empty list is []'),
        ('{}.sort()', 'A dictionary has no `sort`.'),
        ("{'add': 1}.add", "It is a dictionary: write …['add']."),
        ('TRANSIENT_LOCAL', 'Write: DurabilityPolicy.TRANSIENT_LOCAL'),
        ('import rclpy.node\nclass A(rclpy.node):\n    pass', 'The class is in it: from rclpy.node import Node'),
        ('from std_msgs import String', 'Messages are in std_msgs.msg'),
        ('from my_nodes import Talker', 'a file of your own beside it (my_nodes.py)'),
        ('node.get_clock().now().seconds', '.nanoseconds / 1e9 are seconds'),
        ('Duration(seconds=1).sec', '.nanoseconds / 1e9 are seconds'),
        ('node.get_clock().now().to_msg().nanoseconds', 'Time.from_msg(…)'),
        (
            "class Own(Node):\n    def __init__(self):\n        super.__init__('own')\n\nOwn()",
            'Parentheses are missing',
        ),
        ("class Own:\n    def __init__(self):\n        super().__init__('own')\n\nOwn()", 'class …(Node)?'),
        (
            'class Own(Node):\n    def __init__(self):\n        super().__init__(context=node.context)\n\nOwn()',
            'It takes the name of the node',
        ),
        (
            'class Own(Node):\n    def _init_(self):\n        pass\n\nOwn(0.5, context=node.context)',
            'Is `_init_` the constructor?',
        ),
        (
            'class Own(Node):\n    def __new__(cls, *given, **other):\n        return object.__new__(cls)\n\n'
            'Own(0.5, context=node.context)',
            'Is your constructor called __init__',
        ),
        ('QoSProfile(depth=1, durabilty=1)', 'QoSProfile has no argument `durabilty`; there is `durability`.'),
        ('QoSProfile(depth=1, size=1)', 'QoSProfile has no argument `size`: it has history, depth, '),
        ("node.get_logger.info('x')", 'Parentheses call it: node.get_logger().info(…)'),
        ('node.get_parameter.value', 'Parentheses call it: node.get_parameter(…).value'),
        ('Future().result.success', 'Parentheses call it, and what it returns has more'),
        (
            "node.create_publisher(String, 'a', 10).publish(data='alive')",
            'It takes one message, which is made with its',
        ),
        (
            "node.create_publisher(String, 'a', 10).publish(SetBool.Request())",
            'of the type String, and this is a SetBool_Request: make a String',
        ),
        (
            'from turtlesim.msg import Pose as Other\nfrom geometry_msgs.msg import Pose\n'
            "node.create_publisher(Pose, 'a', 10).publish(Other())",
            'Two types are called Pose: the publisher has that of geometry_msgs, and this one is of turtlesim.',
        ),
        ('0.5^2', 'a power is written with two stars'),
        ("node.declare_parameter('rate', 1.0); -node.get_parameter('rate')", 'get_parameter(name).value'),
        ('import os; os.environ["NOT_SET"]', "It is not set. os.environ.get('NOT_SET') gives None then, and no error."),
        ('print()()', 'What is called here is None. If it is a callback, give the function itself'),
        (
            'async def both():\n    await [Future(), Future()]\n\nboth().send(None)',
            '`await` takes one future. For many of them',
        ),
        ("node.create_publisher(String, 'a', 10)(String())", 'an object of the class Publisher'),
        ("ActionClient(Fibonacci, 'count')", 'It takes the node, the type and the name'),
        ('Fibonacci.Impl.FeedbackMessage().sequence', 'message.feedback.sequence'),
        ('Fibonacci.Impl.GetResultService.Response().sequence', 'future.result().result.sequence'),
        ('OccupancyGrid(data=[255])', 'does not fit into the field'),
        ('OccupancyGrid(data=[[1], [2]])', 'no other lists or texts in it'),
        ('count = 3; count()', 'leave out the parentheses'),
        ('range(2.0)', 'A whole number is wanted'),
        ('DurabilityPolicy.TRANSIENTLOCAL', 'DurabilityPolicy has `TRANSIENT_LOCAL`, and no `TRANSIENTLOCAL`'),
        ('DurabilityPolicy.LATCHED', 'DurabilityPolicy has BEST_AVAILABLE, SYSTEM_DEFAULT, TRANSIENT_LOCAL'),
        ("QoSProfile(depth=1, durability='transient_local')", 'durability=DurabilityPolicy.TRANSIENT_LOCAL'),
        ("node.get_parameter('rate')", 'A parameter is declared before anything reads it'),
        ("-node.declare_parameter('rate', 1.0).value; -node.get_parameter('rate')", 'get_parameter(name).value'),
        ("FloatingPointRange(from_value=0.0, to_value='speed')", 'in their order, as in bounded('),
        (
            'class Base(Node):\n    def __init__(self, **options):\n        pass\n\n\n'
            'class Courier(Base):\n    def __init__(self, **options):\n        super().__init__(self, **options)\n\n\n'
            'Courier()',
            '`self` goes along by itself',
        ),
        (
            "node.add_on_set_parameters_callback(lambda parameters: True); node.declare_parameter('rate', 1.0)",
            'returns SetParametersResult(successful=…), on every way',
        ),
    ],
)
def test_what_is_raised_is_explained(node, line, words):
    with pytest.raises(Exception) as raised:  # noqa: PT011 (which one it is, the line decides)
        exec(IMPORTS + line, {'node': node})
    said = explain(type(raised.value).__name__, str(raised.value), answer=line, lines=[line])
    assert words in said, repr(raised.value)


@pytest.mark.parametrize(
    ('text', 'callback', 'words'),
    [
        (
            "Talker.tick() missing 1 required positional argument: 'msg'",
            'timer of 0.5 s',
            'nothing: def on_timer(self)',
        ),
        ("<lambda>() missing 1 required positional argument: 'msg'", 'timer of 0.5 s', 'called with nothing'),
        ('Talker.on() takes 2 positional arguments but 3 were given', 'service /ask', 'the request and the response'),
        ("Talker.on() missing 1 required positional argument: 'x'", 'subscription of /a', 'called with the message'),
        ("Talker.on() missing 1 required positional argument: 'x'", '', 'give the function itself'),
    ],
)
def test_a_callback_with_other_parameters(text, callback, words):
    assert words in explain('TypeError', text, callback=callback)


@pytest.mark.parametrize(
    ('line', 'said'),
    [
        ("self.create_service(SetBool, 'set', self.on_set())", True),
        ("self.create_service(SetBool, 'set', callback=self.on_set())", True),
        ('self.on_set())', True),
        ('self.on_set()', False),  # no argument of a call
        ('answer = self.on_set()', False),
        ('self.publish(self.on_set(1))', False),  # it is called with something
    ],
)
def test_a_callback_that_wants_two_arguments_and_is_called(line, said):
    text = "Camera.on_set() missing 2 required positional arguments: 'request' and 'response'"
    hint = 'If it is a callback, give the function itself, without parentheses: self.on_set, not self.on_set().'
    assert explain('TypeError', text, lines=[line]) == (hint if said else '')


@pytest.mark.parametrize(
    ('outer', 'said'),
    [
        ('future.add_done_callback(self.publish(cloud, future.result()))', 'lambda future: self.publish(…)'),
        ('self.create_timer(0.5, self.publish(cloud))', 'lambda: self.publish(…)'),
        ("self.create_subscription(LaserScan, 'scan', self.publish(0), 10)", 'lambda …: self.publish(…)'),
        ('future.add_done_callback(lambda future: self.publish(cloud, future.result()))', ''),
        ("self.create_timer(self.value('period'), self.publish)", ''),
        ('self.create_timer(1 / self.rate(), self.publish)', ''),
    ],
)
def test_a_callback_that_is_called_where_it_is_given(outer, said):
    text = "'NoneType' object is not subscriptable"
    told = explain('TypeError', text, lines=[outer, 'cloud[0]'])
    assert told.startswith('`self.publish(…)` is called here at once') and told.endswith(said) if said else told == ''
    assert explain('TypeError', text, lines=[outer]) == '', 'the call itself may have come to its end'
    told = explain('TypeError', "'NoneType' object is not callable", lines=[outer])
    assert told.endswith(said) if said else told.startswith('What is called here is None.')


def test_a_name_for_a_base_that_is_no_node():
    text = 'StationKeeper.__init__() takes 1 positional argument but 2 were given'
    told = explain('TypeError', text, lines=["super().__init__('delivery_robot', **options)"])
    assert told == '`super()` is `StationKeeper` here, and not Node: its `__init__` takes no name, so leave it out.'
    for other in ("StationKeeper('delivery_robot')", 'super().__init__(rate)', 'super().__init__()'):
        assert explain('TypeError', text, lines=[other]) == ''


@pytest.mark.parametrize(
    ('line', 'said'),
    [
        ("self.get_logger.info('x')", '`get_logger` is a method. Parentheses call it: self.get_logger().info(…)'),
        ('print(future.result.info)', '`result` is a function. Parentheses call it: future.result().info'),
        ('steer.info', '`steer` is a function. Parentheses call it: steer(…).info'),
        # Which one it is, the line does not show.
        ('a.first.info, a.second.info', 'This is a function. Parentheses call it, and what it returns has more'),
        ('self.clients[0].call.info', 'This is a function. Parentheses call it, and what it returns has more'),
        ('', 'This is a function. Parentheses call it, and what it returns has more'),
    ],
)
def test_a_method_without_its_parentheses(line, said):
    assert explain('AttributeError', "'function' object has no attribute 'info'", lines=[line]).startswith(said)


def test_a_goal_is_asked_for_its_request():
    text = "'ServerGoalHandle' object has no attribute 'order'"
    assert 'goal.request.order' in explain('AttributeError', text)
    assert not explain('AttributeError', "'ServerGoalHandle' object has no attribute '_lock'")


@pytest.mark.parametrize(
    ('kind', 'text'),
    [
        ('ValueError', ''),
        ('AttributeError', 'x'),
        ('TypeError', "'<' not supported between instances of 'Time' and 'NoneType'"),
        ('AttributeError', "'dict_keys' object has no attribute 'sort'"),
        ('AttributeError', "type object 'Own' has no attribute 'LIMIT'"),
        ('TypeError', 'Own.__init__() takes 1 positional argument but 2 were given'),
        ('TypeError', "unsupported operand type(s) for -: 'str' and 'int'"),
        ('TypeError', "'list' object is not callable"),
        ('AttributeError', "'Futures' object has no attribute 'x'"),
        ('AssertionError', ''),
        ('ModuleNotFoundError', "No module named 'std_msgs.messages'"),
        ('TypeError', "ScanToMap.publish() missing 2 required positional arguments: 'cloud' and 'place'"),
        ('TypeError', "Node.get_parameter() missing 1 required positional argument: 'name'"),
        ('TypeError', "object int can't be used in 'await' expression"),
        ('TypeError', "unsupported operand type(s) for ^: 'str' and 'int'"),
        ('TypeError', "bad operand type for unary -: 'str'"),
        ('TypeError', "Own.publish() got an unexpected keyword argument 'data'"),
        ('KeyError', "'AMENT_PREFIX_PATH'"),
        ('AttributeError', "'super' object has no attribute 'on_timer'"),
    ],
)
def test_nothing_is_said_of_others(kind, text):
    assert explain(kind, text) == ''


def test_a_name_whose_cell_could_not_be_run():
    """Where that cell stands, what it uses is not there yet; this has happened in the notebook, too."""
    notes = ["cell 7: NameError: name 'QoSProfile' is not defined", "cell 8: NameError: name 'QOS' is not defined"]
    told = explain('NameError', "name 'QOS' is not defined", notes=notes)
    assert told == f'What may have made `QOS` was not loaded: {notes[0]}.'


@pytest.mark.parametrize(
    ('kind', 'text', 'said'),
    [
        (
            'AttributeError',
            "'ServerGoalHandle' object has no attribute 'cancelled'",
            'goal.canceled() and goal.abort()',
        ),
        ('SyntaxError', 'asynchronous comprehension outside of an asynchronous function', 'begins with `async def`'),
        ('SyntaxError', "'await' outside async function", 'begins with `async def`'),
    ],
)
def test_what_needs_an_action_or_a_whole_cell_to_be_raised(kind, text, said):
    assert said in explain(kind, text)
