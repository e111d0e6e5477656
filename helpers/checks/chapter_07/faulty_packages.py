"""Exercise 7.2's packages: drawn with their faults, and built."""

import ast
import re

from helpers.checks.chapter_07.findings import compare
from helpers.runner import about, expect

PACKAGES = ('greeter', 'porter', 'gardener', 'courier', 'patrol')
PROGRAMS = ('hello', 'status', 'sweep', 'fetch', 'charge', 'lift', 'report', 'dock')
FUNCTIONS = ('main', 'run2', 'start', 'say_hello', 'work')
CAUSES = ('file', 'module', 'function')
FORMS = 8  # so many forms has the cause that has most
WHY = {
    'file': 'An entry point names a module as import does: no `/`, no `.py`. A name such as `copy` has no point.',
    'module': 'The module is looked up among the files of the package: package.name is package/name.py, letter by '
    'letter; a hyphen is no underscore.',
    'function': 'A function that can be started stands at the left margin of its module, after `def`, and is named '
    'after a colon; a method, a class, an `async def`, a comment, or a longer name that only begins so, is none.',
}
_ENTRY = re.compile(r'([\w-]+)\s*=(.*)')
_SETUP = """\
from setuptools import find_packages, setup

package_name = '{package}'

# What is written into the index is found by `ros2 pkg`.
setup(
    name=package_name,
    version='0.1.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='{program} team',
    maintainer_email='team@example.com',
    description='{description}',
    license='Apache-2.0',
    entry_points={{
        'console_scripts': [
{entries}
        ],
    }},
)
"""
_MODULE = '''\
"""One thing that the robot does."""


class Task:
    def {method}(self):
        return '{program}'


async def _{method}(task):
    return task.{method}()


def {private}(task):
    print(task.{method}(), 'says {word}')


def {function}({arguments}):
    {private}(Task())


def _{function}_again(task):
    {private}(task)


class Shift(Task):
    def end(self):
        return '{program} ends'


# def {function}_later(): is for another day
'''
# A function may take arguments, as long as it can be called without any.
_ARGUMENTS = ('', 'args=None', '*args', 'words: list | None = None, **more')
_PACKAGE_XML = """\
<?xml version="1.0"?>
<package format="3">
  <name>{package}</name>
  <version>0.1.0</version>
  <description>What the robot does</description>
  <maintainer email="team@example.com">team</maintainer>
  <license>Apache-2.0</license>
  <export><build_type>ament_python</build_type></export>
</package>
"""


