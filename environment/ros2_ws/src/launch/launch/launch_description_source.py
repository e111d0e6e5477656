"""Where an included launch description comes from."""

from __future__ import annotations

import os

from launch.launch_context import LaunchContext
from launch.launch_description import LaunchDescription
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import describe_substitutions, normalize_to_list_of_substitutions, to_text


class LaunchDescriptionSource:
    """
    A launch description that is there already, or a launch file whose path may be known only while launching.

    Subclasses for files write ``_load``.

    :param launch_description: the description
    :param location: the path, or what the description is called
    :param method: how the description came to be, for messages
    """

    def __init__(
        self,
        launch_description: LaunchDescription | None = None,
        location: SomeSubstitutionsType = '<string>',
        method: str = 'unspecified mechanism from a script',
    ):
        self._description = launch_description
        self._location = normalize_to_list_of_substitutions(location)
        self.method = method
        self._expanded_location: str | None = None

    @property
    def location(self) -> str:
        """The path or name if it is known, otherwise how it will be found."""
        return describe_substitutions(self._location) if self._expanded_location is None else self._expanded_location

    def get_launch_description(self, context: LaunchContext) -> LaunchDescription:
        """
        Return the description, or load the file. What is wrong with it is raised as it comes.

        :raises OSError: if it cannot be read
        """
        location = to_text(context, self._location)
        if self._description is None:
            location = os.path.abspath(location)
        self._expanded_location = location
        return self._load(location) if self._description is None else self._description

    def try_get_launch_description_without_context(self) -> LaunchDescription | None:
        """Load the file if its path is known without launching and it has no fault; otherwise return None."""
        try:
            return self.get_launch_description(LaunchContext())
        except Exception:  # only a guess is wanted: the real launch reports the fault
            return None

    def _load(self, path: str) -> LaunchDescription:
        raise NotImplementedError
