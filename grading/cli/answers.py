"""``./course answers``: the tests of an exercise, tried on answers of which it is known what they are worth."""

from concurrent.futures import ThreadPoolExecutor
from typing import Annotated

import typer

from helpers.cli import Refusal


def answers(
    exercise: Annotated[str, typer.Argument(metavar='3.2', help='The exercise.')],
    names: Annotated[
        list[str] | None, typer.Argument(metavar='[NAME …]', help='Mutants and alternatives; all if none.')
    ] = None,
    seed: Annotated[str | None, typer.Option(help='Let the tests draw other inputs.')] = None,
    jobs: Annotated[int, typer.Option(help='How many answers are judged at a time.')] = 2,
    verbose: Annotated[bool, typer.Option('--verbose', '-v', help='Show what the learner reads.')] = False,
):
    """Judge the solution, the wrong and the other right answers of an exercise: is each judged as it must be?"""
    from grading import trial, variants
    from helpers.exercises import manifest
    from helpers.exercises.result_display import plain

    known = manifest.load()
    if exercise not in known:
        raise Refusal(f'there is no exercise {exercise}; there are {manifest.near(exercise, known)}')
    chosen = known[exercise]
    try:
        chosen_answers = [*([] if names else [None]), *trial.answers(exercise, names or ())]
    except (variants.VariantError, LookupError) as error:
        raise Refusal(str(error)) from None
    wrong = 0
    with ThreadPoolExecutor(max(1, jobs)) as pool:
        for one in pool.map(lambda answer: trial.run(chosen, answer, seed or trial.SEED), chosen_answers):
            broken = ', '.join(
                dict.fromkeys(test.rule or trial.name_of(test) for test in one.result.tests if not test.passed)
            )
            print(f'{"FAULT" if one.faults else "ok":5} {one.name:32} {broken or one.result.verdict}', flush=True)
            for fault in one.faults:
                print(f'      {fault}')
            if verbose:
                print(plain([one.result]))
            wrong += bool(one.faults)
    print(f'{len(chosen_answers) - wrong} of {len(chosen_answers)} answers are judged as they must be', flush=True)
    raise typer.Exit(1 if wrong else 0)
