"""``./course bench``: benchmarks, as one table and as JSON."""

import os
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated

import typer

from helpers import paths
from helpers.cli import Refusal
from helpers.kernel import domains

JSON = paths.ROOT / 'build' / 'bench.json'
WIDTH = 130  # of a table that goes into a file


def bench(
    names: Annotated[list[str] | None, typer.Argument(metavar='[NAME]...', help='Only these; all if none.')] = None,
    output: Annotated[Path, typer.Option('-o', '--output', help='The JSON file.')] = JSON,
):
    """Run the benchmarks, print a table and write JSON. All of them take a quarter of an hour on a quiet machine."""
    from rich.console import Console

    from grading import bench as benchmarks
    from grading.bench import machine_facts
    from grading.bench.report import Report

    found = benchmarks.find(paths.ROOT)
    for name in names or ():
        if name not in found:
            raise Refusal(f'no benchmark {name!r}; there are: {", ".join(found)}')
    chosen = [name for name in found if not names or name in names]
    report = Report()
    if warning := machine_facts.busy(report.load):
        typer.echo(f'course: {warning}', err=True)
    stopped = False
    try:
        for place, name in enumerate(chosen, 1):
            _measure(report, name, found[name], f'[{place}/{len(chosen)}] ')
            report.write(output)  # what is measured stays, whatever comes next
    except KeyboardInterrupt:
        stopped = True
        report.write(output)
    Console(width=None if sys.stdout.isatty() else WIDTH).print(report.table())
    typer.echo(f'written to {output}')
    if stopped:
        typer.echo('course: stopped; the rest was not measured', err=True)
        raise typer.Exit(130)
    raise typer.Exit(int(report.failed))


def _measure(report, name: str, path: Path, place: str) -> None:
    """Add one benchmark to the report, and tell of each figure when it is there."""
    from grading import bench as benchmarks
    from grading.bench.report import Benchmark, cells

    part = Benchmark(name)
    report.parts.append(part)
    begin = time.perf_counter()
    try:
        typer.echo(f'{place}{name}: {benchmarks.title(path)}', err=True)
        with _own_domain():
            for figure in benchmarks.run(path):
                part.figures.append(figure)
                value, unit, reference, theirs, ratio = cells(figure)
                beside = f' ({reference}: {theirs}; ratio {ratio})' if reference else ''
                typer.echo(f'  {figure.what}: {value} {unit}{beside}', err=True)
    except Exception as error:  # one broken benchmark does not take the others along
        part.error = f'{type(error).__name__}: {error}'
        typer.echo(f'{name}: {part.error}', err=True)
    except KeyboardInterrupt:
        part.error = 'stopped'
        raise
    finally:
        part.seconds = time.perf_counter() - begin


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
