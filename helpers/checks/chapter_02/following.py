"""What the tests of exercise 2.2 look at: each fault of the package line_follower by itself, and the rest."""

import configparser
import re

from helpers.checks.chapter_02 import builds
from helpers.runner import about, broken, expect
from helpers.runner.workspaces import ExerciseWorkspace, package

PROGRAM = 'lib/line_follower/follow'
DATA = 'share/line_follower/config/gains.yaml'
MARKER = 'share/ament_index/resource_index/packages/line_follower'
PLACES = PROGRAM, DATA, MARKER, 'share/line_follower/package.xml'
ONCE = 'install the marker, package.xml and the data file, each to one place, and no other file.'
# Its Python code, compiled or not (where it goes is the subject of another rule), and what says the name of the package
_PYTHON = re.compile(
    r'-packages/((line_follower|filters)/.*\.pyc?$|(__pycache__/)?(follow|median|__init__)\.[^/]*$|line_follower-[^/]*-info/)'
)
# setuptools 72 and later do not know tests_require, which `ros2 pkg create` writes.
_UNKNOWN_OPTION = re.compile("Unknown distribution option: '(\\w+)'")
# What follow.py imports, as setup.py calls it: who requires these says what is so.
_REQUIRED = 'pyyaml', 'ament-index-python', 'geometry-msgs'
IMPORTED = ('geometry_msgs', 'ament_index_python', 'python3-yaml')
SAID = 'forward 0.20 m/s, turn -0.08 rad/s'
# tag -> text in package.xml
KEPT = {
    'name': 'line_follower',
    'version': '0.1.0',
    'description': 'Steers along a line.',
    'maintainer': 'You',
    'license': 'Apache-2.0',
    'export/build_type': 'ament_python',
}
EMAIL = 'you@example.com'


def _there(learner) -> list[str]:
    return [name.removeprefix('line_follower/') for name in builds.line_follower(learner).installed()]


def _metadata(learner) -> builds.Metadata:
    """Name and version in setup.py, and its programs."""
    found = builds.metadata(builds.line_follower(learner), 'line_follower')
    if found is None:
        raise broken('setup.py does not install the Python package line_follower any more.', 'rest')
    return found


def judge_entry_point(learner) -> None:
    """The entry point follow leads to main of follow.py: rule `entry-point`."""
    programs = _metadata(learner).programs
    expect(
        'follow' in programs,
        f'setup.py has no entry point `follow`; its programs are: {", ".join(sorted(programs)) or "none"}.',
        'entry-point',
    )
    value = programs['follow'].replace(' ', '')
    expect(
        value == 'line_follower.follow:main',
        f'The program follow leads to {value}. The function main is in the file line_follower/follow.py.',
        'entry-point',
    )


def judge_place(learner) -> None:
    """The program is where `ros2 run` looks, with both kinds of a build: rule `programs`."""
    there = _there(learner)
    elsewhere = [name for name in there if name.endswith('/follow')]
    expect(
        PROGRAM in there or not elsewhere,
        f'The program is installed as {min(elsewhere, default="")}; `ros2 run` looks for it in lib/line_follower. '
        'It is not in lib/line_follower: look at install_scripts in setup.cfg.',
        'programs',
    )
    found = builds.metadata(builds.line_follower(learner), 'line_follower')
    expect(
        elsewhere or not found or 'follow' not in found.programs,
        'There is an entry point `follow`, and no program `follow` is installed where programs are: look at '
        'install_scripts in setup.cfg. $base, with the dollar sign, is the folder of the installation.',
        'programs',
    )
    expect(elsewhere, 'No program `follow` is installed: look at entry_points.', 'entry-point')
    settings = configparser.RawConfigParser()
    with about('programs'):
        try:
            settings.read_string(learner.text('FOLLOWER_CFG'))
        except configparser.Error as error:
            expect(False, f'FOLLOWER_CFG cannot be read: {" ".join(str(error).split())}')
    develop = {
        key.replace('-', '_'): value
        for key, value in (settings.items('develop') if settings.has_section('develop') else ())
    }
    found = ''.join(develop.get('script_dir', 'nothing').split()).rstrip('/')
    expect(
        found == '$base/lib/line_follower',
        f'script_dir in setup.cfg is {found}. It must stay '
        '$base/lib/line_follower: a build with --symlink-install puts the program there.',
        'programs',
    )


