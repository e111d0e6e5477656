"""A plain text."""

from launch.launch_context import LaunchContext
from launch.substitution import Substitution


class TextSubstitution(Substitution):
    """A text that is known already."""

    def __init__(self, *, text: str):
        if not isinstance(text, str):
            raise TypeError(f"TextSubstitution expected a str for 'text', got {text!r}")
        self.text = text

    def describe(self) -> str:
        return f"'{self.text}'"

    def perform(self, context: LaunchContext) -> str:
        return self.text
