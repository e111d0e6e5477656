"""The tree that ``ros2 launch --print`` shows."""

from __future__ import annotations

from launch.action import Action
from launch.actions.emit_event import EmitEvent
from launch.actions.execute_process import ExecuteProcess
from launch.actions.log_info import LogInfo
from launch.actions.register_event_handler import RegisterEventHandler
from launch.launch_description import LaunchDescription

_DESCRIBED = (EmitEvent, ExecuteProcess, LogInfo)  # upstream shows no more than the class of the others


class LaunchIntrospector:
    """Describes launch descriptions, to the letter as upstream does."""

    def format_launch_description(self, launch_description: LaunchDescription) -> str:
        """Return a tree of the entities, one line each, without launching anything."""
        return '\n'.join([str(launch_description), *_draw(_lines(launch_description.entities, 1))])


def _lines(entities, depth: int) -> list[tuple[int, str]]:
    """Return depth and text of each line, from 1 on."""
    result = []
    for entity in entities:
        if isinstance(entity, RegisterEventHandler):
            description, below = entity.event_handler.describe()
            result += [(depth, entity.describe()), (depth + 1, description), *_lines(below, depth + 2)]
        elif isinstance(entity, _DESCRIBED):
            result.append((depth, entity.describe()))
        else:
            kind = 'Action' if isinstance(entity, Action) else 'Unknown entity'
            result.append((depth, f"{kind}('{entity}')"))
    return result


def _draw(lines: list[tuple[int, str]]) -> list[str]:
    """Put the branches before the texts: only the trunk of the outermost level is drawn through."""
    result = []
    for (depth, text), (next_depth, _) in zip(lines, [*lines[1:], (0, '')], strict=True):
        trunk = '' if depth == 1 else '│'.ljust(4 * (depth - 1))
        result.append(trunk + ('├── ' if next_depth >= depth else '└── ') + text)
    if result and result[-1].startswith('│'):
        result[-1] = ' ' + result[-1][1:]
    return result
