"""The tree that ``ros2 launch --print`` shows."""

from __future__ import annotations

from launch.action import Action
from launch.actions.register_event_handler import RegisterEventHandler
from launch.launch_description import LaunchDescription


class LaunchIntrospector:
    """Describes launch descriptions."""

    def format_launch_description(self, launch_description: LaunchDescription) -> str:
        """Return a tree of the entities, one line each, without launching anything."""
        return '\n'.join([str(launch_description), *_branches(launch_description.entities)])


def _branches(entities) -> list[str]:
    entities = [part for entity in entities for part in _unwrap(entity)]
    lines: list[str] = []
    for entity in entities:
        last = entity is entities[-1]
        lines.append(('└── ' if last else '├── ') + entity.describe())
        lines += [('    ' if last else '│   ') + line for line in _below(entity)]
    return lines


def _unwrap(entity) -> list:
    return entity.entities if isinstance(entity, LaunchDescription) else [entity]


def _below(entity) -> list[str]:
    if isinstance(entity, RegisterEventHandler):
        description, entities = entity.event_handler.describe()
        return ['└── ' + description, *('    ' + line for line in _branches(entities))]
    return _branches(entity.get_sub_entities()) if isinstance(entity, Action) else []
