"""The command `ament_copyright`: has each source file a copyright notice and a licence that is known?"""

import argparse
import datetime
import os
import sys
import time
from pathlib import Path

from ament_lint_common.report import Case, find_files, write_xunit

from ament_copyright.licenses import (
    HOLDERS,
    LICENSES,
    UNKNOWN,
    find_copyrights,
    find_license,
    leading_comment,
    with_notice,
)
from ament_copyright.notices import add_missing, add_years

EXTENSIONS = ('.c', '.cc', '.cpp', '.cxx', '.h', '.hh', '.hpp', '.hxx', '.cmake', '.py')
OF_REPOSITORY = ('CONTRIBUTING.md', 'LICENSE')  # a repository has to have these


def main(argv: list[str] | None = None) -> int:
    """Check or change the files; return 1 if one of them has no notice or no known licence, otherwise 0."""
    parser = _parser()
    args = parser.parse_args(argv)
    if args.list_copyright_names:
        print('\n'.join(f'{key}: {HOLDERS[key]}' for key in sorted(HOLDERS)))
        return 0
    if args.list_licenses:
        print('\n'.join(f'{key}: {LICENSES[key].name}' for key in sorted(LICENSES)))
        return 0

    begin = time.monotonic()
    files = source_files(args.paths, args.excludes)
    if not files:
        print('No repository roots and files found', file=sys.stderr)
        return 0
    files.sort()
    if args.add_missing:
        _add_missing(parser, files, *args.add_missing, verbose=args.verbose)
        return 0
    if args.add_copyright_year is not None:
        add_years(files, args.add_copyright_year or [datetime.date.today().year], args.verbose)
        return 0
    return _check(files, args, begin)


def _add_missing(
    parser: argparse.ArgumentParser, files: list[str], holder: str, identifier: str, *, verbose: bool
) -> None:
    if identifier not in LICENSES:
        parser.error("'LICENSE' must be the short name of a licence; '--list-licenses' lists them")
    license_ = LICENSES[identifier]
    holder = HOLDERS.get(holder, holder)
    texts = (license_.contributing_files[0], with_notice(license_.license_files[0], holder))
    add_missing(files, holder, license_, dict(zip(OF_REPOSITORY, texts, strict=True)), verbose)


def _check(files: list[str], args: argparse.Namespace, begin: float) -> int:
    cases = []
    for file in files:
        wrong, finding = examine(file)
        if wrong or args.verbose:
            print(f'{file}: {finding}', file=sys.stderr if wrong else sys.stdout)
        cases.append(Case(file, finding if wrong else None))
    errors = sum(case.problem is not None for case in cases)
    if errors:
        print(f'{errors} errors, checked {len(cases)} files', file=sys.stderr)
    else:
        print(f'No problems found, checked {len(cases)} files')
    if args.xunit_file:
        write_xunit(args.xunit_file, cases, time.monotonic() - begin)
    return int(errors > 0)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(description='Check source files for a copyright notice and a licence.')
    parser.add_argument(
        'paths',
        nargs='*',
        default=[os.curdir],
        help='Files, or directories to look for source files in; a setup.py beside a package.xml is left out',
    )
    parser.add_argument(
        '--exclude', metavar='filename', nargs='*', dest='excludes', default=[], help='Names of files to leave out'
    )
    group = parser.add_mutually_exclusive_group()
    group.add_argument(
        '--add-missing',
        nargs=2,
        metavar=('COPYRIGHT_NAME', 'LICENSE'),
        help='Write the notice of this holder and the header of this licence into each file without one',
    )
    group.add_argument(
        '--add-copyright-year',
        nargs='*',
        type=int,
        metavar='YEAR',
        help='Put these years, or else this year, into the notices that there are',
    )
    group.add_argument('--list-copyright-names', action='store_true', help='List the holders that have a short name')
    group.add_argument('--list-licenses', action='store_true', help='List the licences that are known')
    group.add_argument('--xunit-file', help='Write a JUnit file')
    parser.add_argument('--verbose', action='store_true', help='Show every file, not only those with a problem')
    return parser


def source_files(paths: list[str], excludes: list[str]) -> list[str]:
    """Return the files to check, those that a repository has to have included."""
    files = [
        file
        for file in find_files(paths, lambda name: name.endswith(EXTENSIONS), excludes)
        if not _is_setup_of_package(file)
    ]
    for folder in map(Path, paths):
        if any((folder / name).exists() for name in ('.git', '.hg')):
            files += [os.path.normpath(folder / name) for name in OF_REPOSITORY if name not in excludes]
    return files


def _is_setup_of_package(file: str) -> bool:
    return os.path.basename(file) == 'setup.py' and os.path.exists(os.path.join(os.path.dirname(file), 'package.xml'))


def examine(file: str) -> tuple[bool, str]:
    """Return whether something is wrong with a file, and what was found in it."""
    try:
        text = Path(file).read_text(encoding='utf-8')
    except FileNotFoundError:
        return True, 'file not found'
    of_repository = os.path.basename(file) in OF_REPOSITORY
    if not text:
        return of_repository, 'file empty'
    if of_repository:
        found = find_license(text)
        return found == UNKNOWN, found
    comment = leading_comment(text)
    copyrights = find_copyrights(comment)
    if not copyrights:
        return True, 'could not find copyright notice'
    found = find_license(comment)
    return found == UNKNOWN, f'copyright={", ".join(copyrights)}, license={found}'


if __name__ == '__main__':
    sys.exit(main())
