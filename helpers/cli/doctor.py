"""``./course doctor``: what this machine has and lacks."""

import json
from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import typer

ROOT = Path(__file__).resolve().parents[2]


def doctor(as_json: Annotated[bool, typer.Option('--json', help='One JSON list instead of lines.')] = False) -> None:
    """Say what this machine has and lacks, each lack with its remedy; fails only if something required lacks."""
    from rich.console import Console
    from rich.text import Text

    from environment.setup.facts import facts

    console = Console(soft_wrap=True, highlight=False)
    found = []
    for fact in facts(ROOT):
        found.append(fact)
        if as_json:
            continue
        mark, style = ('ok', 'green') if fact.ok else ('LACKS', 'bold red') if fact.required else ('no', 'yellow')
        console.print(Text.assemble((f'{mark:<6}', style), (f'{fact.name:<24}', 'bold'), fact.text))
        if not fact.ok:
            console.print(Text(f'{"":<30}{fact.remedy}'))
    if as_json:
        typer.echo(json.dumps([asdict(fact) for fact in found], indent=1))
    lacking = [fact for fact in found if fact.required and not fact.ok]
    if lacking:
        typer.echo(f'{len(lacking)} thing(s) that the course needs are not as they should be.', err=True)
        raise typer.Exit(1)
