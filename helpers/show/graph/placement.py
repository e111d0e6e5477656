"""A layered layout: boxes in columns from left to right, so that most arrows lead to the right and few cross.

The steps are those of Sugiyama, Tagawa and Toda, "Methods for Visual Understanding of Hierarchical System Structures"
(1981): turn round edges that close a circle, give each box a column, order each column by the mean place of its
neighbours, place. A long edge gets a point in each column between. The heights in a column are a least-squares fit:
each box as near to the mean of its neighbours as the order and the gaps allow (isotonic regression).
"""

from dataclasses import dataclass, field

_SWEEPS = 12
_LANE = 16.0  # px; height of the place that a passing edge takes in a column


@dataclass
class NodeBox:
    """What is placed. `width` and `height` in px are given; `x`, `y` (of its centre) and `column` are found."""

    width: float
    height: float
    x: float = 0.0
    y: float = 0.0
    column: int = 0


@dataclass
class Edge:
    """From box to another box, by their keys. Found: `backward` (it leads to the left); `points` on its way."""

    start: object
    end: object
    room_start: float = 0.0  # px; for a label beside the box where it starts, and where it ends
    room_end: float = 0.0
    backward: bool = False
    points: list[tuple[float, float]] = field(default_factory=list)


def place(boxes: dict, edges: list[Edge], gap_x: float, gap_y: float) -> tuple[float, float]:
    """Place the boxes (by key) and route the edges; parts without connection stand below each other.

    :param gap_x: px between columns, labels not counted.
    :param gap_y: px between boxes of a column.
    :return: width and height of all, in px; the upper left corner is (0, 0).
    """
    width = top = 0.0
    for keys in _parts(boxes, edges):
        part = {key: boxes[key] for key in keys}
        w, h = _place_part(part, [edge for edge in edges if edge.start in part], gap_x, gap_y, top)
        width, top = max(width, w), top + h + gap_y
    return width, max(0.0, top - gap_y)


def _parts(boxes: dict, edges: list[Edge]) -> list[list]:
    """The connected parts; larger ones first, else in the order of the boxes."""
    near = {key: [] for key in boxes}
    for edge in edges:
        near[edge.start].append(edge.end)
        near[edge.end].append(edge.start)
    parts, seen = [], set()
    for key in boxes:
        if key in seen:
            continue
        seen.add(key)
        part = [key]
        for one in part:
            fresh = [other for other in dict.fromkeys(near[one]) if other not in seen]
            seen.update(fresh)
            part += fresh
        parts.append(sorted(part, key=list(boxes).index))
    return sorted(parts, key=len, reverse=True)


def _place_part(boxes: dict, edges: list[Edge], gap_x: float, gap_y: float, top: float) -> tuple[float, float]:
    columns = _columns(boxes, edges)
    chains = _chains(boxes, edges, columns)
    height = {key: boxes[key].height if key in boxes else _LANE for column in columns for key in column}
    left, right = {key: [] for key in height}, {key: [] for key in height}
    for chain in chains:
        for a, b in zip(chain, chain[1:], strict=False):
            right[a].append(b)
            left[b].append(a)
    columns = _order(columns, left, right)
    y = _heights(columns, height, left, right, gap_y)
    up = min(y[key] - height[key] / 2 for key in y)
    down = max(y[key] + height[key] / 2 for key in y)
    gaps = [gap_x] * len(columns)
    for edge in edges:
        for key, room in ((edge.start, edge.room_start), (edge.end, edge.room_end)):
            after = boxes[key].column - ((key == edge.start) == edge.backward)
            gaps[after] = max(gaps[after], gap_x + room)
    x = width = 0.0
    middle = []
    for column, gap in zip(columns, gaps, strict=True):
        wide = max((boxes[key].width for key in column if key in boxes), default=0.0)
        middle.append((x, x + wide))
        for key in column:
            if key in boxes:
                boxes[key].x, boxes[key].y = x + wide / 2, y[key] - up + top
        width, x = x + wide, x + wide + gap
    for edge, chain in zip(edges, chains, strict=True):
        first = boxes[chain[0]].column
        edge.points = []
        for number, key in enumerate(chain[1:-1], first + 1):
            begin, end = middle[number]
            edge.points += [(begin, y[key] - up + top), (end, y[key] - up + top)]
    return width, down - up


