"""The plug-in of pytest. It stands alone, so that a pytest run does not import rclpy for it."""

import launch_testing_pytest_entrypoint


def pytest_configure(config) -> None:
    """Make the second mark of launch tests known."""
    launch_testing_pytest_entrypoint.MARKS.add('rostest')
    config.addinivalue_line(
        'markers', 'rostest: mark a generate_test_description function as a ROS launch test entrypoint'
    )
