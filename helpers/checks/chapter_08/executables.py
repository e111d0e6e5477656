"""What tests see of a launch file in its output."""

import re


def lacks_parameter_file(log: str) -> bool:
    """Tell from the output of `ros2 launch` whether a parameter file is not there.

    The action Node leaves such a file out with a warning; a program that gets it by itself ends with an error.
    """
    return 'Parameter file path is not a file' in log or 'Error opening YAML file' in log


def telling(log: str) -> str:
    """The line of a launch's output that tells most: an error of the learner's program, or else the last one.

    After what a launch file has raised, launch says that the file may have a syntax error: that tells nothing.
    """
    quiet = 'process has died', 'InvalidFrontendLaunchFileError'
    lines = [line.strip() for line in log.splitlines() if line.strip() and not any(word in line for word in quiet)]
    errors = [line for line in lines if 'Error' in line or 'Exception' in line]
    return (errors or lines or ['nothing'])[-1][:300]


def wrong_type(log: str) -> str:
    """For a message: the value with another type than the parameter, as the node has said it; '' if it has not."""
    found = re.search(r"set parameter '([^']+)' to '(.*?)' of type '(\w+)'", log)
    return f' ROS reads {found[1]} as {found[2][:60]}, of the type {found[3]}.' if found else ''