def judge_packages(learner) -> None:
    """All Python code is installed, with its folders: rule `packages`."""
    there = _there(learner)
    for file in ('filters/__init__.py', 'filters/median.py', '__init__.py', 'follow.py'):
        why = (
            '`packages` in setup.py must name the folder inside of line_follower, as line_follower.filters.'
            if file.startswith('filters')
            else '`packages` in setup.py must name line_follower itself, too: a folder in it is not all of it.'
        )
        expect(
            any(name.endswith(f'-packages/line_follower/{file}') for name in there),
            f'line_follower/{file} is not installed as a part of line_follower, so Python cannot import it. {why}',
            'packages',
        )


def judge_data(learner) -> None:
    """The data file is where the program reads it: rule `data`."""
    there = _there(learner)
    elsewhere = [name for name in there if name.endswith('gains.yaml') and name != DATA]
    expect(
        DATA in there or not elsewhere,
        f'gains.yaml is installed as {min(elsewhere, default="")}; the program reads {DATA}.',
        'data',
    )
    expect(DATA in there, f'{DATA} is not installed: name config/gains.yaml in data_files.', 'data')


def judge_build(learner) -> None:
    """The build has no warning about what setup.py does not install: rule `builds`."""
    done = builds.line_follower(learner).build()
    expect(
        "doesn't explicitly install a marker" not in done.output,
        'setup.py does not install the marker resource/line_follower into '
        'share/ament_index/resource_index/packages. colcon does it for you, with a warning; other tools do not.',
        'builds',
    )
    expect(
        "doesn't explicitly install the 'package.xml'" not in done.output,
        'setup.py no longer installs package.xml into share/line_follower.',
        'builds',
    )
    unknown = [name for name in _UNKNOWN_OPTION.findall(done.output) if name != 'tests_require']
    expect(
        not unknown,
        f'The build warns: setup() has no argument {unknown and unknown[0]}, so what you wrote there does nothing. '
        'Is it a typing error?',
        'builds',
    )


def judge_dependencies(learner) -> None:
    """package.xml declares what the code imports, for run time, and nothing else: rule `dependencies`."""
    with about('dependencies'):
        declared = builds.dependencies(learner, 'FOLLOWER_XML')
        for name in IMPORTED:
            expect(
                name not in declared.get('build_depend', set()) - builds.to_run(declared),
                f'{name} is a build_depend only: it would be there when the package is built, but not when it runs.',
            )
            others = [tag for tag, names in declared.items() if name in names and 'condition' in tag]
            expect(
                name in builds.to_run(declared) or not others,
                f'follow.py needs {name}, and package.xml declares it as {others and others[0]}: that does not hold in '
                'jazzy, so it is not installed.',
            )
            expect(
                name in builds.to_run(declared),
                f'follow.py needs {name}, and package.xml does not declare it. On a fresh machine it is not installed.',
            )
        more = builds.needed(declared) - set(IMPORTED)
        expect(not more, f'package.xml declares {", ".join(sorted(more))}, which follow.py does not import.')
        for tag in ('conflict', 'replace'):
            names = declared.get(tag, set())
            expect(
                not names, f'package.xml has a line {tag}, for {", ".join(sorted(names))}: it had none, and needs none.'
            )


def judge_rest(learner) -> None:
    """Names, versions, licence and the one program are as before: rule `rest`."""
    found = _metadata(learner)
    name, version, programs = found[:3]
    expect(
        (name, version) == ('line_follower', '0.1.0'),
        f'setup.py says {name} {version}, and said line_follower 0.1.0 before.',
        'rest',
    )
    others = [other for other in programs if other != 'follow']
    expect(
        not others or len(programs) == 1,
        f'setup.py has a further program, {others and others[0]}. Only `follow` is asked for.',
        'rest',
    )
    _judge_said(found)
    installed = [name for name in builds.line_follower(learner).installed() if name.startswith('line_follower/')]
    _judge_files([name.removeprefix('line_follower/') for name in installed])  # what is beside it, colcon has written
    root = builds.manifest('FOLLOWER_XML', learner.text('FOLLOWER_XML'))
    for tag, wanted in KEPT.items():
        word = tag.rpartition('/')[2]
        texts = [' '.join((element.text or 'nothing').split()) for element in root.findall(tag)]
        if word == 'build_type':  # there may be one for another ROS
            texts = [builds.type_in(root) or 'nothing']
        expect(
            len(texts) < 2,
            f'package.xml has {len(texts)} lines {word}, {" and ".join(texts)}. There was one before, {wanted}.',
            'rest',
        )
        found = ''.join(texts) or 'nothing'
        expect(
            found == wanted, f'The {word} in package.xml is {found}, and was {wanted} before. It was no fault.', 'rest'
        )
    address = ''.join(element.get('email', '') for element in root.findall('maintainer')) or 'nothing'
    expect(
        address == EMAIL,
        f'The email of the maintainer in package.xml is {address}, and was {EMAIL} before. It was no fault.',
        'rest',
    )


