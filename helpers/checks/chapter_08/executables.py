"""What tests see of a launch file in its output."""


def lacks_parameter_file(log: str) -> bool:
    """Tell from the output of `ros2 launch` whether a parameter file is not there.

    The action Node leaves such a file out with a warning; a program that gets it by itself ends with an error.
    """
    return 'Parameter file path is not a file' in log or 'Error opening YAML file' in log
