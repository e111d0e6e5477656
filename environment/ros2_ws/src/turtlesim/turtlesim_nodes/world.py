"""
The simulation: turtles, their pens and the walls, without ROS and without a picture.

Lengths are metres (45 pixels of the 500-pixel paper), angles radians, speeds per second. x points right and y
up from the lower left corner; a turtle with heading 0 looks along x. All numbers are stock turtlesim's.
"""

import ctypes
import math
import random
from collections import deque
from dataclasses import dataclass, field

from turtlesim_nodes.canvas import Canvas

PIXELS = 500
METER = 45.0  # pixels
STEP = 0.016  # seconds of simulated time in one step, whatever the clock says
COMMAND_TIMEOUT = 1.0  # seconds after which a velocity command is forgotten
ROTATION_SPEED = 1.0
ROTATION_TOLERANCE = 0.02
DEFAULT_BACKGROUND = (0x45, 0x56, 0xFF)
DEFAULT_PEN = (0xB3, 0xB8, 0xFF)
DEFAULT_PEN_WIDTH = 3
BREEDS = (
    'ardent',
    'bouncy',
    'crystal',
    'dashing',
    'eloquent',
    'foxy',
    'galactic',
    'humble',
    'iron',
    'jazzy',
    'rolling',
)
TRAIL_POINTS = 500  # corners of one trail; a longer line goes on in a new trail
TRAILS = 200  # trails kept for drawing; older lines stay on the canvas, but leave the picture


def float32(value: float) -> float:
    """Round to the precision of a message field; too large becomes infinite."""
    return ctypes.c_float(value).value


SIZE = float32((PIXELS - 1) / METER)  # the side of the world: 11.088889 m
CENTRE = float32(SIZE / 2)  # 5.544445 m


def normalize(angle: float) -> float:
    """Return the same angle in [-pi, pi)."""
    return angle - 2 * math.pi * math.floor((angle + math.pi) / (2 * math.pi))


def to_pixels(x: float, y: float) -> tuple[float, float]:
    """Return where a point of the world is on the paper, whose y points down."""
    return x * METER, (SIZE - y) * METER


def check_finite(**values: float) -> None:
    """
    Let only real numbers into the world.

    :raises ValueError: naming the value that is infinite or not a number
    """
    for name, value in values.items():
        if not math.isfinite(value):
            raise ValueError(f'{name} is {value}, not a finite number')


@dataclass
class Trail:
    """A line that a pen has drawn, as corners in metres."""

    color: tuple[int, int, int]
    width: int
    points: list[tuple[float, float]] = field(default_factory=list)

    def extend(self, x: float, y: float) -> None:
        """Go on to (x, y). Steps shorter than a pixel only move the end, so a trail stays small."""
        if len(self.points) > 1 and math.dist(self.points[-2], (x, y)) * METER < 1.0:
            self.points[-1] = (x, y)
        else:
            self.points.append((x, y))


@dataclass
class Pen:
    """What a turtle draws with; the width is in pixels."""

    color: tuple[int, int, int] = DEFAULT_PEN
    width: int = DEFAULT_PEN_WIDTH
    down: bool = True


@dataclass
class Rotation:
    """A turn to an absolute heading. ``remaining`` and ``delta`` are radians."""

    theta: float
    start: float
    remaining: float = 0.0
    delta: float = 0.0
    done: bool = False


@dataclass
class Bump:
    """A turtle ran into a wall at (x, y), in the paper's axes: y points down, as in stock's message."""

    turtle: 'Turtle'
    x: float
    y: float


