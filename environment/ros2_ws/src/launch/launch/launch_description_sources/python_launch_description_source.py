"""Launch files written in Python."""

from __future__ import annotations

import os
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from types import ModuleType

from launch.invalid_launch_file_error import InvalidLaunchFileError
from launch.launch_description import LaunchDescription
from launch.launch_description_source import LaunchDescriptionSource


class _NoCacheLoader(SourceFileLoader):
    """Leaves no .pyc behind, and never runs an old one."""

    def _cache_bytecode(self, *_) -> None:
        pass

    def get_code(self, fullname: str):
        path = self.get_filename(fullname)
        return self.source_to_code(self.get_data(path), path)


def load_python_launch_file_as_module(path: str) -> ModuleType:
    """Run a launch file and return it as a module."""
    loader = _NoCacheLoader('python_launch_file', path)
    module = module_from_spec(spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


def get_launch_description_from_python_launch_file(path: str) -> LaunchDescription:
    """
    Load a Python launch file.

    :raises InvalidLaunchFileError: if running it fails, or it has no ``generate_launch_description``
    :raises OSError: if it cannot be read
    """
    with open(path, 'rb'):
        pass  # the OSError of an unreadable file is clearer than that of an import
    try:
        module = load_python_launch_file_as_module(path)
        if not hasattr(module, 'generate_launch_description'):
            raise AttributeError(f"launch file at '{path}' does not contain the required function "
                                 "'generate_launch_description()'")
        description = module.generate_launch_description()
        if not isinstance(description, LaunchDescription):
            raise TypeError(f"generate_launch_description() of '{path}' returned "
                            f"{type(description).__name__}, not a LaunchDescription")
    except Exception as error:
        raise InvalidLaunchFileError('py', likely_errors=[error]) from error
    return description


def get_launch_description_from_any_launch_file(path: str) -> LaunchDescription:
    """Load a launch file of any kind known here, which is Python only."""
    extension = os.path.splitext(path)[1].lstrip('.')
    if extension in ('xml', 'yaml', 'yml'):
        error = NotImplementedError('only Python launch files (.launch.py) are supported here')
        raise InvalidLaunchFileError(extension, likely_errors=[error])
    return get_launch_description_from_python_launch_file(path)


class PythonLaunchDescriptionSource(LaunchDescriptionSource):
    """A Python launch file."""

    def __init__(self, launch_file_path):
        super().__init__(launch_file_path)

    def _load(self, path: str) -> LaunchDescription:
        return get_launch_description_from_python_launch_file(path)


class AnyLaunchDescriptionSource(PythonLaunchDescriptionSource):
    """A launch file of any kind known here."""

    def _load(self, path: str) -> LaunchDescription:
        return get_launch_description_from_any_launch_file(path)
