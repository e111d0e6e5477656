"""A recording: what is in it, how far it goes, and the page that replays it."""

import base64
import re
import struct
import zlib

import numpy as np
import pytest

from helpers.show.views import poses, recording
from helpers.show.views.recording import Recording
from helpers.show.views.scene import Scene
from helpers.show.views.shapes import Label, Points
from helpers.tests.real_kernel import Kernel
from helpers.tests.show.views.test_live_view import decode

VIEW = """
import helpers
from helpers.show.views import Display
from helpers.show.views.shapes import Sphere


class Ball(Display):
    def update(self, fixed_frame, time):
        self.scene.set('ball', Sphere(0.1))


helpers.ros.start()
view = helpers.TfView(Ball())
helpers.wait_for(lambda: 'Ball/ball' in view.scene)
last = []
view._output.update = lambda content: last.append(content._repr_mimebundle_())
view.stop()
"""


class Clock:
    """Stands still until it is told to go on."""

    def __init__(self):
        self.now = 100.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock():
    return Clock()


@pytest.fixture
def scene():
    return Scene()


@pytest.fixture
def recorded(scene, clock):
    return Recording(scene, lambda: {'problems': []}, clock)


def replay(page: str) -> list[tuple[float, dict]]:
    """What a page holds, read as its script does: time and the message's JSON."""
    text = re.search(r'id="recording">([^<]*)<', page)[1]
    data, found = zlib.decompress(base64.b64decode(text)), []
    while data:
        time, size = struct.unpack_from('<dI', data)
        found.append((time, decode(data[12 : 12 + size])[0]))
        data = data[12 + size :]
    return found


def test_it_begins_with_what_is_seen_first_and_holds_each_change_with_its_time(scene, clock, recorded, tmp_path):
    recorded.update()
    scene.set('empty', None)
    recorded.update()
    assert recorded.count == 0 and recorded.write(tmp_path / 'none') is None and not (tmp_path / 'none').exists()
    clock.now += 5
    scene.set('a', Label('first'))
    recorded.update()
    clock.now += 1
    recorded.update()  # nothing has changed
    scene.pose('a', poses.matrix((1.0, 2.0, 3.0)))
    recorded.update()
    clock.now += 0.01
    scene.set('b', Label('too soon'))
    recorded.update()
    assert recorded.count == 2
    recorded.update(final=True)
    assert recorded.write(tmp_path) == 'scene-01.html'
    (start, first), (later, move), (end, last) = replay((tmp_path / 'scene-01.html').read_text())
    assert (start, later) == (0, 1) and end == pytest.approx(1.01)
    assert first['reset'] and first['shapes'][1][2]['text'] == 'first' and first['state'] == {'problems': []}
    assert set(move) == {'poses'}
    assert last['shapes'][0][2]['text'] == 'too soon'


def test_it_ends_in_time(scene, clock, recorded):
    for number in range(30):
        scene.set('a', Label(str(number)))
        recorded.update()
        clock.now += 1
    assert recorded.count == 21, 'from 0 s to 20 s'


def test_it_does_not_grow_beyond_its_size(scene, clock, recorded, tmp_path, monkeypatch):
    monkeypatch.setattr(recording, 'SIZE', 50_000)
    random = np.random.default_rng(1)
    for _ in range(10):
        scene.set('cloud', Points(random.normal(size=(1000, 3)), (1, 0, 0), 0.1))  # 12 kB that cannot be packed
        recorded.update()
        clock.now += 1
    page = tmp_path / recorded.write(tmp_path)
    assert 3 <= len(replay(page.read_text())) < 10
    assert page.stat().st_size < 50_000 * 4 / 3 + 3000


def test_pages_share_one_plain_script(scene, recorded, tmp_path):
    scene.set('a', Label('</script>'))
    recorded.update()
    assert [recorded.write(tmp_path), recorded.write(tmp_path)] == ['scene-01.html', 'scene-02.html']
    assert {path.name for path in tmp_path.iterdir()} == {'scene-01.html', 'scene-02.html', *recording.SHARED}
    page = (tmp_path / 'scene-01.html').read_text()
    assert page.count('</script>') == 2 and not re.search(r'type="module"|http:', page)
    script = recording.bundled('replay.js')
    assert (
        script.index("modules['shapes.js'] =")
        < script.index("modules['nodes.js'] =")
        < script.index("modules['replay.js'] =")
        and script.count("modules['nodes.js'] =") == 1
    )
    assert 'WebSocket' not in script, 'nothing of the live page'


def test_what_cannot_be_bundled_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(recording.view_pages, 'WEB', tmp_path)
    (tmp_path / 'entry.js').write_text("import * as all from './other.js';\n")
    with pytest.raises(ValueError, match='entry.js: cannot bundle: import'):
        recording.bundled('entry.js')


def test_a_view_in_a_notebook_is_recorded_where_that_is_wished(kernel: Kernel, tmp_path):
    kernel.ok(f'import os; os.environ[{recording.VARIABLE!r}] = {str(tmp_path)!r}')
    kernel.ok(VIEW)
    assert kernel.value('view.address is None and last[0][1]') == {'scene': 'scene-01.html'}
    (_, first), *_ = replay((tmp_path / 'scene-01.html').read_text())
    assert 'Ball/ball' in [path for _, path, _ in first['shapes']]
