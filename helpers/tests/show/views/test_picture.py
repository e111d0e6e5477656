"""The still picture: complete, small, and with everything inside."""

import math
import re
from xml.etree import ElementTree

import numpy as np
import pytest

from helpers.show.views import picture, poses
from helpers.show.views.scene import Scene
from helpers.show.views.shapes import BLUE, GREEN, RED, Arrow, Axes, Box, Cylinder, Label, Line, Mesh, Points, Sphere
from helpers.tests.show.contrast import contrast

SVG = '{http://www.w3.org/2000/svg}'
RNG = np.random.default_rng(0)


def elements(text: str, tag: str) -> list:
    return list(ElementTree.fromstring(text).iter(SVG + tag))


def test_an_empty_scene_says_so():
    text = picture.svg(Scene(), problems=['what <is> wrong'])
    assert [element.text for element in elements(text, 'text')] == ['what <is> wrong', 'no frame so far']


def test_each_shape_is_drawn():
    scene = Scene()
    vertices, faces = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]
    shapes = (
        Axes(),
        Arrow(),
        Box(),
        Cylinder(),
        Sphere(),
        Mesh(vertices, faces),
        Line([[0, 0, 0], [1, 1, 1]]),
        Points(RNG.random((20, 3))),
        Label('name'),
        Label('big', 0.3),
    )
    scene.set('it', Label(''))
    before = len(picture.svg(scene))
    for number, shape in enumerate(shapes):
        scene.set('it', shape)
        scene.pose('it', poses.matrix((number, 0.0, 0.0)))
        text = picture.svg(scene)
        ElementTree.fromstring(text)
        assert len(text) > before, shape
        scene.appearance('it', opacity=0.5)
        assert 'opacity="0.5"' in picture.svg(scene), shape
        scene.appearance('it', opacity=1.0)


def test_axes_have_their_colours_and_z_is_up():
    scene = Scene()
    scene.set('a', Axes(1.0))
    strokes = {element.get('stroke'): element.get('d') for element in elements(picture.svg(scene), 'path')}
    red, green, blue = (
        np.array([float(value) for value in re.findall(r'-?[\d.]+', strokes[colour])])
        for colour in ('#db262e', '#219e38', '#215cdb')
    )
    assert blue[3] < blue[1] and blue[0] == pytest.approx(blue[2], abs=0.11), 'z goes straight up'
    assert red[2] > red[0] and green[2] > green[0] and green[3] < green[1] < red[3], 'x to the front, y to the back'


@pytest.mark.parametrize('scale', [0.01, 1.0, 300.0])
def test_everything_is_inside_at_any_scale(scale):
    scene = Scene()
    for number, place in enumerate(RNG.random((30, 3)) * scale):
        scene.set(f'{number}/axes', Axes(0.05 * scale))
        scene.set(f'{number}/name', Label(f'a_long_name_{number}'))
        scene.pose(str(number), poses.matrix(place))
    text = picture.svg(scene, width=600, height=300)
    for element in elements(text, 'path')[1:]:
        if element.get('stroke') in ('#db262e', '#219e38', '#215cdb'):
            x, y = np.array(re.findall(r'-?[\d.]+', element.get('d')), dtype=float).reshape(-1, 2).T
            assert 0 <= x.min() and x.max() <= 600 and 0 <= y.min() and y.max() <= 300
    for element in elements(text, 'text'):
        assert -60 < float(element.get('x')) < 600 and 0 <= float(element.get('y')) <= 310


def colours_in_order(text: str) -> list[str]:
    return [element.get('fill') for element in elements(text, 'polygon')]


def test_a_long_wall_hides_what_stands_behind_it_whatever_the_distances_of_their_middles():
    scene = Scene()
    scene.set('block', Box((1.0, 1.0, 1.0), (0.0, 1.0, 0.0)))
    scene.pose('block', poses.matrix((9.0, 1.0, 0.5)))  # nearer than the middle of the wall, but behind it
    scene.set('wall', Box((20.0, 0.2, 3.0), (1.0, 0.0, 0.0)))
    scene.pose('wall', poses.matrix((0.0, 0.0, 1.5)))
    scene.set('floor', Box((30.0, 30.0, 0.01), (0.0, 0.0, 1.0)))
    scene.pose('floor', poses.matrix((0.0, 0.0, -0.005)))
    order = colours_in_order(picture.svg(scene))
    floor, wall = '#0000f7', '#d40000'  # its top, its front
    assert order[0] == floor and all(order.index(face) < order.index(wall) for face in order if face[3:5] != '00')
    scene.pose('block', poses.matrix((-9.0, -1.0, 0.5)))  # farther than the middle of the wall, but before it
    order = colours_in_order(picture.svg(scene))
    assert all(order.index(face) > order.index(wall) for face in order if face[3:5] != '00')


