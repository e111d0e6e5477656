"""What the tests of exercise 2.4 look at: the report, where its numbers come from, and what the packages declare."""

import json
import math
import re

from helpers.checks.chapter_02 import builds
from helpers.runner import about, expect

# Calls main with the library replaced by one that takes down its arguments and returns one value after the other.
_OTHER_LIBRARY = """\
import contextlib, io, json, sys
import wheel_math.geometry as geometry
values, asked, said = json.loads(sys.argv[1]), [], []
def distance(ticks, *rest, **more):
    asked.append(ticks)
    return values[(len(asked) - 1) % len(values)]
geometry.distance = distance
ticks = json.loads(sys.argv[2])
for number in ticks:
    sys.argv[1:] = [str(number)]
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        import odometry.report
        odometry.report.main()
    said.append(printed.getvalue())
print(json.dumps([asked, said]))
"""

_ARGUMENT = re.compile('argv|IndexError|ValueError|argument')


def judge_report(learner, zero: bool = False) -> None:
    """What `ros2 run` prints for some numbers of ticks: rules `argument` and `prints`."""
    workspace = builds.odometry(learner)
    for ticks in (
        (learner.random.choice((0, -learner.random.randint(100, 900))),)
        if zero
        else (360, learner.random.randint(1000, 9000))
    ):
        length = 2 * math.pi * 0.033 * ticks / 360
        with about('prints'):
            done = workspace.run('ros2', 'run', 'odometry', 'report', str(ticks))
        command, last = f'`ros2 run odometry report {ticks}`', done.last_line
        expect("No module named 'wheel_math'" not in last, f'{command} ended with: {last}', 'needs')
        expect(
            'No module named' not in last and 'cannot import name' not in last,
            f'{command} ended with: {last}. The function distance is in the module wheel_math.geometry.',
            'library',
        )
        expect(done.lines, f'{command} printed nothing.', 'prints')
        expect(
            "can't multiply sequence" not in last and 'must be real number' not in last,
            f'{command} ended with: {last}. What stands in sys.argv is text: make a number of it with int().',
            'argument',
        )
        expect(done.status == 0, f'{command} ended with: {last}', 'argument' if _ARGUMENT.search(last) else 'prints')
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
        expect(last != wanted.split()[0], f'{command} printed {last}, without the unit; expected {wanted}.', 'prints')
        expect(
            last == wanted or not _written_otherwise(last, length),
            f'{command} printed {last}; expected {wanted}: three decimals, a space and m.',
            'prints',
        )
        expect(last == wanted, f'{command} printed {last}; expected {wanted}.', 'library')


def judge_library(learner) -> None:
    """The report says what distance of wheel_math returns for the ticks: rules `library`, `argument`, `prints`."""
    values = [learner.random.randint(11, 99) / 10 for _ in range(2)]
    ticks = [learner.random.randint(100, 900), learner.random.randint(1000, 9000)]
    with about('library'):
        done = builds.odometry(learner).run('python3', '-c', _OTHER_LIBRARY, json.dumps(values), json.dumps(ticks))
    expect(
        "No module named 'wheel_math'" not in done.last_line,
        'Python does not find wheel_math: it was not built, because odometry does not say that it needs it.',
        'needs',
    )
    expect(
        done.status == 0,
        f'The program ended with: {done.last_line}',
        'argument' if _ARGUMENT.search(done.last_line) else 'library',
    )
    asked, said = json.loads(done.lines[-1])
    said = [text.strip() for text in said]
    expect(
        asked,
        'The report does not come from the library: call distance of wheel_math.geometry, and do not compute '
        'the distance again.',
        'library',
    )
    expect(
        all(number in ticks for number in asked),
        f'With {ticks[0]}, and then {ticks[1]} ticks on the command line, your program asks distance for '
        f'{", then ".join(map(repr, asked))}.',
        'argument',
    )
    more = next((text for text in said if len(text.splitlines()) > 1), '')
    expect(not more, f'main prints {len(more.splitlines())} lines; expected the distance only.', 'prints')
    wanted = [f'{value:.3f} m' for value in values]
    for value, text, right in zip(values, said, wanted, strict=False):
        expect(text, 'The function main printed nothing: use print.', 'prints')
        expect(
            text == right or not _written_otherwise(text, value),
            f'Where distance returns {value}, your program prints {text}; expected {right}: three decimals, a space '
            'and m.',
            'prints',
        )
    expect(
        said == wanted,
        f'Where distance returns {values[0]}, and then {values[1]}, your program prints '
        f'{", then ".join(said)}; expected {", then ".join(wanted)}. Do not compute the distance '
        'again.',
        'library',
    )


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
    with about('needs'):
        declared = builds.dependencies(learner, 'ODOMETRY_XML')
    mine = {tag for tag, names in declared.items() if 'wheel_math' in names}
    names = _needed(declared)
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
    more = names - {'wheel_math'}
    expect(
        not more, f'odometry declares {", ".join(sorted(more))}, and its code imports nothing of it.', 'nothing-else'
    )


def judge_alone(learner) -> None:
    """wheel_math declares nothing: rule `nothing-else`."""
    with about('nothing-else'):
        needed = _needed(builds.dependencies(learner, 'WHEEL_MATH_XML'))
    expect(
        'odometry' not in needed,
        'wheel_math declares odometry, and needs nothing of it. If each needs the other '
        'one, neither can be built first.',
        'order',
    )
    expect(not needed, f'wheel_math declares {", ".join(sorted(needed))}, and needs nothing of it.', 'nothing-else')


def judge_types(learner) -> None:
    """The build type of both packages is ament_python: rule `build-type`."""
    for name in ('WHEEL_MATH_XML', 'ODOMETRY_XML'):
        with about('build-type'):
            found = builds.build_type(learner, name)
        expect(
            found == 'ament_python',
            f'The build type in {name} is {found or "not given"}, expected ament_python.',
            'build-type',
        )


def _written_otherwise(text: str, value: float) -> bool:
    """Whether a text holds this number (m) with other decimals or in another unit."""
    number = re.search(r'-?\d+\.?\d*', text)
    return bool(number) and any(
        math.isclose(float(number[0]), value * factor, abs_tol=0.06 * factor, rel_tol=1e-9) for factor in (1, 100, 1000)
    )


def _needed(declared: dict[str, set[str]]) -> set[str]:
    """All that is declared, except for tests and tools."""
    return set().union(
        *(
            names
            for tag, names in declared.items()
            if tag.endswith('depend') and tag not in ('test_depend', 'doc_depend', 'buildtool_depend')
        )
    )
