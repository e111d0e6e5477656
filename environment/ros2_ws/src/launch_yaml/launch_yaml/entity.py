"""One element of a YAML launch file."""

from __future__ import annotations

from typing import Any

from launch import frontend
from launch.frontend.type_utils import check_is_list_entity
from launch.utilities.type_utils import is_instance_of


class Entity(frontend.Entity):
    """
    An element of YAML: a name with a mapping of attributes, or with a list of children.

    An element with both has its children in the attribute ``children``.
    """

    def __init__(self, element: dict | list, type_name: str, *, parent: Entity | None = None):
        self._element, self._type_name, self._parent = element, type_name, parent
        self._asked: set[str] = set()
        self._asked_children = False

    @property
    def type_name(self) -> str:
        """The name of the element."""
        return self._type_name

    @property
    def parent(self) -> Entity | None:
        """The element around this one."""
        return self._parent

    @property
    def children(self) -> list[Entity]:
        """
        The elements in this one.

        :raises ValueError: if there is no list of them
        """
        self._asked_children = True
        children = self._element
        if isinstance(children, dict):
            if 'children' not in children:
                raise ValueError(
                    f'Expected entity `{self._type_name}` to have children entities.'
                    'That can be a list of subentities or a dictionary with a `children` list element'
                )
            self._asked.add('children')
            children = children['children']
        if not isinstance(children, list):
            raise ValueError(f'Expected a list of subentities in entity `{self._type_name}`, got {children!r}')
        return [self._child(child) for child in children]

    def _child(self, child: Any) -> Entity:
        if not isinstance(child, dict) or len(child) != 1:
            raise RuntimeError(
                'Subentities must be a dictionary with only one key, which is the entity type; '
                f'in entity `{self._type_name}` there is {child!r}'
            )
        (name,) = child
        return Entity(child[name], name, parent=self)

    def assert_entity_completely_parsed(self) -> None:
        """
        Check that every attribute and child has been asked for.

        :raises ValueError: if one has not
        """
        if isinstance(self._element, list):
            if not self._asked_children:
                raise ValueError(f'Unexpected nested entity(ies) found in `{self._type_name}`: {self._element}')
            return
        unknown = set(self._element or {}) - self._asked
        if unknown:
            raise ValueError(f'Unexpected key(s) found in `{self._type_name}`: {unknown}')

    def get_attr(self, name: str, *, data_type: Any = str, optional: bool = False, can_be_str: bool = True) -> Any:
        """
        Return an attribute; for ``List[Entity]`` a list of mappings, as entities.

        :raises AttributeError: if there is none
        :raises TypeError: if it has another type
        """
        if not isinstance(self._element, dict) or name not in self._element:
            if optional:
                return None
            raise AttributeError(f"Attribute '{name}' of type '{data_type}' not found in Entity '{self._type_name}'")
        self._asked.add(name)
        value = self._element[name]
        if check_is_list_entity(data_type):
            if not isinstance(value, list) or not all(isinstance(item, dict) for item in value):
                raise TypeError(
                    f"Attribute '{name}' of Entity '{self._type_name}' expected to be a list of "
                    f'dictionaries, got {value!r}'
                )
            return [Entity(item, name, parent=self) for item in value]
        if data_type is float and type(value) is int:
            value = float(value)
        if not is_instance_of(value, data_type, can_be_str=can_be_str):
            raise TypeError(
                f"Attribute '{name}' of Entity '{self._type_name}' expected to be of type '{data_type}', "
                f'got {type(value)}: {value!r}'
            )
        return value
