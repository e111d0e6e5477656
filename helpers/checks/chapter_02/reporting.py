"""What the tests of exercise 2.4 look at: the report, where its numbers come from, and what the packages declare."""

import ast
import math
import re
import sys

from helpers.checks.chapter_02 import builds
from helpers.runner import about, expect
from helpers.runner.workspaces import Done

# The library for a moment: it knows some numbers of ticks only, and for each of them a value of its own.
_OTHER_LIBRARY = """\
def distance(ticks, *rest, **more):
    try:
        return {values}[ticks]
    except (KeyError, TypeError):
        raise LookupError(f'distance was asked for {{ticks!r}}') from None
"""
# A command behind these words prints without what it writes on the standard error.
_WITHOUT_ERRORS = ('bash', '-c', 'exec "$@" 2>/dev/null', 'bash')
# The ticks stand on the command line before the import, or come onto it later. It stays the same list, for those who
# have another name for it. Then another number takes their place, and main is called once more.
_CALLED = """\
import sys

later = sys.argv.pop() == 'later'
ticks = [sys.argv.pop()] if later else []
from odometry import report

sys.argv.extend(ticks)
report.main()
sys.stdout.flush()
sys.argv[-1] = {other!r}
report.main()
"""
_RETURNED = (
    'ended with an error, and its last words are your text: what main returns, but for None and 0, is an error of the '
    'program. Use print, and let main return nothing.'
)
_PACKAGES = {'cv2': 'opencv', 'sklearn': 'scikit_learn'}  # modules whose packages have other names
_ARGUMENT = re.compile('argv|IndexError|ValueError|argument')
_FORMAT = re.compile('format code|format specifier')
_PROGRAM = re.compile(r"invalid literal for int\(\).*: '[^']*(/report(\.py)?|-c)'")


def _distance(ticks: int) -> float:
    """What the given library returns (m)."""
    return 2 * math.pi * 0.033 * ticks / 360


def _judge_error(done, command: str, last: str, rule: str) -> None:
    """The command has not ended with an error, `last`; `rule`: the one that is broken if the error tells no other."""
    ended = f'{command} ended {done.where}with: {last}'
    expect(
        done.status == 0 or not _FORMAT.search(last),
        f'{ended.rstrip(".")}. What stands behind the colon in the braces is the form of the number: .3f for three '
        'decimals.',
        'prints',
    )
    expect(
        done.status == 0 or not _PROGRAM.search(last),
        f'{ended.rstrip(".")}. sys.argv[0] is the program itself; what stands behind it on the command line begins '
        'with sys.argv[1].',
        'argument',
    )
    expect(done.status == 0, ended, 'argument' if _ARGUMENT.search(last) else rule)


def _judge_distance(workspace, ticks: int, silent: tuple[str, ...]) -> None:
    """What `ros2 run` prints for this number of ticks; `silent`: before its command, a command that hides errors."""
    length = _distance(ticks)
    with about('prints'):
        done = workspace.run(*silent, 'ros2', 'run', 'odometry', 'report', str(ticks))
    command, last = f'`ros2 run odometry report {ticks}`', done.last_line
    expect("No module named 'wheel_math'" not in last, f'{command} ended with: {last}', 'needs')
    expect(
        'No module named' not in last and 'cannot import name' not in last,
        f'{command} ended with: {last}. The function distance is in the module wheel_math.geometry.',
        'library',
    )
    expect(
        done.lines,
        f'{command} printed nothing{" on the standard output, where print() writes" if silent else ""}.',
        'prints',
    )
    expect(
        "can't multiply sequence" not in last and 'must be real number' not in last,
        f'{command} ended with: {last}. What stands in sys.argv is text: make a number of it with int().',
        'argument',
    )
    expect(done.status == 0 or last != f'{length:.3f} m', f'{command} {_RETURNED}', 'prints')
    _judge_error(done, command, last, 'prints')
    expect(
        len(done.lines) == 1,
        f'{command} printed {len(done.lines)} lines; expected the distance only. The last one is: {last}',
        'prints',
    )
    wanted = f'{length:.3f} m'
    expect(
        last != f'{2 * math.pi * 0.033:.3f} m' or ticks == 360,
        f'{command} printed {last}, as for 360 ticks: the number must come from the command line.',
        'argument',
    )
    expect(
        ticks >= 0 or last != f'{-length:.3f} m',
        f'{command} printed {last}; expected {wanted}. Backwards the ticks are negative, and so is the distance.',
        'argument',
    )
    expect(last != wanted.split()[0], f'{command} printed {last}, without the unit; expected {wanted}.', 'prints')
    expect(
        last == wanted or not _written_otherwise(last, length) or re.fullmatch(r'-?\d+\.\d{3} m', last),
        f'{command} printed {last}; expected {wanted}: three decimals, a space and m.',
        'prints',
    )
    expect(last == wanted, f'{command} printed {last}; expected {wanted}, as distance returns it.', 'library')
    _judge_line(command, done, wanted)


