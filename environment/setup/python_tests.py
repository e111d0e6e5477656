"""Lets `colcon test` run every Python package's tests with pytest (runs inside of setuptools and of colcon).

colcon learns from setup.py that a package's tests are pytest's: from `tests_require=['pytest']`, which
`ros2 pkg create` writes and every tutorial has, or from an extra named test. setuptools 72 and later drop
`tests_require` with a warning, and colcon then falls back on unittest, which finds none of pytest's tests and reports
success. Two entry points, which `backports.install_python_tests` writes, correct that for any setuptools:

- `distutils.setup_keywords`: `tests_require` is a keyword of setup() again, so that colcon reads it;
- `colcon_core.python_testing`: a package that says neither, but has files named as pytest's tests are, is tested with
  pytest, too.

setuptools itself needs nothing but this file: what belongs to colcon is imported when colcon asks for it.
"""

from pathlib import Path

FOLDERS = ('test', 'tests')
PATTERNS = ('test_*.py', '*_test.py')  # pytest's own default


def accept(distribution, keyword, value):
    """Take the keyword of setup(): colcon expects a list, setuptools allowed a text with a requirement a line."""
    if isinstance(value, str):
        value = [line.strip() for line in value.splitlines() if line.strip()]
    setattr(distribution, keyword, list(value))


def has_tests(package: Path) -> bool:
    """Whether the package has a file that pytest would take for tests where it looks by itself."""
    beside = any(found for pattern in PATTERNS for found in package.glob(pattern))
    return beside or any(
        found for folder in FOLDERS for pattern in PATTERNS for found in (package / folder).rglob(pattern)
    )


def __getattr__(name):
    """Make colcon's extension when colcon asks for it: pytest, of a lower priority than a package's own choice."""
    if name != 'PytestByDefault':
        raise AttributeError(name)
    from colcon_core.task.python.test.pytest import PytestPythonTestingStep

    class PytestByDefault(PytestPythonTestingStep):
        """Use `pytest` for a package that names no test framework, but has tests."""

        PRIORITY = 150  # colcon's own: 200 for pytest where setup.py names it, 100 for unittest

        def add_arguments(self, *, parser):  # the base class has added them already
            pass

        def match(self, context, env, setup_py_data):
            return has_tests(Path(context.pkg.path))

    return PytestByDefault
