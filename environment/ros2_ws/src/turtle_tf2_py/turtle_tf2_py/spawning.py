"""A turtle that a node asks turtlesim for, without waiting in a callback."""

from rclpy.node import Node
from rclpy.task import Future
from turtlesim.srv import Spawn


class SpawnedTurtle:
    """Asks for a turtle at (4, 2) that looks along x, one step with each call of `is_there`."""

    def __init__(self, node: Node, name: str):
        self._node, self._name = node, name
        self._client = node.create_client(Spawn, 'spawn')
        self._answer: Future | None = None
        self._told = False

    def is_there(self) -> bool:
        """Go on with asking; true from the call after the one that has told of the answer."""
        logger = self._node.get_logger()
        if self._told:
            return True
        if self._answer is None:
            if self._client.service_is_ready():
                self._answer = self._client.call_async(Spawn.Request(name=self._name, x=4.0, y=2.0, theta=0.0))
            else:
                logger.info('Service is not ready')
        elif not self._answer.done():
            logger.info('Spawn is not finished')
        else:
            logger.info(f'Successfully spawned {self._answer.result().name}')
            self._told = True
        return False
