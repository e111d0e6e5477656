"""The simulation and the pictures, without ROS."""

import math
import random
import sys
import types
from xml.etree import ElementTree

import pytest
from turtlesim_nodes.canvas import BLANK, Canvas
from turtlesim_nodes.draw_square import SquareDriver
from turtlesim_nodes.svg import draw_svg
from turtlesim_nodes.teleop import KeyDecoder
from turtlesim_nodes.window import NoWindowError, Window
from turtlesim_nodes.world import CENTRE, DEFAULT_PEN, SIZE, STEP, TRAIL_POINTS, TRAILS, World


@pytest.fixture
def world():
    return World(random_source=random.Random(0))


def run(world, seconds, begin=0.0):
    """Step through simulated seconds; return the bumps."""
    return [bump for i in range(round(seconds / STEP)) for bump in world.step(begin + i * STEP)]


def test_the_world_has_the_size_of_stock_and_the_turtle_starts_in_its_middle(world):
    assert f'{SIZE:f}' == '11.088889'
    turtle = world.spawn()
    assert (turtle.name, f'{turtle.x:f}', f'{turtle.y:f}', turtle.theta) == ('turtle1', '5.544445', '5.544445', 0.0)


def test_a_step_is_16_ms_of_motion(world):
    turtle = world.spawn()
    turtle.command(0.0, 2.0, 0.0)
    world.step(0.0)
    assert turtle.x == pytest.approx(CENTRE + 2.0 * 0.016)
    assert turtle.y == CENTRE


def test_a_velocity_command_lasts_one_second_and_no_longer(world):
    turtle = world.spawn()
    turtle.command(0.0, 1.0, 0.0)
    world.step(1.0)
    assert turtle.linear == 1.0
    world.step(1.001)
    assert turtle.linear == 0.0


def test_driving_backwards_shows_a_positive_speed_as_stock_does(world):
    turtle = world.spawn()
    turtle.command(0.0, -1.5, 0.0)
    world.step(0.0)
    assert turtle.x < CENTRE and turtle.linear == 1.5


def test_a_circle_comes_back(world):
    turtle = world.spawn()
    for i in range(round(2 * math.pi / STEP)):
        turtle.command(i * STEP, 1.0, 1.0)
        world.step(i * STEP)
    assert (turtle.x, turtle.y) == (pytest.approx(CENTRE, abs=0.03), pytest.approx(CENTRE, abs=0.03))


@pytest.mark.parametrize(
    'theta, axis, inside, shown',
    [(0.0, 'x', SIZE, 'x'), (math.pi, 'x', 0.0, 'x'), (math.pi / 2, 'y', SIZE, 'y'), (-math.pi / 2, 'y', 0.0, 'y')],
)
def test_walls_hold_the_turtle_and_report_the_bump_in_the_axes_of_the_paper(world, theta, axis, inside, shown):
    turtle = world.spawn(theta=theta)
    bumps = []
    for i in range(round(4 / STEP)):
        turtle.command(i * STEP, 2.0, 0.0)
        bumps += world.step(i * STEP)
    assert getattr(turtle, axis) == pytest.approx(inside, abs=1e-9)
    assert bumps[0].turtle is turtle
    value = getattr(bumps[0], shown)
    # On the paper y points down: above the upper wall y is negative.
    outside_high = (axis == 'x') == (inside == SIZE)
    assert value > SIZE if outside_high else value < 0
    assert abs(value - (SIZE if outside_high else 0.0)) <= 2.0 * STEP


def test_a_holonomic_turtle_goes_sideways(world):
    turtle = world.spawn()
    turtle.command(0.0, 0.0, 0.0, sideways=1.0)
    world.step(0.0)
    assert (turtle.x, turtle.y) == (CENTRE, pytest.approx(CENTRE + STEP))


@pytest.mark.parametrize('theta, turned', [(1.0, 1.0), (-1.0, -1.0), (math.pi - 0.5 + 2 * math.pi, math.pi - 0.5)])
def test_a_rotation_takes_the_short_way_and_stops(world, theta, turned):
    turtle = world.spawn()
    rotation = turtle.rotate_to(theta)
    world.step(0.0)
    assert turtle.angular == math.copysign(1.0, turned)
    run(world, 4.0, begin=STEP)
    assert rotation.done and turtle.rotation is None and turtle.angular == 0.0
    assert turtle.theta == pytest.approx(turned, abs=0.02)
    assert rotation.delta == pytest.approx(-turned, abs=0.02)


def test_a_velocity_command_ends_a_rotation(world):
    turtle = world.spawn()
    rotation = turtle.rotate_to(2.0)
    world.step(0.0)
    assert turtle.command(0.1, 1.0, 0.0) is rotation
    assert turtle.command(0.2, 1.0, 0.0) is None
    assert not rotation.done


