"""Which ways to ROS 2 this machine has, shown in a notebook."""

from jinja2 import Environment

from environment.setup.routes import Route
from environment.setup.routes import routes as look
from helpers.paths import ROOT
from helpers.show.colours import BAD, GOOD, OPEN

_TEMPLATE = Environment(autoescape=True, trim_blocks=True, lstrip_blocks=True).from_string("""\
{% for route in routes %}
<div style="border-left: 4px solid {{ colour(route) }}; padding: 0.2em 0 0.2em 0.9em; margin: 0.5em 0">
<div style="font-weight: 600">{{ route.name }}: {{ verdict(route) }}</div>
{% for step in route.steps %}
<div><span style="color: {{ good if step.ok else bad }}; font-weight: 700">{{ '✓' if step.ok else '✗' }}</span>
{{ step.name }}: {{ step.text }}{% if not step.ok and step.remedy %} → {{ step.remedy }}{% endif %}</div>
{% endfor %}
</div>
{% endfor %}
""")


def routes() -> 'RoutesTable':
    """Look at this machine, and say for each way to ROS 2 Jazzy what is there and what it would still need."""
    return RoutesTable(list(look(ROOT)))


class RoutesTable(list):
    """The routes found, as a table in a notebook and as lines elsewhere."""

    def _repr_html_(self) -> str:
        return _TEMPLATE.render(routes=self, verdict=verdict, colour=_colour, good=GOOD, bad=BAD)

    def __repr__(self) -> str:
        lines = []
        for route in self:
            lines.append(f'{route.name}: {verdict(route)}')
            for step in route.steps:
                remedy = f' -> {step.remedy}' if not step.ok and step.remedy else ''
                lines.append(f'  {"ok" if step.ok else "--":<4}{step.name}: {step.text}{remedy}')
        return '\n'.join(lines)


def verdict(route: Route) -> str:
    """Say in words how far a route is."""
    if route.ready:
        return 'ready'
    count = len(route.missing)
    return f'needs {count} more {"step" if count == 1 else "steps"}' if route.possible else 'not on this system'


def _colour(route: Route) -> str:
    return GOOD if route.ready else OPEN if route.possible else BAD
