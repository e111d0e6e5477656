"""What goes over the wire to the browser, and the web server: shared, secret, and gone with the last view."""

import asyncio
import json
import socket
import struct
import threading
from urllib.error import HTTPError
from urllib.request import urlopen

import numpy as np
import pytest
from tornado.httpclient import AsyncHTTPClient, HTTPClientError
from tornado.websocket import websocket_connect

from helpers.show.views import poses, view_pages
from helpers.show.views.live_view import LiveRenderer, encode
from helpers.show.views.scene import Scene
from helpers.show.views.shapes import Label, Mesh, Points


def decode(message: bytes) -> tuple[dict, bytes]:
    length = struct.unpack_from('<I', message)[0]
    return json.loads(message[4 : 4 + length]), message[4 + length :]


def numbers(block: bytes, place, kind='<f4') -> np.ndarray:
    return np.frombuffer(block, kind, place[1], place[0])


def listening(port: int) -> bool:
    with socket.socket() as probe:
        return probe.connect_ex(('127.0.0.1', port)) == 0


@pytest.fixture
def stage():
    """A scene, what its page has said, and a function that makes renderers of it."""
    scene, said, open_ones = Scene(), [], []
    heard = threading.Event()

    def take(content):
        said.append(content)
        heard.set()

    def make():
        renderer = LiveRenderer(scene, lambda: {'problems': []}, take, lambda: f'<svg>{len(scene.items())}</svg>')
        open_ones.append(renderer)
        return renderer

    yield scene, said, heard, make
    for renderer in open_ones:
        renderer.close()


