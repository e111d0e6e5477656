"""What an exception of the learner's code means, in a sentence more than Python's own."""

import re
from collections.abc import Mapping, Sequence

from helpers.runner import imports, ros_members, slips, slips_in_lines
from helpers.runner.exception_sentences import SENTENCES

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
    'TransformBroadcaster.__init__': 'the node: TransformBroadcaster(self)',
    'StaticTransformBroadcaster.__init__': 'the node: StaticTransformBroadcaster(self)',
    'lookup_transform_full': 'the target frame and its time, the source frame and its time, and the frame that is '
    'fixed meanwhile',
    'TransformListener.__init__': 'a buffer and the node: TransformListener(self.buffer, self)',
    'lookup_transform': "the target frame, the source frame and the time: lookup_transform('map', 'base_link', Time())",
    'publish': 'the message: publish(message)',
    'send_goal_async': 'the goal: send_goal_async(goal)',
    'call_async': 'the request: call_async(request)',
    'create_timer': 'the period in seconds and the callback: create_timer(0.5, self.on_timer)',
}
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


def explain(
    kind: str,
    text: str,
    early: str = '',
    absent: Mapping[str, str] | None = None,
    callback: str = '',
    notes: Sequence[str] = (),
    answer: str = '',
    lines: Sequence[str] = (),
    cells: Sequence[str] = (),
) -> str:
    """A sentence on an exception of the type `kind` with this text; '' if there is nothing to add.

    `early`: where the program read the result of a future that had none yet. `absent`: by name, why a name
    is not there that some cell binds. `callback`: of what it is the callback, if rclpy has called it and it has begun
    with no line of its own, such as `timer of 0.5 s`. `notes`: what happened in cells with the missing name that
    could not be run. `answer`: the text of the exercise's cell. `lines`: the learner's lines that have
    raised it, as far as they are known, the innermost one last. `cells`: the texts of the other cells.
    """
    line = lines[-1] if lines else ''
    if said := (
        _on_names(kind, text, answer, line, cells)
        or _on_node(kind, text, answer)
        or _on_arguments(kind, text, callback, line)
        or slips_in_lines.explain(kind, text, lines, answer)
    ):
        return said
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
            or ros_members.enumeration_of(name)
            or (f'What may have made `{name}` was not loaded: {notes[0]}.' if notes else '')
            or f'No cell that the check uses defines `{name}`. {_meant(name, answer)}'
        )
    for known, pattern, sentence in SENTENCES:
        if kind == known and (found := re.match(pattern, text)):
            return sentence.format(*found.groups())
    return _on_ros(kind, text, answer, line)


def _on_node(kind: str, text: str, answer: str) -> str:
    """A sentence on a name that rclpy's Node keeps for itself; '' if it is none."""
    if kind != 'AttributeError':
        return ''
    if found := re.search(r"property '(\w+)' of (?:.* has no setter|Node)|can't set attribute '?(\w+)?", text):
        name = found[1] or found[2] or ''
        if not name or name in _RESERVED:
            return (
                f"rclpy's Node uses {f'the name `{name}`' if name else 'this name'} itself (as it does "
                f'{", ".join(_RESERVED[:6])}): choose another one, such as `self.my_{name or "timers"}`.'
            )
    if found := re.match(r'(\w+) cannot be modified after node creation', text):
        return f"rclpy's Node uses the name `{found[1]}` itself: choose another one, such as `self.my_{found[1]}`."
    if found := re.match(r"'\w+' object has no attribute '(_\w+)'", text):
        name = found[1]
        if name in _PRIVATE or name.startswith('_Node__'):
            return (
                f"rclpy's Node is not made yet. `{slips.super_call(answer)}` must come before everything else in "
                '`__init__`.'
            )
    return ''


