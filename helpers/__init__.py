"""What the notebooks import: spinning, waiting, clean-up and checks around plain rclpy.

The notebooks show publishers, subscriptions, timers and callbacks; this package owns only what a Jupyter kernel adds.
Importing it is cheap: rclpy itself is loaded when it is first needed. It sets a few defaults in ``os.environ`` (only
where nothing is set), because rclpy and Fast DDS read them once, at their start.
"""

import importlib
import os
import sys
from types import ModuleType

_DEFAULTS = {
    'ROS_PYTHON_CHECK_FIELDS': '1',  # String(data=3) fails where it is written, not later in publish()
    'RCUTILS_COLORIZED_OUTPUT': '0',  # log lines that read the same in a terminal, a notebook and CI
    'RCUTILS_CONSOLE_OUTPUT_FORMAT': '[{severity}] [{name}]: {message}',
    'ROS_AUTOMATIC_DISCOVERY_RANGE': 'LOCALHOST',  # neighbours in the same network do not drive each other's robots
    'OPENBLAS_NUM_THREADS': '1',
}
for _name, _value in _DEFAULTS.items():
    os.environ.setdefault(_name, _value)

# Public name -> module that defines it; None where the name is the module itself.
_HOME = {
    'CallbackError': 'errors',
    'GraphView': 'graph',
    'PhysicsWorld': 'physics',
    'ProgressBar': 'progress',
    'TfView': 'views.tf_view',
    'TurtleView': 'turtle',
    'Workspace': 'workspace',
    'background': 'processes',
    'check': 'check',
    'collect': 'waiting',
    'ros': None,
    'routes': 'routes',
    'show_frames': 'views.frames_diagram',
    'show_graph': 'graph',
    'show_turtle': 'turtle',
    'spin_for': 'waiting',
    'spinning': 'spinning',
    'submit': 'submit',
    'timeline': 'timeline',
    'wait_for': 'waiting',
}


class _Package(ModuleType):
    """The type of this package: where a function and its module share a name (``spinning``), it shows the function."""

    def __setattr__(self, name, value):
        if isinstance(value, ModuleType) and _HOME.get(name) == name:
            value = getattr(value, name)
        super().__setattr__(name, value)


sys.modules[__name__].__class__ = _Package


def __getattr__(name):
    if name not in _HOME:
        raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    module = importlib.import_module(f'{__name__}.{_HOME[name] or name}')
    value = module if _HOME[name] is None else getattr(module, name)
    setattr(sys.modules[__name__], name, value)
    return value


def __dir__():
    return sorted({*globals(), *_HOME})


if 'IPython' in sys.modules:  # in a kernel: note the executed cells from here on
    importlib.import_module(f'{__name__}.journal').start()
    importlib.import_module(f'{__name__}.kernel_exit').register()
