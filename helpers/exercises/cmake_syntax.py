"""Whether a CMakeLists.txt is made of commands with their arguments in parentheses; CMake knows what they mean."""

import re

_TOKEN = re.compile(
    r"""(?P<comment>\#\[(?P<c>=*)\[.*?\](?P=c)\]|\#[^\n]*)
    |(?P<text>"(?:\\.|[^"\\])*"|\[(?P<t>=*)\[.*?\](?P=t)\])
    |(?P<open>\()|(?P<close>\))
    |(?P<word>(?:\\.|[^\s()"#\\])+)
    |(?P<quote>["\\])""",
    re.DOTALL | re.VERBOSE,
)
_COMMAND = re.compile(r'[A-Za-z_]\w*')


def mistake(text: str) -> tuple[str, int] | None:
    """What is wrong with the text of a CMakeLists.txt, and in which line (from 1)."""
    command: str | None = None  # a name whose ( has not come yet
    begun: list[int] = []  # lines of the open parentheses
    line, at = 1, 0
    for token in _TOKEN.finditer(text):
        line, at = line + text.count('\n', at, token.start()), token.start()
        said = token[0]
        kind = next(name for name in ('comment', 'text', 'open', 'close', 'word', 'quote') if token[name] is not None)
        if kind == 'quote':
            return 'this `"` has no second one' if said == '"' else 'a `\\` stands at the end', line
        if kind == 'comment':
            continue
        if kind == 'open' and (begun or command):
            begun.append(line)
            command = None
        elif kind == 'close' and begun:
            begun.pop()
        elif kind == 'word' and not begun and not command and _COMMAND.fullmatch(said):
            command = said
        elif not begun:
            return f'here must stand a command with its arguments in parentheses, not `{said}`', line
    if begun:
        return 'this `(` is not closed', begun[0]
    return (f'the command `{command}` needs parentheses: `{command}(…)`', line) if command else None
