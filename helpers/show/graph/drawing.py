"""A graph as SVG with its problems in words below it, and as text. Colours suit light and dark pages."""

from dataclasses import dataclass, field

from jinja2 import Environment

from helpers.kernel.qos import words
from helpers.show import inline_svg
from helpers.show.colours import BAD
from helpers.show.graph.links import ROLES, Link
from helpers.show.graph.model import Graph
from helpers.show.graph.placement import Edge, NodeBox, place

NODE, KIND_COLOURS = '#3b6fb6', {'topic': 'currentColor', 'service': '#2e8b57', 'action': '#9a55b5'}
_FONT = "ui-monospace, SFMono-Regular, 'DejaVu Sans Mono', Menlo, Consolas, monospace"
_LETTER, _SMALL_LETTER = 7.0, 5.7  # px; width of a letter of names, and of types and labels
_LINE, _PORT = 17.0, 15.0  # px; height of a line in a box, distance of two arrows at a node
_MARGIN, _HEAD = 10.0, 30.0  # px; around all, and for the legend above
_LONGEST = 46  # letters of a name that are shown
_VERBS = {
    'publisher': 'publishes',
    'subscription': 'subscribes to',
    'client': 'asks',
    'server': 'serves',
    'action client': 'sends goals to',
    'action server': 'acts on',
}

_TEMPLATES = Environment(autoescape=True, trim_blocks=True, lstrip_blocks=True)
_DRAWING = _TEMPLATES.from_string("""\
<svg xmlns="http://www.w3.org/2000/svg" role="img" viewBox="0 0 {{ width }} {{ height }}" \
style="width: 100%; max-width: {{ width }}px; min-width: {{ (0.7 * width) | round | int }}px; height: auto; \
{{ page_colour }}" font-family="{{ font }}" font-size="11.6" fill="currentColor">
<title>{{ summary }}</title>
<desc>{{ description }}</desc>
<g font-family="system-ui, -apple-system, 'Segoe UI', 'DejaVu Sans', sans-serif" font-size="11">
{% for entry in legend %}
{% if entry.dashed is defined %}
<path d="M{{ entry.x }} 12h20" stroke="{{ entry.colour }}" stroke-width="1.5" \
{% if entry.dashed %}stroke-dasharray="5 4" {% endif %}stroke-opacity="0.8"/>
{% else %}
<rect x="{{ entry.x }}" y="6" width="18" height="12" rx="{{ entry.rx }}" fill="{{ entry.colour }}" \
fill-opacity="{{ entry.fill }}" stroke="{{ entry.colour }}" stroke-width="1.2"/>
{% endif %}
<text x="{{ entry.x + 25 }}" y="16" fill-opacity="0.8">{{ entry.text }}</text>
{% endfor %}
</g>
{% for arrow in arrows %}
<g {% if arrow.bad %}color="{{ bad }}"{% endif %}><title>{{ arrow.title }}</title>
<path d="{{ arrow.path }}" fill="none" stroke="currentColor" stroke-opacity="0" stroke-width="12"/>
<path d="{{ arrow.path }}" fill="none" stroke="currentColor" stroke-width="{{ 2 if arrow.bad else 1.4 }}" \
stroke-opacity="{{ 1 if arrow.bad else 0.6 }}" {% if arrow.dashed %}stroke-dasharray="5 4"{% endif %}/>
<path d="{{ arrow.head }}" fill="currentColor" fill-opacity="{{ 1 if arrow.bad else 0.75 }}"/>
{% if arrow.label %}
<text x="{{ arrow.label_x }}" y="{{ arrow.label_y }}" text-anchor="{{ arrow.anchor }}" font-size="9.4" \
fill="currentColor" fill-opacity="{{ 1 if arrow.bad else 0.75 }}">{{ arrow.label }}</text>
{% endif %}
</g>
{% endfor %}
{% for box in boxes %}
<g><title>{{ box.title }}</title>
{% if box.twice %}
<rect x="{{ box.x - 3 }}" y="{{ box.y - 3 }}" width="{{ box.width + 6 }}" height="{{ box.height + 6 }}" \
rx="{{ box.rx + 3 }}" fill="none" stroke="{{ box.colour }}" stroke-width="1"/>
{% endif %}
<rect x="{{ box.x }}" y="{{ box.y }}" width="{{ box.width }}" height="{{ box.height }}" rx="{{ box.rx }}" \
fill="{{ box.colour }}" fill-opacity="{{ box.fill }}" stroke="{{ bad if box.problems else box.colour }}" \
stroke-width="{{ 2.2 if box.problems else 1.2 }}"/>
{% for line in box.lines %}
<text x="{{ box.middle }}" y="{{ line.y }}" text-anchor="middle" \
{% if line.small %}font-size="9.4" fill-opacity="0.7"{% endif %}\
{% if box.node %} fill="#ffffff" font-weight="600"{% endif %}>{{ line.text }}</text>
{% endfor %}
{% for number in box.problems %}
<circle cx="{{ box.x + box.width - 4 - 18 * loop.index0 }}" cy="{{ box.y - 2 }}" r="8" fill="{{ bad }}"/>
<text x="{{ box.x + box.width - 4 - 18 * loop.index0 }}" y="{{ box.y + 1.6 }}" text-anchor="middle" font-size="10" \
font-weight="700" fill="#ffffff">{{ number }}</text>
{% endfor %}
</g>
{% endfor %}
</svg>
""")
_PAGE = _TEMPLATES.from_string("""\
{% if drawing %}
<div style="overflow-x: auto">
{{ drawing | safe }}
</div>
{% endif %}
<div style="font-size: 0.92em; opacity: 0.8">{{ summary }}</div>
{% for problem in problems %}
<div style="margin-top: 0.35em; padding-left: 2em; text-indent: -2em"><span style="display: inline-block; \
text-indent: 0; width: 1.45em; line-height: 1.45em; border-radius: 50%; background: {{ bad }}; color: #fff; \
font-weight: 700; font-size: 0.85em; text-align: center; margin-right: 0.6em">{{ loop.index }}</span>\
<span style="text-indent: 0">{{ problem.text }}</span></div>
{% endfor %}
""")