def _judge_said(found: builds.Metadata) -> None:
    """setup.py requires no other Python package, and says nothing else than package.xml does: rule `rest`."""
    required = builds.unasked(found.requires, _REQUIRED)
    expect(
        not required,
        f'setup.py says that line_follower requires {required and required[0]}, of which follow.py imports nothing. '
        'It required nothing before.',
        'rest',
    )
    for word, wanted in (('licence', KEPT['license']), ('maintainer', KEPT['maintainer']), ('email', EMAIL)):
        said = found.about.get(word, wanted)
        expect(
            said == wanted,
            f'setup.py gives the {word} {said}, and in package.xml it was {wanted}: leave it out of setup.py, or write '
            'the same.',
            'rest',
        )


def _judge_files(there: list[str]) -> None:
    """Besides the Python code, nothing is installed but four files, each once: rule `rest`.

    One that is not in its place is the subject of another rule.
    """
    for name in sorted(there):
        place = next((place for place in PLACES if place.rpartition('/')[2] == name.rpartition('/')[2]), name)
        expect(
            name in PLACES
            or _PYTHON.search(name)
            or builds.COLCON.match(name)
            or (place != name and place not in there),
            f'setup.py also installs {name}, which nobody looks for there: {ONCE}',
            'rest',
        )


def judge_drive(learner) -> None:
    """The repaired program prints what it should; a fault is named by the rule that it breaks."""
    _judge_run(builds.line_follower(learner), SAID)


def judge_linked(learner) -> None:
    """With other gains and readings, and a build with --symlink-install, the program prints what follows from them."""
    random = learner.random
    folder = 'src/line_follower/line_follower'
    text = package(builds.GIVEN / 'line_follower')[f'{folder}/follow.py']
    speed, kp, offset = random.randint(11, 49) / 100, random.randint(5, 19) / 10, random.randint(2, 9) / 10
    readings = random.sample([offset, -offset - random.random(), offset + 1 + random.random()], 3)
    for old, new in (('= 0.2 ', f'= {speed} '), ('[0.1, 9.9, 0.1]', f'{readings}')):
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    changed = {f'{folder}/follow.py': text, 'src/line_follower/config/gains.yaml': f'kd: {random.random()}\nkp: {kp}\n'}
    workspace = builds.line_follower(learner, changed, '--symlink-install')
    elsewhere = [name.removeprefix('line_follower/') for name in workspace.installed() if name.endswith('/follow')]
    expect(
        not elsewhere or PROGRAM in elsewhere,
        f'A build with --symlink-install puts the program into {min(elsewhere, default="")}; `ros2 run` looks for it '
        'in lib/line_follower: look at script_dir in setup.cfg.',
        'programs',
    )
    _judge_run(workspace, f'forward {speed:.2f} m/s, turn {-kp * offset:.2f} rad/s')


def _judge_run(workspace: ExerciseWorkspace, said: str) -> None:
    """The program follow prints this line, and no other."""
    done = workspace.run('ros2', 'run', 'line_follower', 'follow')
    last = done.last_line
    elsewhere = [name for name in workspace.installed() if name.endswith('/follow')]
    rule = 'entry-point'
    for word, other in (
        ("No module named 'line_follower.filters'", 'packages'),
        ("No module named 'line_follower.follow'", 'packages'),
        ('gains.yaml', 'data'),
        ('PackageNotFoundError', 'builds'),
        ("Package 'line_follower' not found", 'builds'),
    ):
        rule = other if word in last else rule
    found = builds.metadata(workspace, 'line_follower')
    if 'No executable found' in done.output and (elsewhere or found and 'follow' in found.programs):
        rule = 'programs'
    expect(done.lines == [said], f'`ros2 run line_follower follow` ended with: {last}; expected: {said}', rule)
