"""What the tests of exercise 2.1 look at: the programs of the package greeter, and what else is installed of it."""

import re

from helpers.checks.chapter_02 import builds
from helpers.runner import about, expect

PROGRAMS = {
    'hello': ('greeter.hello', 'main', 'Hello, {}'),
    'goodbye': ('greeter.farewell', 'main', 'Goodbye, {}'),
    'battery': ('greeter.power.battery', 'report', 'The battery of {} is full'),
}
NAMES = ('Ada', 'Grace', 'Karel', 'Unimate', 'Shakey', 'Genghis', 'Sojourner', 'Talos')
FILES = {
    'share/ament_index/resource_index/packages/greeter': 'the marker resource/greeter, by which ROS finds the package',
    'share/greeter/package.xml': 'package.xml',
}
# What is installed of the package: the programs, the Python package with what says its name, and the two files. Some
# more stands in greeter.egg-info.
KEPT = re.compile(
    rf'lib/greeter/({"|".join(PROGRAMS)})|lib/python[\d.]+/\w+-packages/(greeter/|greeter-[^/]*-info/).*'
    rf'|{"|".join(map(re.escape, FILES))}'
)
PACKAGES = ('greeter/__init__.py', 'greeter/power/__init__.py', 'greeter/farewell.py')


def judge_list(learner) -> None:
    """There are the three programs (each by its own rule), and no others (`no-others`)."""
    done = builds.greeter(learner).once('ros2', 'pkg', 'executables', 'greeter')
    there = sorted(line.split()[-1] for line in done.lines if line.startswith('greeter '))
    expect(there, 'The package has no programs: the list console_scripts is empty.', 'hello')
    said = f'The programs are {", ".join(there)}.'
    for name, (module, _, _) in PROGRAMS.items():
        file = module.rpartition('.')[2]
        as_file = {file, f'{file}.py', f'{name}.py'} & set(there)
        expect(
            name in there or not as_file,
            f'There is a program `{min(as_file, default="")}`, but none with the name `{name}`. The name of a '
            'program is what the specification says; it need not be the name of its file.',
            name,
        )
        expect(name in there, f'There is no program `{name}`. {said}', name)
    others = [name for name in there if name not in PROGRAMS]
    expect(not others, f'There is a program `{others and others[0]}`, which nobody has asked for. {said}', 'no-others')


def judge_program(learner, name: str) -> None:
    """`ros2 run greeter NAME` runs the right function: rule `name`."""
    module, function, text = PROGRAMS[name]
    words = learner.random.sample(NAMES, learner.random.randint(1, 2))
    with about(name):
        done = builds.greeter(learner).run('ros2', 'run', 'greeter', name, *words)
    command, last = f'`ros2 run greeter {name} {" ".join(words)}`', done.last_line
    right = f'Write `{module}:{function}` behind the name.'
    expect('No executable found' not in done.output, f'{command} finds no program `{name}`.', name)
    expect(
        'not callable' not in last,
        f'The entry point of {name} names a module only: add a colon and the function, `:{function}`.',
        name,
    )
    for index, (other, (_, _, its)) in enumerate(PROGRAMS.items()):
        expect(
            other == name or last != its.format(' '.join(words)),
            f'The program {name} runs the function of {list(PROGRAMS)[index]}. {right}',
            name,
        )
    expect(
        last != 'battery.py tests itself',
        f'The program {name} runs `main` of battery.py; the specification asks for the function `{function}`.',
        name,
    )
    expect(
        "No module named 'greeter.power'" not in done.output or 'is not a package' in last,
        'The folder greeter/power is not installed: `packages` in setup.py must name it, or find it.',
        'rest' if name == 'battery' else name,
    )
    absent = re.search(r"No module named '([^']*)'", last)
    why = ' Without .py: Python would import a module `py` of it.' if absent and absent[1].endswith('.py') else ''
    expect(not absent, f'{command} imports `{absent and absent[1]}`, and there is no such module.{why} {right}', name)
    absent = re.search(r"has no attribute '(\w+)'", last)
    expect(
        not absent, f'{command} looks for `{absent and absent[1]}`, and the module has no such function. {right}', name
    )
    expect(done.lines == [text.format(' '.join(words))], f'{command} ended with: {last}', name)


def judge_rest(learner) -> None:
    """What was in setup.py before still works: rule `rest`."""
    workspace = builds.greeter(learner)
    there = {name.removeprefix('greeter/') for name in workspace.installed()}
    warnings = workspace.build().output
    for file, what in FILES.items():
        warning = f"doesn't explicitly install {'a marker' if 'marker' in what else 'the'}"
        expect(
            file in there and warning not in warnings,
            f'setup.py no longer installs {what}. The two lines of data_files must stay.',
            'rest',
        )
    for file in PACKAGES:
        expect(
            any(name.endswith(f'site-packages/{file}') for name in there),
            f'The file {file} is not installed: `packages` must stay find_packages, or name every folder that has '
            'an __init__.py.',
            'rest',
        )
    expect(
        not any(name.endswith('site-packages/test/__init__.py') for name in there),
        "The folder `test` is installed as a package, too: `find_packages(exclude=['test'])` has left it out.",
        'rest',
    )
    found = builds.metadata(workspace, 'greeter')
    name, version = found[:2] if found else ('', '')
    required = builds.unasked(found.requires) if found else []
    expect(
        not required,
        f'setup.py says that greeter requires {required and required[0]}. It required nothing before.',
        'rest',
    )
    other = [one for one in (found.lists if found else ()) if one != 'console_scripts']
    expect(
        not other or 'console_scripts' in found.lists,
        f'setup.py names its programs in {other and other[0]}. The list was called console_scripts: leave its name.',
        'rest',
    )
    expect(name == 'greeter', f'The name of the package in setup.py is {name or "nothing"}, and was greeter.', 'rest')
    expect(version == '0.1.0', f'setup.py says greeter {version}, and said greeter 0.1.0 before.', 'rest')
    programs = workspace.once('ros2', 'pkg', 'executables', 'greeter').output.split()  # the subject of another rule
    more = sorted(
        name
        for path in workspace.installed()
        if (name := path.removeprefix('greeter/')) != path
        and not KEPT.match(name)
        and not builds.COLCON.match(name)
        and not (name.startswith('lib/greeter/') and name.rpartition('/')[2] in programs)
    )
    expect(not more, f'setup.py installs {more and more[0]}, too. {_advice(more)}', 'rest')


def _advice(more: list[str]) -> str:
    """What to do about files that are installed besides."""
    if more and more[0].startswith('lib/greeter/'):
        return 'The build makes the programs there from the entry points: leave data_files as it was.'
    return 'Leave data_files and the other arguments as they were: only the list of programs is new.'
