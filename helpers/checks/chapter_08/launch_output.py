"""What the output of a launch, or of a program that it has started, tells of the launch file."""

import importlib
import re

_MODULES = 'launch', 'launch.actions', 'launch.substitutions', 'launch_ros.actions', 'launch_ros.substitutions'
_HINTS = (
    ("launch configuration '.*' does not exist", 'Declare each argument before the action that needs its value.'),
    ('Invalid node name', 'The name of a node is one word; a namespace is given by itself, as namespace=….'),
    ('too many values to unpack', 'Arguments and remappings are pairs: of a dictionary give its items().'),
    (
        r'Node\.__init__\(\) got an unexpected keyword argument',
        'This is the Node of rclpy. In a launch file write: from launch_ros.actions import Node',
    ),
)


def missing_parameter_file(log: str) -> str:
    """The parameter file that is named and not there, from the output of `ros2 launch`; '' if none is missing.

    The action Node leaves such a file out with a warning; a program that gets it by itself ends with an error.
    """
    found = re.search(r'Parameter file path is not a file: (.*)|Error opening YAML file', log)
    if not found:
        return ''
    return re.sub(r'^.*(?=/share/)', '…', (found[1] or 'a file').strip())[:200]


def telling(log: str) -> str:
    """The line of a launch's output that tells most: an error of the learner's program, or else the last one.

    After what a launch file has raised, launch says that the file may have a syntax error: that tells nothing.
    """
    quiet = 'process has died', 'InvalidFrontendLaunchFileError'
    lines = [line.strip() for line in log.splitlines() if line.strip() and not any(word in line for word in quiet)]
    errors = [line for line in lines if 'Error' in line or 'Exception' in line or '[ERROR]' in line]
    last = (errors or lines or ['nothing'])[-1].removeprefix('- ')[:300].rstrip(':')
    hint = _hint(last)
    return f'{last}. {hint}' if hint else last


def _hint(line: str) -> str:
    """What to do about an error of a launch; '' if that is not known."""
    if found := re.search(r"NameError: name '(\w+)' is not defined", line):
        modules = [module for module in _MODULES if hasattr(importlib.import_module(module), found[1])]
        return f'Write: from {modules[0]} import {found[1]}' if modules else ''
    return next((hint for pattern, hint in _HINTS if re.search(pattern, line)), '')


def wrong_type(log: str) -> str:
    """For a message: the value with another type than the parameter, as the node has said it; '' if it has not."""
    found = re.search(r"set parameter '([^']+)' to '(.*?)' of type '(\w+)'", log)
    if not found:
        return ''
    told = f' ROS reads {found[1]} as {found[2][:60]}, of the type {found[3]}.'
    words = ' In YAML the words on, off, yes, no, true and false are truth values: in quotes they are texts.'
    return told + words if found[3].lower().startswith('bool') else told


def other_name(missing: str, package: str, file: str) -> str:
    """For a message: which file there is, if the missing one is named in the folder of the package; '' if not."""
    other = f'/share/{package}/' in missing and not missing.endswith(f'/{file}')
    return f' In the installed package there is {file}: is that meant?' if other else ''