def test_a_message_carries_shapes_poses_and_appearances():
    scene = Scene()
    scene.set('robot/cloud', Points([[1, 2, 3], [4, 5, 6]], (1, 0, 0), 0.1))
    scene.set('robot/mesh', Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
    scene.pose('robot', poses.matrix((7.0, 8.0, 9.0)))
    scene.appearance('robot', opacity=0.5)
    content, block = decode(encode(scene.changes(), {'past': None}))
    shapes = {path: shape for _, path, shape in content['shapes']}
    assert list(shapes) == ['robot', 'robot/cloud', 'robot/mesh'] and shapes['robot'] is None
    assert numbers(block, shapes['robot/cloud']['points']).tolist() == [1, 2, 3, 4, 5, 6]
    assert numbers(block, shapes['robot/mesh']['faces'], '<u4').tolist() == [0, 1, 2]
    ids, matrices = content['poses']
    assert numbers(block, ids, '<u4').tolist() == [content['shapes'][0][0]] == [content['appearances'][0][0]]
    assert numbers(block, matrices)[12:15].tolist() == [7, 8, 9], 'column after column'
    assert content['appearances'][0][1:] == [True, 0.5] and content['state'] == {'past': None}
    scene.delete('robot')
    assert decode(encode(scene.changes()))[0] == {'deleted': [content['shapes'][0][0]]}


def test_a_browser_gets_everything_then_the_changes_and_can_answer(stage):
    scene, said, heard, make = stage
    renderer = make()
    scene.set('a', Label('first'))
    renderer.update()
    assert not renderer.watched

    async def watch():
        page = await AsyncHTTPClient().fetch(renderer.address)
        assert b'viewer.js' in page.body
        ping = await AsyncHTTPClient().fetch(renderer.address.rsplit('/', 2)[0] + '/ping')
        assert ping.body == b'ok' and ping.headers['Access-Control-Allow-Origin'] == '*'
        connection = await websocket_connect(renderer.address.replace('http', 'ws') + 'socket')
        whole, _ = decode(await connection.read_message())
        assert whole['reset'] and whole['shapes'][0][2]['text'] == 'first' and whole['state'] == {'problems': []}
        scene.set('b', Label('second'))
        renderer.update()
        news, _ = decode(await connection.read_message())
        assert [shape['text'] for _, _, shape in news['shapes']] == ['second'] and 'reset' not in news
        await connection.write_message('{"past": 2}')
        assert await asyncio.to_thread(heard.wait, 20) and said == [{'past': 2}]
        renderer.close()
        assert await connection.read_message() is None and connection.close_code == 4000

    asyncio.run(asyncio.wait_for(watch(), 60))


def test_a_browser_without_webgl_gets_pictures(stage):
    scene, _, _, make = stage
    renderer, other = make(), make()  # the other one keeps the port open
    address = f'{renderer.address}picture?1'
    for count in (0, 1):
        with urlopen(address, timeout=60) as answer:
            assert answer.headers['Content-Type'].startswith('image/svg+xml')
            assert answer.read().decode() == f'<svg>{count}</svg>'
        scene.set('a', Label('first'))
    renderer.close()
    with pytest.raises(HTTPError, match='404'):
        urlopen(address, timeout=60)
    assert other.address


def test_a_slow_browser_gets_no_more_than_it_can_draw_and_misses_nothing(stage):
    scene, _, _, make = stage
    renderer = make()

    def texts(content) -> set[str]:
        return {shape['text'] for _, _, shape in content.get('shapes', ())}

    async def keep_updating():
        while True:
            renderer.update()
            await asyncio.sleep(0.01)

    async def watch():
        connection = await websocket_connect(renderer.address.replace('http', 'ws') + 'socket')
        seen = texts(decode(await connection.read_message())[0])
        for number in range(10):
            scene.set(str(number), Label(str(number)))
            renderer.update()
        for _ in range(2):
            seen |= texts(decode(await connection.read_message())[0])
        unexpected = asyncio.ensure_future(connection.read_message())
        await AsyncHTTPClient().fetch(renderer.address)  # whatever was on its way has come by now
        assert not unexpected.done()
        await connection.write_message('{"drawn": 3}')
        scene.set('last', Label('last'))
        updates = asyncio.ensure_future(keep_updating())
        message = await unexpected
        while not {'9', 'last'} <= (seen := seen | texts(decode(message)[0])):
            await connection.write_message('{"drawn": 1}')
            message = await connection.read_message()
        updates.cancel()
        assert seen == {*'0123456789', 'last'}

    asyncio.run(asyncio.wait_for(watch(), 60))


def test_views_share_one_port_which_the_last_one_closes(stage):
    _, _, _, make = stage
    first, second = make(), make()
    port = int(first.address.split(':')[2].split('/')[0])
    assert f':{port}/' in second.address and first.address != second.address
    first.close()
    assert listening(port)
    second.close()
    second.close()
    assert not listening(port)
    assert all(thread.name != 'views' for thread in threading.enumerate())


def test_without_the_secret_there_is_nothing(stage):
    root = make_root(stage[3]())

    async def look():
        for path in ('/', '/1/', '/meshcat.js', '/ping', '/wrong/1/'):
            with pytest.raises(HTTPClientError, match='404'):
                await AsyncHTTPClient().fetch(root + path)

    asyncio.run(asyncio.wait_for(look(), 60))


def make_root(renderer: LiveRenderer) -> str:
    return '/'.join(renderer.address.split('/')[:3])


def test_the_cell_shows_the_picture_where_the_view_cannot_be_reached(stage):
    html = stage[3]().html('<svg/>', 300)
    assert 'src="data:image/svg+xml;base64,PHN2Zy8+"' in html and '<iframe' not in html


def test_each_shape_and_each_file_of_the_page_is_there():
    from helpers.show.views import shapes

    code = (view_pages.WEB / 'shapes.js').read_text()
    kinds = {
        kind.__name__
        for kind in vars(shapes).values()
        if isinstance(kind, type) and issubclass(kind, shapes.Shape) and not kind.__name__.startswith('_')
    }
    for kind in kinds - {'Shape', 'Label'}:
        assert f'  {kind}(shape' in code, f'web/shapes.js draws {kind}'
