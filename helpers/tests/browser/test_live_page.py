"""The page of a live view by itself, in a real browser: one that gets its size late, and one that has no WebGL."""

import threading

import pytest

from helpers.show.views import picture, poses
from helpers.show.views.live_view import LiveRenderer
from helpers.show.views.scene import Scene
from helpers.show.views.shapes import Axes, Label
from helpers.tests.browser import failure_traces, jupyterlab
from helpers.tests.browser.drawn import DRAWN

pytestmark = [pytest.mark.timeout(600), *jupyterlab.NEEDED]
STATE = {'problems': [], 'fixed_frame': 'map', 'frames': ['map', 'robot'], 'chosen': '', 'past': None, 'history': 10.0}
SOME_PICTURES = """() => new Promise((done) => {
    let left = 5;
    const next = () => { if (left--) requestAnimationFrame(next); else done(); };
    setTimeout(next);
    setTimeout(done, 2000);  // a page without a size may get no pictures at all
})"""
# The address of the picture that is seen, which changes with each picture.
PICTURE = "() => { const {src, naturalWidth} = document.querySelector('#pane img'); return naturalWidth ? src : ''; }"


class Live:
    """A live view of two frames: its scene, its renderer, and what its page has said."""

    def __init__(self):
        self.scene, self.said, self.heard = Scene(), [], threading.Event()
        self.scene.set('map', Axes(1.0))
        self.scene.set('robot', Label('robot'))
        self.renderer = LiveRenderer(self.scene, lambda: STATE, self._take, lambda: picture.svg(self.scene))

    def _take(self, content):
        self.said.append(content)
        self.heard.set()


@pytest.fixture
def live():
    live = Live()
    yield live
    live.renderer.close()


def test_a_page_that_gets_its_size_late_shows_the_scene(browser, live):
    """WebKit runs a frame's scripts before it has given it a size."""
    page = failure_traces.watch(browser.new_page(viewport={'width': 700, 'height': 420}))
    page.set_default_timeout(jupyterlab.PATIENCE)
    address = live.renderer.address
    page.goto(address)  # so that the page around it is of the same origin, and its pictures are not held back
    page.set_content(f'<iframe style="width: 0; height: 0; border: 0" src="{address}"></iframe>')
    frame = page.locator('iframe').element_handle().content_frame()
    frame.wait_for_function('window.updates')
    frame.evaluate(SOME_PICTURES)
    page.evaluate("document.querySelector('iframe').style = 'width: 600px; height: 400px'")
    frame.wait_for_function("document.getElementById('labels').width === 600")
    assert frame.evaluate(DRAWN), 'the name of the frame is seen'
    page.close()


def test_without_webgl_one_picture_comes_after_the_other(page_without_webgl, live):
    page = page_without_webgl
    page.goto(live.renderer.address)
    page.get_by_text('flat: no WebGL here').wait_for()
    first = page.wait_for_function(PICTURE).json_value()
    live.scene.pose('robot', poses.matrix((5.0, 0.0, 0.0)))
    live.renderer.update()
    page.wait_for_function(f'({PICTURE})() !== {first!r} && ({PICTURE})() !== ""')
    assert not page.get_by_role('button', name='fit').is_visible()
    page.locator('#fixed').select_option('robot')  # the other controls work
    assert live.heard.wait(60) and live.said == [{'fixed_frame': 'robot'}]
    live.renderer.close()
    page.get_by_text('ended').wait_for()
    assert page.evaluate(PICTURE), 'the last picture stays'
