"""What the tests of chapter 2 build: the learner's texts with the files that are given. Built once per session.

Each function returns a `helpers.runner.workspaces.ExerciseWorkspace` in which the build has succeeded.
"""

import configparser
import email
import json
import re
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

from catkin_pkg.condition import evaluate_condition
from catkin_pkg.package import InvalidPackage, parse_package_string

from helpers.checks.chapter_02 import interface_faults
from helpers.runner import about, broken, expect
from helpers.runner.workspaces import ExerciseWorkspace, package, reason

GIVEN = Path(__file__).with_name('given')
DISTRO = {'ROS_DISTRO': 'jazzy', 'ROS_VERSION': '2', 'ROS_PYTHON_VERSION': '3'}  # what the condition of a line sees
# What colcon writes into `share` itself
COLCON = re.compile(r'share/(\w+/(package\.(?!xml)\w+|hook/.*)|colcon-core/.*)')
# What setup.py says of a package -> the field in which it is installed
_BESIDES = {'licence': 'License', 'maintainer': 'Maintainer', 'email': 'Maintainer-email', 'description': 'Summary'}
_PYTHON_TOOLS = 'ament_python', 'python3-setuptools'
ODOMETRY_MANIFESTS = 'WHEEL_MATH_XML', 'ODOMETRY_XML'  # the two files package.xml of exercise 2.4


def greeter(learner) -> ExerciseWorkspace:
    """Exercise 2.1's package."""
    text = learner.text('GREETER_SETUP')
    files = {**package(GIVEN / 'greeter'), 'src/greeter/setup.py': text, 'src/greeter/test/__init__.py': ''}
    workspace = learner.workspace(files)  # tests of the package's own, which setup.py leaves out
    with about('builds'):
        if workspace.build(check=False).status != 0:
            for _, value in re.findall(r"""(['"])\s*[\w.-]+\s*=([^'"=]*)\1""", text):
                expect(
                    '/' not in value and '-' not in value,
                    f'The entry point `{value.strip()}` names a file. An entry point names a module as import does: '
                    'with dots, and without .py.',
                )
            expect(
                not re.search(r"""=\s*[\w.]+:\w+(['"])[^\S\n]*\n\s*['"]""", text),
                'A comma is missing between two entry points. Python joins two texts that follow each other to one.',
            )
        workspace.build()
    return workspace


def line_follower(learner, changed: dict[str, str] | None = None, *arguments: str) -> ExerciseWorkspace:
    """Exercise 2.2's package.

    :param changed: other texts (by path) instead of given ones. :param arguments: of `colcon build`.
    """
    workspace = learner.workspace(
        {
            **package(GIVEN / 'line_follower'),
            **(changed or {}),
            'src/line_follower/setup.py': learner.text('FOLLOWER_SETUP'),
            'src/line_follower/setup.cfg': learner.text('FOLLOWER_CFG'),
            'src/line_follower/package.xml': learner.text('FOLLOWER_XML'),
        }
    )
    with about('builds'):
        workspace.build(*arguments)
    return workspace


def dock_interfaces(learner) -> ExerciseWorkspace:
    """Exercise 2.3's package."""
    folder = 'src/dock_interfaces'
    workspace = learner.workspace(
        {
            f'{folder}/msg/Charge.msg': learner.text('MSG'),
            f'{folder}/srv/Dock.srv': learner.text('SRV'),
            f'{folder}/CMakeLists.txt': learner.text('CMAKE'),
            f'{folder}/package.xml': learner.text('DOCK_XML'),
        }
    )
    done = workspace.build(check=False)
    if done.status != 0:
        _check_how_it_is_built(learner)
        message, rule = interface_faults.cause(done.output, reason)
        raise broken(f'colcon build failed: {message}', rule)
    return workspace


def _check_how_it_is_built(learner) -> None:
    """Name and build type in the package.xml of exercise 2.3: a build that fails does not say that they are wrong."""
    with about('to-build'):
        root = manifest('DOCK_XML', learner.text('DOCK_XML'))
        found = type_in(root)
    expect(
        found == 'ament_cmake',
        f'The build type in DOCK_XML is {found or "not given"}, expected ament_cmake: CMake makes code of interfaces.',
        'both',
    )
    name = (root.findtext('name') or '').strip()
    expect(
        name == 'dock_interfaces',
        f'The package is called {name} in DOCK_XML, expected dock_interfaces, as CMakeLists.txt says in project().',
        'both',
    )


