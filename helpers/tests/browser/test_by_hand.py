"""What one drives in a notebook, in a real browser: the turtle's arrows, sliders, a view whose block has ended."""

import nbformat
import pytest

from helpers.tests.browser import lab
from helpers.tests.browser.drawn import DRAWN

pytestmark = [pytest.mark.timeout(600), pytest.mark.early, *lab.NEEDED]
NOTEBOOK = 'controls.ipynb'
CELLS = {
    'start': """\
import sys
import helpers, rclpy
from geometry_msgs.msg import TransformStamped
from helpers import Sliders, TfView, TurtleView, background, wait_for
from tf2_ros import StaticTransformBroadcaster

helpers.ros.start();""",
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
    'sliders': """\
node = rclpy.create_node('artist')
broadcaster = StaticTransformBroadcaster(node)

def move(x, y):
    message = TransformStamped(child_frame_id='cup')
    message.header.frame_id = 'world'
    message.transform.rotation.w = 1.0
    message.transform.translation.x, message.transform.translation.y = float(x), float(y)
    broadcaster.sendTransform(message)
    return f'the cup is at {x}, {y}'

Sliders(move, node, x=(0, 5), y=(0, 5))""",
    'block': """\
with TfView() as view:
    wait_for(lambda: 'cup' in view.frames)""",
    'next': """\
with TfView(frames=False):
    pass
node.destroy_node()""",
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


def test_a_slider_calls_its_function_and_a_view_can_be_turned_after_its_block_until_the_next(learner):
    page = learner.page
    learner.run('sliders')
    learner.sees('sliders', 'the cup is at 0, 0')
    learner.output('sliders').locator('.noUi-handle').first.press('ArrowRight')
    learner.sees('sliders', 'the cup is at 1, 0')

    learner.run('block')
    drawing = learner.output('block').frame_locator('iframe').locator('#pane canvas')
    drawing.wait_for()
    frame = drawing.element_handle().owner_frame()
    frame.wait_for_function('document.body.classList.contains("ended")')  # the page came after the end of the block
    before = frame.evaluate(DRAWN)
    box = drawing.bounding_box()
    page.mouse.move(box['x'] + box['width'] / 2, box['y'] + box['height'] / 2)
    page.mouse.down()
    page.mouse.move(box['x'] + box['width'] / 2 + 80, box['y'] + box['height'] / 2 + 30, steps=3)
    page.mouse.up()
    assert frame.evaluate(DRAWN) != before

    learner.run('next')
    assert learner.output('block').locator('iframe').count() == 0
    learner.output('block').locator('img, svg').first.wait_for()
    assert learner.output('sliders').locator('.noUi-handle').count() == 0
    learner.sees('sliders', 'the cup is at 1, 0')


# The view says the heading in degrees.
_TURNED = r"""() => {
    const said = document.querySelector('.turtle-view')?.textContent.match(/theta (-?\d+)°/);
    return said && Number(said[1]) > 60;
}"""
