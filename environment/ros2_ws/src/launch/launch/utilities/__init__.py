"""Small helpers for actions and substitutions."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution


def ensure_argument_type(argument: Any, types, argument_name: str, caller: str | None = None) -> None:
    """
    Check the type of an argument.

    :param types: a type, or several of which one has to fit
    :raises TypeError: if none fits
    """
    allowed = tuple(types) if isinstance(types, Iterable) else (types,)
    if not isinstance(argument, allowed):
        where = f" to '{caller}'" if caller else ''
        expected = ', '.join(f"'{kind}'" for kind in allowed)
        one_of = 'one of ' if len(allowed) > 1 else ''
        raise TypeError(
            f"Expected '{argument_name}'{where} to be {one_of}{expected}, but got '{argument}' of type "
            f"'{type(argument)}'"
        )


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


def describe_substitutions(value: SomeSubstitutionsType) -> str:
    """Return how to show a text before it is known."""
    return ' + '.join(substitution.describe() for substitution in normalize_to_list_of_substitutions(value))


def to_entities(value: Any) -> list:
    """Return a list of entities for None, one entity or an iterable of them."""
    from launch.launch_description_entity import LaunchDescriptionEntity

    if value is None:
        return []
    return [value] if isinstance(value, LaunchDescriptionEntity) else list(value)


def normalize_to_list_of_entities(entities: Any) -> list:
    """Return a flat list of the entities in a list of entities and lists."""
    from launch.launch_description_entity import LaunchDescriptionEntity

    if isinstance(entities, LaunchDescriptionEntity):
        return [entities]
    return [entity for part in entities for entity in normalize_to_list_of_entities(part)]


def is_a(value: Any, kind: type) -> bool:
    """Return True if the value is of the type."""
    return isinstance(value, kind)


def is_a_subclass(value: Any, kind: type) -> bool:
    """Return True if the value's type, or the value itself if it is a class, derives from the type."""
    return issubclass(value if isinstance(value, type) else type(value), kind)