def test_faces_hide_points_behind_them():
    scene = Scene()
    scene.set('wall', Box((4.0, 0.1, 2.0)))
    before, behind = [(x, -0.07, 0.0) for x in (-1, 0, 1)], [(x, 1.0, -0.5) for x in (-1, 0, 1)]
    scene.set('scan', Points(before + behind, (1, 0, 0), 0.03))
    [path] = [element for element in elements(picture.svg(scene), 'path') if element.get('stroke') == '#ff0000']
    assert path.get('d').count('M') == 3
    scene.appearance('wall', opacity=0.5)
    [path] = [element for element in elements(picture.svg(scene), 'path') if element.get('stroke') == '#ff0000']
    assert path.get('d').count('M') == 6, 'one can see through it'


def test_what_is_on_top_is_painted_last_and_a_point_can_be_in_the_middle():
    scene = Scene()
    scene.set('body', Box())
    scene.set('inside', Axes(0.3, on_top=True))
    scene.set('far', Axes(1.0))
    scene.pose('far', poses.matrix((50.0, 50.0, 0.0)))
    text = picture.svg(scene, around=(np.zeros(3), 2.0)).split('</style>')[1]
    assert text.rfind('<polygon') < text.find('#db262e') and text.count('#db262e') == 1, 'the far one is left out'


def test_names_at_one_place_do_not_cover_each_other():
    scene = Scene()
    for number in range(6):
        scene.set(f'{number}', Label('camera_optical_frame'))
    places = [
        (float(element.get('x')), float(element.get('y')))
        for element in elements(picture.svg(scene), 'text')
        if element.text == 'camera_optical_frame'
    ]
    assert len(places) == 6
    for i, (x, y) in enumerate(places):
        assert all(abs(x - u) > 100 or abs(y - v) > 12 for u, v in places[:i])


@pytest.mark.parametrize('legend', [[], [('moves', RED, False), ('static', BLUE, True)]])
@pytest.mark.parametrize('across', np.linspace(-0.6, 0.6, 7))
def test_the_line_below_the_picture_makes_room_for_a_label_that_has_its_size(across, legend):
    scene = Scene()
    scene.set('storage', Label('storage', 0.1))
    scene.pose('storage', poses.matrix(tuple(across * picture._RIGHT - 0.83 * picture._UP)))
    text = picture.svg(scene, 'fixed frame: map', legend=legend, around=(np.zeros(3), 1.5))
    label, line = [element for element in elements(text, 'text') if element.text.startswith(('storage', 'fixed'))]
    size, left, x = float(label.get('font-size')), float(label.get('x')), float(line.get('x'))
    assert -0.2 * size < float(label.get('y')) - float(line.get('y')) < 0.5 * size, 'they are at one height'
    assert x > left + 0.5 * size * len('storage') or x + 6.5 * len(line.text) < left
    assert 12 <= x < 720 - 6.5 * len(line.text)


def test_a_name_makes_room_for_a_label_that_has_its_size():
    scene = Scene()
    scene.set('name', Label('name'))
    scene.set('storage', Label('storage', 0.1))
    places = {element.text: element for element in elements(picture.svg(scene), 'text')}
    name, storage = (float(places[text].get('y')) for text in ('name', 'storage'))
    assert abs(name - storage) > 0.6 * float(places['storage'].get('font-size'))


def test_the_picture_stays_small():
    scene = Scene()
    scene.set('cloud', Points(RNG.random((50_000, 3)), RNG.random((50_000, 3))))
    side = 60
    grid = np.array([(x, y, np.sin(x / 9) * np.cos(y / 7)) for x in range(side) for y in range(side)]) / side
    faces = [(a, a + 1, a + side) for a in range(side * (side - 1) - 1)]
    scene.set('mesh', Mesh(grid, faces))
    angles = np.linspace(0, 60, 5000)
    scene.set('trail', Line(np.column_stack((np.cos(angles), np.sin(angles), angles / 60))))
    for number in range(60):
        scene.set(f'{number}/axes', Axes())
        scene.set(f'{number}/name', Label(f'frame_{number}'))
        scene.pose(str(number), poses.matrix(RNG.random(3)))
    assert len(picture.svg(scene)) < 60_000


def test_a_sphere_that_the_pose_scales_is_an_ellipse():
    scene = Scene()
    scene.set('egg', Sphere(0.5))
    scene.pose('egg', np.diag((1.0, 1.0, 3.0, 1.0)))
    ellipse = elements(picture.svg(scene), 'ellipse')[0]
    assert abs(float(ellipse.get('transform').removeprefix('rotate(').split()[0])) == 90  # it stands upright
    assert 2 < float(ellipse.get('rx')) / float(ellipse.get('ry')) < 3  # seen from above, a little


