"""What an exception of the learner's code means, in a sentence more than Python's own. Pure functions."""

import re
from collections.abc import Mapping

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
    'create_timer': 'the period in seconds and the callback: create_timer(0.5, self.on_timer)',
}


def explain(kind: str, text: str, early: str = '', elsewhere: Mapping[str, str] | None = None) -> str:
    """A sentence on an exception of the type `kind` with this text; '' if there is nothing to add.

    `early`: where the program read the result of a future that had none yet. `elsewhere`: by name, the cell of the
    notebook that defines it and that has not been run.
    """
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
    if kind == 'TypeError' and (found := re.match(r'(?:\w+\.)?(create_\w+)\(\) missing \d', text)):
        wanted = _ARGUMENTS.get(found[1])
        return f'It takes {wanted}.' if wanted else ''
    if kind == 'TypeError' and (found := re.match(r'\w+\.(?!__)(\w+)\(\) missing 1 required positional', text)):
        name = found[1]
        return f'If it is a callback, give the function itself, without parentheses: self.{name}, not self.{name}().'
    if kind == 'AssertionError' and (found := re.search(r"must be of type '(int|bool|str)'", text)):
        return (
            f'Write {found[1]}(…) around the value.' if found[1] != 'str' else 'Write str(…) around it, or an f-string.'
        )
    if kind == 'AssertionError' and "must be of type 'float'" in text:
        return 'A float field takes no int: write 2.0 instead of 2, or float(…) around the value.'
    if kind == 'AttributeError' and text.startswith("'NoneType' object") and early:
        return (
            f'`result()` was asked {early}, before the answer had come, and gave None. Go on in a done-callback, '
            'or after `await future`.'
        )
    if kind == 'RuntimeError' and text in ('no running event loop', "await wasn't used with future"):
        return (
            "rclpy's `await` is not asyncio: no event loop runs. Use futures, timers and callbacks of rclpy "
            'instead of functions of asyncio.'
        )
    if kind == 'NameError' and (found := re.match(r"name '(\w+)' is not defined", text)):
        name = found[1]
        return not_run(name, elsewhere or {}) or (
            'The first argument of a method is `self`.'
            if name == 'self'
            else f'No cell that the check uses defines `{name}`. Is it a typing error, or is a cell gone that came '
            'with the chapter? A fresh copy of the notebook has all of them.'
        )
    return ''


def not_run(name: str, elsewhere: Mapping[str, str]) -> str:
    """A sentence on a name that a cell of the notebook defines which has not been run; '' if there is none."""
    where = elsewhere.get(name)
    return f'`{name}` is defined in {where}: run that cell first, then check again.' if where else ''
