"""Tells pytest of the marker that tests of this linter carry."""


def pytest_configure(config):
    """Register the marker."""
    config.addinivalue_line('markers', 'copyright: a test that runs ament_copyright')
