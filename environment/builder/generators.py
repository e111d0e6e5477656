"""ROS's code generators, called as functions of one process that share what each of them would do anew.

What they write is what they write in processes of their own: `test_builder` compares.
"""

import sys
from collections.abc import Callable
from pathlib import Path

# rosidl_typesupport_c and rosidl_generator_py take a list of type supports after the file of arguments.
_MODULES = ('rosidl_generator_type_description', 'rosidl_generator_c', 'rosidl_typesupport_introspection_c',
            'rosidl_typesupport_fastrtps_c', 'rosidl_typesupport_c', 'rosidl_generator_py')  # fmt: skip


def find(arguments: list[str]) -> Callable[[], object] | None:
    """What runs `python ARGUMENTS`, if that is one of ROS's generators for C and Python; otherwise None."""
    if not arguments or Path(arguments[0]).name not in _MODULES:
        return None
    script = Path(arguments[0])
    namespace: dict = {}

    def run() -> None:
        code = _code(script)
        argv, sys.argv = sys.argv, list(arguments)
        try:
            namespace.update(__name__='__main__', __file__=str(script))
            exec(code, namespace)
        except SystemExit as end:
            if end.code:
                raise RuntimeError(f'{script.name} ended with {end.code}') from None
        finally:
            sys.argv = argv

    return run


_scripts: dict[Path, object] = {}


def _code(script: Path):
    if script not in _scripts:
        _scripts[script] = compile(script.read_text(), str(script), 'exec')
    return _scripts[script]


def share_work() -> None:
    """Let all generators of this process share the parsed .idl files and the split templates."""
    _share_parsed_files()
    _share_split_templates()


def _share_parsed_files() -> None:
    import rosidl_parser.parser as parser

    parse, known = parser.parse_idl_string, {}

    def parse_once(idl_string, png_file=None):
        if png_file:
            return parse(idl_string, png_file)
        if idl_string not in known:
            known[idl_string] = parse(idl_string)
        return known[idl_string]

    parser.parse_idl_string = parse_once


def _share_split_templates() -> None:
    """EmPy splits a template into tokens each time that it fills it in; the same text has the same tokens."""
    import em

    known: dict[str, list] = {}

    def string(self, string, locals=None, dispatcher=None):
        if string not in known:
            known[string] = _split(em, self, string)
        for token in known[string]:
            self.run(token, locals)

    em.Interpreter.string = string


def _split(em, interpreter, text: str) -> list:
    scanner = em.Scanner(interpreter.config, interpreter.getContext(), interpreter.currents, text)
    tokens = []
    while True:
        try:
            token = scanner.one()
        except em.TransientParseError:
            # As EmPy's own `safe`: the last token may wait for more. A second failure is a mistake in the template.
            scanner.feed(interpreter.config.prefix + '\n')
            token = scanner.one()
        if token is None:
            return tokens
        tokens.append(token)
        scanner.accumulate()
