"""The order in which the parts of a still picture are painted: hidden parts first.

Of two parts that overlap, the plane of a face tells which one is behind: a part all of which is on the far side of a
face is painted before it. Where planes do not decide (between lines, or for parts that hide each other in a ring), the
distances of their middles decide.
"""

import heapq
from dataclasses import dataclass

import numpy as np

_MOST_FACES, _MOST = 800, 1500  # more are ordered by their distances alone
_SUNK = 0.1  # if no plane decides otherwise: this share of a part may reach through a face


@dataclass
class Element:
    """One element of the picture."""

    element: str
    points: np.ndarray  #: N x 3, in space
    low: np.ndarray  #: its box in the picture
    high: np.ndarray
    normal: np.ndarray | None = None  #: of a face, towards the viewer
    layer: int = 0  #: higher ones are painted later, whatever the distances


def order(parts: list[Element], view_from: np.ndarray) -> list[str]:
    """Return the elements in the order in which to paint them.

    :param view_from: unit vector to the viewer.
    """
    by_distance = sorted(parts, key=lambda part: (part.layer, float((part.points @ view_from).mean())))
    lowest = [part for part in by_distance if part.layer == 0]
    return [part.element for part in _by_planes(lowest) + by_distance[len(lowest) :]]


def _by_planes(parts: list[Element]) -> list[Element]:
    """Order parts, which are given from far to near."""
    faces = [number for number, part in enumerate(parts) if part.normal is not None]
    if not faces or len(faces) > _MOST_FACES or len(parts) > _MOST:
        return parts
    first = _who_is_first(parts, faces)
    after = [np.flatnonzero(row) for row in first]  # the parts that must be painted after this one
    waiting = first.sum(axis=0)
    free = [number for number in range(len(parts)) if not waiting[number]]
    heapq.heapify(free)
    left, found = set(range(len(parts))), []
    while left:
        number = heapq.heappop(free) if free else _in_ring(left, after, waiting)
        if number not in left:
            continue
        left.remove(number)
        found.append(parts[number])
        for other in after[number]:
            waiting[other] -= 1
            if waiting[other] == 0:
                heapq.heappush(free, int(other))
    return found


def _in_ring(left: set[int], after: list[np.ndarray], waiting: np.ndarray) -> int:
    """Where to begin if the parts that are left hide each other in a ring.

    It is the part that the most others wait for, less those that it waits for itself: so a floor comes before the walls
    on it, even if an arrow lies a little below its surface. Of equal ones it is the farthest.
    """
    return min(left, key=lambda number: (waiting[number] - sum(int(other) in left for other in after[number]), number))


def _who_is_first(parts: list[Element], faces: list[int]) -> np.ndarray:
    """Return N x N booleans: the part of the row must be painted before that of the column."""
    points = np.vstack([part.points for part in parts])
    starts = np.cumsum([0, *(len(part.points) for part in parts[:-1])])
    normals = np.array([parts[face].normal for face in faces])
    height = points @ normals.T - np.einsum('ij,ij->i', normals, points[starts[faces]])
    highest, lowest = np.maximum.reduceat(height, starts), np.minimum.reduceat(height, starts)  # part x face
    little = 1e-5 * float(np.ptp(points, axis=0).max())
    says = _sides(highest, lowest, little, faces)
    roughly = _sides(highest, lowest, little + _SUNK * (highest - lowest), faces)
    says |= roughly & ~says & ~says.T
    low, high = np.array([part.low for part in parts]), np.array([part.high for part in parts])
    overlap = np.all((low[:, None] < high) & (low < high[:, None]), axis=2)
    return says & overlap


def _sides(highest: np.ndarray, lowest: np.ndarray, tolerance, faces: list[int]) -> np.ndarray:
    """What the planes of the faces decide, as N x N booleans; False where two of them contradict each other."""
    below, above = highest <= tolerance, lowest >= -tolerance
    says = np.zeros((len(highest), len(highest)), dtype=bool)
    says[:, faces] |= below & ~above
    says[faces, :] |= (above & ~below).T
    return says & ~says.T
