"""Where an included launch description comes from."""

from __future__ import annotations

import os

from launch.launch_context import LaunchContext
from launch.launch_description import LaunchDescription
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import describe_substitutions, normalize_to_list_of_substitutions, to_text


class LaunchDescriptionSource:
    """A launch file whose path may be known only while launching. Subclasses write ``_load``."""

    def __init__(self, location: SomeSubstitutionsType):
        self._location = normalize_to_list_of_substitutions(location)
        self._path: str | None = None

    @property
    def location(self) -> str:
        """The path if it is known, otherwise how it will be found."""
        return self._path or describe_substitutions(self._location)

    def get_launch_description(self, context: LaunchContext) -> LaunchDescription:
        """
        Load the file.

        :raises InvalidLaunchFileError: if it has a fault
        :raises OSError: if it cannot be read
        """
        self._path = os.path.abspath(to_text(context, self._location))
        return self._load(self._path)

    def try_get_launch_description_without_context(self) -> LaunchDescription | None:
        """Load the file if its path is known without launching and it has no fault; otherwise return None."""
        try:
            return self.get_launch_description(LaunchContext())
        except Exception:  # only a guess is wanted: the real launch reports the fault
            return None

    def _load(self, path: str) -> LaunchDescription:
        raise NotImplementedError
