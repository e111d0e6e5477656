"""The world as an SVG picture, for notebooks and documents."""

from html import escape

from turtlesim_nodes.shape import polygons
from turtlesim_nodes.world import PIXELS, Trail, World, to_pixels


def draw_svg(world: World, size: int = PIXELS) -> str:
    """
    Return the world as it is now: background, trails, turtles.

    :param size: side of the picture on the screen, in pixels
    :returns: the text of one ``<svg>`` element; the same world gives the same text
    """
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{size}" height="{size}" viewBox="0 0 {PIXELS} {PIXELS}">',
        f'<rect width="{PIXELS}" height="{PIXELS}" fill="{_rgb(world.background)}"/>',
    ]
    lines += [_polyline(trail) for trail in world.trails]
    for name in sorted(world.turtles):
        lines.append(f'<g><title>{escape(name)}</title>')
        for fill, corners in polygons(world.turtles[name]):
            lines.append(f'<polygon fill="{fill}" points="{_points(corners)}"/>')
        lines.append('</g>')
    return '\n'.join([*lines, '</svg>'])


def _polyline(trail: Trail) -> str:
    return (
        f'<polyline fill="none" stroke="{_rgb(trail.color)}" stroke-width="{trail.width}" '
        f'stroke-linecap="square" stroke-linejoin="round" points="{_points(trail.points)}"/>'
    )


def _points(corners) -> str:
    return ' '.join('{:.1f},{:.1f}'.format(*to_pixels(x, y)) for x, y in corners)


def _rgb(color: tuple[int, int, int]) -> str:
    return '#{:02x}{:02x}{:02x}'.format(*color)
