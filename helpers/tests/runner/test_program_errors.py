"""What is said of the problems that a learner's process reports: which of the learner's lines are named."""

import pytest

from helpers.runner.program_errors import ProgramErrors, hanging

GIVEN = {'cell': 'Exercise 8.8', 'line': 11, 'function': 'drive', 'code': 'command.linear.x = forward'}
ANSWER = {'cell': 'Exercise 8.9', 'line': 33, 'function': 'execute', 'code': 'self.drive(0, 0)'}
EARLIER = {**ANSWER, 'line': 20, 'code': 'self.finish(goal)'}


def said(lines, **problem):
    errors = ProgramErrors('Exercise 8.9', {}, '')
    problem = {
        'kind': 'exception',
        'where': 'execute',
        'type': 'ZeroDivisionError',
        'text': 'division by zero',
    } | problem
    return str(errors.of({**problem, 'lines': lines}, {}))


@pytest.mark.parametrize(
    ('lines', 'place'),
    [
        ([EARLIER, ANSWER], ' at Exercise 8.9, line 33.'),
        ([EARLIER, ANSWER, GIVEN], ' at Exercise 8.8, line 11, called from Exercise 8.9, line 33: `self.drive(0, 0)`.'),
        ([GIVEN, ANSWER], ' at Exercise 8.9, line 33.'),  # a given function that has called the answer's
        ([GIVEN], ' at Exercise 8.8, line 11.'),
        ([], 'division by zero.'),
    ],
)
def test_the_line_of_the_exercise_is_named_if_another_cell_has_raised_it(lines, place):
    assert said(lines).endswith(place)


def test_a_wait_in_another_cell_names_the_line_of_the_exercise():
    told = said([ANSWER, GIVEN], kind='sleeps')
    assert 'at Exercise 8.8, line 11: `command.linear.x = forward`, called from Exercise 8.9, line 33: `self.' in told
    assert 'called from' not in said([ANSWER], kind='sleeps')
    assert 'called from Exercise 8.9, line 33' in said([ANSWER, GIVEN], kind='waits', call='rclpy.spin')


def test_a_loop_that_stands_in_another_cell_names_the_line_of_the_exercise():
    told = str(hanging('call', 6.0, {'name': 'triage'}, [ANSWER, GIVEN], 'Exercise 8.9'))
    assert 'It was still at Exercise 8.8, line 11: `command.linear.x = forward`, called from Exercise 8.9, li' in told
    assert 'called from' not in str(hanging('call', 6.0, {'name': 'triage'}, [GIVEN, ANSWER], 'Exercise 8.9'))
    assert 'It was still' not in str(hanging('call', 6.0, {'name': 'triage'}, [], 'Exercise 8.9'))


def test_functions_of_other_cells_and_the_lines_are_looked_at():
    cells = ['def steer(x, y):\n    pass']
    errors = ProgramErrors('Exercise 8.9', {}, 'class Own(Base):\n    def go(self):\n        self.steer(1, 2)', cells)
    problem = {'kind': 'exception', 'type': 'AttributeError', 'text': "'Own' object has no attribute 'steer'"}
    assert str(errors.of({**problem, 'lines': [ANSWER]}, {})).endswith('write it without `self.`.')
    problem['text'] = "'function' object has no attribute 'info'"
    line = {**ANSWER, 'code': "self.get_logger.info('x')"}
    assert 'self.get_logger().info(…)' in str(errors.of({**problem, 'lines': [EARLIER, line]}, {}))
