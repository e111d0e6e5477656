"""Small helpers for actions and substitutions."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution


def normalize_to_list_of_substitutions(value: SomeSubstitutionsType) -> list[Substitution]:
    """
    Return a list of substitutions for a text, a substitution, or several of them.

    :raises TypeError: for anything else
    """
    from launch.substitutions.text_substitution import TextSubstitution

    if isinstance(value, Substitution):
        return [value]
    if isinstance(value, (str, Path)):
        return [TextSubstitution(text=os.fspath(value))]
    if isinstance(value, Iterable):
        return [item for part in value for item in normalize_to_list_of_substitutions(part)]
    raise TypeError(f'expected a text, a substitution or a list of them, got {value!r}')


def perform_substitutions(context: LaunchContext, substitutions: Iterable[Substitution]) -> str:
    """Return the texts of the substitutions as one text."""
    return ''.join(context.perform_substitution(substitution) for substitution in substitutions)


def to_text(context: LaunchContext, value: SomeSubstitutionsType) -> str:
    """Return the text that ``value`` stands for at this moment."""
    return perform_substitutions(context, normalize_to_list_of_substitutions(value))


def to_number(context: LaunchContext, value: float | SomeSubstitutionsType) -> float:
    """Return the number that ``value`` stands for at this moment."""
    return float(value) if isinstance(value, (int, float)) else float(to_text(context, value))


def to_bool(context: LaunchContext, value: bool | SomeSubstitutionsType) -> bool:
    """Return the truth value that ``value`` stands for at this moment."""
    from launch.conditions import evaluate_condition_expression

    return value if isinstance(value, bool) else evaluate_condition_expression(context, value)


def describe_substitutions(value: SomeSubstitutionsType) -> str:
    """Return how to show a text before it is known."""
    return ' + '.join(substitution.describe() for substitution in normalize_to_list_of_substitutions(value))


def to_entities(value: Any) -> list:
    """Return a list of entities for None, one entity or an iterable of them."""
    from launch.launch_description_entity import LaunchDescriptionEntity

    if value is None:
        return []
    return [value] if isinstance(value, LaunchDescriptionEntity) else list(value)
