"""Loading launch files written in Python."""

from __future__ import annotations

from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from types import ModuleType

from launch.launch_description import LaunchDescription


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


class InvalidPythonLaunchFileError(Exception):
    """A Python launch file lacks its function."""


def get_launch_description_from_python_launch_file(python_launch_file_path: str) -> LaunchDescription:
    """
    Load a Python launch file. An exception of the file itself is passed on.

    :raises InvalidPythonLaunchFileError: if it has no ``generate_launch_description``
    :raises TypeError: if that returns anything else
    :raises OSError: if it cannot be read
    """
    path = str(python_launch_file_path)
    module = load_python_launch_file_as_module(path)
    if not hasattr(module, 'generate_launch_description'):
        raise InvalidPythonLaunchFileError(
            f"launch file at '{path}' does not contain the required function 'generate_launch_description()'"
        )
    description = module.generate_launch_description()
    if not isinstance(description, LaunchDescription):
        raise TypeError(
            f"generate_launch_description() of '{path}' returned {type(description).__name__}, not a LaunchDescription"
        )
    return description