class FaultyPackage:
    """A drawn package: `files` as the learner gets them, `expected` findings, `right` entry points."""

    def __init__(self, random, *causes: str, form: int | None = None):
        """`form`: which of the forms of each cause it is, by its number; None: as it comes."""
        self.name = random.choice(PACKAGES)
        programs = random.sample(PROGRAMS, 3)
        # Two that are right: one has .py in its right side, the name of the other ends as that of another one.
        programs += ['pylon', f're_{programs[0]}']
        self.words = {program: f'word{random.randint(100, 999)}' for program in programs}
        self.right, self.expected, entries = {}, [], []
        self.files = {f'{self.name}/__init__.py': '', 'README.md': f'The robot {self.name}\n'}
        likely = [programs[0], programs[-1], *random.sample(programs[1:3], 2), 'pylon']
        faulty = dict(zip(likely, causes, strict=False))
        first = programs[0]
        random.shuffle(programs)
        lost = f'{self.name}.{random.choice(["main", "program", "node"])}:main'  # programs may share a wrong one
        for program in programs:
            function, method = random.sample(FUNCTIONS, 2)
            if program == first:  # no function named is a fault also where the module has a main
                function, method = 'main', random.choice(FUNCTIONS[1:])
            elif program == likely[1]:  # neither letters alone, nor spaces around the sign
                function, method = random.sample(('run2', 'say_hello'), 2)
            self.files[f'{self.name}/{program}.py'] = _MODULE.format(
                function=function,
                arguments=random.choice(_ARGUMENTS),
                method=method,
                program=program,
                word=self.words[program],
                private=f'_{function}',
            )
            self.right[program] = value = f'{self.name}.{program}:{function}'
            if program in faulty:
                forms = self._wrong(program, function, method, lost)[faulty[program]]
                value = random.choice(forms) if form is None else forms[form % len(forms)]
                self.expected.append(('no_program', program, faulty[program], value))
            quote = random.choice(['"', "'"])
            sign = random.choice(['=', '  =  '] if program == likely[1] else [' = ', '=', '  =  '])
            entries.append(f'            {quote}{program}{sign}{value}{quote},')
        # The first wrong right side stands before the entries, too, where it does no harm.
        self.description = ' as '.join(['What the robot does', *[finding[3] for finding in self.expected[:1]]])
        self.files['setup.py'] = _SETUP.format(
            package=self.name, program=programs[0], description=self.description, entries='\n'.join(entries)
        )
        paths = random.sample([*self.files], len(self.files))
        first = random.choice([paths[0], random.choice(['README.md', 'setup.py'])])  # often none of the package
        self.files = {path: self.files[path] for path in [first, *paths]}

    def _wrong(self, program: str, function: str, method: str, lost: str) -> dict[str, list[str]]:
        """Wrong right sides of a program, by their cause; `lost`: one that several may have."""
        return {
            'file': [
                f'{self.name}/{program}.py:{function}',
                f'{self.name}.{program}.py:{function}',
                f'{self.name}/{program}:{function}',
            ],
            'module': [
                lost,
                f'{program}:{function}',
                f'{self.name}.{program}_:{function}',
                f'other.{program}:{function}',
            ],
            'function': [
                f'{self.name}.{program}',
                f'{self.name}.{program}:{method}',
                f'{self.name}.{program}:{function[:-1]}',
                f'{self.name}.{program}:_{method}',
                f'{self.name}.{program}:Task',
                f'{self.name}.{program}:{function.capitalize()}',
                f'{self.name}.{program}:Shift',
                f'{self.name}.{program}:{function}_later',
            ],
        }

    def diagnose(self, learner, rule: str = '') -> None:
        """Ask the learner's diagnose_package, and fail with words if it does not find what is expected."""
        entries = [repr(entry) for entry in _console_scripts(self.files['setup.py'])[0]]
        given = f'The entry points are: {" ".join(entries)}\nThe files are: {", ".join(self.files)}'
        compare(learner.call('diagnose_package', self.files), self.expected, WHY, rule, given)

    def check(self, repaired) -> None:
        """Fail with words if the repaired files do not have the right entry points."""
        expect(
            isinstance(repaired, dict) and all(isinstance(text, str) for text in repaired.values()),
            'repair_package must return a dictionary of strings.',
            'repaired',
        )
        lost = sorted(self.files.keys() - repaired.keys())
        expect(not lost, f'repair_package must return all files: {lost and lost[0]} is missing.', 'kept')
        changed = sorted(name for name in self.files if name != 'setup.py' and repaired[name] != self.files[name])
        expect(
            not changed, f'{changed and changed[0]} was right, and is changed: only setup.py is to be repaired.', 'kept'
        )
        self._check_setup(repaired['setup.py'])

    def _check_setup(self, setup: str) -> None:
        """Fail with words if a program leads elsewhere, or anything but the entry points is changed."""
        try:
            entries, rest = _console_scripts(setup)
        except (SyntaxError, ValueError, RecursionError, MemoryError) as error:  # whatever is in a learner's text
            expect(False, f'After your repair, Python cannot read setup.py: {error}.', 'repaired')
        expect(
            self.description in rest,
            f'In setup.py, the description was right, `{self.description}`, and your repair has changed it: replace '
            'a whole entry, with the name of its program, and not its right side wherever that stands.',
            'kept',
        )
        there = dict(match.groups() for match in map(_ENTRY.fullmatch, entries) if match)
        healthy = self.right.keys() - {finding[1] for finding in self.expected}
        for program, value in self.right.items():
            rule = 'kept' if program in healthy else 'repaired'
            expect(
                program in there,
                f'The program {program} is gone from setup.py, which now has the entry points {entries}.',
                rule,
            )
            expect(
                ''.join(there[program].split()) == value,
                f'After your repair, {program} leads to `{there[program].strip()}`, expected `{value}`.',
                rule,
            )
        comments = [line for line in self.files['setup.py'].splitlines() if line.startswith('#')]
        expect(
            all(comment in setup for comment in comments),
            f'The comment `{comments[0]}` is gone from setup.py, in which only the entry points are to be repaired.',
            'kept',
        )
        expect(
            rest == _console_scripts(self.files['setup.py'])[1] and len(entries) == len(self.right),
            'In setup.py, something else is changed than the right sides of entry points:\n' + setup,
            'kept',
        )

    def build(self, learner, repaired: dict[str, str]) -> None:
        """Fail with words if the repaired package cannot be built, or a program does not run."""
        self.check(repaired)  # what is wrong already is not built
        texts = {
            **repaired,
            'package.xml': _PACKAGE_XML.format(package=self.name),
            f'resource/{self.name}': '',
            'setup.cfg': f'[install]\ninstall_scripts=$base/lib/{self.name}\n',
        }
        workspace = learner.workspace({f'src/{self.name}/{name}': text for name, text in texts.items()})
        workspace.build()
        done = workspace.run('bash', '-c', 'for program in "$@"; do ros2 run $0 $program; done', self.name, *self.words)
        for program, word in self.words.items():
            expect(
                f'{program} says {word}' in done.lines,
                f'`ros2 run {self.name} {program}` did not print `{program} says {word}`.',
                'repaired',
            )


