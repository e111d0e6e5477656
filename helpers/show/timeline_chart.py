"""The timeline chart: a recording (`helpers.show.timeline`) as SVG for a notebook, and as text."""

from jinja2 import Environment

from helpers.show import inline_svg

_COLOURS = ('#3b6fb6', '#b3541e', '#2e7d4f', '#8e4a9e', '#1f7a8c', '#a8324a', '#6b6f2a', '#5c5f66')
_LEFT, _WIDTH, _LANE, _BAR = 90, 760, 44, 20  # px: begin of the time axis, whole width, height of a lane, of a bar
_RIGHT = 74  # px; room for the label of the last bar
_CHARACTER = 6.8  # px; width of a character
_MOST_LINES = 60  # of text
_KINDS = {
    'publish': 'publishes on',
    'receive': 'receives from',
    'request': 'sends a request to',
    'take': 'takes a request of',
    'respond': 'sends a response of',
    'answer': 'gets a response of',
}

_AWAITS = (
    '<rect x="0" y="6" width="16" height="12" rx="3" fill="currentColor" fill-opacity="0.1" '
    'stroke="currentColor" stroke-dasharray="4 3"/>'
)
_LINE = '<line x1="-2" y1="12" x2="16" y2="12" stroke="currentColor" stroke-width="1.2" stroke-opacity="0.75" {}/>'

_TEMPLATE = Environment(autoescape=True, trim_blocks=True, lstrip_blocks=True).from_string("""\
<svg xmlns="http://www.w3.org/2000/svg" role="img" viewBox="0 0 {{ width }} {{ height }}" \
style="width: 100%; max-width: {{ width }}px; height: auto; {{ page_colour }}" \
font-family="system-ui, -apple-system, 'Segoe UI', 'DejaVu Sans', sans-serif" font-size="12" fill="currentColor">
<title>{{ summary }}</title>
<desc>{{ description }}</desc>
{% for entry in legend %}
<rect x="{{ entry.x }}" y="6" width="12" height="12" rx="3" fill="{{ entry.colour }}"/>
<text x="{{ entry.x + 17 }}" y="16">{{ entry.text }}</text>
{% endfor %}
{% for entry in signs %}
{{ entry.sign }}
<text x="{{ entry.x + 12 }}" y="16">{{ entry.text }}</text>
{% endfor %}
{% for tick in ticks %}
<line x1="{{ tick.x }}" y1="{{ top }}" x2="{{ tick.x }}" y2="{{ bottom }}" stroke="currentColor" stroke-opacity="0.13"/>
<text x="{{ tick.x }}" y="{{ bottom + 15 }}" text-anchor="middle" fill-opacity="0.75">{{ tick.text }}</text>
{% endfor %}
{% for lane in lanes %}
<rect x="{{ left }}" y="{{ lane.y }}" width="{{ width - left - 8 }}" height="{{ lane.height }}" fill="currentColor" \
fill-opacity="{{ '0.055' if loop.index is odd else '0.02' }}"/>
<text x="{{ left - 8 }}" y="{{ lane.y + lane.height / 2 + 4 }}" text-anchor="end">{{ lane.text }}</text>
{% endfor %}
{% for bar in bars %}
<g><title>{{ bar.title }}</title>
{% if bar.rest %}
<rect x="{{ bar.x - 2 }}" y="{{ bar.y - 3 }}" width="{{ bar.width + 4 }}" height="{{ bar.height + 6 }}" rx="5" \
fill="{{ bar.colour }}" fill-opacity="0.16" stroke="{{ bar.colour }}" stroke-width="1.2" stroke-dasharray="4 3"/>
{% endif %}
{% for part in bar.parts %}
<rect x="{{ part.x }}" y="{{ bar.y }}" width="{{ part.width }}" height="{{ bar.height }}" \
rx="{{ [4, part.width / 2] | min }}" fill="{{ bar.colour }}"/>
{% endfor %}
</g>
{% endfor %}
{% for path in paths %}
<path d="{{ path.d }}" fill="none" stroke="currentColor" stroke-width="1.2" stroke-opacity="0.75" \
{% if path.back %}stroke-dasharray="3 3"{% endif %}/>
{% endfor %}
{% for bar in bars if bar.text %}
<text x="{{ bar.text_x }}" y="{{ bar.y + bar.height / 2 + 4 }}" \
fill="{{ '#ffffff' if bar.inside else 'currentColor' }}" font-size="12">{{ bar.text }}</text>
{% endfor %}
{% for mark in marks %}
<g><title>{{ mark.title }}</title>{{ mark.sign }}</g>
{% endfor %}
<text x="{{ width - 8 }}" y="{{ bottom + 30 }}" text-anchor="end" fill-opacity="0.75">time [{{ unit }}]</text>
</svg>
""")


