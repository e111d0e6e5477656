"""Completion by the Tab key of values in YAML: several lines, in quotes for the shell, to be edited."""

import argcomplete


def quoted_yaml(text: str, prefix: str) -> list[str]:
    """
    Return what completes a value.

    :param text: YAML, as rosidl_runtime_py writes it.
    :param prefix: what stands there already; whoever has typed the first letters has typed a quote, too.
    """
    text = text.replace("''", '""')  # the empty string, as it may stand between single quotes
    return [text] if prefix.strip("'") else ["'" + text.replace("'", r"'\''") + "'"]


class CompletionFinder(argcomplete.CompletionFinder):
    """Gives values in YAML to the shell as they are, if nothing else completes the line."""

    def quote_completions(
        self, completions: list[str], cword_prequote: str, last_wordbreak_pos: int | None
    ) -> list[str]:
        """Return the completions in the form that the shell takes."""
        if len(completions) == 1 and completions[0].startswith("'") and not cword_prequote:
            return completions
        return super().quote_completions(completions, cword_prequote, last_wordbreak_pos)