def judge_rare_entries(learner) -> None:
    """Entry points whose programs have other names than their modules, in a package with a folder in it.

    One name is written in capitals, one with a hyphen, one ends in py, four modules stand in another folder, three
    right sides name a file, one of them after the colon;
    a function is only another name of one, one is inside of another, one is the end of another name, one that begins
    with `_` can be started as any other, one module begins with its only `def`, one is empty, and two right sides have
    a sign too much.
    """
    random = learner.random
    package, (inner, first, last, empty) = random.choice(PACKAGES), random.sample(PROGRAMS, 4)
    go, other = random.sample(FUNCTIONS, 2)
    files = _rare_files(package, (inner, first, last, empty), go, other)
    entries = [
        (f'{package}.tools.{inner}:{go}', ''),
        (f'{package}.{inner}:{go}', 'module'),
        (f'{package}.tools.{last}:{go}', 'module'),
        (f'tools.{inner}:{go}', 'module'),
        (f'{package}_2.{last}:{go}', 'module'),
        (f'{package}.{first.capitalize()}:{go}', 'module'),
        (f'{package}.{first}-{inner}:{go}', 'module'),
        (f'{package}.{first}_{inner}:{go}', ''),
        (f'{package}.copy:{go}', ''),
        (f'{package}:scripts/{first}', 'file'),
        (f'{package}.{last}.py:{next(one for one in (go, other) if one != "main")}', 'file'),
        (f'{package}.{last}.py', 'file'),
        (f'{package}.{first}:{other}', 'function'),
        (f'{package}.{last}:{other}', 'function'),
        (f'{package}.{last}:{go}', ''),
        (f'{package}.{last}:_{go}', ''),
        (f'{package}.{last}:{go[1:]}', 'function'),
        (f'{package}.{last}::{go}', 'function'),
        (f'{package}.{first}:Task.{go}', 'function'),
        (f'{package}.{empty}:{go}', 'function'),
    ]
    for value, cause in entries:
        program = f'tool{random.randint(10, 99)}'
        text = _SETUP.format(
            package=package, program=program, description='Tools', entries=f"            '{program} = {value}',"
        )
        expected = [('no_program', program, cause, value)] if cause else []
        given = f'The entry point is: {program} = {value}\nThe files are: {", ".join(files)}'
        rule = cause or ('function' if ':_' in value else 'file' if '.copy:' in value else 'module')
        with about(rule):
            got = learner.call('diagnose_package', {**files, 'setup.py': text})
            compare(got, expected, WHY, rule, given)


def _rare_files(package: str, modules: tuple[str, str, str, str], go: str, other: str) -> dict[str, str]:
    """The files of the package of `judge_rare_entries`; `go` is a function, `other` is none."""
    inner, first, last, empty = modules
    return {
        f'{package}/__init__.py': '',
        f'{package}/tools/__init__.py': '',
        f'{package}/tools/{inner}.py': f'def {go}():\n    pass\n',
        f'{package}/{first}.py': f'def {go}():\n    def {other}():\n        pass\n\n    {other}()\n',
        f'{package}/{first}_{inner}.py': f'def {go}():\n    pass\n',
        f'{package}/copy.py': f'def {go}():\n    pass\n',
        f'{package}/{last}.py': f'import math\n\n\ndef {go}():\n    print(math.pi)\n\n\n'
        f'def _{go}():\n    {go}()\n\n\n{other} = {go}\n',
        f'{package}/{empty}.py': '',
    }


def _console_scripts(setup: str) -> tuple[list[str], str]:
    """The entry points of a setup.py, and all the rest of it, as Python reads both.

    :raises SyntaxError, ValueError, RecursionError, MemoryError: Python cannot read it.
    """
    tree = ast.parse(setup)
    entries: list[str] = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Dict):
            for key, value in zip(node.keys, node.values, strict=True):
                if isinstance(key, ast.Constant) and key.value == 'console_scripts' and isinstance(value, ast.List):
                    entries += [str(one.value) for one in value.elts if isinstance(one, ast.Constant)]
                    value.elts = []
    return entries, ast.dump(tree)
