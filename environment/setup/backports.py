"""Patches of installed packages: corrections that the ROS wheels lack, upstream's and ours, and of the test tools.

Each patch of a module is a module that is put beside the packages, and a few lines that put it to use. Elsewhere one
text takes the place of another.
"""

from pathlib import Path

from environment.setup import action_client, context_end, missing_linters, python_tests, signal_end, xacro_errors
from environment.setup.relocation import replace

# For each patched module its patch, what marks a version that needs none, and the lines at its end.
_PATCHES = {
    'rclpy/action/client.py': (
        action_client,
        'Lock()',
        '\n\nfrom {name} import patch  # noqa: E402 - ros2/rclpy#1123\n\npatch(ActionClient)\n',
    ),
    'rclpy/context.py': (
        context_end,
        None,
        '\n\nfrom {name} import patch  # noqa: E402 - ros2/rclpy#1352\n\npatch(Context)\n',
    ),
    'rclpy/signals.py': (
        signal_end,
        None,
        '\n\nfrom {name} import patch  # noqa: E402 - else a signal may be heard, and the shutdown after it not\n\n'
        'patch(SignalHandlerGuardCondition)\n',
    ),
    'xacro/__init__.py': (
        xacro_errors,
        'import xml.parsers.expat',
        '\n\nfrom {name} import expat  # noqa: E402, F401 - else a file that is not there ends in an AttributeError\n',
    ),
    **{
        f'ament_{program}/main.py': (
            missing_linters,
            None,
            f'\n\nfrom {{name}} import skip_without  # noqa: E402\n\nmain = skip_without({program!r}, main)\n',
        )
        for program in ('cppcheck', 'uncrustify')
    },
}
# For each patched CMake file, below the prefix, the text that is replaced, and the new one.
_CMAKE = {
    # CMake's STRINGS ends at the first letter that is not ASCII, unless it is told the encoding: no interface package
    # could be built in a folder such as /home/jörg or ~/机器人.
    'share/rosidl_adapter/cmake/rosidl_adapt_interfaces.cmake': (
        'file(STRINGS "${idl_output}" idl_tuples)',
        'file(STRINGS "${idl_output}" idl_tuples ENCODING UTF-8)',
    )
}
# The same for Python modules, below site-packages.
_MODULES = {
    # What makes Python code of interfaces needs a parser. Each node imports this package for its message types, and
    # waited an eighth of its start for the parser.
    'rosidl_generator_py/__init__.py': (
        """\
try:
    from .generate_py_impl import generate_py
    assert generate_py
    __all__.append('generate_py')
except ImportError:
    logger = logging.getLogger('rosidl_generator_py')
    logger.debug(
        'Failed to import modules for generating Python structures:\\n' + traceback.format_exc())
""",
        """\
__all__.append('generate_py')


def __getattr__(name):
    if name != 'generate_py':
        raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    from .generate_py_impl import generate_py

    return generate_py
""",
    )
}
_TESTS = '_course_python_tests'
# What tells setuptools and colcon of the entry points: the record of an installed distribution.
_DISTRIBUTION = {
    'METADATA': 'Metadata-Version: 2.1\nName: course-python-tests\nVersion: 1\n'
    'Summary: Lets colcon test run the tests of each Python package with pytest.\n',
    'INSTALLER': 'course\n',
    'entry_points.txt': f'[distutils.setup_keywords]\ntests_require = {_TESTS}:accept\n\n'
    f'[colcon_core.python_testing]\npytest_by_default = {_TESTS}:PytestByDefault\n',
}


def text() -> str:
    """All that the patches are made of: when it changes, they are due again."""
    modules = action_client, context_end, missing_linters, python_tests, signal_end, xacro_errors
    files = [__file__, *(module.__file__ for module in modules)]
    return ''.join([*(Path(file).read_text() for file in files), *_DISTRIBUTION.values()])


def apply(prefix: Path, site: Path) -> list[str]:
    """Patch the packages below `prefix`, whose Python modules are in `site` (site-packages).

    Returns the files that were patched. A second call writes the same.
    """
    install_python_tests(site)
    modules = [path for path, patch in _PATCHES.items() if _patch(site, path, *patch)]
    texts = [(prefix, path, *change) for path, change in _CMAKE.items()]
    texts += [(site, path, *change) for path, change in _MODULES.items()]
    return modules + [path for folder, path, old, new in texts if _replace_text(folder / path, old, new)]


def _patch(site: Path, path: str, patch, mark: str | None, tail: str) -> bool:
    module = site / path
    if not module.is_file():
        return False
    name = f'_course_{patch.__name__.rpartition(".")[2]}'
    tail = tail.format(name=name)
    # Without the lines of any earlier version of the patch, whatever it was called.
    old = module.read_text().partition('\n\nfrom _course_')[0]
    if mark and mark in old:
        return False
    (site / f'{name}.py').write_text(Path(patch.__file__).read_text())
    replace(module, (old + tail).encode())
    return True


def _replace_text(file: Path, old: str, new: str) -> bool:
    if not file.is_file() or old not in (text := file.read_text()):
        return False
    replace(file, text.replace(old, new).encode())
    return True


def install_python_tests(site: Path) -> None:
    """Give setuptools the keyword `tests_require` again, and colcon pytest for packages that name no framework."""
    (site / f'{_TESTS}.py').write_text(Path(python_tests.__file__).read_text())
    folder = site / 'course_python_tests-1.dist-info'
    folder.mkdir(exist_ok=True)
    for name, content in _DISTRIBUTION.items():
        (folder / name).write_text(content)
    installed = [f'{_TESTS}.py', *(f'{folder.name}/{name}' for name in (*_DISTRIBUTION, 'RECORD'))]
    (folder / 'RECORD').write_text(''.join(f'{name},,\n' for name in installed))
