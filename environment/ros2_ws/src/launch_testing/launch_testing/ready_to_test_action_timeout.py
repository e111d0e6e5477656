"""How long the system may take until it is ready."""

from collections.abc import Callable


def ready_to_test_action_timeout(timeout: float) -> Callable[[Callable], Callable]:
    """Let the tests wait so many seconds for ReadyToTest, instead of 15."""

    def decorate(test_description: Callable) -> Callable:
        test_description.__ready_to_test_action_timeout__ = timeout
        return test_description

    return decorate