def _on_arguments(kind: str, text: str, callback: str, line: str) -> str:
    """A sentence on arguments that a callback or a method of ROS gets or lacks; '' if it is about others."""
    if kind != 'TypeError':
        return ''
    if callback and re.search(r'\(\) (?:takes|missing) \d+ (?:required )?positional', text):
        for whose, arguments in _CALLED_WITH.items():
            if callback.startswith(whose):
                return f'It is called with {arguments}.'
    if '__init__() takes' in text and re.search(r'super\(\)\.__init__\(\s*self\b', line):
        return '`self` goes along by itself: leave it out behind super().__init__.'
    if found := re.match(r'(?:(\w+)\.)?(\w+)\(\) missing (\d+)( required positional)?', text):
        if found[1] == 'CallbackGroup':
            return 'A class is given where a group is wanted. A group is made: MutuallyExclusiveCallbackGroup().'
        wanted = _ARGUMENTS.get(f'{found[1]}.{found[2]}', _ARGUMENTS.get(found[2], ''))
        if found[1] in _CLASSES or found[1] is None:
            return f'It takes {wanted}.' if wanted else ''
        if found[4] and not found[2].startswith('__'):
            return slips_in_lines.without_arguments(found[2], int(found[3]), line)
    return ''


def _meant(name: str, answer: str) -> str:
    if near := slips.near_name(name, answer) or imports.nearest(name):
        return f'Is `{near}` meant?'
    lost = 'is a cell gone that came with the chapter? A fresh copy of the notebook has all of them.'
    return f'Is it a typing error, or {lost}'


def _on_ros(kind: str, text: str, answer: str, line: str) -> str:
    """A sentence on what a class of ROS lacks or wants; '' if there is none."""
    if kind == 'AttributeError' and (found := re.match(r"'(\w+)' object has no attribute '(\w+)'", text)):
        return ros_members.attribute(found[1], found[2])
    if kind == 'AttributeError' and (found := re.match(r"(?:type object '(\w+)' has no attribute ')?(\w+)'?$", text)):
        return ros_members.member(found[2], answer, found[1] or '')
    if kind == 'TypeError' and (found := re.match(r'(\w+)\.__init__\(\) takes 1 positional argument but', text)):
        return ros_members.named_values(found[1])
    if kind == 'TypeError' and (found := re.match(r".*'(\w+)' and '(\w+)'", text)):
        # Time and Duration are also classes of rclpy, which can be compared.
        if any(one not in ('Time', 'Duration') and ros_members.is_message(one) for one in found.groups()):
            return 'A message stands where a value is wanted: take one of its fields.'
    if kind == 'AssertionError' and (found := re.match(r'Invalid .* constructor: dict_keys\(\[(.*)\]\)', text)):
        return ros_members.argument('QoSProfile', re.findall(r"'(\w+)'", found[1]))
    if kind == 'AssertionError' and not text and 'QoSProfile(' in line:
        return 'The parts of a QoSProfile have types of their own, such as durability=DurabilityPolicy.TRANSIENT_LOCAL.'
    return ''


def _on_names(kind: str, text: str, answer: str, line: str, cells: Sequence[str]) -> str:
    """A sentence on a name that the answer or a module lacks, or has by a slip; '' if there is none."""
    if kind in ('NameError', 'UnboundLocalError') and (found := re.match(r"(?:name|.*local variable) '(\w+)'", text)):
        meant = slips.class_meant(found[1], answer) if kind == 'NameError' else ''
        return meant or slips.missing_self(found[1], answer, line)
    if kind == 'AttributeError' and (found := re.match(r"'(\w+)' object has no attribute '(\w+)'", text)):
        if found[1] == 'super':
            return slips.constructor_meant(found[2])
        if found[2][0] != '_' and re.search(rf'^class {found[1]}\b', answer, re.MULTILINE):
            return slips.unset_attribute(found[2], answer, found[1], cells)
    if kind == 'AttributeError' and (found := re.match(r"module '([\w.]+)' has no attribute '(\w+)'", text)):
        if meant := slips.class_meant(found[1], answer):
            return meant
        return f'It is elsewhere. Write: {there[0]}' if (there := imports.lines_for(found[2])) else ''
    if kind == 'TypeError' and re.match(r'Node\.__init__\(\) |__init__\(\): incompatible constructor arguments', text):
        return slips.misspelt_constructor(answer)
    return ''
