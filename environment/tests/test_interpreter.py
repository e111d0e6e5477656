"""The choice of the Python that the environment is made from."""

import sys

import pytest

from environment.setup import interpreter
from environment.setup.errors import PreflightError
from environment.setup.interpreter import Interpreter, choose
from environment.setup.underlay import Underlay


def python(command, version=(3, 12, 1), *, venv=True, headers=True, cpython=True):
    return Interpreter(command, command, version, cpython, 64, venv, headers)


def machine(*pythons):
    """A probe for a machine that has just these."""
    return {p.command: p for p in pythons}.get


RUNNING = sys.executable


def test_the_systems_comes_first():
    chosen = choose({}, Underlay(), machine(python('/usr/bin/python3', (3, 11, 2)), python(RUNNING)))
    assert chosen.command == '/usr/bin/python3'


@pytest.mark.parametrize(
    'unfit',
    [
        python('/usr/bin/python3', (3, 9, 1)),
        python('/usr/bin/python3', (3, 14, 0)),
        python('/usr/bin/python3', venv=False),
        python('/usr/bin/python3', headers=False),
        python('/usr/bin/python3', cpython=False),
    ],
)
def test_an_unfit_system_python_is_passed_over(unfit):
    assert choose({}, Underlay(), machine(unfit, python(RUNNING))).command == RUNNING
    assert choose({}, Underlay(), machine(unfit, python('python3.10', (3, 10, 0)))).command == 'python3.10'


def test_course_python_wins_and_what_is_wrong_with_it_is_told():
    both = machine(python('/usr/bin/python3'), python('/my/python', headers=False))
    with pytest.raises(PreflightError, match='headers'):
        choose({'COURSE_PYTHON': '/my/python'}, Underlay(), both)
    with pytest.raises(PreflightError, match='not a Python that can be run'):
        choose({'COURSE_PYTHON': '/no/python'}, Underlay(), both)


def test_the_remedy_for_the_systems_python_is_an_apt_line():
    with pytest.raises(PreflightError) as error:
        choose({}, Underlay(), machine(python('/usr/bin/python3', venv=False, headers=False)))
    assert 'apt install python3.12-venv python3.12-dev' in error.value.remedy


def test_only_wrong_versions():
    with pytest.raises(PreflightError, match=r'Python 3\.9, the course needs 3\.10-3\.13'):
        choose({}, Underlay(), machine(python('/usr/bin/python3', (3, 9, 2))))
    with pytest.raises(PreflightError, match='no Python'):
        choose({}, Underlay(), machine())


def test_a_stock_ros_decides(stock):
    ros = Underlay((stock('jazzy', 'rclpy', python='python3.12'),))
    chosen = choose({}, ros, machine(python('/usr/bin/python3', (3, 11, 2)), python('/usr/bin/python3.12')))
    assert chosen.command == '/usr/bin/python3.12'
    with pytest.raises(PreflightError, match='was not found'):
        choose({}, ros, machine(python('/usr/bin/python3', (3, 11, 2))))


def test_probe_tells_the_truth_of_this_interpreter():
    found = interpreter.probe(RUNNING)
    assert found.version == sys.version_info[:3]
    assert found.complete


def test_probe_survives_a_broken_interpreter(tool):
    assert interpreter.probe(str(tool('python3', 'exit 3') / 'python3')) is None
    assert interpreter.probe('/no/such/python') is None