def interface(learner, cases: list | None = None) -> tuple[dict, list | None]:
    """The fields of exercise 2.3's types, its constant and its default value, as Python sees them.

    With `cases` also what came over the wire, a list for each: [message, docked, frame_id, percent, charging]. A case
    is [station, speed, docked, percent, charging]; a speed of None is left out.
    """
    arguments = [json.dumps(cases)] if cases else []
    done = dock_interfaces(learner).run(*arguments, program=_TRY_IT)
    absent = re.search(r"No module named 'dock_interfaces\.(msg|srv)'|cannot import name '(\w+)'", done.last_line)
    expect(
        not absent,
        f'Python does not find {absent and ("your ." + absent[1] if absent[1] else absent[2])}: is each '
        'file named in rosidl_generate_interfaces?',
        'both',
    )
    found = next((json.loads(line) for line in done.lines if line.startswith('{')), None)
    expect(found is not None, f'A program that uses your types ended with: {done.last_line}', 'both')
    wire = json.loads(done.lines[-1]) if done.status == 0 and arguments else None
    return {**found, 'last_line': done.last_line}, wire


def odometry(learner) -> ExerciseWorkspace:
    """Exercise 2.4's two packages, of which those are built that odometry declares to need."""
    workspace = learner.workspace(
        {
            **package(GIVEN / 'wheel_math'),
            **package(GIVEN / 'odometry'),
            'src/wheel_math/package.xml': learner.text('WHEEL_MATH_XML'),
            'src/odometry/package.xml': learner.text('ODOMETRY_XML'),
            'src/odometry/odometry/report.py': learner.text('REPORT_PY'),
        }
    )
    for name in ODOMETRY_MANIFESTS:
        package_xml(learner, name)
    done = workspace.build('--packages-up-to', 'odometry', check=False)
    expect(
        'Unable to order packages' not in done.output,
        'The two packages need each other in a circle, so neither can be built first. wheel_math needs nothing of '
        'odometry.',
        'order',
    )
    if done.status:
        check_build_types(learner)
    with about('needs'):
        workspace.build('--packages-up-to', 'odometry')
    return workspace


def check_build_types(learner) -> None:
    """The build type of both packages of exercise 2.4 is ament_python: rule `build-type`."""
    for name in ODOMETRY_MANIFESTS:
        root = package_xml(learner, name)
        with about('build-type'):
            found = type_in(root)
        expect(
            found == 'ament_python',
            f'The build type in {name} is {found or "not given"}, expected ament_python.',
            'build-type',
        )


def package_xml(learner, name: str) -> ElementTree.Element:
    """The root element of a package.xml of exercise 2.4, the learner's text `name`: rule `build-type`."""
    with about('build-type'):
        return manifest(name, learner.text(name))


def type_in(root: ElementTree.Element) -> str:
    """The build type in a package.xml, '' if there is none. One whose condition is false in jazzy does not count."""
    for element in root.findall('export/build_type'):
        try:
            if evaluate_condition(element.get('condition'), DISTRO):
                return (element.text or '').strip()
        except ValueError:
            raise broken(f'The condition of a build type, {element.get("condition")!r}, has a mistake.') from None
    return ''


def dependencies(learner, name: str) -> dict[str, set[str]]:
    """What the package.xml in the learner's text `name` declares for this distribution: tag -> packages."""
    return declared(manifest(name, learner.text(name)))


def declared(root: ElementTree.Element) -> dict[str, set[str]]:
    """What a package.xml declares: tag -> packages. A line whose condition is false in jazzy declares nothing."""
    found: dict[str, set[str]] = {}
    for element in root:
        package_name, condition = (element.text or '').strip(), element.get('condition')
        try:
            holds = evaluate_condition(condition, DISTRO)
        except ValueError:
            raise broken(f'The condition of {package_name} in package.xml, {condition!r}, has a mistake.') from None
        found.setdefault(element.tag if holds else f'{element.tag} condition="{condition}"', set()).add(package_name)
    return found


def manifest(name: str, text: str) -> ElementTree.Element:
    """The root element of a package.xml with this text; `name` is what the learner calls it.

    :raises ExpectationFailed: it cannot be read, or colcon does not take it for a package.xml.
    """
    expect('<!DOCTYPE' not in text and '<!ENTITY' not in text, f'{name} needs no DOCTYPE.')
    try:
        root = ElementTree.fromstring(text.encode())
    except (ElementTree.ParseError, LookupError, ValueError) as error:  # also an encoding that nobody knows
        raise broken(f'{name} is not XML: {error}.') from None
    try:
        parse_package_string(text.encode(), filename=name, warnings=[])
    except (InvalidPackage, AssertionError, ValueError) as error:  # also a format that is no number, or none of 1 to 3
        why = getattr(error, 'msg', str(error)).replace('Error(s):\n- ', '').partition(', please')[0]
        raise broken(
            f'colcon cannot read {name}, warns, and does not take the folder for a ROS package. {why.rstrip(".")}.'
        ) from None
    return root


class Metadata(NamedTuple):
    """What setup.py says of its package."""

    name: str
    version: str
    programs: dict[str, str]  # name -> right side
    lists: list[str]  # of entry points: console_scripts, and others
    requires: list[str]  # other Python packages that must be there, with what is asked of their version
    about: dict[str, str]  # what it says besides, if it does: licence, maintainer, email, description