def test_teleports_happen_with_the_next_step_in_order_and_draw(world):
    turtle = world.spawn()
    turtle.teleport_absolute(2.0, 3.0, math.pi / 2)
    turtle.teleport_relative(1.0, 0.0)
    assert (turtle.x, turtle.y) == (CENTRE, CENTRE)
    world.step(0.0)
    assert (turtle.x, turtle.y) == (pytest.approx(2.0), pytest.approx(4.0))
    assert world.trails[0].points[0] == (CENTRE, CENTRE) and world.trails[0].points[1] == (2.0, 3.0)


def test_a_teleport_out_of_the_world_ends_at_the_wall(world):
    turtle = world.spawn()
    turtle.teleport_absolute(20.0, 5.0, 0.0)
    (bump,) = world.step(0.0)
    assert (turtle.x, turtle.y, bump.x) == (SIZE, pytest.approx(5.0), 20.0)


def test_the_sensor_sees_lines_and_blank_paper(world):
    turtle = world.spawn()
    world.step(0.0)
    assert turtle.color_below == BLANK
    turtle.command(0.0, 1.0, 0.0)
    run(world, 0.5)
    assert turtle.color_below == DEFAULT_PEN
    world.clear()
    turtle.command(10.0, 0.0, 0.0)
    world.step(10.0)
    assert turtle.color_below == BLANK


def test_the_pen_changes_colour_and_width_and_can_be_lifted(world):
    turtle = world.spawn()
    turtle.set_pen((255, 0, 0), 5, down=True)
    turtle.teleport_relative(1.0, 0.0)
    world.step(0.0)
    turtle.set_pen((0, 255, 0), 5, down=False)
    turtle.teleport_relative(1.0, 0.0)
    world.step(0.0)
    turtle.set_pen((0, 0, 255), 0, down=True)
    turtle.teleport_relative(1.0, 0.0)
    world.step(0.0)
    assert [(trail.color, trail.width) for trail in world.trails] == [((255, 0, 0), 5), ((0, 0, 255), 1)]
    assert world.canvas.pixel((CENTRE + 0.5) * 45, CENTRE * 45) == (255, 0, 0)
    assert world.canvas.pixel((CENTRE + 1.5) * 45, CENTRE * 45) == BLANK


def test_names_are_given_in_order_and_only_once(world):
    assert world.spawn().name == 'turtle1'
    assert world.spawn(name='turtle2').name == 'turtle2'
    assert world.spawn().name == 'turtle3'
    assert world.spawn(name='turtle1') is None
    assert world.kill('turtle1').name == 'turtle1'
    assert world.kill('turtle1') is None
    assert world.reset().name == 'turtle1'
    assert list(world.turtles) == ['turtle1'] and not world.trails


@pytest.mark.parametrize('bad', [math.nan, math.inf, -math.inf])
def test_numbers_that_are_none_do_not_get_in(world, bad):
    turtle = world.spawn()
    for attempt in (
        lambda: turtle.command(0.0, bad, 0.0),
        lambda: turtle.command(0.0, 0.0, bad),
        lambda: turtle.teleport_absolute(bad, 0.0, 0.0),
        lambda: turtle.teleport_relative(0.0, bad),
        lambda: turtle.rotate_to(bad),
        lambda: world.spawn(x=bad),
    ):
        with pytest.raises(ValueError, match='finite'):
            attempt()
    assert world.step(0.0) == [] and (turtle.x, turtle.y) == (CENTRE, CENTRE)


def test_trails_stay_bounded_however_long_a_turtle_drives(world):
    turtle = world.spawn()
    for i in range(3 * TRAIL_POINTS):
        turtle.command(i * STEP, 3.0, 1.0)
        world.step(i * STEP)
    assert len(world.trails) > 1 and world.trails.maxlen == TRAILS
    assert all(len(trail.points) <= TRAIL_POINTS for trail in world.trails)
    assert world.trails[0].points[-1] == world.trails[1].points[0], 'the line has a gap'


@pytest.mark.parametrize('end', [(40, 20), (20, 40), (40, 40), (0, 20), (20, 20), (25, 33)])
def test_a_line_covers_just_the_pixels_near_it(end):
    canvas, start, width = Canvas(61), (20, 20), 5
    canvas.line(start, end, (1, 2, 3), width)
    length = math.dist(start, end)
    ux, uy = ((end[0] - start[0]) / length, (end[1] - start[1]) / length) if length else (1.0, 0.0)
    for y in range(61):
        for x in range(61):
            along = (x - start[0]) * ux + (y - start[1]) * uy
            across = abs((y - start[1]) * ux - (x - start[0]) * uy)
            outside = max(across - width / 2, -width / 2 - along, along - length - width / 2)
            if abs(outside) > 1e-6:
                assert (canvas.pixel(x, y) == (1, 2, 3)) == (outside < 0), (x, y)


def test_lines_off_the_paper_do_no_harm():
    canvas = Canvas(10)
    canvas.line((-100, -100), (200, 50), (0, 0, 0), 255)
    canvas.line((50, 50), (60, 60), (9, 9, 9), 3)
    assert canvas.pixel(-1, 5) == BLANK and canvas.pixel(5, 10) == BLANK


