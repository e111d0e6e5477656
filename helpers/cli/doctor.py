"""``./course doctor``: what this machine has, and what is missing."""

import json
from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import typer

ROOT = Path(__file__).resolve().parents[2]


def doctor(as_json: Annotated[bool, typer.Option('--json', help='One JSON list instead of lines.')] = False) -> None:
    """Say what this machine has, what is missing and what to do about it; fails only if something needed is missing."""
    from rich.console import Console
    from rich.text import Text

    from environment.setup.facts import facts

    console = Console(soft_wrap=True, highlight=False)
    found = []
    for fact in facts(ROOT):
        first_of_theirs = fact.instructors and not any(earlier.instructors for earlier in found)
        found.append(fact)
        if as_json:
            continue
        if first_of_theirs:
            lacking = any(one.required and not one.ok for one in found)
            console.print('' if lacking else '\nYou can learn on this machine: ./course lab\n')
            console.print(Text('For instructors: what grading and the tests of the course need', 'bold'))
        mark, style = ('ok', 'green') if fact.ok else ('MISSING', 'bold red') if fact.required else ('no', 'yellow')
        console.print(Text.assemble((f'{mark:<8}', style), (f'{fact.name:<24}', 'bold'), fact.text))
        if not fact.ok:
            console.print(Text(f'{"":<32}{fact.remedy}'))
    if as_json:
        typer.echo(json.dumps([asdict(fact) for fact in found], indent=1))
    lacking = [fact.name for fact in found if fact.required and not fact.ok]
    if lacking:
        typer.echo(f'The course does not work on this machine until this is repaired: {", ".join(lacking)}.', err=True)
        raise typer.Exit(1)
