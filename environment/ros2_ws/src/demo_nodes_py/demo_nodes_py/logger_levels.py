"""A node whose logger's level another node sets, by the services that rclpy offers for it."""

import rclpy
from node_program.running import ros
from rcl_interfaces.msg import LoggerLevel
from rcl_interfaces.srv import GetLoggerLevels, SetLoggerLevels
from rclpy.executors import SingleThreadedExecutor
from rclpy.impl.logging_severity import LoggingSeverity
from rclpy.node import Node
from rclpy.task import Future
from std_msgs.msg import String

from .waiting import result_of, wait_for

SERVER = 'LoggerServiceNode'


class LoggerServiceNode(Node):
    """Logs each message at four levels."""

    def __init__(self) -> None:
        """Subscribe, and offer the services for the logger's level."""
        super().__init__(SERVER, enable_logger_service=True)
        self.create_subscription(String, 'output', self._log, 10)
        self.heard = Future()

    def _log(self, message: String) -> None:
        logger = self.get_logger()
        logger.debug(message.data + ' with DEBUG logger level.')
        logger.info(message.data + ' with INFO logger level.')
        logger.warning(message.data + ' with WARN logger level.')
        logger.error(message.data + ' with ERROR logger level.')
        self.heard.set_result(True)


def main(args: list[str] | None = None) -> None:
    """Let the node log with its own level, and with three that it is given."""
    with ros(args):
        server, node = LoggerServiceNode(), rclpy.create_node('TestNode')
        logger = node.get_logger()
        publisher = node.create_publisher(String, 'output', 10)
        getter = node.create_client(GetLoggerLevels, f'{SERVER}/get_logger_levels')
        setter = node.create_client(SetLoggerLevels, f'{SERVER}/set_logger_levels')
        executor = SingleThreadedExecutor()
        executor.add_node(server)
        executor.add_node(node)
        for client in (getter, setter):
            wait_for(client, logger.info)
        while not publisher.get_subscription_count():
            executor.spin_once(timeout_sec=0.1)

        levels = [None, LoggingSeverity.DEBUG, LoggingSeverity.WARN, LoggingSeverity.ERROR]
        for number, level in enumerate(levels, 1):
            logger.info(f'Output with {"default" if level is None else level.name.lower()} logger level:')
            if level is not None:
                asked = SetLoggerLevels.Request(levels=[LoggerLevel(name=SERVER, level=level)])
                done = result_of(setter.call_async(asked), executor).results[0]
                if not done.successful:
                    logger.error(f'Failed to set the level: {done.reason}')
            server.heard = Future()
            publisher.publish(String(data=f'Output {number}'))
            result_of(server.heard, executor)
            answer = result_of(getter.call_async(GetLoggerLevels.Request(names=[SERVER])), executor)
            logger.info(f'Current logger level: {answer.levels[0].level}')
