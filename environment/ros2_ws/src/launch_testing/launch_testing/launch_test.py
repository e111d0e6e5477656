"""``launch_test``: runs one launch test."""

from __future__ import annotations

import argparse
import os
import sys
from importlib.util import module_from_spec, spec_from_file_location
from types import ModuleType

from launch_testing.junitxml import unittestResultsToXml
from launch_testing.loader import LoadTestsFromPythonModule, TestRun
from launch_testing.test_runner import LaunchTestRunner


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of ``launch_test``."""
    parser.add_argument('launch_test_file', help='Path to the launch test.')
    parser.add_argument(
        '--package-name',
        action='store',
        default=None,
        help='Name of the package the test is in. Useful to aggregate xUnit reports.',
    )
    parser.add_argument('-v', '--verbose', action='store_true', default=False, help='Run with verbose output')
    parser.add_argument(
        '-s',
        '--show-args',
        '--show-arguments',
        action='store_true',
        default=False,
        help='Show arguments that may be given to the launch test.',
    )
    parser.add_argument(
        'launch_arguments', nargs='*', help="Arguments in '<name>:=<value>' format (for duplicates, last one wins)."
    )
    parser.add_argument(
        '--junit-xml', action='store', dest='xmlpath', default=None, help='Do write xUnit reports to specified path.'
    )


def run(parser: argparse.ArgumentParser, args: argparse.Namespace, test_runner_cls=LaunchTestRunner) -> int:
    """Run the test; return 0 if all cases passed, otherwise 1. A file that does not exist ends the program."""
    if not os.path.isfile(args.launch_test_file):
        parser.error(f"Test file '{args.launch_test_file}' does not exist")
    path = os.path.abspath(args.launch_test_file)
    base = os.path.splitext(os.path.basename(path))[0]
    package = args.package_name or base
    runs = LoadTestsFromPythonModule(_load(package, path), name=f'{package}.{base}.launch_tests')
    runner = test_runner_cls(test_runs=runs, launch_file_arguments=args.launch_arguments, debug=args.verbose)
    runner.validate()
    if args.show_args:
        _print_arguments(runs[0])
        return 0
    results = runner.run()
    if args.xmlpath:
        report = unittestResultsToXml(test_results=results, name=f'{package}.{base}')
        report.write(args.xmlpath, encoding='utf-8', xml_declaration=True)
    return int(not all(result.wasSuccessful() for result in results.values()))


def _load(name: str, path: str) -> ModuleType:
    spec = spec_from_file_location(name, path)
    module = module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


def _print_arguments(test_run: TestRun) -> None:
    arguments = test_run.get_launch_description().get_launch_arguments()
    print("Arguments (pass arguments as '<name>:=<value>'):")
    for argument in arguments:
        print(f"\n    '{argument.name}':\n        {argument.description}")
        if argument.default_value is not None:
            print(f'        (default: {" + ".join(part.describe() for part in argument.default_value)})')
    if not arguments:
        print('\n  No arguments.')


def main() -> None:
    """Run ``launch_test``; an error of the test's file is told in one line."""
    parser = argparse.ArgumentParser(description='Launch integration testing tool.')
    add_arguments(parser)
    args = parser.parse_args()
    try:
        status = run(parser, args)
    except Exception as error:  # of the test's own file
        if args.verbose:
            raise
        parser.error(str(error) or type(error).__name__)
    sys.exit(status)


if __name__ == '__main__':
    main()