def test_what_stands_on_a_floor_is_painted_over_it():
    scene = Scene()
    scene.set('far', Box((0.2, 0.2, 0.2), (1.0, 0.0, 0.0)))
    scene.pose('far', poses.matrix((-4.0, 4.0, 0.1)))
    scene.set('floor', Box((10.0, 10.0, 0.01), (0.0, 0.0, 1.0)))
    fills = [element.get('fill') for element in elements(picture.svg(scene), 'polygon')]
    top = next(number for number, fill in enumerate(fills) if fill.startswith('#0000'))
    assert all(number > top for number, fill in enumerate(fills) if fill.endswith('0000'))


def test_a_floor_stays_below_its_walls_if_an_arrow_lies_a_little_below_its_surface():
    scene = Scene()
    scene.set('floor', Box((10.0, 10.0, 0.02), (0.0, 0.0, 1.0)))
    scene.set('arrow', Line([[-4.0, 3.0, -0.005], [4.0, -3.0, 0.005]], (0.0, 1.0, 0.0), 0.05))
    for number, y in enumerate((-4.0, 0.0, 4.0)):
        scene.set(f'wall {number}', Box((8.0, 0.1, 1.0), (1.0, 0.0, 0.0)))
        scene.pose(f'wall {number}', poses.matrix((0.0, y, 0.51)))
    fills = colours_in_order(picture.svg(scene))
    floor, walls = (
        [fill for fill in fills if fill.startswith('#0000')],
        [fill for fill in fills if fill.endswith('0000')],
    )
    assert floor and walls and all(fills.index(wall) > fills.index(floor[0]) for wall in walls)


def test_a_large_cloud_is_thinned_out_without_a_pattern():
    some = picture._some(10_000, 2_500)
    assert len(set(some.tolist())) == 2_500
    assert set((some % 100).tolist()) == set(range(100))  # every column of a camera's 100 x 100 points


@pytest.mark.parametrize('turn', [0.0, 0.8, 1.6, 2.4, 3.2, 4.0, 4.8, 5.6])
def test_a_name_lies_beside_the_axes_of_its_frame(turn):
    scene = Scene()
    pose = poses.matrix([0, 0, 0], [0, 0, math.sin(turn / 2), math.cos(turn / 2)])
    for path, shape in (('axes', Axes(0.4)), ('name', Label('robot_base')), ('far', Sphere(3.0))):
        scene.set(path, shape)
        scene.pose(path, pose)
    text = picture.svg(scene)
    (name,) = (element for element in elements(text, 'text') if element.text == 'robot_base')
    left, foot = float(name.get('x')), float(name.get('y'))
    for element in elements(text, 'path'):
        if element.get('stroke') in {picture._hex(colour) for colour in (RED, GREEN, BLUE)}:
            ends = np.array(re.findall(r'-?[\d.]+', element.get('d')), dtype=float).reshape(-1, 2)
            for x, y in ends[0] + (ends[1] - ends[0]) * np.linspace(0, 1, 50)[:, None]:
                assert not (left < x < left + 65 and foot - 10 < y < foot), 'an axis goes through the name'


def test_on_a_dark_page_texts_and_axes_stand_out_from_the_ground():
    scene = Scene()
    for name, shape in (
        ('axes', Axes()),
        ('a', Label('a')),
        ('b', Label('b', colour=(0.3, 0.4, 0.5))),
        ('c', Label('c', 0.1, (0, 0, 0))),
        ('cloud', Points([[0, 0, 1], [0, 1, 1]], [(0, 0, 0.5), (1, 1, 0.8)])),
        ('trail', Line([[0, 0, 0], [1, 0, 0]], [(0.1, 0.2, 0.4)])),
    ):
        scene.set(name, shape)
    text = picture.svg(scene, 'a caption', problems=['a problem'])
    for element in elements(text, 'style'):
        changed = dict(re.findall(r'="(#[0-9a-f]+)"\] { (?:fill|stroke): (#[0-9a-f]+) }', element.text))
    ground = changed[elements(text, 'rect')[0].get('fill')]
    words = {changed[element.get('fill')] for element in elements(text, 'text')}
    axes = {changed[picture._hex(colour)] for colour in (RED, GREEN, BLUE)}
    strokes = {element.get('stroke') for element in elements(text, 'path')} - {picture._GRID}
    marks = {changed.get(colour, colour) for colour in strokes} - axes - words
    assert len(words) == 5 and len(axes) == len(marks) == 3
    assert min(contrast(colour, ground) for colour in words) > 4.5
    assert min(contrast(colour, ground) for colour in axes | marks) > 3
    assert changed['#fff'] == ground  # around the names