def _judge_line(command: str, done: Done, wanted: str) -> None:
    """What stands before the right text, and behind it: nothing, and the end of the line."""
    expect(
        done.output.endswith('\n'),
        f'{command} printed {wanted} without the end of the line, so what comes next stands behind it: leave out '
        "`end=''` of print, or write '\\n' at the end.",
        'prints',
    )
    empty = len(done.output.splitlines()) - len(done.lines)
    expect(
        not empty,
        f'{command} printed {wanted}, and {empty} empty {"line" if empty == 1 else "lines"}: the distance is the only '
        "line. Look for a print() with nothing in it, and for a '\\n' too many.",
        'prints',
    )
    printed = next(line for line in done.output.splitlines() if line.strip() == wanted)
    expect(
        not printed.startswith(wanted) or printed == wanted,
        f'{command} printed {printed!r}: a space stands behind the unit. Expected {wanted!r}.',
        'prints',
    )
    expect(
        printed == wanted,
        f'{command} printed {printed!r}: spaces stand before the number. Expected {wanted!r}. A format such as '
        '`8.3f` fills a number up with spaces, `.3f` does not.',
        'prints',
    )


def _rounded_away(random, least: int, most: int) -> int:
    """A number of ticks whose distance has more behind its third decimal than half a millimetre.

    Who cuts the other decimals off gets another one.
    """
    while True:
        ticks = random.randint(least, most)
        if 0.55 < _distance(ticks) * 1000 % 1 < 0.95:
            return ticks


def judge_report(learner, zero: bool = False) -> None:
    """What `ros2 run` prints for some numbers of ticks: rules `argument` and `prints`."""
    workspace = builds.odometry(learner)
    first = learner.random.choice((0, -_rounded_away(learner.random, 100, 900))) if zero else 360
    # So far a wheel has turned after a day; a thousand metres may be written as 1,000.
    for ticks, silent in ((first, ()), (_rounded_away(learner.random, 5_000_000, 9_000_000), _WITHOUT_ERRORS)):
        _judge_distance(workspace, ticks, silent)
    with about('prints'):
        done = workspace.run('python3', '-c', 'import odometry.report', str(first))
    expect(
        done.status == 0 and not done.lines,
        f'`import odometry.report` already does something, and says: {done.last_line}. Only the function main reads '
        'the command line and prints.',
        'prints',
    )


def judge_call(learner) -> None:
    """main reads the command line as it is when main is called: rule `argument`."""
    workspace = builds.odometry(learner)
    ticks, other = learner.random.randint(100, 300), learner.random.randint(400, 900)
    program = _CALLED.format(other=str(other))
    with about('argument'):
        before, later = (workspace.run(str(ticks), when, program=program) for when in ('before', 'later'))
        expect(
            before.status != 0 or before.lines[:1] == later.lines[:1],  # what is wrong in both: see the other tests
            f'A program has imported odometry.report, and then called main with {ticks} on the command line. It '
            f'ended with: {later.last_line}; expected {"".join(before.lines[:1])}, as when the number is there '
            'before the import. Read sys.argv inside of main: what stands outside of a function is done once, when the '
            'module is imported.',
        )
        expect(
            len(later.lines) != 2 or later.lines[0] != later.lines[1],
            f'A program has called main with {ticks} on the command line, and then once more with {other}: both times '
            f'it printed {later.last_line}. Read sys.argv each time main is called, and keep nothing of '
            'the call before.',
        )


def judge_library(learner) -> None:
    """The report says what distance of wheel_math returns for the ticks: rules `library`, `argument`, `prints`."""
    random = learner.random
    ticks = [random.randint(100, 900), -random.randint(10**10, 10**11)]  # a number may have many digits
    values = dict(zip(ticks, (random.randint(11, 99) / 10, -random.randint(11, 99) / 10 - 10), strict=True))
    random.shuffle(ticks)
    for number, done in zip(ticks, _with_library(learner, _OTHER_LIBRARY.format(values=values), ticks), strict=True):
        last, value = done.last_line, values[number]
        told = f'With {number} on the command line'
        asked = re.search('distance was asked for (.*)', last)
        expect(not asked, f'{told}, your program asks distance for {asked and asked[1]}.', 'argument')
        wanted = f'{value:.3f} m'
        expect(done.status == 0 or last != wanted, f'{told}, the program {_RETURNED}', 'prints')
        _judge_error(done, 'The program', last, 'library')
        expect(len(done.lines) < 2, f'main prints {len(done.lines)} lines; expected the distance only.', 'prints')
        expect(done.lines, 'The function main printed nothing: use print.', 'prints')
        formula = _distance(number)
        told = f'{told} and where distance returns {value}, your program prints {last}; expected {wanted}'
        expect(
            last == wanted or not _written_otherwise(last, value) or _written_otherwise(last, formula),
            f'{told}: three decimals, a space and m.',
            'prints',
        )
        expect(
            last != f'{-value:.3f} m',
            f'{told}. Print what distance returns, with its sign: backwards the ticks are negative, and so is the '
            'distance.',
            'library',
        )
        expect(
            last == wanted,
            f'{told}: call distance of wheel_math.geometry, and do not compute the distance again.',
            'library',
        )
    (alone,) = _with_library(learner, '', ticks[:1])
    expect(
        not re.fullmatch(r'-?[\d.]+ m', alone.last_line),
        f'Where the module wheel_math.geometry has no function distance, your program prints {alone.last_line} all the '
        'same: it computes nothing itself, and ends with an error then.',
        'library',
    )