class GraphPicture:
    """A graph as Jupyter shows it."""

    def __init__(self, graph: Graph):
        self.graph = graph

    def _repr_mimebundle_(self, include=None, exclude=None) -> dict[str, str]:
        return {'text/html': html(self.graph), 'text/plain': str(self)}

    def __str__(self) -> str:
        return text(self.graph)

    __repr__ = __str__


def summary(graph: Graph) -> str:
    """One line: the domain, how many of each, and how many problems; or that there is nothing."""
    if not graph.nodes:
        where = '' if graph.namespace == '/' else f' in the namespace {graph.namespace}'
        return f'Domain {graph.domain_id}: no node is running{where}.'
    counts = [(len(graph.nodes), 'node'), *((len(graph.names(kind)), kind) for kind in KIND_COLOURS)]
    there = [f'{count} {word}{"s" * (count != 1)}' for count, word in counts if count or word in ('node', 'topic')]
    wrong = len(graph.problems)
    there += [f'{wrong} problem{"s" * (wrong != 1)}' if wrong else 'no problem found'] if graph.links else []
    return f'Domain {graph.domain_id}: {", ".join(there)}'


def text(graph: Graph) -> str:
    """The graph as lines: each node with what it does, then the problems."""
    lines = [summary(graph)]
    for node in sorted(set(graph.nodes)):
        lines.append(node)
        mine = sorted(
            (link for link in graph.links if link.node == node), key=lambda one: (list(ROLES).index(one.role), one.key)
        )
        lines += [f'  {_sentence(link)}' for link in mine]
    return '\n'.join([*lines, *(f'{number}. {problem.text}' for number, problem in enumerate(graph.problems, 1))])


def html(graph: Graph) -> str:
    """The graph as SVG, and its problems as numbered lines."""
    return _Drawing(graph).render()


@dataclass
class _Arrow:
    """Equal edges between a node and a box, drawn as one."""

    links: list[Link]
    edge: Edge
    ends: dict = field(default_factory=dict)  # key of a box -> (x, y) where the arrow meets it


