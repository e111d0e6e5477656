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


def explain(kind: str, text: str, early: str = '', elsewhere: Mapping[str, str] | None = None) -> str:
    """A sentence on an exception of the type `kind` with this text; '' if there is nothing to add.

    `early`: where the program read the result of a future that had none yet. `elsewhere`: by name, the cell of the
    notebook that defines it and that has not been run.
    """
    if kind == 'AttributeError' and (
        found := re.search(
            r"property '(\w+)' of .* has no setter|can't set attribute "
            r"'?(\w+)?",
            text,
        )
    ):
        name = found[1] or found[2] or ''
        if not name or name in _RESERVED:
            return (
                f"rclpy's Node uses {f'the name `{name}`' if name else 'this name'} itself (as it does "
                f'{", ".join(_RESERVED[:6])}): choose another one, such as `self.my_{name or "timers"}`.'
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
        return not_run(found[1], elsewhere or {})
    return ''


def not_run(name: str, elsewhere: Mapping[str, str]) -> str:
    """A sentence on a name that a cell of the notebook defines which has not been run; '' if there is none."""
    where = elsewhere.get(name)
    return f'`{name}` is defined in {where}: run that cell first, then check again.' if where else ''
