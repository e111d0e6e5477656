"""A recorded view in a real browser, from a file: it plays, goes back and can be turned."""

import pytest

from helpers.show.views import poses
from helpers.show.views.recording import Recording
from helpers.show.views.scene import Scene
from helpers.show.views.shapes import Axes, Label
from helpers.tests.browser import failure_traces, jupyterlab
from helpers.tests.browser.drawn import DRAWN

pytestmark = [pytest.mark.timeout(600), *jupyterlab.NEEDED]
STEPS = 5


@pytest.fixture
def recorded(tmp_path):
    """The page of a frame that goes 1 m in each of some steps, 0.2 s apart."""
    scene, now = Scene(), [0.0]
    recording = Recording(
        scene,
        lambda: {'problems': ['nothing is wrong'], 'fixed_frame': 'map', 'past': None, 'focus': None, 'span': 2.0},
        lambda: now[0],
    )
    scene.set('map', Axes(1.0))
    scene.set('map/name', Label('map'))
    for step in range(STEPS + 1):
        scene.set('robot', Label('robot'))
        scene.pose('robot', poses.matrix((float(step), 0.0, 0.0)))
        recording.update()
        now[0] += 0.2
    return tmp_path / recording.write(tmp_path)


def test_without_webgl_the_page_says_that_it_cannot_draw(page_without_webgl, recorded):
    page_without_webgl.goto(recorded.as_uri())
    page_without_webgl.get_by_text('This browser draws no 3-D: it has no WebGL.').wait_for()
    assert not page_without_webgl.locator('#slider').is_visible()


def test_a_recording_plays_goes_back_and_can_be_turned(browser, recorded):
    errors = []
    page = failure_traces.watch(browser.new_page(viewport={'width': 600, 'height': 400}))
    page.set_default_timeout(jupyterlab.PATIENCE)
    page.on('pageerror', lambda error: errors.append(error))
    page.goto(recorded.as_uri())
    page.wait_for_function('document.getElementById("when").textContent === "1.0 of 1.0 s"')  # it plays by itself
    page.get_by_role('button', name='play').wait_for()
    assert page.locator('#fixed').inner_text() == 'fixed frame: map'
    assert page.evaluate('window.updates') == STEPS + 1
    at_the_end = page.evaluate(DRAWN)
    page.locator('#slider').fill('0')
    assert page.locator('#when').inner_text() == '0.0 of 1.0 s'
    at_the_start = page.evaluate(DRAWN)
    page.mouse.move(300, 200)
    page.mouse.down()
    page.mouse.move(400, 230, steps=3)
    page.mouse.up()
    turned = page.evaluate(DRAWN)
    assert len({at_the_end, at_the_start, turned}) == 3
    page.get_by_role('button', name='play').click()
    page.wait_for_function('document.getElementById("when").textContent === "1.0 of 1.0 s"')
    page.close()
    assert errors == []
