"""A cell in which its learner also tries the answer: the answer is judged, whatever becomes of the trial."""

import pytest

from helpers.exercises.notebooks import NotebookCell
from helpers.runner import session
from helpers.tests import small

HELPERS = NotebookCell('from helpers import background, spin_for, spinning, wait_for', 1)
ONE_TALKER = '''
def test_talker(learner):
    """One node, one publisher."""
    heard = learner.listen('/chatter', String)
    learner.start('Talker')
    learner.run(2.2)
    expect(heard.data[:3] == ['0', '1', '2'], f'{heard.data} came.')
    count = len(learner.endpoints('/chatter').publishers)
    expect(count == 1, f'{count} publishers')
'''


OTHER = """class Echo(Node):
    def __init__(self):
        super().__init__('echo')
        self.publisher = self.create_publisher(String, 'chatter', 10)

"""


@pytest.mark.parametrize(
    'trial',
    [
        'mine = Talker()',
        'mine = [Talker(), Talker()]',
        'mine = Talker()\nwith spinning(mine):\n    spin_for(1)\nassert mine.count == 2',
        'heard = []\nwith spinning(Talker()):\n    wait_for(lambda: heard)\nprint(heard[0])',
        'simulator = background("sleep 60")\nprint(simulator.nothing)',
        'mine = Talker()\nmine.nothing()\nmine.destroy_node()',
        'mine = Talker()\nfor _ in range(5):\n    mine.tick()\nmine.destroy_node()',
        'kept = {"mine": Talker()}',
        f'{OTHER}echo = Echo()',
        'rclpy.spin(Talker())',
    ],
)
def test_a_trial_below_the_answer_costs_nothing(tmp_path, trial):
    cells = [HELPERS, *small.cells(f'{small.TALKER}\n{trial}\n')]
    options = session.Options(visible=small.write_tests(tmp_path, ONE_TALKER))
    report = session.run(cells, [small.exercise()], options)
    (test,) = report.exercises[0].tests
    assert test.verdict == 'passed', test.message


def test_a_trial_between_two_names_of_the_answer_costs_nothing(tmp_path):
    cells = small.cells(f'{small.TALKER}\nmine = Talker()\n\n\nclass Ear:\n    pass\n')
    options = session.Options(visible=small.write_tests(tmp_path, ONE_TALKER))
    (result,) = session.run(cells, [small.exercise(names=('Talker', 'Ear'))], options).exercises
    assert result.tests[0].verdict == 'passed', result.tests[0].message


def test_what_the_answer_is_made_of_is_no_trial(tmp_path):
    """An error above the answer, or in a function that it needs, is told."""
    cells = small.cells(f'1 / 0\n{small.TALKER}')
    report = session.run(cells, [small.exercise()], session.Options(visible=small.write_tests(tmp_path, ONE_TALKER)))
    assert 'ZeroDivisionError' in report.exercises[0].tests[0].message
