"""Why the build of exercise 2.3's interfaces failed: the cause out of a long output, and the rule that is broken."""

import re
from collections.abc import Callable

_EXCEPTION = re.compile(r'^ *(?:\w+\.)*((?:\w+Error|Invalid\w+|\w*Exception): [^\n]*(?:\n  \S[^\n]*)?)', re.MULTILINE)
_IN_FILE = re.compile(r"Error processing '([^']*)' of 'dock_interfaces/(\w+)'")


def cause(output: str, reason: Callable[[str], str]) -> tuple[str, str]:
    """The cause of a failed build in one sentence, and the rule that is broken.

    :param output: what the build printed. :param reason: gives the best line of it, where the cause is none of these.
    """
    text = ' '.join(output.split())
    if found := _cause_in_a_line(text, output):
        return found
    if "KeyError: 'std_msgs'" in text:
        return (
            'Charge uses a type of std_msgs, and rosidl_generate_interfaces does not say so: write DEPENDENCIES '
            'std_msgs at its end.'
        ), 'std-msgs'
    if "dependency 'std_msgs' has not been found" in text:
        return 'CMakeLists.txt has DEPENDENCIES std_msgs, but no find_package(std_msgs REQUIRED) before it.', 'std-msgs'
    if found := re.search(r"No such file or directory: '[^']*/dock_interfaces/msg/(\w+)\.json'", text):
        return (
            f'There is no type {found[1]} in your package. For the type of another package write its name, too: '
            f'std_msgs/{found[1]}.'
        ), 'charge'
    if 'Could not find separator' in text:
        return (
            'Dock.srv has no line `---`. It divides the request from the response, and nothing else stands in it, not '
            'even a blank.'
        ), 'response'
    if '<member_of_group>' in text:
        return (
            'package.xml does not say that the package is a member of the group: it needs '
            '<member_of_group>rosidl_interface_packages</member_of_group>.'
        ), 'group'
    if found := re.search(r"the passed file '([^']*)' doesn't exist", text):
        return (
            f'CMakeLists.txt names the file {found[1]}, and there is none. The files are msg/Charge.msg and '
            'srv/Dock.srv.'
        ), 'both'
    if re.search(r'CMake Warning.*No project\(\) command is present', text):
        return 'CMakeLists.txt has no line project(dock_interfaces), which comes second.', 'both'
    if found := re.search(r'Unknown CMake command "(\w+)"', text):
        package = {'rosidl_generate_interfaces': 'rosidl_default_generators'}.get(found[1], 'ament_cmake')
        return f'CMake does not know {found[1]}: find_package({package} REQUIRED) must come before it.', 'both'
    if found := _IN_FILE.search(output):
        why = _last(output) or 'its type is unknown'
        return f'The line `{found[1]}` of {found[2]} cannot be read: {why}', _rule(output)
    if last := _last(output):
        return last, 'full' if 'InvalidValue' in last else 'both'
    return reason(output), 'both'


def _cause_in_a_line(text: str, output: str) -> tuple[str, str] | None:
    """The cause, if a line of an interface file has a name or a type that cannot be. `text`: `output` in one line."""
    if found := re.search(r"'(\w+)' is an invalid constant name", text):
        name = found[1]
        if name.upper() == 'FULL':
            return f'The name of the constant is `{name}`. A constant has capital letters: FULL.', 'full'
        return (
            f'The line of `{name}` has a `=`, so it is a constant, and a constant has capital letters. A default '
            'value follows after a space only.'
        ), 'default' if name == 'speed' else 'full'
    if (found := re.search(r"'(\w+)' is an invalid field name", text)) and found[1].upper() == found[1]:
        return (
            f'The line of `{found[1]}` has no `=`, so it is a field, and fields have small letters. A constant has a '
            '`=` before its value.'
        ), 'full' if found[1] == 'FULL' else _rule(output)
    if found := re.search(r"'(\w+)' is an invalid field name", text):
        return f'`{found[1]}` cannot be the name of a field: it has small letters, digits and single _ only.', _rule(
            output
        )
    if found := re.search(r"InvalidResourceName: '(float|int|uint|double|long|str|text)' is an invalid", text):
        known = {'float': 'float32 and float64', 'double': 'float64'}.get(found[1], 'int32, uint8, string and others')
        return f'There is no type {found[1]} in interfaces: ROS has {known}.', _rule(output)
    if found := re.search(r'InvalidResourceName: (\w+)/(?:msg|srv)/(\w+)', text):
        return f'In an interface file the type is written without /msg/: `{found[1]}/{found[2]}`.', 'charge'
    return None


def _rule(output: str) -> str:
    """The rule of the part of an interface in which a line cannot be read."""
    found = _IN_FILE.search(output)
    if found and found[2] == 'Charge' and '=' in found[1]:
        return 'full'
    parts = {'Charge': 'charge', 'Dock_Request': 'request', 'Dock_Response': 'response'}
    return parts.get(found[2], 'both') if found else 'both'


def _last(output: str) -> str:
    """The last exception that a tool has printed, in one line."""
    found = _EXCEPTION.findall(output)
    return ' '.join(found[-1].split())[:300] if found else ''
