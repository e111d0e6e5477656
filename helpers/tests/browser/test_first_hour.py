"""Two learners in a real browser, by the keyboard: one solves an exercise of chapter 3 and hands it in, the other sees
the frames of chapter 6 move."""

import io
import json
import re
import subprocess
import sys
from zipfile import ZipFile

import pytest

from helpers import paths
from helpers.tests.browser import jupyterlab

pytestmark = [pytest.mark.timeout(900), pytest.mark.early, *jupyterlab.NEEDED]
SOLUTION = paths.ROOT / 'solutions' / '03_nodes_and_topics.ipynb'
HEARD = "['Hello ROS 2: 0', 'Hello ROS 2: 1', 'Hello ROS 2: 2']"


@pytest.fixture(scope='module')
def folder(tmp_path_factory):
    return jupyterlab.copy_notebooks(tmp_path_factory.mktemp('notebooks'))


@pytest.fixture(scope='module')
def learners(request, browser, folder, tmp_path_factory):
    """At one server: by chapter, a learner who has come there from the start page and has told it to run.

    The chapters whose tests are drawn run side by side, the longer one first, each with a kernel of its own.
    """
    drawn = {item.name for item in request.session.items}
    with jupyterlab.served(folder, tmp_path_factory.mktemp('jupyter')) as address:
        found = {}
        for chapter in (6, 3):
            if not any(name.startswith(f'test_chapter_{chapter}_') for name in drawn):
                continue
            learner = jupyterlab.Learner(browser.new_page(viewport={'width': 1366, 'height': 768}))
            learner.open(address, f'chapter-{chapter}')
            learner.follow(f'{chapter}. ')
            learner.start_all()
            found[chapter] = learner
        yield found
        for learner in found.values():
            learner.page.close()


def failed(outputs, notebook):
    """The errors in a notebook's outputs, without those that its author wants."""
    cells = json.loads(notebook.read_text())['cells']
    wanted = {cell['id'] for cell in cells if 'raises-exception' in cell['metadata'].get('tags', [])}
    return [
        f'cell {cell}: {output["ename"]}: {output["evalue"]}'
        for cell in outputs.keys() - wanted
        for output in outputs[cell]
        if output['output_type'] == 'error'
    ]


@pytest.mark.one_of(16, group=5, of='what costs most')
@pytest.mark.skipif(not SOLUTION.is_file(), reason="the learner's edition has no solutions")
def test_chapter_3_from_the_start_page_to_a_submission(learners, folder, tmp_path):
    learner = learners[3]
    learner.wait_until_all_ran()
    assert not failed(learner.outputs(), folder / SOLUTION.name)
    sources = learner.sources()
    talk = next(cell for cell, source in sources.items() if 'with spinning(Talker(), listener' in source)
    learner.sees(talk, HEARD)
    check = next(cell for cell, source in sources.items() if source == 'check("3.1")')
    learner.sees(check, 'Not solved yet')

    solved = {cell['id']: ''.join(cell['source']) for cell in json.loads(SOLUTION.read_text())['cells']}
    learner.write('ex-3-1', solved['ex-3-1'])
    learner.run('ex-3-1')
    learner.run(check)
    learner.sees(check, re.compile(r'Exercise 3\.1.*\s+Solved: \d+ of \d+ rules are kept'))
    learner.save()

    handed_in = tmp_path / 'ada.zip'
    done = subprocess.run(
        [sys.executable, '-m', 'helpers.cli', 'submit', '--id', 'ada', '-o', handed_in, '--notebooks', folder],
        cwd=paths.ROOT,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    assert '3.1' in done.stdout
    with ZipFile(handed_in) as archive:
        assert 'Beacon' in next(archive.read(name).decode() for name in archive.namelist() if '03_nodes' in name)


UPDATES = 'count => window.updates >= count'  # so many came from the kernel
FOUND = 10  # updates, after which the camera has found its place
MOST = 200  # updates; by then a frame that moves has moved
LIVE = """\
helpers.ros.start()
spinning(DynamicTFBroadcaster())
view = TfView()"""


def moved(before, after):
    """How many pixels of two pictures of the same thing are clearly not the same."""
    from PIL import Image, ImageChops

    pictures = [Image.open(io.BytesIO(png)).convert('L') for png in (before, after)]
    return sum(ImageChops.difference(*pictures).histogram()[64:])


@pytest.mark.one_of(16, group=6, of='what costs most')
def test_chapter_6_runs_and_its_frames_move(learners, folder):
    learner = learners[6]
    learner.wait_until_all_ran()
    outputs, sources = learner.outputs(), learner.sources()
    assert not failed(outputs, folder / '06_tf2_and_tools.ipynb')
    shown = [outputs[cell] for cell, source in sources.items() if 'with TfView(' in source]
    assert shown and all(any('image/svg+xml' in output.get('data', ()) for output in cell) for cell in shown)

    cell = learner.add(LIVE)
    page = learner.output(cell).frame_locator('iframe')
    drawing = page.locator('#pane canvas')
    drawing.wait_for()
    frame = drawing.element_handle().owner_frame()
    frame.wait_for_function(UPDATES, arg=FOUND)
    first, changed, seen = drawing.screenshot(), 0, FOUND
    while changed <= 50 and seen < MOST:
        seen = frame.evaluate('window.updates') + 5
        frame.wait_for_function(UPDATES, arg=seen)
        changed = moved(first, drawing.screenshot())
    assert changed > 50

    learner.add('view.stop()')
    output = learner.output(cell)
    output.locator('img, svg').first.wait_for()
    assert output.locator('iframe').count() == 0
