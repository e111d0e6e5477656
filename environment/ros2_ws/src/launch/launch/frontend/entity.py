"""One element of a launch file, whatever the file's format."""

from __future__ import annotations

from typing import Any


class Entity:
    """An element with a type, attributes and children. Each format derives its own."""

    @property
    def type_name(self) -> str:
        """The name of the tag."""
        raise NotImplementedError

    @property
    def parent(self) -> Entity | None:
        """The element around this one."""
        raise NotImplementedError

    @property
    def children(self) -> list[Entity]:
        """The elements in this one."""
        raise NotImplementedError

    def assert_entity_completely_parsed(self) -> None:
        """
        Check that every attribute and child has been asked for, so that a misspelled one is found.

        :raises ValueError: if one has not
        """
        raise NotImplementedError

    def get_attr(self, name: str, *, data_type: Any = str, optional: bool = False, can_be_str: bool = True) -> Any:
        """
        Return an attribute.

        :param data_type: the type wanted, see ``launch.utilities.type_utils``; None for what YAML makes of it;
            ``List[Entity]`` for the children of that name
        :param optional: return None if there is none
        :param can_be_str: accept a text in place of another type, as it may hold substitutions
        :raises AttributeError: if there is none
        :raises TypeError: if it has another type
        """
        raise NotImplementedError
