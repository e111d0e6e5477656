"""``./course build``: from the sources of the chapters to the notebooks."""

import re
import sys
from pathlib import Path
from typing import Annotated

import typer

from helpers import paths
from helpers.cli import Refusal


def build(
    chapters: Annotated[list[str] | None, typer.Argument(metavar='[NN …]', help='Chapters; all if none.')] = None,
    check: Annotated[bool, typer.Option('--check', help='Run nothing: prove that all fits its source.')] = False,
    rules: Annotated[
        bool,
        typer.Option(
            '--rules',
            help='Run nothing: show which tests look at which rule of a card, and which wrong answers break it.',
        ),
    ] = False,
    force: Annotated[bool, typer.Option('--force', help='Execute unchanged chapters too.')] = False,
    html: Annotated[
        Path | None,
        typer.Option(metavar='DIR', help='Only write the course as web pages, without solutions, from what is built.'),
    ] = None,
    scenes: Annotated[
        bool,
        typer.Option(
            help='In the pages: 3-D scenes to turn and replay. For them chapters with such views are executed again.'
        ),
    ] = True,
    timeout: Annotated[float, typer.Option(help='Longest time of one cell, in seconds.')] = 60.0,
):
    """Make the executed solution and the learner's notebook of each chapter from solutions/NN_name.md."""
    from grading.authoring import chapter_build as builder
    from grading.authoring.chapter import sources
    from grading.authoring.chapter_errors import ChapterErrors

    tree = builder.CourseFolders(paths.ROOT)
    known = {int(path.name[:2]) for path in sources(tree.solutions)}
    selected = {_number(text) for text in chapters or []}
    if selected - known:
        there = ', '.join(f'{number:02}' for number in sorted(known)) or 'none'
        raise Refusal(f'no source of chapter {min(selected - known):02} in solutions/; there are: {there}')
    try:
        if check:
            raise typer.Exit(_check(tree, len(known)))
        if rules:
            raise typer.Exit(_rules(builder.read_all(tree), selected, tree))
        if html:
            if chapters:
                raise Refusal('--html always writes the whole course: leave the chapters out')
            _write_pages(tree, html, scenes, timeout)
            return
        builder.build(tree, selected or None, force=force, timeout=timeout)
    except ChapterErrors as errors:
        print(errors, file=sys.stderr)
        raise typer.Exit(1) from None


def _check(tree, count: int) -> int:
    """Print which generated files of the `count` chapters are out of step; returns the exit status."""
    from grading.authoring import chapter_build as builder
    from grading.authoring import in_step

    lines = in_step.drift(tree)
    for line in lines:
        print(line)
    _checked(builder.read_all(tree))
    print(
        f'{len(lines)} generated files are out of step; run ./course build'
        if lines
        else f'{count} chapters are in step with their sources'
    )
    return 1 if lines else 0


def _write_pages(tree, folder: Path, scenes: bool, timeout: float) -> None:
    """Write the course as web pages into a folder."""
    from grading.edition import pages

    try:
        written = pages.write(tree, folder, scenes=scenes, timeout=timeout)
    except (pages.EditionError, OSError) as error:
        raise Refusal(str(error)) from None
    print(f'{len(written)} pages; begin with {written[0]}')


def _checked(chapters) -> None:
    """Print how many checked statements each chapter has."""
    from grading.authoring import rules

    counts = rules.checked_counts(chapters).items()
    print('checked statements by chapter:', ', '.join(f'{number:02}: {count}' for number, count in counts))


def _rules(chapters, selected: set[int], tree) -> int:
    """Print the table of rules; returns the exit status."""
    from grading import variants
    from grading.authoring import coverage

    _checked(chapters)
    rows = [row for chapter in chapters if not selected or chapter.number in selected for row in chapter.exercises()]
    try:
        table = coverage.table(rows, tree.manifest.parent)
    except variants.VariantError as error:
        raise Refusal(str(error)) from None
    for line in table.lines():
        print(line)
    return 0 if table.complete else 1


def _number(text: str) -> int:
    match = re.fullmatch(r'(\d{1,2})(_\w+)?(\.md)?', text.rpartition('/')[2])
    if not match:
        raise Refusal(f'{text!r} is no chapter: write its number, such as 03')
    return int(match[1])