def html(chart) -> str:
    """The chart for a notebook."""
    return inline_svg.html(svg(chart), _WIDTH, _summary(chart))


def text(chart) -> str:
    """The recording as lines: what happened in each thread, in order."""
    lines = [_summary(chart)]
    for thread, name in chart.threads.items():
        events = [(c.start, _bar_text(c)) for c in chart.callbacks if c.thread == thread]
        events += [(m.time, _mark_text(m)) for m in chart.messages if m.thread == thread]
        if events:
            lines += [f'{name}:', *(f'  {sentence}' for _, sentence in sorted(events))]
    more = len(lines) - _MOST_LINES
    return '\n'.join(lines[:_MOST_LINES] + ([f'… and {more} more lines'] if more > 0 else []))


def svg(chart) -> str:
    """The recording as an SVG element that suits light and dark pages."""
    from markupsafe import Markup

    view = _View(chart)
    paths = view.paths()
    signs, x = [], view.legend_end
    for words, sign, there in (
        ('sent', _mark(6, 12, True), any(message.sent for message in view.messages)),
        ('received', _mark(6, 12, False), any(not message.sent for message in view.messages)),
        ('awaits', _AWAITS, any(callback.awaited for callback in chart.callbacks)),
        ('request', _LINE.format(''), any(not path['back'] for path in paths)),
        ('response', _LINE.format('stroke-dasharray="3 3"'), any(path['back'] for path in paths)),
    ):
        if there:
            signs.append({'sign': Markup(f'<g transform="translate({x} 0)">{sign}</g>'), 'x': x + 9, 'text': words})
            x += 36 + round(_CHARACTER * len(words))
    marks = [
        {
            'title': _mark_text(message),
            'sign': Markup(
                _mark(
                    view.x(message.time),
                    view.mark_y(message),
                    message.sent,
                    view.colour.get(message.node, 'currentColor'),
                )
            ),
        }
        for message in view.messages
    ]
    return _TEMPLATE.render(
        page_colour=inline_svg.PAGE_COLOUR,
        width=_WIDTH,
        height=view.bottom + 36,
        left=_LEFT,
        top=view.top,
        bottom=view.bottom,
        unit=view.unit,
        summary=_summary(chart),
        description=text(chart),
        legend=view.legend,
        signs=signs,
        ticks=view.ticks,
        lanes=view.lanes,
        bars=view.bars(),
        marks=marks,
        paths=paths,
    )


