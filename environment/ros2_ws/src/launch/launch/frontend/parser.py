"""Makes launch descriptions from launch files that are no programs."""

from __future__ import annotations

import itertools
import os
import traceback
import warnings
from importlib.metadata import entry_points
from typing import TYPE_CHECKING, Any, ClassVar, TextIO

from launch.frontend.entity import Entity
from launch.frontend.expose import instantiate_action
from launch.frontend.parse_substitution import parse_if_substitutions, parse_substitution, replace_escaped_characters
from launch.invalid_launch_file_error import InvalidLaunchFileError

if TYPE_CHECKING:
    from launch.launch_description import LaunchDescription


class InvalidFrontendLaunchFileError(InvalidLaunchFileError):
    """A launch file that is no program cannot be loaded."""


class Parser:
    """
    The parser of a format derives from this and writes ``load`` and ``get_file_extensions``.

    It is found by an entry point of the group ``launch.frontend.parser``; packages with actions and substitutions of
    their own are found by one of the group ``launch.frontend.launch_extension``.
    """

    extensions_loaded: ClassVar[bool] = False
    frontend_parsers: ClassVar[dict[str, type[Parser]] | None] = None

    @classmethod
    def load_launch_extensions(cls) -> None:
        """Import the packages that have actions and substitutions, once."""
        if not Parser.extensions_loaded:
            _load_entry_points('launch.frontend.launch_extension', 'launch')
            Parser.extensions_loaded = True

    @classmethod
    def load_parser_implementations(cls) -> None:
        """Import the parsers of all formats, once."""
        if Parser.frontend_parsers is None:
            Parser.frontend_parsers = _load_entry_points('launch.frontend.parser', 'parser')

    @classmethod
    def _parsers(cls) -> dict[str, type[Parser]]:
        cls.load_parser_implementations()
        return Parser.frontend_parsers

    # --- from entities to actions -----------------------------------------------------------------------------

    def parse_action(self, entity: Entity) -> Any:
        """
        Return the action that an entity stands for.

        :raises RuntimeError: if its tag is not known
        """
        self.load_launch_extensions()
        return instantiate_action(entity, self)

    def parse_substitution(self, value: str) -> list:
        """Return the substitutions that a text consists of."""
        self.load_launch_extensions()
        return parse_substitution(value)

    def parse_if_substitutions(self, value: Any) -> Any:
        """Return a value with the substitutions in its texts."""
        self.load_launch_extensions()
        return parse_if_substitutions(value)

    def escape_characters(self, value: str) -> str:
        """Return the text without the backslashes that protect a character."""
        return replace_escaped_characters(value)

    def parse_description(self, entity: Entity) -> LaunchDescription:
        """
        Return the launch description of a whole file.

        :raises RuntimeError: if the outermost tag is not ``launch``
        """
        from launch.launch_description import LaunchDescription

        if entity.type_name != 'launch':
            raise RuntimeError("Expected 'launch' as root tag")
        deprecated = entity.get_attr('deprecated', optional=True)
        return LaunchDescription([self.parse_action(child) for child in entity.children], deprecated_reason=deprecated)

    # --- from files to entities -------------------------------------------------------------------------------

    @classmethod
    def get_available_extensions(cls) -> list[str]:
        """Return the names of the formats, e.g. xml."""
        return list(cls._parsers())

    @classmethod
    def get_file_extensions(cls) -> set[str]:
        """Return what the names of launch files of this format end with."""
        return set()

    @classmethod
    def get_file_extensions_from_parsers(cls) -> set[str]:
        """Return what the names of launch files of all these formats end with."""
        return set(itertools.chain.from_iterable(parser.get_file_extensions() for parser in cls._parsers().values()))

    @classmethod
    def may_parse(cls, filename: str) -> bool:
        """Return True if a file of that name may have this format."""
        return any(filename.endswith('.' + extension) for extension in cls.get_file_extensions())

    @classmethod
    def is_filename_valid(cls, filename: str) -> bool:
        """Return True if a file of that name may have one of the formats."""
        return bool(cls.get_parsers_from_filename(filename))

    @classmethod
    def get_parsers_from_filename(cls, filename: str) -> list[type[Parser]]:
        """Return the parsers of the formats that a file of that name may have."""
        return [parser for parser in cls._parsers().values() if parser.may_parse(filename)]

    @classmethod
    def load(cls, file: str | os.PathLike | TextIO) -> tuple[Entity, Parser]:
        """
        Return the outermost entity of a file, and the parser for it: first tried by the file's name, then all others.

        :raises InvalidFrontendLaunchFileError: if it can be read as none of the formats
        :raises OSError: if it cannot be read at all
        """
        if isinstance(file, (str, os.PathLike)):
            with open(file, encoding='utf-8') as opened:
                return cls.load(opened)
        name = str(getattr(file, 'name', ''))
        likely = cls.get_parsers_from_filename(name)
        errors = []
        for parser in [*likely, *(parser for parser in cls._parsers().values() if parser not in likely)]:
            try:
                return parser.load(file)
            except Exception as error:  # of any parser, and of any kind
                errors.append(error)
                file.seek(0)
        extension = os.path.splitext(name)[1][1:] if likely else ''
        raise InvalidFrontendLaunchFileError(extension, likely_errors=errors)


def _load_entry_points(group: str, kind: str) -> dict[str, Any]:
    """Import what the entry points name; warn of one that fails, as the others may be all that is needed."""
    loaded = {}
    for entry_point in sorted(entry_points(group=group), key=lambda point: point.name):
        try:
            loaded[entry_point.name] = entry_point.load()
        except Exception:
            warnings.warn(
                f'Failed to load the {kind} extension: {entry_point.name}\n{traceback.format_exc()}', stacklevel=2
            )
    return loaded
