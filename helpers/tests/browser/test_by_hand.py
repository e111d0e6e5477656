"""What one does by hand, in a real browser: drive the turtle by its arrows, move a slider, turn a view whose block has
ended, write a file in a cell, make a package in a terminal, and go on with the capstone after a restarted kernel."""

import json
import re

import nbformat
import pytest

from helpers import paths
from helpers.tests.browser import jupyterlab
from helpers.tests.browser.drawn import DRAWN

pytestmark = [pytest.mark.timeout(600), pytest.mark.early, *jupyterlab.NEEDED]
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
    'left': "print('it turned' if view.pose().theta > 0.05 else view.pose())",
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
    'plot': "print('a line of words')\nhelpers.figure().plot([0, 1]);",
    'file': '',
}
# What somebody types into a cell: a file with a mistake in its second line, and the same without it.
WRONG = """\
%%answer CONFIG config/robot.yaml
/**:
  ros__parameters: low: 0.25"""
RIGHT = WRONG.replace(': low', ':\n    low')


@pytest.fixture(scope='module')
def folder(tmp_path_factory):
    """The chapters, and a notebook with the cells above."""
    folder = jupyterlab.copy_notebooks(tmp_path_factory.mktemp('notebooks'))
    cells = [nbformat.v4.new_code_cell(source, id=name) for name, source in CELLS.items()]
    kernel = {'kernelspec': {'name': 'python3', 'display_name': 'Python 3'}}  # else JupyterLab asks for one
    nbformat.write(nbformat.v4.new_notebook(cells=cells, metadata=kernel), folder / NOTEBOOK)
    return folder


@pytest.fixture(scope='module')
def address(folder, tmp_path_factory):
    """One server for all of these tests: the address of that notebook."""
    with jupyterlab.served(folder, tmp_path_factory.mktemp('jupyter'), NOTEBOOK) as address:
        yield address


@pytest.fixture(scope='module')
def newcomer(browser):
    """Makes somebody at the keyboard, who has opened nothing yet."""
    made = []

    def make():
        made.append(jupyterlab.Learner(browser.new_page(viewport={'width': 1366, 'height': 900})))
        return made[-1]

    yield make
    for learner in made:
        learner.page.close()


@pytest.fixture(scope='module')
def learner(newcomer, address):
    """Somebody in that notebook, of which `start` has been run."""
    learner = newcomer()
    learner.open_notebook(address)
    learner.run('start')
    return learner


@pytest.mark.one_of(16, group=0, of='what costs most')
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


@pytest.mark.one_of(16, group=1, of='what costs most')
def test_a_slider_calls_its_function_and_a_view_can_be_turned_after_its_block_until_the_next_view(learner):
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
    learner.run('plot')  # a cell in between changes nothing
    learner.output('block')
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


@pytest.mark.one_of(16, group=0, of='what costs most')
def test_a_plot_has_no_background_on_a_dark_page_and_lines_break_between_words(learner):
    learner.run('plot')
    plot = learner.output('plot').locator('img')
    plot.wait_for()
    learner.page.evaluate(_DARK)
    assert plot.evaluate('plot => getComputedStyle(plot).backgroundColor') == 'rgba(0, 0, 0, 0)'
    words = learner.output('plot').locator('pre').first
    assert words.evaluate('pre => getComputedStyle(pre).wordBreak') == 'normal'


@pytest.mark.one_of(16, group=1, of='what costs most')
def test_a_cell_with_a_file_tells_a_mistake_with_its_line_and_writes_the_file(learner, folder):
    (folder / 'config').mkdir()
    for text in (WRONG, RIGHT):
        learner.write('file', text)
        learner.page.wait_for_function(_COLOURED)
        learner.run('file')
        learner.sees('file', 'Written: config/robot.yaml')
        written = (folder / 'config/robot.yaml').read_text()
        assert written == text.partition('\n')[2] + '\n'
        if text == WRONG:
            learner.sees('file', 'config/robot.yaml, line 2: mapping values are not allowed here')
    assert learner.output('file').inner_text().strip() == 'Written: config/robot.yaml'
    shown = learner.add('print(CONFIG)')
    learner.sees(shown, 'low: 0.25')
    learner.write('file', RIGHT.replace('%%answer CONFIG', '%%writefile'))  # a file of the lesson has colours, too
    learner.page.wait_for_function(_COLOURED)


# Whether the course's own language colours the active cell, and a key of YAML has a colour.
_COLOURED = """() => {
    const cell = window.jupyterapp.shell.currentWidget.content.activeCell;
    return cell.model.mimeType === 'text/x-ros2-course-answers'
        && [...cell.node.querySelectorAll('.cm-line span')].some(span => span.textContent.includes('ros__parameters'));
}"""
# The view says the heading in degrees. How far a press turns it depends on how busy the machine is.
# As JupyterLab marks a dark theme, without its colours.
_DARK = "() => { document.body.dataset.jpThemeLight = 'false'; }"

