"""The command `ament_xmllint`: are XML files well-formed, and is a package.xml one?"""

import argparse
import os
import shutil
import subprocess
import sys
import time
from xml.etree import ElementTree

from ament_lint_common.report import Case, find_files, write_xunit


def main(argv: list[str] | None = None) -> int:
    """Check the files; return 0 if all are valid, otherwise 1."""
    parser = argparse.ArgumentParser(description='Check that XML files are well-formed.')
    parser.add_argument('paths', nargs='*', default=[os.curdir], help='Files, or directories to look for files in')
    parser.add_argument('--exclude', nargs='*', default=[], help='Names of files and directories to leave out')
    parser.add_argument('--extensions', nargs='*', default=['xml'], help='What the names of the files end with')
    parser.add_argument('--xunit-file', help='Write a JUnit file')
    args = parser.parse_args(argv)

    begin = time.monotonic()
    endings = tuple(f'.{extension}' for extension in args.extensions)
    files = find_files(args.paths, lambda name: name.endswith(endings), args.exclude)
    if not files:
        print('No files found', file=sys.stderr)
        return 1
    cases = []
    for file in files:
        problem = find_problem(file)
        if problem is None:
            print(f"File '{file}' is valid\n")
            cases.append(Case(file))
        else:
            print(f"File '{file}' is invalid:\n{problem}\n", file=sys.stderr)
            cases.append(Case(file, problem.splitlines()[0], problem))
    invalid = sum(case.problem is not None for case in cases)
    if invalid:
        print(f'{invalid} files are invalid', file=sys.stderr)
    else:
        print('No problems found')
    if args.xunit_file:
        write_xunit(args.xunit_file, cases, time.monotonic() - begin)
    return int(invalid > 0)


def find_problem(file: str) -> str | None:
    """
    Return what is wrong with a file, or None.

    With the program xmllint, when it is installed; otherwise with Python's parser. The schema that a file names is not
    fetched from the network; instead a package.xml is read as the build tools read it.
    """
    xmllint = shutil.which('xmllint')
    if xmllint:
        done = subprocess.run([xmllint, '--noout', '--nonet', file], capture_output=True, text=True)
        if done.returncode:
            return done.stderr.strip() or f'xmllint ended with status {done.returncode}'
    else:
        try:
            ElementTree.parse(file)
        except ElementTree.ParseError as error:
            return f'{file}:{error}'
    return _problem_of_manifest(file) if os.path.basename(file) == 'package.xml' else None


def _problem_of_manifest(file: str) -> str | None:
    from catkin_pkg.package import InvalidPackage, parse_package

    try:
        parse_package(file)
    except InvalidPackage as error:
        return str(error).strip()
    return None


if __name__ == '__main__':
    sys.exit(main())
