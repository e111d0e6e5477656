"""The command line ``./course``, run as ``python -m helpers.cli`` by the entry script once the environment is there.

One module per command, found by name when it exists: ``helpers.cli.<name>`` for everybody, ``grading.cli.<name>`` for
the instructor. A command's module

- defines a function of its own name, typer's way: parameters are arguments and options, the docstring is the help;
- may define SETTINGS, keywords for ``app.command`` (``{'context_settings': {...}}``);
- imports what is slow (rclpy, nbformat, pytest …) inside the function, as all modules are imported at each start;
- raises ``helpers.cli.Refusal`` on unusable input and ``typer.Exit(1)`` if something fell short.
"""


class Refusal(Exception):
    """The input or the machine is unusable: one line that says what is wrong and what to do. Ends with status 2."""
