"""What an exception of the learner's code means, in a sentence more than Python's own."""

import re
from collections.abc import Mapping, Sequence

from helpers.runner import imports, slips

# Properties of rclpy's Node that have no setter.
_RESERVED = (
    'clients',
    'guards',
    'publishers',
    'services',
    'subscriptions',
    'timers',
    'waitables',
    'context',
    'handle',
    'default_callback_group',
)
# What rclpy's Node keeps for itself; nobody has it before `super().__init__`.
_PRIVATE = (
    '_clients',
    '_clock',
    '_context',
    '_default_callback_group',
    '_guards',
    '_logger',
    '_parameter_overrides',
    '_parameters',
    '_publishers',
    '_services',
    '_subscriptions',
    '_timers',
)
_ARGUMENTS = {
    'create_publisher': 'the type, the name, and the queue depth or a QoS profile: create_publisher(String, …, 10)',
    'create_subscription': 'the type, the name, the callback, and the queue depth or a QoS profile: '
    'create_subscription(String, …, self.on_message, 10)',
    'create_service': 'the type, the name and the callback: create_service(Trigger, …, self.on_request)',
    'create_client': 'the type and the name: create_client(Trigger, …)',
    'Node.__init__': "the name of the node: super().__init__('name')",
    'ActionClient.__init__': 'the node, the type and the name: ActionClient(self, Fibonacci, …)',
    'ActionServer.__init__': 'the node, the type, the name and the execute callback: '
    'ActionServer(self, Fibonacci, …, self.execute)',
    'TransformListener.__init__': 'a buffer and the node: TransformListener(self.buffer, self)',
    'lookup_transform': "the target frame, the source frame and the time: lookup_transform('map', 'base_link', Time())",
    'publish': 'the message: publish(message)',
    'send_goal_async': 'the goal: send_goal_async(goal)',
    'call_async': 'the request: call_async(request)',
    'create_timer': 'the period in seconds and the callback: create_timer(0.5, self.on_timer)',
}
# Whose values have names: messages, and parts of rclpy. A class of the learner's own is another matter.
_OF_ROS = (
    r'String|Bool|U?Int\d+|Float\d+|Header|Twist|Vector3|Point|Pose|Quaternion|Transform|(?:Twist|Point|Pose|Transform)Stamped'
    r'|LaserScan|BatteryState|Duration|QoSProfile'
)
_OF_SERVICES = 'Trigger|SetBool|AddTwoInts|SetStation|Spawn|Kill|TeleportAbsolute|SetPen'
_OF_ACTIONS = 'Fibonacci|DriveTo|GoToStation|RotateAbsolute'
# Classes of ROS, whose methods are no callbacks of the learner's.
_CLASSES = frozenset(
    'Node LifecycleNode Publisher Subscription Client Service Timer Clock Time Duration Future Executor Buffer '
    'BufferCore BufferInterface TransformListener TransformBroadcaster StaticTransformBroadcaster ActionClient '
    'ActionServer ClientGoalHandle ServerGoalHandle Parameter QoSProfile'.split()
)
# What the callback of what gets.
_CALLED_WITH = {
    'timer': 'nothing: def on_timer(self)',
    'service': 'the request and the response: def on_request(self, request, response)',
    'subscription': 'the message: def on_message(self, message)',
}
_NUMBER = 'A number of seconds is no duration: write Duration(seconds=…), or compare with .nanoseconds / 1e9.'
_WITH = (
    'What stands behind `with` cannot stand there. If it is rclpy.init(): that works from the distribution after Jazzy '
    'on. Here write rclpy.init() in a line of its own, and rclpy.try_shutdown() at the end.'
)
# (type of the exception, what its text is, the sentence): {0} is the first group of the pattern.
_SENTENCES = (
    (
        'AssertionError',
        r".*must be of type 'float'",
        'A float field takes no int: write 2.0 instead of 2, or float(…) around the value.',
    ),
    ('AssertionError', r".*must be of type '(int|bool)'", 'Write {0}(…) around the value.'),
    ('AssertionError', r".*must be of type 'str'", 'Write str(…) around it, or an f-string.'),
    (
        'AssertionError',
        r".*must be a sub message of type '(?:Time|Duration)'",
        'A time or a duration of rclpy becomes this message with .to_msg().',
    ),
    (
        'AssertionError',
        r".*must be a sub message of type '(\w+)'",
        'This field is a message itself, a {0}: set its fields one by one.',
    ),
    (
        'AssertionError',
        r'Invalid arguments passed to constructor: (\w+)',
        'The message has no field `{0}`: `ros2 interface show` prints the fields that it has.',
    ),
    (
        'AttributeError',
        r"'ServerGoalHandle' object has no attribute '(?:cancell?e?d?|succee?ded|success|aborted|finish(?:ed)?)'",
        'A goal is ended by one of goal.succeed(), goal.canceled() and goal.abort().',
    ),
    (
        'NotImplementedError',
        r'(Service|Action) classes can not be instantiated',
        'As a type it stands without parentheses. The messages of a service are made by ….Request() and ….Response(), '
        'those of an action by ….Goal(), ….Feedback() and ….Result().',
    ),
    (
        'RuntimeError',
        r"The (service|action) type provided is not valid \(<class '[\w.]+\.(\w+)_(?:Request|Response|Goal|Result)'>",
        'The type of the {0} is {1} itself, without a part of it.',
    ),
    (
        'SyntaxError',
        r"(?:asynchronous comprehension|'await'|'async \w+') outside",
        '`await` may stand in a function only that begins with `async def`.',
    ),
    (
        'AttributeError',
        r"'ServerGoalHandle' object has no attribute '([a-z]\w*)'",
        'What the client asked for is in the request of the goal: goal.request.{0}.',
    ),
    (
        'AttributeError',
        r"type object '\w+' has no attribute '_TYPE_SUPPORT'",
        'A type is the class itself, without quotes, such as String from std_msgs.msg.',
    ),
    (
        'AttributeError',
        r"'(?:Duration|Time)' object has no attribute '(?:nano)?sec'",
        'A time or a duration of rclpy tells its nanoseconds; .nanoseconds / 1e9 are seconds.',
    ),
    (
        'AttributeError',
        r"'(?:Duration|Time)' object has no attribute '(?:secs|seconds|total_seconds|to_sec)'",
        'A stamp, which is a message, has sec and nanosec. A time or a duration of rclpy tells its nanoseconds; '
        '.nanoseconds / 1e9 are seconds.',
    ),
    (
        'AttributeError',
        r"'(Duration|Time)' object has no attribute 'nanoseconds'",
        'This is a message: {0}.from_msg(…) makes a {0} of rclpy of it.',
    ),
    (
        'AttributeError',
        r"'\w+_FeedbackMessage' object has no attribute '([a-z]\w*)'",
        'The feedback stands in this message: message.feedback.{0}.',
    ),
    (
        'AttributeError',
        r"'\w+_GetResult_Response' object has no attribute '([a-z]\w*)'",
        "This answer has a status and the action's result: future.result().result.{0}.",
    ),
    (
        'AttributeError',
        r"'Future' object has no attribute '[a-z]",
        'A future is not the answer. When it is done, future.result() gives the answer, and so does `await future`.',
    ),
    (
        'ImportError',
        r"cannot import name '\w+' from '(\w+_(?:msgs|interfaces|srvs)|turtlesim)' ",
        'Messages are in {0}.msg, services in {0}.srv, and actions in {0}.action.',
    ),
    (
        'ModuleNotFoundError',
        r"No module named '([A-Za-z]\w*)'$",
        'Only the cells of the notebook count: a file of your own beside it ({0}.py), and a package that you have '
        'installed, is not there when the exercise is judged. Write what you need of it into the cell.',
    ),
    (
        'OverflowError',
        r'(?:un)?signed \w+ is (?:greater|less) than',
        'A number does not fit into the field: `ros2 interface show` tells its type.',
    ),
    (
        'RCLError',
        r'.*invalid transition from state EXECUTING with event CANCELED',
        'Only a goal that a client has asked to cancel can end as canceled: look at goal.is_cancel_requested.',
    ),
    (
        'RCLError',
        r'.*invalid transition from state (?:SUCCEEDED|ABORTED|CANCELED) with event',
        'The goal has ended already, and a goal ends once.',
    ),
    (
        'RCLError',
        r'.*invalid transition from state ACCEPTED with event (?:SUCCEED|ABORT)',
        'The goal is not executed yet. goal.execute() begins it, and then rclpy calls the execute callback.',
    ),
    (
        'RuntimeError',
        r'Subscription\.__init__\(\): callback should be',
        'It is called with the message. The first parameter of a method is `self`, before the message.',
    ),
    (
        'RuntimeError',
        r"(?:no running event loop|await wasn't used with future)$",
        "rclpy's `await` is not asyncio: no event loop runs. Use futures, timers and callbacks of rclpy instead of "
        'functions of asyncio.',
    ),
    (
        'TypeError',
        r'$',
        "So rclpy says that it wants an object of another type: publish_feedback takes the action's Feedback, "
        "send_goal_async its Goal, and call_async the service's Request; a service callback returns the response.",
    ),
    (
        'TypeError',
        r'(\w+)_(Request|Response|Goal|Feedback|Result)\.__init__\(\) takes 1 positional argument but',
        'Its values are given by their names: {0}.{1}(…=…).',
    ),
    (
        'TypeError',
        rf'({_OF_ROS})\.__init__\(\) takes 1 positional argument but',
        'Its values are given by their names: {0}(…=…).',
    ),
    (
        'TypeError',
        rf"({_OF_SERVICES})\.__init__\(\) got an unexpected keyword argument '\w+'",
        'This is the type of the service. A message for it is made by {0}.Request(…) or {0}.Response(…).',
    ),
    (
        'TypeError',
        rf"({_OF_ACTIONS})\.__init__\(\) got an unexpected keyword argument '\w+'",
        'This is the type of the action. A message for it is made by {0}.Goal(…), {0}.Feedback(…) or {0}.Result(…).',
    ),
    (
        'TypeError',
        r'(?:\w+\.)?(?!__)\w+\(\) takes (?:0 positional arguments but 1|1 positional argument but 2) w',
        'It is called with one argument more than it has parameters. Is `self` missing, which comes first in a method, '
        'or the parameter for what it is given?',
    ),
    (
        'TypeError',
        r'Publisher\.publish\(\) takes 2 positional arguments',
        'It takes one message, whose fields are set before.',
    ),
    (
        'TypeError',
        r"Expected <class '[\w.]+\.(\w+)'>, got <class '(?:str|bool|int|float|tuple|list|dict)'>",
        'What is published is a message. Put the value into a field of it: {0}(…=…).',
    ),
    (
        'TypeError',
        r"Expected <class '[\w.]+\.(\w+)'>, got <class '[\w.]+\.Metaclass_\w+'>",
        'A class is given where a message is wanted. A message is made: {0}().',
    ),
    (
        'TypeError',
        r'module\(\) takes at most 2 arguments',
        'A module is given as the base of a class. The class is in it: from rclpy.node import Node, class …(Node).',
    ),
    (
        'TypeError',
        r"Expected <class '[\w.]+\.(\w+)'>, got <class 'NoneType'>",
        'There is nothing to publish yet (None), where a {0} is wanted.',
    ),
    (
        'TypeError',
        r"descriptor '__init__' requires a 'super' object",
        "Parentheses are missing: super().__init__('name').",
    ),
    (
        'TypeError',
        r'object\.__init__\(\) takes exactly one argument',
        'The class has no base that takes an argument. Should it be a node: class …(Node)?',
    ),
    (
        'TypeError',
        r'__init__\(\): incompatible constructor arguments(?s:.*)_rclpy_pybind11\.Node\(',
        'The first argument of Node is the name of the node, a string. Is your constructor called __init__, with two '
        "underscores on each side, and does it begin with super().__init__('name')?",
    ),
    ('TypeError', r"'NoneType' object does not support the context manager protocol", _WITH),
    ('AttributeError', r'__enter__$', _WITH),  # the same in Python 3.10
    ('TypeError', r"'float' object cannot be interpreted as an integer", 'A whole number is wanted: int(…), or //.'),
    (
        'TypeError',
        r"'(?:list|tuple|str)' object cannot be interpreted as an integer",
        'A whole number is wanted. Where it is to be one of a list, the list has no other lists or texts in it.',
    ),
    (
        'TypeError',
        r"'(?:bool|int|float|str)' object is not callable",
        'This is a value and no function: leave out the parentheses.',
    ),
    (
        'TypeError',
        r"'([A-Z]\w*)' object is not callable",
        'Before the parentheses stands an object of the class {0}, and neither a class nor a function.',
    ),
    (
        'TypeError',
        r"unsupported operand type\(s\) for \S+ 'Time' and 'Time'",
        'One of the two is a stamp, which is a message: Time.from_msg(stamp) makes a time of rclpy of it.',
    ),
    (
        'TypeError',
        r".*(?:not '?Parameter'?$|'Parameter' and '| and 'Parameter')",
        'A parameter of a node is not its value: get_parameter(name).value.',
    ),
    ('TypeError', r".*'(?:Time|Duration)' and '(?:int|float)'", _NUMBER),
    ('TypeError', r".*'(?:int|float)' and '(?:Time|Duration)'", _NUMBER),
    (
        'ValueError',
        r"topic name '.*' is invalid: unknown substitution: \{(\w+)\}",
        "Is an f missing before the string? f'{{{0}}}/…' puts the value of {0} into it.",
    ),
    (
        'InvalidParameterValueException',
        r'.*Callback returned an invalid type',
        'A callback that checks parameters returns SetParametersResult(successful=…), on every way.',
    ),
    (
        'AttributeError',
        rf"'(?:\w+_(?:Request|Response|Goal|Result|Feedback)|{_OF_ROS})' object has no attribute '(\w+)'",
        'The message has no field `{0}`: `ros2 interface show` prints the fields that it has.',
    ),
    (
        'ParameterNotDeclaredException',
        '',
        'A parameter is declared before anything reads it. Is a callback called here that should only be named?',
    ),
)


