"""What fork servers import before they fork, so that a learner's program finds it loaded."""

import gc
import importlib
import re
from collections.abc import Iterable
from contextlib import suppress

import helpers

# What most programs import; the rest is imported by the program itself.
_MESSAGE_PACKAGES = (
    'std_msgs',
    'geometry_msgs',
    'sensor_msgs',
    'nav_msgs',
    'builtin_interfaces',
    'rosgraph_msgs',
    'rcl_interfaces',
)
_SERVICES = ('example_interfaces.srv', 'std_srvs.srv', 'example_interfaces.action', 'rclpy.action')
# Their C type support is loaded too.
_MESSAGES = {
    'std_msgs': ('String', 'UInt64', 'Int32', 'Bool', 'Float64', 'Header'),
    'rosgraph_msgs': ('Clock',),
    'geometry_msgs': ('Twist', 'Pose', 'PoseStamped'),
    'sensor_msgs': ('LaserScan',),
    'nav_msgs': ('OccupancyGrid', 'Odometry'),
    'rcl_interfaces': ('Log', 'ParameterEvent'),
}

# Slow to import, and only some programs do: the server imports them for the first one, and the others have them.
ON_DEMAND = (
    'tf2_ros',
    'tf_transformations',
    'tf2_geometry_msgs',
    'tf2_sensor_msgs',
    'sensor_msgs_py.point_cloud2',
    'matplotlib.pyplot',
    'mujoco_world.world',
    'rosbags.rosbag2',
)
TESTS_SIDE = [
    'helpers.runner.fork_client',
    'helpers.runner.program_process',
    'helpers.runner.plugin',
    'helpers.runner.tester',
]  # what runs an exercise's tests
# So do names of `helpers`, behind which its modules are; `check` alone brings nbformat.
# These patterns meet hostile texts: none may begin with what spans lines, or look far ahead.
_FROM_HELPERS = re.compile(r'^[ \t]*from[ \t]{1,9}helpers[ \t]{1,9}import[ \t]{1,9}(\([^)]{0,2000}\)|.+)', re.MULTILINE)


def warm_up() -> None:
    """Load code and shared libraries, without opening a participant.

    rcl brings two idle threads of LTTng's; a forked child lives without them.
    """
    import numpy  # noqa: F401
    import rclpy
    import rclpy.action
    import rclpy.event_handler  # noqa: F401
    import rclpy.executors

    rclpy.get_rmw_implementation_identifier()  # loads the middleware's library
    for package in _MESSAGE_PACKAGES:
        module = importlib.import_module(f'{package}.msg')
        for name in _MESSAGES.get(package, ()):
            getattr(module, name).__class__.__import_type_support__()
    for name in _SERVICES:
        importlib.import_module(name)
    from rcl_interfaces import srv

    for name in (
        'DescribeParameters',
        'GetParameters',
        'GetParameterTypes',
        'ListParameters',
        'SetParameters',
        'SetParametersAtomically',
    ):
        getattr(srv, name).__class__.__import_type_support__()

    import helpers.runner.worker  # noqa: F401


def keep() -> None:
    """Let forked processes' garbage collections leave alone what is imported now: nothing of it will go.

    A collection looks at each object, and so copies each page that is shared with the server: that took a tenth of a
    second at the end of each pytest.
    """
    gc.collect()
    gc.freeze()


def warm_up_for(modules: list[str]) -> None:
    """Import those of `modules` that `on_demand` may name."""
    for name in modules:
        with suppress(Exception):  # the program's own import will tell
            if name in ON_DEMAND:
                importlib.import_module(name)
            elif name in _names_of_helpers():
                getattr(helpers, name.removeprefix('helpers.'))
    gc.freeze()


def on_demand(cells: Iterable[dict]) -> list[str]:
    """What the server imports before a program with these cells (`helpers.exercises.program.Program.cells`) begins.

    These are modules of ON_DEMAND and names of `helpers`, as ``helpers.check``, that the cells seem to import.
    """
    text = '\n'.join(cell['source'] for cell in cells)
    named = {name for names in _FROM_HELPERS.findall(text) for name in re.findall(r'\w+', names)}
    return [
        *(
            name
            for name in ON_DEMAND
            if re.search(rf'^[ \t]*(import|from)[ \t]{{1,9}}{re.escape(name)}\b', text, re.MULTILINE)
        ),
        *(name for name in _names_of_helpers() if name.removeprefix('helpers.') in named),
    ]


def _names_of_helpers() -> list[str]:
    return [f'helpers.{name}' for name in dir(helpers) if not name.startswith('_')]


def warm_up_for_pytest(modules: list[str]) -> None:
    """Import pytest with what it imports for a run, and `modules`."""
    from _pytest import config

    for name in config.default_plugins:
        importlib.import_module(f'_pytest.{name}')
    import pytest  # noqa: F401

    for name in modules:
        with suppress(Exception):  # the tests' own import will tell
            importlib.import_module(name)
    gc.freeze()
