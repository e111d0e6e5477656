"""The page of a live view by itself, in a real browser: what JupyterLab's pages may do to it."""

import pytest

from helpers.show.views.live_view import LiveRenderer
from helpers.show.views.scene import Scene
from helpers.show.views.shapes import Axes, Label
from helpers.tests.browser import failure_traces, jupyterlab
from helpers.tests.browser.drawn import DRAWN

pytestmark = [pytest.mark.timeout(600), *jupyterlab.NEEDED]
STATE = {'problems': [], 'fixed_frame': 'map', 'frames': ['map'], 'chosen': '', 'past': None, 'history': 10.0}
SOME_PICTURES = """() => new Promise((done) => {
    let left = 5;
    const next = () => { if (left--) requestAnimationFrame(next); else done(); };
    setTimeout(next);
    setTimeout(done, 2000);  // a page without a size may get no pictures at all
})"""


def test_a_page_that_gets_its_size_late_shows_the_scene(browser):
    """WebKit runs a frame's scripts before it has given it a size."""
    scene = Scene()
    scene.set('map', Axes(1.0))
    scene.set('map/name', Label('map'))
    renderer = LiveRenderer(scene, lambda: STATE, lambda content: None, lambda: '<svg/>')
    page = failure_traces.watch(browser.new_page(viewport={'width': 700, 'height': 420}))
    page.set_default_timeout(jupyterlab.PATIENCE)
    try:
        page.goto(renderer.address)  # so that the page around it is of the same origin, and its pictures are not held
        page.set_content(f'<iframe style="width: 0; height: 0; border: 0" src="{renderer.address}"></iframe>')
        frame = page.locator('iframe').element_handle().content_frame()
        frame.wait_for_function('window.updates')
        frame.evaluate(SOME_PICTURES)
        page.evaluate("document.querySelector('iframe').style = 'width: 600px; height: 400px'")
        frame.wait_for_function("document.getElementById('labels').width === 600")
        assert frame.evaluate(DRAWN), 'the name of the frame is seen'
    finally:
        page.close()
        renderer.close()
