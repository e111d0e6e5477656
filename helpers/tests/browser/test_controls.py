"""What one drives in a notebook, in a real browser: the turtle's arrows."""

import nbformat
import pytest

from helpers.tests.browser import lab

pytestmark = [pytest.mark.timeout(600), pytest.mark.early, *lab.NEEDED]
NOTEBOOK = 'controls.ipynb'
CELLS = {
    'start': """\
import math, sys
import helpers, rclpy
from helpers import TurtleView, background, spin_for, wait_for

helpers.ros.start()""",
    'turtle': """\
code = 'from turtlesim_nodes.simulator import main; main()'
simulator = background([sys.executable, '-c', code], env={'DISPLAY': '', 'WAYLAND_DISPLAY': ''})
view = TurtleView()
wait_for(view.pose, timeout=30);""",
    'east': """\
wait_for(lambda: view.pose().x > 6.5, timeout=60)  # while this runs, somebody presses an arrow
print('it went')""",
    'left': "print('it turned' if view.pose().theta > 0.5 else view.pose())",
    'stop': """\
view.stop()
simulator.stop();""",
}


@pytest.fixture(scope='module')
def learner(browser, tmp_path_factory):
    """Somebody in a notebook with the cells above, which has been run so far as `start`."""
    folder = tmp_path_factory.mktemp('notebooks')
    cells = [nbformat.v4.new_code_cell(source, id=name) for name, source in CELLS.items()]
    kernel = {'kernelspec': {'name': 'python3', 'display_name': 'Python 3'}}  # else JupyterLab asks for one
    nbformat.write(nbformat.v4.new_notebook(cells=cells, metadata=kernel), folder / NOTEBOOK)
    with lab.served(folder, tmp_path_factory.mktemp('jupyter'), NOTEBOOK) as address:
        learner = lab.Learner(browser.new_page(viewport={'width': 1366, 'height': 900}))
        learner.open_notebook(address)
        learner.run('start')
        yield learner
        learner.page.close()


def test_an_arrow_button_drives_the_turtle_while_a_cell_runs_and_a_key_when_the_view_has_the_focus(learner):
    learner.run('turtle')
    view = learner.page.locator('.turtle-view')
    learner.start('east')
    view.get_by_role('button', name='up').click()
    learner.wait_until_ran('east')
    learner.sees('east', 'it went')

    learner.page.keyboard.press('ArrowLeft')  # the button has the focus, and so its view
    learner.page.wait_for_function(_TURNED)
    learner.run('left')
    learner.sees('left', 'it turned')

    learner.run('stop')
    assert view.count() == 0
    learner.output('turtle').locator('img, svg').first.wait_for()


# The view says the heading in degrees.
_TURNED = r"""() => {
    const said = document.querySelector('.turtle-view')?.textContent.match(/theta (-?\d+)°/);
    return said && Number(said[1]) > 60;
}"""