def _with_library(learner, text: str, ticks: list[int]) -> list[Done]:
    """What `report` does for these ticks while the installed library is another one."""
    workspace = builds.odometry(learner)
    installed = [name for name in workspace.installed() if name.endswith('-packages/wheel_math/geometry.py')]
    expect(
        installed,
        'Python does not find wheel_math: it was not built, because odometry does not say that it needs it.',
        'needs',
    )
    file = f'install/{installed[0]}'
    with about('library'):
        try:
            workspace.run('bash', '-c', 'printf %s "$2" >"$1"', 'bash', file, text)
            return [workspace.run('ros2', 'run', 'odometry', 'report', str(number)) for number in ticks]
        finally:
            workspace.run('cp', 'src/wheel_math/wheel_math/geometry.py', file)


def judge_order(learner) -> None:
    """colcon builds wheel_math, then odometry: rules `needs` and `order`."""
    done = builds.odometry(learner).build('--packages-up-to', 'odometry')
    order = re.findall(r'Finished <<< (\w+)', done.output)
    expect(
        'wheel_math' in order,
        'Only odometry was built. Its package.xml does not say that it needs wheel_math.',
        'needs',
    )
    expect(
        order == ['wheel_math', 'odometry'],
        f'The build finished {", then ".join(order)}; expected wheel_math, then odometry.',
        'order',
    )


def judge_needs(learner) -> None:
    """odometry declares wheel_math for run time, and nothing else: rules `needs` and `nothing-else`."""
    root = builds.package_xml(learner, 'ODOMETRY_XML')
    with about('needs'):
        declared = builds.declared(root)
    mine = {tag for tag, names in declared.items() if 'wheel_math' in names}
    names = builds.needed(declared, elsewhere=True)
    module = [name for name in names if name.startswith('wheel_math.')]
    expect(
        not module,
        f'`{module and module[0]}` names a Python module. A dependency is a ROS package: wheel_math.',
        'needs',
    )
    expect(
        'wheel_math' in builds.to_run(declared),
        f'wheel_math is declared as {", ".join(sorted(mine)) or "nothing"}. It is imported when the program runs, '
        'so it must be an exec_depend or a depend.',
        'needs',
    )
    imported = _imported(learner.text('REPORT_PY'))
    lacking = sorted(module for module in imported if not any(_names(name, module) for name in builds.to_run(declared)))
    expect(
        not lacking,
        f'report.py imports {lacking and lacking[0]}, and package.xml of odometry does not declare it, so on a fresh '
        'machine it is missing. Take the import away if nothing needs it; else declare its package as an exec_depend.',
        'needs',
    )
    more = {name for name in names - {'wheel_math'} if not any(_names(name, module) for module in imported)}
    expect(
        not more, f'odometry declares {", ".join(sorted(more))}, and its code imports nothing of it.', 'nothing-else'
    )


def _imported(text: str) -> set[str]:
    """The modules that a Python file must have and that neither Python nor the two packages bring along."""
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return set()  # running it says so
    perhaps = {id(node) for one in ast.walk(tree) if isinstance(one, ast.Try) for node in ast.walk(one)}
    found = set()
    for node in ast.walk(tree):
        if id(node) in perhaps:  # it may do without
            continue
        if isinstance(node, ast.Import):
            found |= {alias.name.partition('.')[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            found.add(node.module.partition('.')[0])
    return found - sys.stdlib_module_names - {'wheel_math', 'odometry'}


def _names(package: str, module: str) -> bool:
    """Whether a package of package.xml brings this module: one of ROS, or one of Python, such as python3-yaml."""
    plain = package.lower().removeprefix('python3-').replace('-', '_')
    return plain.removesuffix('_modules') in (module.lower(), _PACKAGES.get(module))


def judge_alone(learner) -> None:
    """wheel_math declares nothing: rule `nothing-else`."""
    root = builds.package_xml(learner, 'WHEEL_MATH_XML')
    with about('nothing-else'):
        needed = builds.needed(builds.declared(root), elsewhere=True)
    expect(
        'odometry' not in needed,
        'wheel_math declares odometry, and needs nothing of it. If each needs the other '
        'one, neither can be built first.',
        'order',
    )
    expect(not needed, f'wheel_math declares {", ".join(sorted(needed))}, and needs nothing of it.', 'nothing-else')


def _written_otherwise(text: str, value: float) -> bool:
    """Whether a text holds this number (m) with other decimals or in another unit."""
    number = re.search(r'-?\d+\.?\d*', text.replace(',', ''))
    return bool(number) and any(
        math.isclose(float(number[0]), value * factor, abs_tol=0.06 * factor, rel_tol=1e-9) for factor in (1, 100, 1000)
    )
