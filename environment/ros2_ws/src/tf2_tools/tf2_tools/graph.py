"""
The tree of frames as a picture.

The data is what `all_frames_as_yaml` tells, parsed: `{frame: {parent, broadcaster, rate, buffer_length,
most_recent_transform, oldest_transform}}`.
"""

from html import escape

FIELDS = (
    ('Broadcaster', 'broadcaster'),
    ('Average rate', 'rate'),
    ('Buffer length', 'buffer_length'),
    ('Most recent transform', 'most_recent_transform'),
    ('Oldest transform', 'oldest_transform'),
)
NOTHING = 'No tf data received'


def label(entry):
    """Return the lines that describe a transform."""
    return [f'{title}: {entry[key]}' for title, key in FIELDS]


def roots(data):
    """Return the frames that have no parent themselves, in the order in which they are mentioned."""
    return [parent for parent in dict.fromkeys(entry['parent'] for entry in data.values()) if parent not in data]


def _quote(text):
    return '"' + str(text).replace('\\', '\\\\').replace('"', '\\"') + '"'


def generate_dot(data, recorded_time):
    """
    Return the frames as a Graphviz digraph.

    :param recorded_time: when, as `(seconds, nanoseconds)`.
    """
    if not data:
        return f'digraph G {{ "{NOTHING}" }}'
    lines = ['digraph G {']
    for frame, entry in data.items():
        text = ''.join(line.replace('"', "'") + '\\n' for line in label(entry))
        lines.append(f'{_quote(entry["parent"])} -> {_quote(frame)}[label=" {text}"];')
    lines += [
        'edge [style=invis];',
        ' subgraph cluster_legend { style=bold; color=black; label ="view_frames Result";',
        f'"Recorded at time: {recorded_time[0] + recorded_time[1] / 1e9}"[ shape=plaintext ] ;',
    ]
    top = roots(data)
    lines.append('}' + (f'->{_quote(top[-1])};' if top else ''))
    return '\n'.join([*lines, '}'])


# The picture without Graphviz: every level of the tree one row; sizes in pixels.
COLUMN, ROW, BOX_HEIGHT, LINE_HEIGHT, MARGIN, CHARACTER = 260, 170, 36, 14, 40, 8


def _layout(data):
    """Return `{frame: (column, row)}`: leaves side by side, parents above the middle of their children."""
    children = {}
    for frame, entry in data.items():
        children.setdefault(entry['parent'], []).append(frame)
    places = {}
    columns = 0
    # Frames in a loop hang on no root: after the roots, whatever is left is begun with anywhere.
    for start in [*roots(data), *data]:
        if start in places:
            continue
        seen = {start}
        stack = [(start, 0, False)]  # a frame comes twice: to unfold its children, and when these are placed
        while stack:
            frame, row, unfolded = stack.pop()
            below = children.get(frame, [])
            if not unfolded:
                new = [child for child in below if child not in seen and child not in places]
                seen.update(new)
                stack += [(frame, row, True), *((child, row + 1, False) for child in reversed(new))]
                continue
            placed = [places[child][0] for child in below if child in places]
            if placed:
                places[frame] = (sum(placed) / len(placed), row)
            else:
                places[frame] = (columns, row)
                columns += 1
    return places


def generate_svg(data, recorded_time):
    """Return the same picture as SVG, drawn without Graphviz."""
    places = _layout(data)
    title = f'Recorded at time: {recorded_time[0] + recorded_time[1] / 1e9}' if data else NOTHING
    width = max([MARGIN + (column + 1) * COLUMN for column, _ in places.values()], default=COLUMN) + MARGIN
    height = max([(row + 1) * ROW for _, row in places.values()], default=0) + MARGIN

    def centre(frame):
        column, row = places[frame]
        return MARGIN + (column + 0.5) * COLUMN, 2 * MARGIN + row * ROW

    shapes = [f'<text x="{MARGIN}" y="{MARGIN / 2}">view_frames Result. {escape(title)}</text>']
    for frame, entry in data.items():
        (x0, y0), (x1, y1) = centre(entry['parent']), centre(frame)
        shapes.append(
            f'<path d="M{x0:g},{y0 + BOX_HEIGHT / 2:g} C{x0:g},{y0 + ROW / 2:g} {x1:g},{y1 - ROW / 2:g} '
            f'{x1:g},{y1 - BOX_HEIGHT / 2:g}" fill="none" stroke="black" marker-end="url(#arrow)"/>'
        )
        above = y1 - BOX_HEIGHT / 2 - 12 - LINE_HEIGHT * len(FIELDS)
        shapes += [
            f'<text x="{x1 + 8:g}" y="{above + LINE_HEIGHT * number:g}" font-size="11">{escape(line)}</text>'
            for number, line in enumerate(label(entry), start=1)
        ]
    for frame in places:
        x, y = centre(frame)
        half = max(40, CHARACTER * len(str(frame)) / 2 + 12)
        shapes += [
            f'<ellipse cx="{x:g}" cy="{y:g}" rx="{half:g}" ry="{BOX_HEIGHT / 2}" fill="white" stroke="black"/>',
            f'<text x="{x:g}" y="{y + 4:g}" text-anchor="middle">{escape(str(frame))}</text>',
        ]
    return '\n'.join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}" height="{height:g}" '
            f'viewBox="0 0 {width:g} {height:g}" font-family="sans-serif" font-size="14">',
            '<defs><marker id="arrow" markerWidth="8" markerHeight="8" refX="8" refY="4" orient="auto">'
            '<path d="M0,0 L8,4 L0,8 z"/></marker></defs>',
            '<rect width="100%" height="100%" fill="white"/>',
            *shapes,
            '</svg>\n',
        ]
    )
