"""``./course release``: the learner's edition, or an autograder for Gradescope."""

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer

from helpers.cli import Refusal


def release(
    output: Annotated[
        Path,
        typer.Option(
            '-o', '--output', metavar='DIR', help='A new or empty folder; with --gradescope, the zip to write.'
        ),
    ],
    gradescope: Annotated[bool, typer.Option('--gradescope', help='Make the autograder zip for Gradescope.')] = False,
    classroom: Annotated[
        bool, typer.Option('--classroom', help='Add a GitHub workflow that runs the visible checks at each push.')
    ] = False,
    chapter: Annotated[
        list[int] | None,
        typer.Option(
            metavar='N', help="With --gradescope: grade only this chapter's exercises; may be given several times."
        ),
    ] = None,
    sandbox: Annotated[
        str, typer.Option(metavar='NAME', help="With --gradescope: where learners' code runs there.")
    ] = 'none',
    hidden: Annotated[
        str,
        typer.Option(
            metavar='WHEN',
            help='With --gradescope: when learners see the hidden tests: visible, after_due_date, '
            'after_published or hidden.',
        ),
    ] = 'after_published',
):
    """Make the learner's edition: no solutions/, no grading/. Or an autograder for Gradescope."""
    if gradescope:
        if classroom:
            raise Refusal('--gradescope and --classroom are two different releases: give one')
        _gradescope(output, sandbox, hidden, chapter or ())
        return
    if chapter:
        raise Refusal("--chapter is for --gradescope: the learners' edition always has all chapters")
    from grading import learners_edition as edition

    try:
        files = edition.release(output, classroom=classroom)
    except edition.ReleaseError as error:
        raise Refusal(str(error)) from None
    except edition.Leak as leak:
        typer.echo(f'not released: {leak}', err=True)
        raise typer.Exit(1) from None
    typer.echo(f'{output}: {len(files)} files')


def _gradescope(output: Path, sandbox: str, hidden: str, chapters: Sequence[int]) -> None:
    from grading.gradescope import bundle

    if output.is_dir():
        raise Refusal(f'{output} is a folder: give the name of the zip, such as {output / "autograder.zip"}')
    try:
        names = bundle.bundle(output, sandbox, hidden, chapters=chapters)
    except bundle.BundleError as error:
        raise Refusal(str(error)) from None
    typer.echo(f'{output}: {len(names)} files, {output.stat().st_size / 2**20:.1f} MB')
    if sandbox == 'none':
        typer.echo(
            "Sandbox on Gradescope: none. Learners' code runs as a plain process in the container of its own "
            'submission. It can reach no other learner, but it can read the hidden tests there, and could '
            'falsify its own marks. Each result says so. See grading/README.md, "Gradescope".',
            err=True,
        )