class _View:
    """Places things: time to x, threads to lanes, nodes to colours."""

    def __init__(self, chart):
        self.chart = chart
        self.messages = sorted(chart.messages, key=lambda message: message.time)
        used = {event.thread for event in (*chart.callbacks, *chart.messages)}
        threads = [thread for thread in chart.threads if thread in used]
        self.top = 30
        self.y = {thread: self.top + 4 + number * (_LANE + 4) for number, thread in enumerate(threads)}
        self.lanes = [{'y': self.y[t], 'height': _LANE, 'text': chart.threads[t]} for t in threads]
        self.bottom = self.top + 4 + max(1, len(threads)) * (_LANE + 4)
        self.begin = min([c.start for c in chart.callbacks] + [m.time for m in chart.messages], default=0.0)
        last = [c.end if c.end is not None else chart.end for c in chart.callbacks] + [m.time for m in chart.messages]
        self.length = max(max(last, default=chart.end) - self.begin, 1e-4) * 1.02
        self._colours()
        self._ticks()

    def x(self, moment: float) -> float:
        """The place of a moment on the time axis."""
        return round(_LEFT + 6 + (moment - self.begin) / self.length * (_WIDTH - _LEFT - _RIGHT), 2)

    def mark_y(self, message) -> float:
        """Marks stand above the bars if something is sent, below if it is received."""
        return self.y[message.thread] + (7 if message.sent else _LANE - 6)

    def _colours(self) -> None:
        # By name, so that a node has one colour in charts of the same nodes.
        nodes = sorted({c.node for c in self.chart.callbacks} | {m.node for m in self.messages if m.node})
        self.colour = {node: _COLOURS[number % len(_COLOURS)] for number, node in enumerate(nodes)}
        self.legend, x = [], _LEFT + 6
        for node in nodes:
            self.legend.append({'x': x, 'colour': self.colour[node], 'text': node or 'no node'})
            x += 34 + round(_CHARACTER * len(node or 'no node'))
        self.legend_end = x + 10

    def _ticks(self) -> None:
        self.unit, factor = ('ms', 1e3) if self.length < 0.5 else ('s', 1.0)
        raw = self.length * factor / 6
        power = 10.0 ** len(str(int(raw))) / 10 if raw >= 1 else 0.1 if raw >= 0.1 else 0.01
        step = next(power * n for n in (1, 2, 5, 10, 20) if power * n >= raw)
        self.ticks, n = [], 0
        while n * step / factor <= self.length:
            self.ticks.append({'x': self.x(self.begin + n * step / factor), 'text': f'{n * step:g}'})
            n += 1

    def bars(self) -> list[dict]:
        """The callbacks, with a label inside if it fits, else beside if that is free."""
        made = []
        for callback in sorted(self.chart.callbacks, key=lambda c: c.start):
            end = callback.end if callback.end is not None else self.chart.end
            x, width = self.x(callback.start), max(3.0, self.x(end) - self.x(callback.start))
            parts = [
                {'x': self.x(a), 'width': round(max(3.0, self.x(end if b is None else b) - self.x(a)), 2)}
                for a, b in callback.parts
            ]
            words = callback.name if callback.end is not None else f'{callback.name} …'
            needed = len(words) * _CHARACTER + 8
            inside = needed <= parts[0]['width']
            others = [
                other for other in self.chart.callbacks if other.thread == callback.thread and other is not callback
            ]
            if inside:
                text_x, shown = x + 5, words
            elif (
                callback.awaited
                and needed <= width
                and not any(other.start < end and (other.end is None or other.end > callback.start) for other in others)
            ):
                text_x, shown = x + parts[0]['width'] + 5, words
            else:
                after = min(
                    (
                        self.x(other.start)
                        for other in others
                        if other.start > callback.start and not (callback.awaited and other.start < end)
                    ),
                    default=_WIDTH - 8,
                )
                text_x, shown = x + width + 5, words if after - (x + width) >= needed else ''
            made.append(
                {
                    'x': x,
                    'y': self.y[callback.thread] + (_LANE - _BAR) / 2,
                    'width': round(width, 2),
                    'height': _BAR,
                    'colour': self.colour[callback.node],
                    'rest': callback.awaited,
                    'parts': parts,
                    'text': shown,
                    'text_x': round(text_x, 2),
                    'inside': inside,
                    'title': _bar_text(callback),
                }
            )
        _uncover(made)
        return sorted(made, key=lambda bar: not bar['rest'])  # those that await are drawn behind the others

    def paths(self) -> list[dict]:
        """Requests to their servers, and responses back, where it is sure which is which."""
        of = {}
        for message in self.messages:
            if message.call is not None:
                of.setdefault(message.call, {})[message.kind] = message
        found = []
        for parts in of.values():
            for begin, end in (('request', 'take'), ('respond', 'answer')):
                if begin in parts and end in parts:
                    a, b = parts[begin], parts[end]
                    x1, y1, x2, y2 = self.x(a.time), self.mark_y(a), self.x(b.time), self.mark_y(b)
                    middle = round((x1 + x2) / 2, 2)
                    found.append(
                        {'d': f'M{x1} {y1} C{middle} {y1} {middle} {y2} {x2} {y2}', 'back': begin == 'respond'}
                    )
        return found


def _uncover(bars: list[dict]) -> None:
    """Leave out labels that would cover another one of their lane; first those of callbacks that await."""
    taken: dict[float, list[tuple[float, float]]] = {}
    for bar in sorted(bars, key=lambda bar: bar['rest']):
        if bar['text'] and not bar['inside']:
            begin, end = bar['text_x'], bar['text_x'] + _CHARACTER * len(bar['text'])
            lane = taken.setdefault(bar['y'], [])
            if any(begin < other_end and other_begin < end for other_begin, other_end in lane):
                bar['text'] = ''
            else:
                lane.append((begin, end))


def _mark(x: float, y: float, sent: bool, colour: str = 'currentColor') -> str:
    """A triangle: up for what is sent, down for what is received."""
    d = 4.5
    points = f'{x},{y - d} {x - d},{y + d} {x + d},{y + d}' if sent else f'{x},{y + d} {x - d},{y - d} {x + d},{y - d}'
    fill = f'fill="{colour}"' if sent else f'fill="none" stroke="{colour}" stroke-width="1.5"'
    return f'<polygon points="{points}" {fill}/>'


def _summary(chart) -> str:
    busy = {c.thread for c in chart.callbacks}
    return (
        f'Timeline: {len(chart.callbacks)} callbacks in {len(busy)} thread{"s" * (len(busy) != 1)}, '
        f'{len(chart.messages)} messages, {chart.end:.2f} s'
    )


def _bar_text(callback) -> str:
    end = 'not ended' if callback.end is None else f'{callback.end:.3f} s'
    ran = sum((b if b is not None else callback.start) - a for a, b in callback.parts)
    awaited = f' (ran for {ran:.3f} s, awaited something in between)' if callback.awaited else ''
    return f'{callback.start:.3f} s to {end}: {callback.node} {callback.name}{awaited}'


def _mark_text(message) -> str:
    return f'{message.time:.3f} s: {message.node or "the notebook"} {_KINDS[message.kind]} {message.name}'