def explain(
    kind: str,
    text: str,
    early: str = '',
    absent: Mapping[str, str] | None = None,
    callback: str = '',
    notes: Sequence[str] = (),
    answer: str = '',
) -> str:
    """A sentence on an exception of the type `kind` with this text; '' if there is nothing to add.

    `early`: where the program read the result of a future that had none yet. `absent`: by name, why a name
    is not there that some cell binds. `callback`: of what it is the callback, if rclpy has called it and it has begun
    with no line of its own, such as `timer of 0.5 s`. `notes`: what happened in cells with the missing name that
    could not be run. `answer`: the text of the exercise's cell.
    """
    if said := _on_names(kind, text, answer):
        return said
    if kind == 'AttributeError' and (
        found := re.search(r"property '(\w+)' of (?:.* has no setter|Node)|can't set attribute '?(\w+)?", text)
    ):
        name = found[1] or found[2] or ''
        if not name or name in _RESERVED:
            return (
                f"rclpy's Node uses {f'the name `{name}`' if name else 'this name'} itself (as it does "
                f'{", ".join(_RESERVED[:6])}): choose another one, such as `self.my_{name or "timers"}`.'
            )
    if kind == 'AttributeError' and (found := re.match(r'(\w+) cannot be modified after node creation', text)):
        return f"rclpy's Node uses the name `{found[1]}` itself: choose another one, such as `self.my_{found[1]}`."
    if kind == 'AttributeError' and (found := re.match(r"'\w+' object has no attribute '(_\w+)'", text)):
        name = found[1]
        if name in _PRIVATE or name.startswith('_Node__'):
            return (
                "rclpy's Node is not made yet. `super().__init__('name')` must come before everything else in "
                '`__init__`.'
            )
    if kind == 'TypeError' and callback and re.search(r'\(\) (?:takes|missing) \d+ (?:required )?positional', text):
        for whose, arguments in _CALLED_WITH.items():
            if callback.startswith(whose):
                return f'It is called with {arguments}.'
    if kind == 'TypeError' and (found := re.match(r'(?:(\w+)\.)?(\w+)\(\) missing \d', text)):
        if found[1] == 'CallbackGroup':
            return 'A class is given where a group is wanted. A group is made: MutuallyExclusiveCallbackGroup().'
        wanted = _ARGUMENTS.get(f'{found[1]}.{found[2]}', _ARGUMENTS.get(found[2], ''))
        if found[1] in _CLASSES or found[1] is None and wanted:
            return f'It takes {wanted}.' if wanted else ''
    if kind == 'TypeError' and (found := re.match(r'\w+\.(?!__)(\w+)\(\) missing 1 required positional', text)):
        name = found[1]
        return (
            f'If it is a callback, give the function itself, without parentheses: self.{name}, not self.{name}(). If '
            'that is so, it has more parameters than it is called with.'
        )
    if kind == 'AttributeError' and text.startswith("'NoneType' object") and early:
        return (
            f'`result()` was asked {early}, before the answer had come, and gave None. Go on in a done-callback, '
            'or after `await future`.'
        )
    if kind == 'NameError' and (found := re.match(r"name '(\w+)' is not defined", text)):
        name = found[1]
        return (absent or {}).get(name) or (
            'The first argument of a method is `self`.'
            if name == 'self'
            else imports.advice(name)
            or (f'What may have made `{name}` was not loaded: {notes[0]}.' if notes else '')
            or f'No cell that the check uses defines `{name}`. Is it a typing error, or is a cell gone that came '
            'with the chapter? A fresh copy of the notebook has all of them.'
        )
    for known, pattern, sentence in _SENTENCES:
        if kind == known and (found := re.match(pattern, text)):
            return sentence.format(*found.groups())
    return ''


def _on_names(kind: str, text: str, answer: str) -> str:
    """A sentence on a name that the answer or a module lacks, or has by a slip; '' if there is none."""
    if kind in ('NameError', 'UnboundLocalError') and (found := re.match(r"(?:name|.*local variable) '(\w+)'", text)):
        return slips.missing_self(found[1], answer)
    if kind == 'AttributeError' and (found := re.match(r"'(\w+)' object has no attribute '([A-Za-z]\w*)'", text)):
        if re.search(rf'^class {found[1]}\b', answer, re.MULTILINE):
            return slips.unset_attribute(found[2], answer)
    if kind == 'AttributeError' and (found := re.match(r"module '([\w.]+)' has no attribute '(\w+)'", text)):
        return f'It is elsewhere. Write: {lines[0]}' if (lines := imports.lines_for(found[2])) else ''
    if kind == 'TypeError' and text.startswith('Node.__init__() missing'):
        return slips.misspelt_constructor(answer)
    return ''
