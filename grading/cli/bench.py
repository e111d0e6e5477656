"""``./course bench``: benchmarks, as one table and as JSON."""

import json
import os
import platform
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated

import typer

from helpers import domains, paths
from helpers.cli import Refusal

JSON = paths.ROOT / 'build' / 'bench.json'


def bench(
    name: Annotated[str | None, typer.Argument(metavar='[NAME]', help='One benchmark; all if none.')] = None,
    output: Annotated[Path, typer.Option('-o', '--output', help='The JSON file.')] = JSON,
):
    """Run the benchmarks, print a table and write JSON."""
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table

    from grading import bench as benchmarks

    found = benchmarks.find(paths.ROOT)
    if name is not None and name not in found:
        raise Refusal(f'no benchmark {name!r}; there are: {", ".join(found)}')
    results, failed = [], False
    table = Table('benchmark', 'what', 'value', 'unit')
    for one, path in found.items():
        if name not in (None, one):
            continue
        Console(stderr=True).print(f'{one}: {benchmarks.title(path)}', markup=False, highlight=False)
        table.add_section()
        named = False
        try:
            with _own_domain():
                for what, value, unit in benchmarks.run(path):
                    typer.echo(f'  {what}: {value:.4g} {unit}', err=True)
                    table.add_row('' if named else one, escape(what), f'{value:.4g}', unit)
                    results.append({'benchmark': one, 'what': what, 'value': value, 'unit': unit})
                    named = True
        except Exception as error:  # one broken benchmark does not take the others along
            failed = True
            results.append({'benchmark': one, 'error': f'{type(error).__name__}: {error}'})
            typer.echo(f'{one}: {type(error).__name__}: {error}', err=True)
    Console().print(table)
    machine = {'cpus': len(os.sched_getaffinity(0)), 'machine': platform.machine(), 'python': platform.python_version()}
    report = {'time': time.strftime('%Y-%m-%dT%H:%M:%SZ', time.gmtime()), 'machine': machine, 'results': results}
    output.parent.mkdir(parents=True, exist_ok=True)
    output.write_text(json.dumps(report, indent=2) + '\n', encoding='utf-8')
    typer.echo(f'written to {output}')
    raise typer.Exit(int(failed))


@contextmanager
def _own_domain() -> Iterator[None]:
    """A ROS domain that nobody else uses, for this process and those that it starts."""
    before = os.environ.get('ROS_DOMAIN_ID')
    with domains.claim() as domain_id:
        os.environ['ROS_DOMAIN_ID'] = str(domain_id)
        try:
            yield
        finally:
            os.environ.pop('ROS_DOMAIN_ID')
            if before is not None:
                os.environ['ROS_DOMAIN_ID'] = before
