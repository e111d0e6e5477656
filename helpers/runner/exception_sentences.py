"""Sentences on exceptions, each known by its type and its text."""

_OF_SERVICES = 'Trigger|SetBool|AddTwoInts|SetStation|Spawn|Kill|TeleportAbsolute|SetPen'
_OF_ACTIONS = 'Fibonacci|DriveTo|GoToStation|RotateAbsolute'
_NUMBER = 'A number of seconds is no duration: write Duration(seconds=…), or compare with .nanoseconds / 1e9.'
_CALLED = 'A function is called with parentheses, not with brackets.'
_VALUE = 'A parameter of a node is not its value: get_parameter(name).value.'
_WITH = (
    'What stands behind `with` cannot stand there. If it is rclpy.init(): that works from the distribution after Jazzy '
    'on. Here write rclpy.init() in a line of its own, and rclpy.try_shutdown() at the end.'
)
# (type of the exception, what its text is, the sentence): {0} is the first group of the pattern.
SENTENCES = (
    (
        'AssertionError',
        r"The '(?:from|to)_value' field must be of type 'float'",
        'A bound is a float: write 2.0 instead of 2. If it is a text: are the arguments in their order, as in '
        'bounded(description, low, high)?',
    ),
    (
        'AssertionError',
        r".*must be of type 'float'",
        'A float field takes no int: write 2.0 instead of 2, or float(…) around the value.',
    ),
    (
        'AssertionError',
        r".*must be of type 'bool'",
        'Write bool(…) around the value; of a message take the field that holds it.',
    ),
    (
        'AssertionError',
        r".*must be of type 'int'",
        'A whole number is wanted: int(…) makes one of a float, and len(…) counts a list or a text; of a message take '
        'the field that holds it.',
    ),
    (
        'AssertionError',
        r".*must be of type 'str'",
        'A text is wanted. Of a number make one with str(…) or an f-string; of a message take the field that holds '
        'it. None is no text: did a function end without `return`?',
    ),
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
        r'Invalid arguments passed to constructor: (?!dict_keys\()(\w+)',
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
        r"'ClientGoalHandle' object has no attribute '\w*cancel\w*'",
        'A client asks for the end of its goal with cancel_goal_async().',
    ),
    (
        'AttributeError',
        r"'ClientGoalHandle' object has no attribute '\w*result\w*'",
        'A client asks for the result of its goal with get_result_async().',
    ),
    (
        'AttributeError',
        r"'(?:builtin_function_or_|)(?:function|method)' object has no attribute",
        'This is a function. Parentheses call it, and what it returns has more: future.result().…',
    ),
    (
        'AttributeError',
        r"'(?:property|getset_descriptor|member_descriptor)' object has no attribute",
        'A class stands where an object of it is wanted: parentheses are missing, as in Twist().',
    ),
    (
        'AttributeError',
        r"'xml\.etree\.ElementTree\.Element' object has no attribute '(\w+)'",
        "What stands in the tag of an element is read with get('{0}'), what stands in the element with .text.",
    ),
    (
        'AttributeError',
        r"'tuple' object has no attribute",
        'The parts of a plain tuple have numbers, [0], [1] …, and no names.',
    ),
    (
        'AttributeError',
        r".* object has no attribute 'add_entity'",
        'A callback group is an object, such as MutuallyExclusiveCallbackGroup().',
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
    ('AttributeError', r"'Parameter' object has no attribute '\w*value\w*'", _VALUE),
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
        r'.*invalid transition from state (?:EXECUTING|CANCELING) with event EXECUTE',
        'This goal runs already: execute() is called once for each goal.',
    ),
    (
        'RCLError',
        r'.*invalid transition from state (?:SUCCEEDED|ABORTED|CANCELED) with event EXECUTE',
        'The goal has ended already: execute() is called once for each goal, before its end. If you give it '
        'a callback, write its name without parentheses: rclpy calls it.',
    ),
    (
        'RCLError',
        r'.*invalid transition from state (?:SUCCEEDED|ABORTED|CANCELED) with event (?!EXECUTE)',
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
        r"Expected <class '(\w+)\.[\w.]+\.(\w+)'>, got <class '(?!\1\b)(\w+)\.[\w.]+\.\2'>",
        'Two types are called {1}: the publisher has that of {0}, and this one is of {2}.',
    ),
    (
        'TypeError',
        r"Expected <class '[\w.]+\.(\w+)'>, got <class '[\w.]+\.(\w+)'>",
        'The messages of this publisher are of the type {0}, and this is a {1}: make a {0}, and put into its fields '
        'what is wanted.',
    ),
    (
        'TypeError',
        r"Publisher\.publish\(\) got an unexpected keyword argument '(\w+)'",
        'It takes one message, which is made with its fields before: publish(…({0}=…)), with the type of the message '
        'in front of the inner parentheses.',
    ),
    (
        'TypeError',
        r"(?:object (?:list|tuple|generator)|.*'(?:list|tuple|generator)' object) can't be (?:used in 'await'|awaited)",
        '`await` takes one future. For many of them: [await future for future in futures].',
    ),
    (
        'TypeError',
        r"unsupported operand type\(s\) for \^=?: '(?:int|float)' and '(?:int|float)'",
        'In Python a power is written with two stars: width ** 2.',
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
    ('TypeError', r"'(?:bool|int|float)' object is not iterable", 'A list, or something else with parts, is wanted.'),
    (
        'TypeError',
        r".* not 'xml\.etree\.ElementTree\.Element'",
        "This is a whole element. Of it take a value: get('value'), or .text.",
    ),
    (
        'TypeError',
        r"'(?:bool|int|float|str)' object is not callable",
        'This is a value and no function: leave out the parentheses.',
    ),
    (
        'TypeError',
        r"'NoneType' object is not callable",
        'What is called here is None. If it is a callback, give the function itself, without parentheses: '
        'self.on_timer, not self.on_timer().',
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
    ('TypeError', r".*(?:not '?Parameter'?$|: 'Parameter'$|'Parameter' and '| and 'Parameter')", _VALUE),
    (
        'TypeError',
        r"Can't (?:subtract|compare) times with different clock types",
        'Two times are of different clocks. Time.from_msg(stamp) is of the clock of ROS, as is get_clock().now() of a '
        'node; Time(seconds=…) is not.',
    ),
    (
        'TypeError',
        r'time must have sec and nanosec, or nanoseconds',
        'A number of seconds is no duration: write Duration(seconds=…).',
    ),
    (
        'TypeError',
        r".*'array\.array' and '(?:int|float)'",
        'Such a field holds many numbers, not one. Look at each of them, in a loop or with any(… for … in …).',
    ),
    (
        'TypeError',
        r".*'(?:property|type|Metaclass_\w+|getset_descriptor|member_descriptor)'",
        'A class is given where an object of it is wanted.',
    ),
    (
        'TypeError',
        r"'(?:builtin_function_or_method|function|type|method)' object does not support the context manager",
        'Behind `with` stands a function or a class, which has not been called: parentheses are missing.',
    ),
    ('TypeError', r"'(?:builtin_function_or_|)(?:function|method)' object is not subscriptable", _CALLED),
    (
        'TypeError',
        r'\w*TransformBroadcaster\.sendTransform\(\) takes 2 positional arguments',
        'It takes one transform, or a list of transforms.',
    ),
    (
        'TypeError',
        r"The given value is not one of the allowed types '\w*\.?\w*\.?ParameterDescriptor",
        'A parameter is declared with its name, its default value, and then its descriptor.',
    ),
    (
        'TypeError',
        r'Third element .* is not a ParameterDescriptor',
        'A parameter is declared with its name, its default value, and a ParameterDescriptor, which holds the '
        'description.',
    ),
    ('InvalidQoSProfileException', '.*depth settings are required', 'A queue has a depth: QoSProfile(depth=…, …).'),
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
        'ParameterNotDeclaredException',
        '',
        'A parameter is declared before anything reads it. Is a callback called here that should only be named?',
    ),
)