def _columns(boxes: dict, edges: list[Edge]) -> list[list]:
    """Give each box a column, and say which edges lead backward."""
    following = {key: [] for key in boxes}
    for edge in edges:
        following[edge.start].append(edge)
    entering = {edge.end for edge in edges}
    state: dict = {}

    def visit(key):
        state[key] = 'open'
        for edge in following[key]:
            edge.backward = state.get(edge.end) == 'open'
            if edge.end not in state:
                visit(edge.end)
        state[key] = 'done'

    for key in sorted(boxes, key=lambda key: key in entering):  # first those without an incoming edge
        if key not in state:
            visit(key)
    ahead = {key: [] for key in boxes}
    behind = {key: [] for key in boxes}
    for edge in edges:
        a, b = (edge.end, edge.start) if edge.backward else (edge.start, edge.end)
        ahead[a].append(b)
        behind[b].append(a)
    depth: dict = {}

    def longest(key) -> int:
        if key not in depth:
            depth[key] = max((longest(other) + 1 for other in behind[key]), default=0)
        return depth[key]

    for key in boxes:
        longest(key)
    for key in boxes:  # without an incoming edge: as far to the right as possible
        if not behind[key] and ahead[key]:
            depth[key] = min(depth[other] for other in ahead[key]) - 1
    columns = [[] for _ in range(max(depth.values()) + 1)]
    for key, box in boxes.items():
        box.column = depth[key]
        columns[box.column].append(key)
    return columns


def _chains(boxes: dict, edges: list[Edge], columns: list[list]) -> list[list]:
    """For each edge its boxes, with a point (a key of its own) in each column between, which also joins that column."""
    chains = []
    for number, edge in enumerate(edges):
        a, b = (edge.end, edge.start) if edge.backward else (edge.start, edge.end)
        chain = [a]
        for column in range(boxes[a].column + 1, boxes[b].column):
            point = ('point', number, column)
            columns[column].append(point)
            chain.append(point)
        chains.append([*chain, b])
    return chains


def _order(columns: list[list], left: dict, right: dict) -> list[list]:
    """Order each column by the mean place of its neighbours, in both directions; keep that with fewest crossings."""
    best, fewest = [column.copy() for column in columns], _crossings(columns, right)
    for sweep in range(_SWEEPS):
        forward = sweep % 2 == 0
        for number in range(1, len(columns)) if forward else range(len(columns) - 2, -1, -1):
            other = columns[number - 1 if forward else number + 1]
            place = {key: index for index, key in enumerate(other)}
            near = left if forward else right
            own = {key: index for index, key in enumerate(columns[number])}

            def mean(key, place=place, near=near, own=own):
                found = [place[one] for one in near[key]]
                return sum(found) / len(found) if found else own[key]

            columns[number] = sorted(columns[number], key=mean)
        count = _crossings(columns, right)
        if count < fewest:
            best, fewest = [column.copy() for column in columns], count
    return best


def _crossings(columns: list[list], right: dict) -> int:
    total = 0
    for column, following in zip(columns, columns[1:], strict=False):
        place = {key: index for index, key in enumerate(following)}
        ends = [sorted(place[other] for other in right[key]) for key in column]
        flat = [end for group in ends for end in group]
        total += sum(later < end for index, end in enumerate(flat) for later in flat[index + 1 :])
    return total


def _heights(columns: list[list], height: dict, left: dict, right: dict, gap: float) -> dict:
    """The y of each box and point, in px."""
    y = {}
    for column in columns:
        at = 0.0
        for key in column:
            y[key] = at + height[key] / 2
            at += height[key] + gap
    for sweep in range(2 * _SWEEPS):
        for column in columns if sweep % 2 == 0 else reversed(columns):
            wanted = []
            for key in column:
                near = [y[other] for other in left[key] + right[key]]
                wanted.append(sum(near) / len(near) if near else y[key])
            # After the least distances are subtracted, the values must only not decrease.
            offset, offsets = 0.0, []
            for index, key in enumerate(column):
                if index:
                    offset += (height[column[index - 1]] + height[key]) / 2 + gap
                offsets.append(offset)
            fitted = _isotonic([w - o for w, o in zip(wanted, offsets, strict=True)])
            y.update({key: f + o for key, f, o in zip(column, fitted, offsets, strict=True)})
    return y


def _isotonic(values: list[float]) -> list[float]:
    """The non-decreasing sequence nearest to `values` (pool adjacent violators)."""
    pools: list[list[float]] = []  # sum, count
    for value in values:
        pools.append([value, 1])
        while len(pools) > 1 and pools[-2][0] / pools[-2][1] > pools[-1][0] / pools[-1][1]:
            total, count = pools.pop()
            pools[-1][0] += total
            pools[-1][1] += count
    return [total / count for total, count in pools for _ in range(int(count))]
