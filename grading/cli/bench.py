"""``./course bench``: benchmarks, as a table and as JSON."""

import json
import os
import platform
import time
from pathlib import Path
from typing import Annotated

import typer

from helpers import paths
from helpers.cli import Refusal

JSON = paths.ROOT / 'build' / 'bench.json'


def bench(
    name: Annotated[str | None, typer.Argument(metavar='[NAME]', help='One benchmark; all if none.')] = None,
    output: Annotated[Path, typer.Option('-o', '--output', help='The JSON file.')] = JSON,
):
    """Run the benchmarks, print a table and write JSON."""
    from rich.console import Console
    from rich.table import Table

    from grading import bench as benchmarks

    found = benchmarks.find(paths.ROOT)
    if name is not None and name not in found:
        raise Refusal(f'no benchmark {name!r}; there are: {", ".join(found)}')
    results, failed = [], False
    for one, path in found.items():
        if name not in (None, one):
            continue
        Console().print(f'{one}: {benchmarks.title(path)}', markup=False)
        table = Table('', 'value', 'unit')
        try:
            rows = benchmarks.run(path)
        except Exception as error:  # one broken benchmark does not take the others along
            failed = True
            results.append({'benchmark': one, 'error': f'{type(error).__name__}: {error}'})
            typer.echo(f'{one}: {type(error).__name__}: {error}', err=True)
            continue
        for what, value, unit in rows:
            table.add_row(what, f'{value:.4g}', unit)
            results.append({'benchmark': one, 'what': what, 'value': value, 'unit': unit})
        Console().print(table)
    machine = {'cpus': len(os.sched_getaffinity(0)), 'machine': platform.machine(), 'python': platform.python_version()}
    report = {'time': time.strftime('%Y-%m-%dT%H:%M:%SZ', time.gmtime()), 'machine': machine, 'results': results}
    output.parent.mkdir(parents=True, exist_ok=True)
    output.write_text(json.dumps(report, indent=2) + '\n', encoding='utf-8')
    typer.echo(f'written to {output}')
    raise typer.Exit(int(failed))