def metadata(workspace: ExerciseWorkspace, package_name: str) -> Metadata | None:
    """Name and version that setup.py gives, and its programs. None if nothing is installed.

    They are read from the files that the build has installed: nothing of the learner's runs for this.
    """
    pattern = (
        rf'{package_name}/.*-packages/[^/]*\.(?:egg|dist)-info/(PKG-INFO|METADATA|entry_points\.txt|requires\.txt)'
    )
    found = {match[1]: name for name in workspace.installed() if (match := re.fullmatch(pattern, name))}
    about_it = found.get('PKG-INFO') or found.get('METADATA')
    if not about_it:
        return None
    said = email.message_from_string(workspace.read(about_it))
    programs = configparser.RawConfigParser(delimiters='=', strict=False)
    programs.optionxform = str  # type: ignore[assignment,method-assign]  # names keep their capital letters
    try:
        programs.read_string(workspace.read(found['entry_points.txt']) if 'entry_points.txt' in found else '')
    except configparser.Error:
        programs.clear()  # what nobody can read has no programs
    scripts = dict(programs['console_scripts']) if programs.has_section('console_scripts') else {}
    requires = [line for line in said.get_all('Requires-Dist', []) if 'extra ==' not in line]
    if not requires and 'requires.txt' in found:  # where setuptools before 68 writes it; extras have a title
        requires = workspace.read(found['requires.txt']).partition('[')[0].split()
    besides = {word: ' '.join(str(said[field]).split()) for word, field in _BESIDES.items() if said[field]}
    if 'licence' not in besides and 'License-Expression' in said:  # setuptools 77 and later
        besides['licence'] = str(said['License-Expression'])
    return Metadata(str(said['Name']), str(said['Version']), scripts, programs.sections(), requires, besides)


def unasked(requires: list[str], allowed: Iterable[str] = ()) -> list[str]:
    """Those of the required Python packages that are neither allowed nor the one that `ros2 pkg create` requires."""
    names = {'setuptools', *allowed}
    return [one for one in requires if re.split(r'[^\w.-]', one.strip())[0].lower().replace('_', '-') not in names]


def to_run(found: dict[str, set[str]]) -> set[str]:
    """The packages that must be there when it runs."""
    return found.get('depend', set()) | found.get('exec_depend', set())


def to_build(found: dict[str, set[str]]) -> set[str]:
    """The packages that must be there when it is built, tools included."""
    return found.get('depend', set()) | found.get('build_depend', set()) | found.get('buildtool_depend', set())


def needed(found: dict[str, set[str]], elsewhere: bool = False) -> set[str]:
    """All that is declared, except for tests, and as the tool that builds Python packages.

    :param elsewhere: count also what is declared for another distribution only, except for its tool to build.
    """
    kinds = [(tag.partition(' ')[0], ' ' in tag, names) for tag, names in found.items()]
    return {
        name
        for tag, conditional, names in kinds
        for name in names
        if tag.endswith('depend')
        and tag != 'test_depend'
        and not (tag == 'buildtool_depend' and (conditional or name in _PYTHON_TOOLS))
        and (elsewhere or not conditional)
    }


# Runs on the learner's side: prints the fields, then offers, publishes and calls what the learner has defined.
_TRY_IT = """\
import json
import sys

import rclpy
from dock_interfaces.msg import Charge
from dock_interfaces.srv import Dock

print(json.dumps({
    'msg': list(Charge.get_fields_and_field_types().items()),
    'request': list(Dock.Request.get_fields_and_field_types().items()),
    'response': list(Dock.Response.get_fields_and_field_types().items()),
    'FULL': getattr(Charge, 'FULL', None),
    'speed': getattr(Dock.Request(), 'speed', None),
    'others': [getattr(Dock.Request(), 'station', None), getattr(Dock.Response(), 'docked', None),
               getattr(Dock.Response(), 'message', None)],
}))
if len(sys.argv) > 1:
    rclpy.init()
    node = rclpy.create_node('dock')
    heard = []
    node.create_subscription(Charge, 'charge', heard.append, 10)
    publisher = node.create_publisher(Charge, 'charge', 10)

    def dock(request, response):
        message = Charge(percent=percent, charging=charging)
        message.header.frame_id = request.station
        publisher.publish(message)
        response.docked, response.message = docked, f'{request.station} at {request.speed:.2f} m/s'
        return response

    node.create_service(Dock, 'dock', dock)
    client = node.create_client(Dock, 'dock')
    client.wait_for_service(timeout_sec=10)
    arrived = []
    for station, speed, docked, percent, charging in json.loads(sys.argv[1]):
        answer = client.call_async(Dock.Request(station=station, **({} if speed is None else {'speed': speed})))
        rclpy.spin_until_future_complete(node, answer, timeout_sec=10)
        while not heard:
            rclpy.spin_once(node, timeout_sec=10)
        message = heard.pop()
        arrived.append([answer.result().message, answer.result().docked, message.header.frame_id, message.percent,
                        message.charging])
    print(json.dumps(arrived))
    rclpy.try_shutdown()
"""
