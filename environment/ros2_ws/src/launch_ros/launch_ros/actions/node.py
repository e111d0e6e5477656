"""Runs a ROS node."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable, Mapping
from pathlib import Path

import launch.logging
import yaml
from launch.actions import ExecuteProcess
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import describe_substitutions, to_text

from launch_ros.actions.set_parameter import GLOBAL_PARAMETERS, GlobalParameter
from launch_ros.actions.set_remap import REMAPPINGS
from launch_ros.namespaces import join_namespace
from launch_ros.parameter_descriptions import ParameterFile
from launch_ros.parameters import evaluate_parameters
from launch_ros.substitutions import ExecutableInPackage

UNSPECIFIED_NAME = '<node_name_unspecified>'


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
    :raises TypeError: if parameters or remappings are not lists
    """

    def __init__(
        self,
        *,
        executable: SomeSubstitutionsType,
        package: SomeSubstitutionsType | None = None,
        name: SomeSubstitutionsType | None = None,
        namespace: SomeSubstitutionsType | None = None,
        exec_name: SomeSubstitutionsType | None = None,
        parameters: list | None = None,
        remappings: list[tuple[SomeSubstitutionsType, SomeSubstitutionsType]] | None = None,
        ros_arguments: Iterable[SomeSubstitutionsType] | None = None,
        arguments: Iterable[SomeSubstitutionsType] | None = None,
        **kwargs,
    ):
        for label, value in (('parameters', parameters), ('remappings', remappings)):
            if value is not None and not isinstance(value, (list, tuple)):
                raise TypeError(f"'{label}' of Node must be a list, got {type(value).__name__}")
        program = executable if package is None else ExecutableInPackage(package=package, executable=executable)
        super().__init__(cmd=[program, *(arguments or [])], name=exec_name, **kwargs)
        self.node_package, self.node_executable = package, executable
        self._node_name, self._node_namespace = name, namespace
        self._parameters, self._remappings = list(parameters or []), list(remappings or [])
        self._ros_arguments = list(ros_arguments or [])
        self._final_name: str | None = None

    @property
    def node_name(self) -> str:
        """
        The full name of the node.

        :raises RuntimeError: before the action is executed
        """
        if self._final_name is None:
            raise RuntimeError("cannot access 'node_name' before executing action")
        return self._final_name

    def describe(self) -> str:
        package = '' if self.node_package is None else f'package={describe_substitutions(self.node_package)}, '
        return f'Node({package}executable={describe_substitutions(self.node_executable)})'

    def get_command(self, context: LaunchContext) -> list[str]:
        return [*super().get_command(context), '--ros-args', *self._ros_words(context)]

    def _ros_words(self, context: LaunchContext) -> list[str]:
        words = [to_text(context, argument) for argument in self._ros_arguments]
        name = '' if self._node_name is None else to_text(context, self._node_name)
        base = context.launch_configurations.get('ros_namespace', '')
        given = '' if self._node_namespace is None else to_text(context, self._node_namespace)
        namespace = join_namespace(base, given)
        _validate(name, namespace)
        self._final_name = f'{namespace.rstrip("/")}/{name or UNSPECIFIED_NAME}'
        if name:
            words += ['-r', f'__node:={name}']
        if namespace:
            words += ['-r', f'__ns:={namespace}']
        parameters = [*context.launch_configurations.get(GLOBAL_PARAMETERS, []), *self._parameters]
        for item in parameters:
            words += self._parameter_words(context, item, self._final_name if name else '/**')
        remappings = [(to_text(context, old), to_text(context, new)) for old, new in self._remappings]
        for old, new in [*context.launch_configurations.get(REMAPPINGS, []), *remappings]:
            words += ['-r', f'{old}:={new}']
        return words

    @staticmethod
    def _parameter_words(context: LaunchContext, item, node: str) -> list[str]:
        if isinstance(item, GlobalParameter):
            return ['-p', f'{item.name}:={item.as_yaml()}']
        if isinstance(item, Mapping):
            return ['--params-file', _write_parameters(context, node, evaluate_parameters(context, item))]
        path = to_text(context, item.param_file if isinstance(item, ParameterFile) else item)
        if not Path(path).is_file():
            launch.logging.get_logger('launch_ros.actions.node').warning(f'Parameter file path is not a file: {path}')
        return ['--params-file', path]


def _validate(name: str, namespace: str) -> None:
    """Refuse bad names here, where the message is clear."""
    from rclpy.validate_namespace import validate_namespace
    from rclpy.validate_node_name import validate_node_name

    if name:
        validate_node_name(name)
    if namespace:
        validate_namespace(namespace)


def _write_parameters(context: LaunchContext, node: str, parameters: Mapping) -> str:
    """Write a parameter file that is removed when the launch ends; return its path."""
    with tempfile.NamedTemporaryFile('w', prefix='launch_params_', suffix='.yaml', delete=False) as file:
        yaml.safe_dump({node: {'ros__parameters': dict(parameters)}}, file, default_flow_style=False)
    context.remove_at_end(file.name)
    return file.name
