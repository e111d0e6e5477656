"""The texts of message types, for programs that write files of their own."""

import re
from dataclasses import dataclass

from rosbag2_py.definitions import message_text, service_text, type_hash

_NAME = re.compile(r'\w+(/\w+)*/\w+', re.ASCII)
_OF_ACTIONS = ('action_msgs/msg/GoalStatusArray', 'action_msgs/srv/CancelGoal_Event')


@dataclass
class MessageDefinition:
    """The text of a type with those that it holds: `ros2msg` or `ros2idl`, or `unknown` and empty."""

    topic_type: str = ''
    encoding: str = 'unknown'
    encoded_message_definition: str = ''
    type_hash: str = ''


class LocalMessageDefinitionSource:
    """Finds definitions in the packages that are installed and sourced."""

    def get_full_text(self, root_type: str) -> MessageDefinition:
        """
        Return the text of a message, a service, or a service's events, `PACKAGE/msg/NAME` or `PACKAGE/srv/NAME`.

        What is no name of a type, and the types of actions, have none: `unknown`, as in stock's bags.

        :raises RuntimeError: if there is no such definition.
        """
        if not _NAME.fullmatch(root_type) or '/action/' in root_type or root_type in _OF_ACTIONS:
            return MessageDefinition(root_type)
        try:
            if '/srv/' not in root_type:
                return MessageDefinition(root_type, *message_text(root_type), _hash(root_type))
            return MessageDefinition(root_type, *service_text(root_type.removesuffix('_Event')), _hash(root_type))
        except LookupError as error:
            raise RuntimeError(str(error.args[0])) from None


def _hash(name: str) -> str:
    return type_hash(name) if name.count('/') == 2 else ''