class _Drawing:
    """Places boxes and arrows."""

    def __init__(self, graph: Graph):
        self.graph = graph
        self.bad = {link for problem in graph.problems for link in problem.links}
        self.groups = self._groups()
        self.arrows = [_Arrow(links, _edge(links[0], key)) for key, by_role in self.groups.items() for links in by_role]
        self.boxes = {name: self._node_box(name) for name in sorted(set(graph.nodes))}
        self.boxes |= {key: self._channel_box(key) for key in self.groups}
        width, height = place(self.boxes, [arrow.edge for arrow in self.arrows], 46, 20)
        for box in self.boxes.values():
            box.x, box.y = box.x + _MARGIN, box.y + _HEAD + _MARGIN
        for arrow in self.arrows:
            arrow.edge.points = [(x + _MARGIN, y + _HEAD + _MARGIN) for x, y in arrow.edge.points]
        self._ports()
        self.legend, legend_width = self._legend()
        self.width = round(max(width, legend_width, 240) + 2 * _MARGIN)
        self.height = round(height + _HEAD + 2 * _MARGIN)

    def _groups(self) -> dict[tuple, list[list[Link]]]:
        """(kind, names) -> its edges, equal ones together. Those with one and the same participant share a box."""
        channels: dict[tuple, list[Link]] = {}
        for link in self.graph.links:
            channels.setdefault((link.kind, link.name), []).append(link)
        same: dict[tuple, list[str]] = {}
        for (kind, name), links in channels.items():
            lonely = len(links) == 1 and links[0] not in self.bad
            looks = tuple((link.node, link.role, _label(link)) for link in links)
            same.setdefault((kind, looks if lonely else name), []).append(name)
        groups = {}
        for (kind, _), names in same.items():
            by_role: dict[tuple, list[Link]] = {}
            for name in names:
                for link in channels[kind, name]:
                    by_role.setdefault((link.node, link.role, link.out, _label(link)), []).append(link)
            groups[kind, tuple(names)] = list(by_role.values())
        return groups

    def _node_box(self, name: str) -> NodeBox:
        ends = [
            sum(arrow.edge.start == name for arrow in self.arrows),
            sum(arrow.edge.end == name for arrow in self.arrows),
        ]
        count = self.graph.nodes.count(name)
        letters = len(_short(name)) + (len(f' ×{count}') if count > 1 else 0)
        return NodeBox(letters * _LETTER + 26, max(32.0, _PORT * (max(ends) + bool(min(ends))) + 8))

    def _channel_box(self, key: tuple) -> NodeBox:
        lines = self._lines(key)
        width = max(len(line) * (_SMALL_LETTER if small else _LETTER) for line, small in lines)
        ends = max(
            sum(arrow.edge.start == key for arrow in self.arrows), sum(arrow.edge.end == key for arrow in self.arrows)
        )
        return NodeBox(width + 26, max(len(lines) * _LINE + 8, 7.0 * ends + 8))

    def _lines(self, key: tuple) -> list[tuple[str, bool]]:
        """What stands in a box, and whether it is small."""
        kind, names = key
        if len(names) > 1:
            return [(_short(name), False) for name in names]
        types = sorted({link.type for links in self.groups[key] for link in links})
        return [(_short(names[0]), False), *((_short(one), True) for one in types)]

    def _ports(self) -> None:
        """Where arrows meet boxes: side by side, in the order of what is at their other ends."""
        sides: dict[tuple, list] = {}
        for arrow in self.arrows:
            start, end = arrow.edge.start, arrow.edge.end
            left, right = (end, start) if arrow.edge.backward else (start, end)
            beyond = arrow.edge.points[0] if arrow.edge.points else (0, self.boxes[right].y)
            before = arrow.edge.points[-1] if arrow.edge.points else (0, self.boxes[left].y)
            sides.setdefault((left, 'right'), []).append((beyond[1], arrow))
            sides.setdefault((right, 'left'), []).append((before[1], arrow))
        for (key, side), found in sides.items():
            box = self.boxes[key]
            found.sort(key=lambda one: one[0])
            step = min(_PORT, (box.height - 6) / len(found))
            for number, (_, arrow) in enumerate(found):
                x = box.x + box.width / 2 * (1 if side == 'right' else -1)
                arrow.ends[key] = (x, box.y + (number - (len(found) - 1) / 2) * step)

    def render(self) -> str:
        numbers: dict = {}
        for number, problem in enumerate(self.graph.problems, 1):
            for key in self.groups:
                if any(link in problem.links for links in self.groups[key] for link in links):
                    numbers.setdefault(key, []).append(number)
            for name in problem.nodes:
                numbers.setdefault(name, []).append(number)
        drawing = _DRAWING.render(
            page_colour=inline_svg.PAGE_COLOUR,
            width=self.width,
            height=self.height,
            font=_FONT,
            bad=BAD,
            summary=summary(self.graph),
            description=text(self.graph),
            legend=self.legend,
            arrows=sorted(map(self._draw, self.arrows), key=lambda arrow: arrow['bad']),
            boxes=[self._drawn_box(key, box, numbers.get(key, [])) for key, box in self.boxes.items()],
        )
        return _PAGE.render(
            drawing=inline_svg.html(drawing, self.width, summary(self.graph)) if self.boxes else '',
            summary=summary(self.graph),
            problems=self.graph.problems,
            bad=BAD,
        )

    def _drawn_box(self, key, box: NodeBox, problems: list[int]) -> dict:
        node = isinstance(key, str)
        if node:
            count = self.graph.nodes.count(key)
            lines, title, kind = [(_short(key) + (f' ×{count}' if count > 1 else ''), False)], f'node {key}', 'node'
        else:
            kind, lines = key[0], self._lines(key)
            links = [link for links in self.groups[key] for link in links]
            title = '\n'.join(sorted({f'{kind} {link.name} [{link.type}]' for link in links}))
        top = box.y - len(lines) * _LINE / 2
        return {
            'x': round(box.x - box.width / 2, 1),
            'y': round(box.y - box.height / 2, 1),
            'width': round(box.width, 1),
            'height': round(box.height, 1),
            'middle': round(box.x, 1),
            'rx': {'node': 8, 'topic': 3}.get(kind, 14),
            'node': node,
            'title': title,
            'problems': problems,
            'colour': NODE if node else KIND_COLOURS[kind],
            'fill': 1 if node else 0.07,
            'twice': kind == 'action',
            'lines': [
                {'text': line, 'small': small, 'y': round(top + _LINE * number + 12.5, 1)}
                for number, (line, small) in enumerate(lines)
            ],
        }

    def _draw(self, arrow: _Arrow) -> dict:
        """A path from the left end to the right one; the head is where the edge ends."""
        edge, link = arrow.edge, arrow.links[0]
        left, right = (edge.end, edge.start) if edge.backward else (edge.start, edge.end)
        begin, end = arrow.ends[left], arrow.ends[right]
        label = _label(link)
        stub = len(label) * _SMALL_LETTER + 14 if label else 10
        node_left = left == link.node
        first = (begin[0] + (stub if node_left else 10), begin[1])
        last = (end[0] - (10 if node_left else stub), end[1])
        path, at = [f'M{begin[0]:.1f} {begin[1]:.1f}H{first[0]:.1f}'], first
        for number, point in enumerate([*edge.points, last]):
            if number % 2 == 0:  # from column to column; then straight through the column
                middle = (at[0] + point[0]) / 2
                path.append(f'C{middle:.1f} {at[1]:.1f} {middle:.1f} {point[1]:.1f} {point[0]:.1f} {point[1]:.1f}')
            else:
                path.append(f'H{point[0]:.1f}')
            at = point
        path.append(f'H{end[0]:.1f}')
        (x, y), back = (begin, 1) if edge.backward else (end, -1)
        if node_left:
            label_x = begin[0] + (12 if edge.backward else 6)
        else:
            label_x = end[0] - (6 if edge.backward else 12)
        return {
            'path': ''.join(path),
            'head': f'M{x:.1f} {y:.1f}l{8 * back} -4v8z',
            'title': '\n'.join(f'{link.node} {_sentence(link)}' for link in arrow.links),
            'bad': any(link in self.bad for link in arrow.links),
            'dashed': not link.reliable,
            'label': label,
            'label_x': round(label_x, 1),
            'anchor': 'start' if node_left else 'end',
            'label_y': round((begin if node_left else end)[1] - 3.5, 1),
        }

    def _legend(self) -> tuple[list[dict], float]:
        found, x = [], _MARGIN
        kinds = {key[0] for key in self.groups}
        entries = [{'text': 'node', 'rx': 4, 'colour': NODE, 'fill': 1}] if self.graph.nodes else []
        entries += [
            {'text': kind, 'rx': 2 if kind == 'topic' else 6, 'colour': colour, 'fill': 0.07}
            for kind, colour in KIND_COLOURS.items()
            if kind in kinds
        ]
        reliable = {link.reliable for link in self.graph.links if link.qos}
        entries += [
            {'text': words, 'dashed': dashed, 'colour': 'currentColor'}
            for words, dashed in (('reliable', False), ('best effort', True))
            if (not dashed) in reliable
        ]
        entries += [{'text': 'problem', 'dashed': False, 'colour': BAD}] if self.bad else []
        for entry in entries:
            found.append({**entry, 'x': round(x)})
            x += 46 + len(entry['text']) * 6.2
        return found, x


def _edge(link: Link, key: tuple) -> Edge:
    room = len(_label(link)) * _SMALL_LETTER
    return Edge(link.node, key, room_start=room) if link.out else Edge(key, link.node, room_end=room)


def _label(link: Link) -> str:
    """The QoS in two words; '' for services and actions."""
    if link.qos is None:
        return ''
    return ('reliable' if link.reliable else 'best effort') + (', latched' if link.latched else '')


def _sentence(link: Link) -> str:
    qos = f' ({", ".join(words(link.qos))})' if link.qos else ''
    return f'{_VERBS[link.role]} {link.name} [{link.type}]{qos}'


def _short(name: str) -> str:
    """A name that fits into a box: the middle of a very long one is left out."""
    if len(name) <= _LONGEST:
        return name
    half = (_LONGEST - 1) // 2
    return f'{name[:half]}…{name[-half:]}'
