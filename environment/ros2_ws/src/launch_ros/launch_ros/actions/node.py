"""Runs a ROS node."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import launch.logging
import yaml
from launch.actions import ExecuteProcess
from launch.frontend import Entity, Parser, expose_action
from launch.frontend.type_utils import get_data_type_from_identifier
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import normalize_to_list_of_substitutions, to_text

from launch_ros.actions.set_remap import REMAPPINGS
from launch_ros.global_parameters import GLOBAL_PARAMETERS, GlobalParameter
from launch_ros.namespaces import join_namespace
from launch_ros.parameter_descriptions import Parameter, ParameterFile, ParameterValue, write_temporary_file
from launch_ros.parameters import check_parameters, evaluate_parameters
from launch_ros.substitutions import ExecutableInPackage
from launch_ros.utilities import add_node_name


class _NodeName(Substitution):
    """The remapping that gives a node its name; it is known once the name is."""

    def __init__(self, name: SomeSubstitutionsType):
        self._name = name

    def describe(self) -> str:
        return "LocalVar('node name')"

    def perform(self, context: LaunchContext) -> str:
        return f'__node:={to_text(context, self._name)}'


@expose_action('node')
class Node(ExecuteProcess):
    """
    Runs a program of a package with a node's name, namespace, parameters and remappings.

    Further keyword arguments are those of ``ExecuteProcess``.

    :param executable: the program; without a package a path, or a name on the PATH
    :param package: where to look for it
    :param name: the node's name, instead of the program's own
    :param namespace: below the one of PushROSNamespace, unless it begins with /
    :param exec_name: what the log calls the process
    :param parameters: dictionaries and paths of YAML files; later ones win
    :param remappings: (from, to) pairs
    :param ros_arguments: further words for behind --ros-args
    :param arguments: further words for the program
    :raises TypeError: if parameters or remappings are not lists, or have items that they cannot have
    """

    # What stands for a name and a namespace that only the node's program knows.
    UNSPECIFIED_NODE_NAME = '<node_name_unspecified>'
    UNSPECIFIED_NODE_NAMESPACE = '<node_namespace_unspecified>'

    def __init__(
        self,
        *,
        executable: SomeSubstitutionsType,
        package: SomeSubstitutionsType | None = None,
        name: SomeSubstitutionsType | None = None,
        namespace: SomeSubstitutionsType | None = None,
        exec_name: SomeSubstitutionsType | None = None,
        parameters: list | None = None,
        remappings: Iterable[tuple[SomeSubstitutionsType, SomeSubstitutionsType]] | None = None,
        ros_arguments: Iterable[SomeSubstitutionsType] | None = None,
        arguments: Iterable[SomeSubstitutionsType] | None = None,
        **kwargs,
    ):
        if parameters is not None and not isinstance(parameters, (list, tuple)):
            raise TypeError(f"'parameters' of Node must be a list, got {type(parameters).__name__}")
        check_parameters(parameters or [])
        remappings = list(remappings or [])  # as in stock, any pairs will do: those of a dictionary, too
        check_remappings(remappings)
        program = executable if package is None else ExecutableInPackage(package=package, executable=executable)
        cmd = [program, *(arguments or []), '--ros-args', *(ros_arguments or [])]
        cmd += [] if name is None else ['-r', _NodeName(name)]
        super().__init__(cmd=cmd, name=exec_name, **kwargs)
        self.node_package, self.node_executable = package, executable
        self._node_name, self._node_namespace = name, namespace
        self._parameters, self._remappings = list(parameters or []), remappings
        self._final_name: str | None = None
        self._final_namespace = self.UNSPECIFIED_NODE_NAMESPACE

    @classmethod
    def parse(cls, entity: Entity, parser: Parser):
        """Read ``node``."""
        _, kwargs = super().parse(entity, parser, ignore=('cmd', 'name'))
        kwargs['executable'] = parser.parse_substitution(entity.get_attr('exec'))
        for attribute, argument in (
            ('pkg', 'package'),
            ('name', 'name'),
            ('exec_name', 'exec_name'),
            ('namespace', 'namespace'),
        ):
            value = entity.get_attr(attribute, optional=True)
            if value is not None:
                kwargs[argument] = parser.parse_substitution(value)
        for attribute, argument in (('args', 'arguments'), ('ros_args', 'ros_arguments')):
            value = entity.get_attr(attribute, optional=True)
            if value is not None:
                kwargs[argument] = cls._parse_cmdline(value, parser)
        kwargs.update(parse_remappings(entity, parser))
        kwargs.update(parse_parameters(entity, parser))
        return cls, kwargs

    @property
    def node_name(self) -> str:
        """
        The full name of the node.

        :raises RuntimeError: before the action is executed
        """
        if self._final_name is None:
            raise RuntimeError("cannot access 'node_name' before executing action")
        return self._final_name

    @property
    def expanded_node_namespace(self) -> str:
        """The node's namespace, once the action is executed and if it is known."""
        return self._final_namespace

    def is_node_name_fully_specified(self) -> bool:
        """Return True if name and namespace are both known; only then parameters can name the node."""
        return not any(
            unknown in self.node_name for unknown in (self.UNSPECIFIED_NODE_NAME, self.UNSPECIFIED_NODE_NAMESPACE)
        )

    def execute(self, context: LaunchContext) -> None:
        super().execute(context)
        if self.is_node_name_fully_specified():
            add_node_name(context, self.node_name, logger=self.process_name)

    def prepare(self, context: LaunchContext) -> None:
        """Find the texts of name, command, directory and environment; the command gets what ROS reads of it."""
        self._expand_name(context)
        program = self.process_description
        program.cmd.extend(normalize_to_list_of_substitutions(word) for word in self._ros_words(context))
        super().prepare(context)

    def _expand_name(self, context: LaunchContext) -> None:
        """Find out the full name, which may have parts that are known only now."""
        name = None if self._node_name is None else to_text(context, self._node_name)
        base = context.launch_configurations.get('ros_namespace')
        given = None if self._node_namespace is None else to_text(context, self._node_namespace)
        namespace = None if base is None and given is None else join_namespace(base or '', given or '') or '/'
        _validate(name, namespace)
        self._final_namespace = namespace or self.UNSPECIFIED_NODE_NAMESPACE
        self._final_name = f'{self._final_namespace.rstrip("/")}/{name or self.UNSPECIFIED_NODE_NAME}'

    def _ros_words(self, context: LaunchContext) -> list[str]:
        known = self._final_namespace != self.UNSPECIFIED_NODE_NAMESPACE
        words = ['-r', f'__ns:={self._final_namespace}'] if known else []
        node = self._final_name if self.is_node_name_fully_specified() else '/**'
        parameters = [*context.launch_configurations.get(GLOBAL_PARAMETERS, []), *self._parameters]
        for item in parameters:
            words += self._parameter_words(context, item, node)
        remappings = [(to_text(context, old), to_text(context, new)) for old, new in self._remappings]
        for old, new in [*context.launch_configurations.get(REMAPPINGS, []), *remappings]:
            words += ['-r', f'{old}:={new}']
        return words

    @staticmethod
    def _parameter_words(context: LaunchContext, item, node: str) -> list[str]:
        if isinstance(item, Parameter):
            item = GlobalParameter(*item.evaluate(context))
        if isinstance(item, GlobalParameter):
            return ['-p', f'{item.name}:={item.as_yaml()}']
        if isinstance(item, Mapping):
            parameters = {node: {'ros__parameters': evaluate_parameters(context, item)}}
            text = yaml.safe_dump(parameters, default_flow_style=False)
            return ['--params-file', str(write_temporary_file(context, text))]
        path = item.evaluate(context) if isinstance(item, ParameterFile) else Path(to_text(context, item))
        if not path.is_file():
            launch.logging.get_logger('launch_ros.actions.node').warning(f'Parameter file path is not a file: {path}')
            return []  # with the path of no file, the node would not start
        return ['--params-file', str(path)]


