"""Names and types of topics."""

import sys
from argparse import Namespace
from typing import Any

from ros2cli.deferred import attributes_from

__getattr__ = attributes_from(
    {
        'NodeStrategy': 'ros2cli.node.strategy',
        'add_qos_arguments': 'ros2topic.api.qos',
        'choose_qos': 'ros2topic.api.qos',
        'get_message': 'rosidl_runtime_py.utilities',
        'message_to_yaml': 'rosidl_runtime_py',
        'profile_configure_short_keys': 'ros2topic.api.qos',
        'qos_profile_from_short_keys': 'ros2topic.api.qos',
    },
    module=__name__,
)

# The completers look names up here, so that a test can put something else in their place, as with upstream's module.
_this = sys.modules[__name__]


def get_topic_names_and_types(*, node: Any, include_hidden_topics: bool = False) -> list[tuple[str, list[str]]]:
    """Return the topics of the graph with their types, hidden ones only if asked for."""
    from rclpy.topic_or_service_is_hidden import topic_or_service_is_hidden

    return [
        (name, types)
        for name, types in node.get_topic_names_and_types()
        if include_hidden_topics or not topic_or_service_is_hidden(name)
    ]


def get_topic_names(*, node: Any, include_hidden_topics: bool = False) -> list[str]:
    """Return the topics of the graph, hidden ones only if asked for."""
    return [name for name, _ in get_topic_names_and_types(node=node, include_hidden_topics=include_hidden_topics)]


def expand_topic(node: Any, topic: str) -> str:
    """
    Return the full name of a topic as the node would use it.

    :raises RuntimeError: if it is not a valid name.
    """
    from rclpy.exceptions import InvalidTopicNameException
    from rclpy.expand_topic_name import expand_topic_name
    from rclpy.validate_full_topic_name import validate_full_topic_name

    try:
        full_name = expand_topic_name(topic, node.get_name(), node.get_namespace())
        validate_full_topic_name(full_name)
    except (ValueError, InvalidTopicNameException) as e:
        raise RuntimeError(str(e)) from None
    return full_name


def get_msg_class(node: Any, topic: str, blocking: bool = False, include_hidden_topics: bool = False) -> Any:
    """
    Return the message class of a topic, or None if nobody publishes or subscribes to it.

    :param node: a ros2cli DirectNode.
    :param blocking: wait until somebody does.
    :raises RuntimeError: if the topic has several types, or one that is not installed.
    """
    message_class = _find_msg_class(node, topic, include_hidden_topics)
    if message_class is not None:
        return message_class
    print(f'WARNING: topic [{topic}] does not appear to be published yet')
    if not blocking:
        return None

    def found() -> bool:
        nonlocal message_class
        message_class = _find_msg_class(node, topic, include_hidden_topics)
        return message_class is not None

    node.spin(until=found)
    return message_class


def _find_msg_class(node: Any, topic: str, include_hidden_topics: bool) -> Any:
    full_name = expand_topic(node, topic)
    types = dict(get_topic_names_and_types(node=node, include_hidden_topics=include_hidden_topics)).get(full_name)
    if types is None:
        return None
    if len(types) > 1:
        raise RuntimeError(f"Cannot echo topic '{topic}', as it contains more than one type: [{', '.join(types)}]")
    return load_message_class(types[0], f"The message type '{types[0]}' is invalid")


def load_message_class(name: str, error: str = 'The passed message type is invalid') -> Any:
    """
    Return a message class.

    :param error: what to say if there is none of that name.
    :raises RuntimeError: if there is none of that name.
    """
    try:
        return _this.get_message(name)
    except (AttributeError, ModuleNotFoundError, ValueError):
        raise RuntimeError(error) from None


class TopicNameCompleter:
    """Completes the names of topics."""

    def __init__(self, *, include_hidden_topics_key: str | None = None) -> None:
        """Remember which argument says whether hidden topics count."""
        self.include_hidden_topics_key = include_hidden_topics_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """Return the names."""
        hidden = bool(self.include_hidden_topics_key and getattr(parsed_args, self.include_hidden_topics_key, False))
        with _this.NodeStrategy(parsed_args) as node:
            return get_topic_names(node=node, include_hidden_topics=hidden)


def message_type_completer(**_: Any) -> list[str]:
    """Return all message types."""
    from rosidl_runtime_py import get_message_interfaces

    return [f'{package}/{name}' for package, names in sorted(get_message_interfaces().items()) for name in names]


class TopicTypeCompleter:
    """Completes the type of a message: the one the topic has, or any."""

    def __init__(self, *, topic_name_key: str | None = None) -> None:
        """Remember which argument names the topic."""
        self.topic_name_key = topic_name_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """Return the types."""
        if self.topic_name_key is not None:
            with _this.NodeStrategy(parsed_args) as node:
                types = dict(get_topic_names_and_types(node=node, include_hidden_topics=True)).get(
                    getattr(parsed_args, self.topic_name_key)
                )
            if types:
                return types
        return message_type_completer()


class TopicMessagePrototypeCompleter:
    """Completes the values of a message: its fields with their defaults."""

    def __init__(self, *, topic_type_key: str) -> None:
        """Remember which argument names the type."""
        self.topic_type_key = topic_type_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """Return one text, the YAML of a message with default values."""
        from ros2cli.yaml_completion import quoted_yaml

        message_class = load_message_class(getattr(parsed_args, self.topic_type_key))
        return quoted_yaml(_this.message_to_yaml(message_class()), prefix)