_TURNED = r"""() => {
    const said = document.querySelector('.turtle-view')?.textContent.match(/theta (-?\d+)°/);
    return said && Number(said[1]) > 5;
}"""


SOLVED = paths.ROOT / 'solutions'
needs_solutions = pytest.mark.skipif(not SOLVED.is_dir(), reason="the learner's edition has no solutions")
# What a learner types, with the files of the solution: see `written`.
COMMANDS = """\
mkdir -p my_ws/src
cd my_ws/src
ros2 pkg create --build-type ament_python --license Apache-2.0 --dependencies rclpy std_msgs -- patrol > ../created.txt
rm -r patrol/test
mkdir patrol/config patrol/test
{files}
cd ..
colcon build --packages-select patrol
echo $? > status.txt
mv status.txt done.txt
"""


def solution(chapter: str) -> dict[str, str]:
    """The sources of a solved chapter by cell id."""
    cells = json.loads((SOLVED / f'{chapter}.ipynb').read_text())['cells']
    return {cell['id']: ''.join(cell['source']) for cell in cells}


def written(package: dict[str, str]) -> str:
    """The lines that write these files of a package in a shell."""
    return '\n'.join(f"cat > 'patrol/{path}' <<'END'\n{text.rstrip()}\nEND" for path, text in package.items())


@pytest.mark.one_of(16, group=4, of='what costs most')
def test_a_second_terminal_is_opened_beside_the_first(newcomer, address, folder):
    learner, shells = newcomer(), []
    # A notebook that no other test changes: else a dialog about that may cover the terminals.
    learner.open_notebook(address.replace(NOTEBOOK, '01_environment.ipynb'))
    for name in ('first', 'second'):
        learner.open_terminal()
        learner.type_lines(f'tty > {name}.tmp && mv {name}.tmp {name}.txt')
        jupyterlab.wait_for_file(folder / f'{name}.txt')
        shells.append((folder / f'{name}.txt').read_text())
    assert len(set(shells)) == 2


@needs_solutions
@pytest.mark.one_of(16, group=2, of='what costs most')  # the check itself builds the package several times
def test_a_package_is_made_in_the_terminal_and_its_check_passes(newcomer, address, folder):
    learner, names = newcomer(), {}
    exec(solution('02_workspace_and_packages')['ex-2-5'].partition('\nmy_ws = ')[0], names)
    learner.open_notebook(address.replace(NOTEBOOK, '02_workspace_and_packages.ipynb'))
    learner.open_terminal()
    learner.type_lines(f'{paths.ROOT}/course shell')
    learner.type_lines('touch ready.txt')
    jupyterlab.wait_for_file(folder / 'ready.txt')
    learner.type_lines(COMMANDS.format(files=written(names['PACKAGE'])).rstrip())
    jupyterlab.wait_for_file(folder / 'my_ws' / 'done.txt')
    assert (folder / 'my_ws' / 'done.txt').read_text() == '0\n'
    assert 'creating folder ./patrol' in (folder / 'my_ws' / 'created.txt').read_text()

    learner.open_notebook(address.replace(NOTEBOOK, '02_workspace_and_packages.ipynb'))
    sources = learner.sources()
    learner.run(next(cell for cell, source in sources.items() if 'from helpers import' in source))
    check = next(cell for cell, source in sources.items() if source == 'check("2.5")')
    learner.run(check)
    learner.sees(check, SOLVED_ALL)


SOLVED_ALL = re.compile(r'Solved: (\d+) of \1 rules are kept')


@pytest.mark.one_of(16, group=3, of='what costs most')
@needs_solutions
def test_the_capstone_goes_on_after_a_restart_of_the_kernel(newcomer, address, folder):
    learner = newcomer()
    learner.open_notebook(address.replace(NOTEBOOK, '08_best_practices.ipynb'))
    sources = learner.sources()
    cells = [cell for cell, source in sources.items() if source]
    learner.run(next(cell for cell in cells if 'helpers.ros.start()' in sources[cell]))
    learner.restart()
    show = next(cell for cell in cells if 'ros2 interface show delivery_interfaces' in sources[cell])
    learner.run(show)
    learner.sees(show, 'from helpers import resume; resume()')
    begin = next(cell for cell in cells if 'resume()' in sources[cell])
    learner.run(begin)
    learner.sees(begin, re.compile(r'Back from the \d+ cells above: '))
    learner.sees(begin, 'the workspace delivery_ws is in')
    code = [cell for cell in cells[cells.index(begin) + 1 : cells.index('ex-8-5')] if cell in learner.outputs()]
    for cell in code:
        learner.run(cell)
    assert (folder / 'delivery_ws' / 'src' / 'delivery_robot' / 'package.xml').is_file()
    learner.write('ex-8-5', solution('08_best_practices')['ex-8-5'])
    learner.run('ex-8-5')
    check = next(cell for cell in cells if sources[cell] == 'check("8.5")')
    learner.run(check)
    learner.sees(check, SOLVED_ALL)
