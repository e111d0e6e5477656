"""What the notebooks import: spinning, waiting, clean-up and checks around plain rclpy.

The notebooks show publishers, subscriptions, timers and callbacks; this package owns only what a Jupyter kernel adds.
Importing it is cheap: rclpy itself is loaded when it is first needed. It sets a few defaults in ``os.environ`` (only
where nothing is set), because rclpy and Fast DDS read them once, at their start.
"""

import importlib
import os
import sys

from environment.setup.startup import DEFAULTS as _DEFAULTS

# Already set in the course's own environment; another installation of ROS has no start-up file.
for _name, _value in _DEFAULTS.items():
    os.environ.setdefault(_name, _value)

# Public name -> module that defines it. README.md says the same for readers.
_HOME = {
    'CallbackError': 'kernel.callback_errors',
    'Finding': 'programs.faults.finding',
    'GraphView': 'show.graph.view',
    'PhysicsWorld': 'programs.physics_world',
    'ProgressBar': 'show.progress_bar',
    'QosSliders': 'show.qos_sliders',
    'Sliders': 'show.sliders',
    'TfView': 'show.views.tf_view',
    'TurtleView': 'show.turtle_view',
    'Workspace': 'programs.workspace',
    'background': 'programs.processes',
    'cell_text': 'exercises.cell_text',
    'check': 'exercises.exercise_check',
    'collect': 'kernel.waiting',
    'parameter_sliders': 'show.parameter_sliders',
    'resume': 'exercises.resuming',
    'route_map': 'show.route_map',
    'figure': 'show.charts',
    'routes': 'show.routes_table',
    'show_frames': 'show.views.frames_diagram',
    'show_graph': 'show.graph.view',
    'show_charge': 'show.charts',
    'show_support': 'show.charts',
    'show_turtle': 'show.turtle_view',
    'spin_for': 'kernel.waiting',
    'spinning': 'kernel.spinning',
    'submit': 'exercises.handing_in',
    'timeline': 'show.timeline',
    'wait_for': 'kernel.waiting',
}
# Public names that are modules themselves.
_MODULES = {
    'domains': 'kernel.domains',
    'faults': 'programs.faults',
    'paths': 'paths',
    'ros': 'kernel.ros',
    'views': 'show.views',
}


def __getattr__(name):
    if name in _MODULES:
        value = importlib.import_module(f'{__name__}.{_MODULES[name]}')
    elif name in _HOME:
        value = getattr(importlib.import_module(f'{__name__}.{_HOME[name]}'), name)
    else:
        raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    globals()[name] = value
    return value


def __dir__():
    return sorted({*globals(), *_HOME, *_MODULES})


if 'IPython' in sys.modules:  # in a kernel: note the executed cells from here on, and take files and programs in them
    importlib.import_module(f'{__name__}.kernel.journal').start()
    importlib.import_module(f'{__name__}.kernel.kernel_exit').register()
    importlib.import_module(f'{__name__}.exercises.answer_magic').register()
    importlib.import_module(f'{__name__}.exercises.file_parts').register()
    importlib.import_module(f'{__name__}.programs.script_cells').register()
