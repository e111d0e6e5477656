"""Scenes: what stands around the robot, and where it can be sent. They are YAML files in ``scenes/``."""

from dataclasses import dataclass, field
from math import isfinite
from pathlib import Path

import yaml
from ament_index_python.packages import get_package_share_directory

COLOURS = {  # red, green, blue, alpha
    'wall': (0.80, 0.82, 0.86, 1.0),
    'wood': (0.76, 0.60, 0.42, 1.0),
    'metal': (0.62, 0.66, 0.72, 1.0),
    'grey': (0.45, 0.47, 0.52, 1.0),
    'red': (0.85, 0.30, 0.28, 1.0),
    'green': (0.33, 0.62, 0.42, 1.0),
    'blue': (0.26, 0.48, 0.80, 1.0),
    'orange': (0.93, 0.58, 0.22, 1.0),
}

Pose2D = tuple[float, float, float]  # x, y in metres and yaw in radians, in the frame map


class SceneError(ValueError):
    """A scene that does not exist or cannot be read; the text says which and why."""


@dataclass(frozen=True)
class Wall:
    """A box that stands on the floor and never moves: a wall or a piece of furniture.

    :param at: x and y of its centre, in metres, in the frame map.
    :param size: lengths along x and y, in metres.
    """

    name: str
    at: tuple[float, float]
    size: tuple[float, float]
    height: float = 0.6
    colour: tuple[float, float, float, float] = COLOURS['wall']


@dataclass(frozen=True)
class Scene:
    """A floor at z = 0 with walls on it, and the places to which the robot can be sent.

    :param start: where the robot's base_footprint begins: x, y, yaw.
    :param stations: x, y, yaw by name.
    :param colours: of the stations' discs on the floor, by name.
    """

    name: str = 'empty'
    start: Pose2D = (0.0, 0.0, 0.0)
    stations: dict[str, Pose2D] = field(default_factory=dict)
    walls: tuple[Wall, ...] = ()
    colours: dict[str, tuple[float, float, float, float]] = field(default_factory=dict)


def names() -> list[str]:
    """The scenes that come with this package."""
    return sorted(file.stem for file in _directory().glob('*.yaml'))


def load(scene: 'str | Path | Scene') -> Scene:
    """Return a scene: by its name (see `names`), from a YAML file, or as given.

    :raises SceneError: there is no such scene, or the file is none.
    """
    if isinstance(scene, Scene):
        return scene
    path = Path(scene)
    if path.suffix not in ('.yaml', '.yml'):
        path = _directory() / f'{scene}.yaml'
        if not path.is_file():
            raise SceneError(f'there is no scene {str(scene)!r}; there are {", ".join(names())}, or give a .yaml file')
    try:
        return _read(path.stem, yaml.safe_load(path.read_text()) or {})
    except OSError as error:
        raise SceneError(f'cannot read the scene {path}: {error.strerror}') from None
    except yaml.YAMLError as error:
        raise SceneError(f'{path} is no YAML: {" ".join(str(error).split())}') from None
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise SceneError(f'{path} is no scene: {type(error).__name__}: {error}') from None


def _directory() -> Path:
    return Path(get_package_share_directory('mujoco_world'), 'scenes')


def _read(name: str, text: dict) -> Scene:
    walls = tuple(
        Wall(
            str(one['name']),
            _numbers(one['at'], 2),
            _positive(one['size'], 2),
            *_positive([one.get('height', 0.6)], 1),
            COLOURS[one.get('colour', 'wall')],
        )
        for one in text.get('walls') or ()
    )
    if len({wall.name for wall in walls}) < len(walls):
        raise ValueError('two walls have the same name')
    return Scene(
        name=name,
        start=_numbers(text.get('start', (0.0, 0.0, 0.0)), 3),
        stations={key: _numbers(pose, 3) for key, pose in (text.get('stations') or {}).items()},
        walls=walls,
        colours={key: COLOURS[colour] for key, colour in (text.get('colours') or {}).items()},
    )


def _numbers(values, count: int) -> tuple[float, ...]:
    numbers = tuple(float(value) for value in values)
    if len(numbers) != count or not all(map(isfinite, numbers)):
        raise ValueError(f'{list(values)} are not {count} numbers')
    return numbers


def _positive(values, count: int) -> tuple[float, ...]:
    numbers = _numbers(values, count)
    if min(numbers) <= 0:
        raise ValueError(f'{list(values)}: a size must be above zero')
    return numbers