class Turtle:
    """One turtle. Only ``step`` moves it; the other methods say what the next steps do."""

    def __init__(self, name: str, x: float, y: float, theta: float, breed: str):
        check_finite(x=x, y=y, theta=theta)
        self.name, self.breed = name, breed
        self.x, self.y, self.theta = x, y, theta
        self.forward = self.sideways = self.angular = 0.0
        self.pen = Pen()
        self.trail: Trail | None = None
        self.color_below = (255, 255, 255)
        self.rotation: Rotation | None = None
        self._last_command = -math.inf
        self._teleports: list = []

    @property
    def linear(self) -> float:
        """The speed over ground; never negative, as in stock's pose."""
        return math.hypot(self.forward, self.sideways)

    def command(self, now: float, forward: float, angular: float, sideways: float | None = None) -> Rotation | None:
        """
        Drive for the next second, or until another command.

        :param now: the time in seconds, on the clock that ``World.step`` is given
        :param sideways: only for a holonomic turtle; None leaves it as it is
        :returns: the rotation that this command has ended, if there was one
        :raises ValueError: if a speed is not finite
        """
        check_finite(linear=forward, angular=angular, sideways=sideways or 0.0)
        self._last_command = now
        self.forward, self.angular = forward, angular
        if sideways is not None:
            self.sideways = sideways
        return self.end_rotation()

    def set_pen(self, color: tuple[int, int, int], width: int, down: bool) -> None:
        """Change the pen. Lifting it keeps its colour; a width of 0 means one pixel."""
        self.trail = None
        if down:
            self.pen = Pen(color, width or 1)
        else:
            self.pen.down = False

    def teleport_absolute(self, x: float, y: float, theta: float) -> None:
        """Be at a place with the next step, drawing a straight line to it."""
        check_finite(x=x, y=y, theta=theta)
        self._teleports.append((False, x, y, theta))

    def teleport_relative(self, linear: float, angular: float) -> None:
        """Turn, then jump forward, with the next step."""
        check_finite(linear=linear, angular=angular)
        self._teleports.append((True, linear, 0.0, angular))

    def rotate_to(self, theta: float) -> Rotation:
        """Begin a turn to a heading; a turn under way is forgotten."""
        check_finite(theta=theta)
        self.rotation = Rotation(theta, self.theta)
        return self.rotation

    def end_rotation(self) -> Rotation | None:
        """Give the turn up and return it, or None if there was none."""
        rotation, self.rotation = self.rotation, None
        return rotation

    def halt(self) -> None:
        """Stand still."""
        self.forward = self.sideways = self.angular = 0.0

    def step(self, world: 'World', now: float) -> Bump | None:
        """Live for one ``STEP``; return the bump if there was a wall in the way."""
        for relative, a, b, angle in self._teleports:
            old = (self.x, self.y)
            if relative:
                self.theta += angle
                self.x += math.cos(self.theta) * a
                self.y += math.sin(self.theta) * a
            else:
                self.x, self.y, self.theta = a, min(b, SIZE), angle
            self._draw(world, old)
        self._teleports.clear()

        self._turn(now)
        if now - self._last_command > COMMAND_TIMEOUT:
            self.halt()

        old = (self.x, self.y)
        self.theta = normalize(self.theta + self.angular * STEP)
        cos, sin = math.cos(self.theta), math.sin(self.theta)
        x = self.x + (cos * self.forward - sin * self.sideways) * STEP
        y = self.y + (sin * self.forward + cos * self.sideways) * STEP
        self.x, self.y = min(max(x, 0.0), SIZE), min(max(y, 0.0), SIZE)
        bump = None if (self.x, self.y) == (x, y) else Bump(self, x, SIZE - y)

        self.color_below = world.canvas.pixel(*to_pixels(self.x, self.y))
        if (self.x, self.y) != old:
            self._draw(world, old)
        return bump

    def _turn(self, now: float) -> None:
        rotation = self.rotation
        if rotation is None:
            return
        self.halt()
        rotation.remaining = normalize(normalize(rotation.theta) - self.theta)
        rotation.delta = normalize(rotation.start - self.theta)
        if abs(rotation.remaining) < ROTATION_TOLERANCE:
            rotation.done = True
            self.rotation = None
        else:
            self.angular = math.copysign(ROTATION_SPEED, rotation.remaining)
            self._last_command = now

    def _draw(self, world: 'World', old: tuple[float, float]) -> None:
        if not self.pen.down:
            return
        if self.trail is None or len(self.trail.points) >= TRAIL_POINTS:
            self.trail = Trail(self.pen.color, self.pen.width)
            self.trail.points.append(old)
            world.trails.append(self.trail)
        self.trail.extend(self.x, self.y)
        world.canvas.line(to_pixels(*old), to_pixels(self.x, self.y), self.pen.color, self.pen.width)


class World:
    """The square that the turtles live in. ``background`` may be changed at any time."""

    def __init__(self, *, random_source: random.Random | None = None):
        self.background = DEFAULT_BACKGROUND
        self.turtles: dict[str, Turtle] = {}
        self.trails: deque[Trail] = deque(maxlen=TRAILS)
        self.canvas = Canvas(PIXELS)
        self._random = random_source or random.Random()
        self._count = 0

    def spawn(self, x: float = CENTRE, y: float = CENTRE, theta: float = 0.0, name: str = '') -> Turtle | None:
        """
        Add a turtle of a random breed; without a name it becomes ``turtle1``, ``turtle2``, …

        :returns: the turtle, or None if the name is taken
        :raises ValueError: if the place or the heading is not finite
        """
        check_finite(x=x, y=y, theta=theta)
        if name in self.turtles:
            return None
        while not name or name in self.turtles:
            self._count += 1
            name = f'turtle{self._count}'
        self.turtles[name] = Turtle(name, x, y, theta, self._random.choice(BREEDS))
        return self.turtles[name]

    def kill(self, name: str) -> Turtle | None:
        """Take a turtle away, leaving its lines, and return it; None if there is none of that name."""
        return self.turtles.pop(name, None)

    def clear(self) -> None:
        """Wipe the paper."""
        self.canvas.clear()
        self.trails.clear()
        for turtle in self.turtles.values():
            turtle.trail = None

    def reset(self) -> Turtle:
        """Begin anew: a clean paper and one turtle, ``turtle1``, in the middle, which is returned."""
        self.turtles.clear()
        self._count = 0
        self.clear()
        return self.spawn()

    def step(self, now: float) -> list[Bump]:
        """
        Move every turtle by one ``STEP`` of 16 ms.

        :param now: the time in seconds; only differences count, for the timeout of commands
        :returns: who ran into a wall
        """
        bumps = [turtle.step(self, now) for turtle in sorted(self.turtles.values(), key=lambda turtle: turtle.name)]
        return [bump for bump in bumps if bump is not None]
