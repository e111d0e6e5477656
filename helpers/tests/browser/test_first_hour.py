"""A learner in a real browser: opens a chapter, runs and solves it, checks it, hands it in, and sees frames move."""

import io
import json
import re
import subprocess
import sys
from importlib.util import find_spec
from zipfile import ZipFile

import pytest

from helpers import paths
from helpers.tests.browser import lab

pytestmark = [
    pytest.mark.timeout(600),
    pytest.mark.skipif(not lab.CHROMIUM, reason='no browser; run: sudo apt-get install chromium'),
    pytest.mark.skipif(not find_spec('playwright'), reason='no Playwright; run: .venv/bin/uv pip install -r '
                       'environment/browser.lock'),
]
SOLUTION = paths.ROOT / 'solutions' / '03_nodes_and_topics.ipynb'


@pytest.fixture(scope='module')
def browser():
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=lab.CHROMIUM, args=lab.FLAGS)
        yield chromium
        chromium.close()


@pytest.fixture(scope='module')
def folder(tmp_path_factory):
    return lab.copy_notebooks(tmp_path_factory.mktemp('notebooks'))


@pytest.fixture(scope='module')
def address(folder, tmp_path_factory):
    with lab.served(folder, tmp_path_factory.mktemp('jupyter')) as where:
        yield where


@pytest.fixture
def learner(browser, address):
    page = browser.new_page(viewport={'width': 1366, 'height': 768})
    someone = lab.Learner(page)
    someone.open(address)
    yield someone
    page.close()


def failed(outputs, notebook):
    """The errors in a notebook's outputs, without those that its author wants."""
    cells = json.loads(notebook.read_text())['cells']
    wanted = {cell['id'] for cell in cells if 'raises-exception' in cell['metadata'].get('tags', [])}
    return [output for cell in outputs.keys() - wanted for output in outputs[cell] if output['output_type'] == 'error']


@pytest.mark.skipif(not SOLUTION.is_file(), reason='the learner\'s edition has no solutions')
def test_chapter_3_from_the_start_page_to_a_submission(learner, folder, tmp_path):
    learner.follow('3. Nodes and topics')
    learner.run_all()
    outputs = learner.outputs()
    assert not failed(outputs, folder / SOLUTION.name)
    sources = learner.sources()
    check = next(cell for cell, source in sources.items() if source == 'check("3.1")')
    assert 'Not solved yet' in learner.run(check)

    solved = {cell['id']: ''.join(cell['source']) for cell in json.loads(SOLUTION.read_text())['cells']}
    learner.write('ex-3-1', solved['ex-3-1'])
    assert re.search(r'Exercise 3\.1.*\n+.*All', learner.run(check), re.IGNORECASE)
    learner.save()

    handed_in = tmp_path / 'ada.zip'
    done = subprocess.run([sys.executable, '-m', 'helpers.cli', 'submit', '--id', 'ada', '-o', handed_in,
                           '--notebooks', folder], cwd=paths.ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert '3.1' in done.stdout
    with ZipFile(handed_in) as archive:
        assert 'Beacon' in next(archive.read(name).decode() for name in archive.namelist() if '03_nodes' in name)


UPDATES = 'count => window.updates >= count'  # so many came from the kernel
LIVE = """\
helpers.ros.start()
spinning(DynamicTFBroadcaster())
view = TfView()"""


def moved(before, after):
    """How many pixels of two pictures of the same thing are clearly not the same."""
    from PIL import Image, ImageChops

    pictures = [Image.open(io.BytesIO(png)).convert('L') for png in (before, after)]
    return sum(ImageChops.difference(*pictures).histogram()[64:])


def test_chapter_6_runs_and_its_frames_move(learner, folder):
    learner.follow('6. ')
    learner.run_all()
    outputs, sources = learner.outputs(), learner.sources()
    assert not failed(outputs, folder / '06_tf2_and_tools.ipynb')
    shown = [outputs[cell] for cell, source in sources.items() if 'with TfView(' in source]
    assert shown and all(any('image/svg+xml' in output.get('data', ()) for output in cell) for cell in shown)

    cell = learner.add(LIVE)
    page = learner.output(cell).frame_locator('iframe')
    drawing = page.locator('#pane canvas')
    drawing.wait_for()
    frame = drawing.element_handle().owner_frame()
    frame.wait_for_function(UPDATES, arg=10)  # the camera has found its place
    first = drawing.screenshot()
    frame.wait_for_function(UPDATES, arg=50)
    assert moved(first, drawing.screenshot()) > 50

    learner.add('view.stop()')
    output = learner.output(cell)
    output.locator('img, svg').first.wait_for()
    assert output.locator('iframe').count() == 0
