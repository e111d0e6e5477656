"""Views in a browser that cannot draw in 3-D, as in many virtual machines: pictures, and a sentence that says why."""

import threading

import pytest

from helpers.show.views import picture, poses
from helpers.show.views.live_view import LiveRenderer
from helpers.show.views.recording import Recording
from helpers.show.views.scene import Scene
from helpers.show.views.shapes import Axes, Label
from helpers.tests.browser import failure_traces, jupyterlab

pytestmark = [pytest.mark.timeout(600), *jupyterlab.NEEDED]
NO_WEBGL = """
const getContext = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
  return kind.includes('webgl') ? null : getContext.call(this, kind, ...more);
};
"""
STATE = {'problems': [], 'fixed_frame': 'map', 'frames': ['map', 'robot'], 'chosen': '', 'past': None, 'history': 10.0}
# The address of the picture that is seen, which changes with each picture.
PICTURE = "() => { const {src, naturalWidth} = document.querySelector('#pane img'); return naturalWidth ? src : ''; }"


@pytest.fixture
def page(browser):
    page = failure_traces.watch(browser.new_page(viewport={'width': 700, 'height': 420}))
    page.set_default_timeout(jupyterlab.PATIENCE)
    page.add_init_script(NO_WEBGL)
    yield page
    page.close()


@pytest.fixture
def scene():
    scene = Scene()
    scene.set('map', Axes(1.0))
    scene.set('robot', Label('robot'))
    return scene


def test_a_live_view_shows_one_picture_after_the_other(page, scene):
    said, heard = [], threading.Event()

    def take(content):
        said.append(content)
        heard.set()

    renderer = LiveRenderer(scene, lambda: STATE, take, lambda: picture.svg(scene))
    try:
        page.goto(renderer.address)
        page.get_by_text('flat: no WebGL here').wait_for()
        first = page.wait_for_function(PICTURE).json_value()
        scene.pose('robot', poses.matrix((5.0, 0.0, 0.0)))
        renderer.update()
        page.wait_for_function(f'({PICTURE})() !== {first!r} && ({PICTURE})() !== ""')
        assert not page.get_by_role('button', name='fit').is_visible()
        page.locator('#fixed').select_option('robot')  # the other controls work
        assert heard.wait(60) and said == [{'fixed_frame': 'robot'}]
    finally:
        renderer.close()
    page.get_by_text('ended').wait_for()
    assert page.evaluate(PICTURE), 'the last picture stays'


def test_the_page_of_a_recording_says_that_it_cannot_draw_it(page, scene, tmp_path):
    recording = Recording(scene, lambda: STATE)
    recording.update()
    page.goto((tmp_path / recording.write(tmp_path)).as_uri())
    page.get_by_text('This browser draws no 3-D: it has no WebGL.').wait_for()
    assert not page.locator('#slider').is_visible()
