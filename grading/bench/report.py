"""What a run of the benchmarks has found, as one table and as JSON."""

import json
import time
from dataclasses import dataclass, field
from pathlib import Path

from grading.bench import Measurement, machine_facts


@dataclass
class Benchmark:
    """One benchmark: its figures, how long it took (s), and why it failed, if it did."""

    name: str
    figures: list[Measurement] = field(default_factory=list)
    seconds: float = 0.0
    error: str = ''


@dataclass
class Report:
    """A run: its parts in their order, the facts of the machine, and its load when the run began."""

    parts: list[Benchmark] = field(default_factory=list)
    facts: dict[str, object] = field(default_factory=machine_facts.facts)
    load: float = field(default_factory=machine_facts.load)
    begin: str = field(default_factory=lambda: _now())

    @property
    def failed(self) -> bool:
        """Whether a part has failed."""
        return any(part.error for part in self.parts)

    def write(self, path: Path) -> None:
        """Write all that there is so far, as JSON."""
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(
            json.dumps(
                {
                    'begin': self.begin,
                    'end': _now(),
                    'machine': self.facts,
                    'load': {'begin': self.load, 'end': machine_facts.load()},
                    'benchmarks': {
                        part.name: {'seconds': round(part.seconds, 1), 'error': part.error} for part in self.parts
                    },
                    'results': [_as_dict(part.name, figure) for part in self.parts for figure in part.figures],
                },
                indent=2,
                ensure_ascii=False,
            )
            + '\n',
            encoding='utf-8',
        )

    def table(self):
        """Return all figures as a table of rich's."""
        from rich.markup import escape
        from rich.table import Table

        table = Table(
            title='Benchmarks',
            caption='ratio: the value of the course divided by that of the reference. '
            'Less than 1 is good for a time, more than 1 for a rate.',
        )
        table.add_column('benchmark')
        table.add_column('what', ratio=1)
        for name, justify in (
            ('value', 'right'),
            ('unit', 'left'),
            ('reference', 'left'),
            ('its value', 'right'),
            ('ratio', 'right'),
        ):
            table.add_column(name, justify=justify, no_wrap=name != 'reference')
        for part in self.parts:
            table.add_section()
            rows = [(escape(figure.what), *cells(figure)) for figure in part.figures]
            if part.error:
                rows.append((f'[bold red]failed:[/] {escape(part.error)}',))
            for number, row in enumerate(rows):
                table.add_row('' if number else part.name, *row)
        return table


def cells(figure: Measurement) -> tuple[str, str, str, str, str]:
    """Return value, unit, reference, its value, and the ratio of a figure, as text."""
    if figure.ratio is None:
        return number(figure.value), figure.unit, '', '', ''
    return number(figure.value), figure.unit, figure.reference, number(figure.reference_value), f'{figure.ratio:.2f}'


def number(value: float) -> str:
    """Return a number with at most four digits that say something, and no exponent."""
    if abs(value) >= 1000:
        return f'{float(f"{value:.4g}"):,.0f}'
    return f'{value:.4g}'


def _as_dict(name: str, figure: Measurement) -> dict[str, object]:
    found = {'benchmark': name, 'what': figure.what, 'value': figure.value, 'unit': figure.unit}
    if figure.ratio is not None:
        found |= {'reference': figure.reference, 'reference_value': figure.reference_value, 'ratio': figure.ratio}
    return found


def _now() -> str:
    return time.strftime('%Y-%m-%dT%H:%M:%SZ', time.gmtime())