def test_the_svg_shows_background_trails_and_turtles(world):
    turtle = world.spawn(name='a<b')
    turtle.teleport_relative(1.0, 0.0)
    world.step(0.0)
    world.background = (1, 2, 3)
    root = ElementTree.fromstring(draw_svg(world, size=200))
    tag = '{http://www.w3.org/2000/svg}'
    assert root.get('width') == '200' and root.get('viewBox') == '0 0 500 500'
    assert root.find(f'{tag}rect').get('fill') == '#010203'
    assert root.find(f'{tag}polyline').get('points') == '249.5,249.5 294.5,249.5'
    assert root.find(f'{tag}g/{tag}title').text == 'a<b'
    assert len(root.findall(f'{tag}g/{tag}polygon')) > 5
    assert draw_svg(world) == draw_svg(world)


def test_the_square_driver_draws_a_square(world):
    turtle, said = world.spawn(), []
    driver = SquareDriver(said.append)
    corners = set()
    for i in range(round(30 / STEP)):
        pose = types.SimpleNamespace(
            x=turtle.x, y=turtle.y, theta=turtle.theta, linear_velocity=turtle.linear, angular_velocity=turtle.angular
        )
        command = driver.step(pose)
        if command is not None:
            turtle.command(i * STEP, *command)
        if turtle.angular:
            corners.add((round(turtle.x - CENTRE), round(turtle.y - CENTRE)))
        world.step(i * STEP)
    assert {(2, 0), (2, 2), (0, 2), (0, 0)} <= corners
    assert said[0] == f'New goal [{CENTRE + 2:f} {CENTRE:f}, 0.000000]'
    assert said[1] == 'Reached goal'


def test_keys_are_decoded_whatever_pieces_they_come_in():
    decoder = KeyDecoder()
    assert list(decoder.feed(b'\x1b[A\x1bOB')) == ['up', 'down']
    assert [key for byte in b'\x1b[Cg\x1b[D' for key in decoder.feed(bytes([byte]))] == ['right', 'g', 'left']
    assert list(decoder.feed(b'B\x1b[Zq')) == ['b', 'q']


def test_without_a_display_there_is_no_window(world, monkeypatch):
    monkeypatch.delenv('DISPLAY', raising=False)
    monkeypatch.delenv('WAYLAND_DISPLAY', raising=False)
    with pytest.raises(NoWindowError, match='there is no display'):
        Window(world)


def test_without_tkinter_there_is_no_window_and_the_remedy_is_named(world, monkeypatch):
    monkeypatch.setenv('DISPLAY', ':77')
    monkeypatch.setitem(sys.modules, 'tkinter', None)
    with pytest.raises(NoWindowError, match='apt install python3-tk'):
        Window(world)


class _Toolkit(types.ModuleType):
    """Stands in for tkinter: remembers what is on the canvas."""

    class TclError(Exception):
        pass

    def __init__(self):
        super().__init__('tkinter')
        self.items, self.options, self.destroyed, self.protocols = {}, {}, 0, {}
        toolkit = self

        class Tk:
            title = resizable = update = lambda self, *args: None

            def protocol(self, name, function):
                toolkit.protocols[name] = function

            def destroy(self):
                toolkit.destroyed += 1

        class Picture:
            def __init__(self, root, **options):
                pass

            def pack(self):
                pass

            def configure(self, **options):
                toolkit.options.update(options)

            def delete(self, what):
                keep = {key: item for key, item in toolkit.items.items() if what not in (key, item[2])}
                toolkit.items = keep

            def create_line(self, *points, **options):
                return self._create('line', points, options)

            def create_polygon(self, *points, **options):
                return self._create('polygon', points, options)

            def _create(self, kind, points, options):
                key = len(toolkit.items) + 1000
                while key in toolkit.items:
                    key += 1
                toolkit.items[key] = (kind, points, options.get('tags'))
                return key

        self.Tk, self.Canvas = Tk, Picture


def test_the_window_shows_the_world_and_follows_it(world, monkeypatch):
    toolkit = _Toolkit()
    monkeypatch.setenv('DISPLAY', ':77')
    monkeypatch.setitem(sys.modules, 'tkinter', toolkit)
    window = Window(world)
    turtle = world.spawn()
    for _ in range(3):
        turtle.teleport_relative(1.0, 0.5)
        world.step(0.0)
        window.show()
    lines = [item for item in toolkit.items.values() if item[0] == 'line']
    assert len(lines) == 1 and len(lines[0][1]) == 8, 'one line with four corners'
    turtles = len(toolkit.items) - 1
    assert turtles > 5 and toolkit.options['background'] == '#4556ff'
    world.clear()
    window.show()
    assert len(toolkit.items) == turtles
    toolkit.protocols['WM_DELETE_WINDOW']()
    window.show()
    assert window.closed and toolkit.destroyed == 1
