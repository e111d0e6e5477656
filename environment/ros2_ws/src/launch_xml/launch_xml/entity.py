"""One element of an XML launch file."""

from __future__ import annotations

from typing import Any
from xml.etree import ElementTree

from launch import frontend
from launch.frontend.type_utils import check_is_list_entity
from launch.utilities.type_utils import get_typed_value


class Entity(frontend.Entity):
    """An element of XML. An attribute is a text; ``name-sep`` divides the attribute ``name`` into a list."""

    def __init__(self, xml_element: ElementTree.Element, *, parent: Entity | None = None):
        self._element, self._parent = xml_element, parent
        self._asked_attributes: set[str] = set()
        self._asked_children: set[str] = set()

    @property
    def type_name(self) -> str:
        """The name of the tag."""
        return self._element.tag

    @property
    def parent(self) -> Entity | None:
        """The element around this one."""
        return self._parent

    @property
    def children(self) -> list[Entity]:
        """The elements in this one."""
        self._asked_children = {child.tag for child in self._element}
        return [Entity(child, parent=self) for child in self._element]

    def assert_entity_completely_parsed(self) -> None:
        """
        Check that every attribute and child has been asked for.

        :raises ValueError: if one has not
        """
        children = {child.tag for child in self._element} - self._asked_children
        if children:
            raise ValueError(f'Unexpected nested tag(s) found in `{self.type_name}`: {children}')
        attributes = set(self._element.attrib) - self._asked_attributes
        if attributes:
            raise ValueError(f'Unexpected attribute(s) found in `{self.type_name}`: {attributes}')

    def get_attr(self, name: str, *, data_type: Any = str, optional: bool = False, can_be_str: bool = True) -> Any:
        """
        Return an attribute, read as the type wanted; for ``List[Entity]`` the children of that name.

        :raises AttributeError: if there is none
        :raises TypeError: if its text is no value of the type
        """
        if check_is_list_entity(data_type):
            value = [Entity(child, parent=self) for child in self._element if child.tag == name] or None
            self._asked_children.add(name)
        else:
            value = self._text_or_list(name)
        if value is None:
            if optional:
                return None
            raise AttributeError(f"Attribute '{name}' of type '{data_type}' not found in Entity '{self.type_name}'")
        if check_is_list_entity(data_type):
            return value
        try:
            return get_typed_value(value, data_type, can_be_str=can_be_str)
        except ValueError:
            raise TypeError(
                f"Attribute '{name}' of Entity '{self.type_name}' expected to be of type '{data_type}'."
                f"'{value}' can not be converted to one of those types"
            ) from None

    def _text_or_list(self, name: str) -> str | list[str] | None:
        value = self._element.attrib.get(name)
        separator = self._element.attrib.get(f'{name}-sep')
        self._asked_attributes |= {name, f'{name}-sep'}
        return value if value is None or separator is None else value.split(separator)
