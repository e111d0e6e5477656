"""Tells pytest of the marker that tests of this linter carry."""


def pytest_configure(config):
    """Register the marker."""
    config.addinivalue_line('markers', 'lint_cmake: a test that runs ament_lint_cmake')
