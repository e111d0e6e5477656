"""The command `ament_lint_cmake`: the style of CMake files, by cmakelint."""

import argparse
import os
import sys
import time
from types import SimpleNamespace

from ament_lint_common.report import Case, find_files, write_xunit

LINE_LENGTH = 140


def main(argv: list[str] | None = None) -> int:
    """Check the files; return 0 if nothing was found, otherwise 1."""
    parser = argparse.ArgumentParser(description='Check the style of CMake files.')
    parser.add_argument('paths', nargs='*', default=[os.curdir], help='Files, or directories to look for files in')
    parser.add_argument('--filters', default='', help='Checks of cmakelint to leave out, such as -whitespace/eol')
    parser.add_argument('--linelength', metavar='N', type=int, default=LINE_LENGTH, help='The longest line allowed')
    parser.add_argument('--xunit-file', help='Write a JUnit file')
    args = parser.parse_args(argv)

    begin = time.monotonic()
    files = find_files(args.paths, is_cmake_file)
    if not files:
        print('No files found', file=sys.stderr)
        return 1
    cases = []
    for file in files:
        found = lint(file, args.filters, args.linelength)
        for line, category, message in found:
            print(f'{file}:{line}: {message} [{category}]', file=sys.stderr)
        if found:
            print('')
        cases += [Case(f'{category} ({file}:{line})', message) for line, category, message in found] or [Case(file)]
    errors = sum(case.problem is not None for case in cases)
    print(f'\n{errors} errors' if errors else '\nNo problems found')
    if args.xunit_file:
        write_xunit(args.xunit_file, cases, time.monotonic() - begin)
    return int(errors > 0)


def is_cmake_file(name: str) -> bool:
    """Return whether a file of this name is CMake code."""
    return name.lower() == 'cmakelists.txt' or name.lower().endswith(('.cmake', '.cmake.in'))


def lint(file: str, filters: str = '', line_length: int = LINE_LENGTH) -> list[tuple[int, str, str]]:
    """Return what cmakelint finds in a file: the number of the line, the category, the message."""
    from cmakelint import main as cmakelint

    found: list[tuple[int, str, str]] = []
    # cmakelint keeps its settings in the module, and prints what it finds.
    saved = SimpleNamespace(error=cmakelint.Error, valid=cmakelint.IsValidFile, state=cmakelint._lint_state)
    state = cmakelint._lint_state = cmakelint._CMakeLintState()
    state.SetFilters(filters)
    state.SetLineLength(str(line_length))

    def note(name: str, line: int, category: str, message: str) -> None:
        if cmakelint.ShouldPrintError(category):
            found.append((line, category, message))

    try:
        cmakelint.Error, cmakelint.IsValidFile = note, lambda name: True
        cmakelint.ProcessFile(file)
    finally:
        cmakelint.Error, cmakelint.IsValidFile, cmakelint._lint_state = saved.error, saved.valid, saved.state
    return found


if __name__ == '__main__':
    sys.exit(main())
