"""What may stand where a text is wanted."""

from collections.abc import Iterable
from pathlib import Path
from typing import Union

from launch.substitution import Substitution

SomeSubstitutionsType = Union[str, Path, Substitution, Iterable[Union[str, Path, Substitution]]]
