"""A recorded view in a real browser, from a file: it plays, goes back and can be turned."""

import pytest

from helpers.show.views import poses
from helpers.show.views.recording import Recording
from helpers.show.views.scene import Scene
from helpers.show.views.shapes import Axes, Label
from helpers.tests.browser import evidence, lab

pytestmark = [pytest.mark.timeout(600), *lab.NEEDED]
STEPS = 5
STILL = 10  # pictures that are alike
# A number that differs when names are drawn elsewhere, as when a frame has moved or one looks from elsewhere; it is
# taken when a few pictures in a row are alike.
DRAWN = """() => new Promise((done) => {
    const canvas = document.getElementById('labels');
    let last = null, alike = 0;
    const look = () => {
        const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        let sum = 0;
        for (let i = 3; i < data.length; i += 4) sum = (31 * sum + data[i]) % 1000003;
        alike = sum === last ? alike + 1 : 0;
        last = sum;
        if (alike < STILL) requestAnimationFrame(look); else done(sum);
    };
    look();
})""".replace('STILL', str(STILL))


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


def test_a_recording_plays_goes_back_and_can_be_turned(browser, recorded):
    errors = []
    page = evidence.watch(browser.new_page(viewport={'width': 600, 'height': 400}))
    page.set_default_timeout(lab.PATIENCE)
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