def check_remappings(remappings: Iterable) -> None:
    """
    Check that remappings are pairs.

    :raises TypeError: if one is not
    """
    for remapping in remappings:
        if not isinstance(remapping, (tuple, list)) or len(remapping) != 2:
            raise TypeError(f"'remappings' of Node must be pairs (from, to), got {remapping!r}")


def parse_remappings(entity: Entity, parser: Parser) -> dict[str, Any]:
    """Return the keyword argument ``remappings`` that the ``remap`` in an element stand for; nothing without one."""
    remappings = entity.get_attr('remap', data_type=list[Entity], optional=True)
    if remappings is None:
        return {}
    pairs = [tuple(parser.parse_substitution(remap.get_attr(key)) for key in ('from', 'to')) for remap in remappings]
    for remap in remappings:
        remap.assert_entity_completely_parsed()
    return {'remappings': pairs}


def parse_parameters(
    entity: Entity, parser: Parser, *, tag: str = 'param', argument: str = 'parameters'
) -> dict[str, Any]:
    """Return the keyword argument that the ``param`` in an element stand for; nothing without one."""
    parameters = entity.get_attr(tag, data_type=list[Entity], optional=True)
    return {} if parameters is None else {argument: [_parse_parameter(each, parser) for each in parameters]}


def _parse_parameter(entity: Entity, parser: Parser) -> ParameterFile | dict:
    """Return the file or the value that a ``param`` of a node names."""
    path = entity.get_attr('from', optional=True)
    if path is None:
        if entity.get_attr('name', optional=True) is None:
            raise ValueError('param Entity should have name or from attribute')
        return _parse_value(entity, parser)
    if entity.get_attr('name', optional=True) is not None:
        raise RuntimeError('name and from attributes are mutually exclusive')
    allow = entity.get_attr('allow_substs', data_type=bool, optional=True)
    entity.assert_entity_completely_parsed()
    return ParameterFile(parser.parse_substitution(path), allow_substs=parser.parse_if_substitutions(allow or False))


def _parse_value(entity: Entity, parser: Parser) -> dict:
    """Return the value of a ``param`` with a name, or those of the ``param`` in it, below that name."""
    name = tuple(parser.parse_substitution(entity.get_attr('name')))
    identifier = entity.get_attr('type', optional=True)
    kind = get_data_type_from_identifier(identifier or 'yaml')
    value = entity.get_attr('value', data_type=kind, optional=True)
    nested = entity.get_attr('param', data_type=list[Entity], optional=True)
    entity.assert_entity_completely_parsed()
    if value is not None and nested:
        raise RuntimeError('nested parameters and value attributes are mutually exclusive')
    if kind is not None and nested:
        raise RuntimeError('nested parameters and type attributes are mutually exclusive')
    if nested:
        below: dict = {}
        for part in nested:
            below.update(_parse_value(part, parser))
        return {name: below}
    if value is None:
        raise RuntimeError('either a value attribute or nested params are needed')
    return {name: ParameterValue(parser.parse_if_substitutions(value), value_type=kind)}


def _validate(name: str | None, namespace: str | None) -> None:
    """Refuse bad names here, where the message is clear."""
    from rclpy.validate_namespace import validate_namespace
    from rclpy.validate_node_name import validate_node_name

    if name is not None:
        validate_node_name(name)
    if namespace:
        validate_namespace(namespace)
