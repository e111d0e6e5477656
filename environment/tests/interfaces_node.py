"""A program whose node uses every interface that it is told on its standard input, until that is closed.

Run as `python -m environment.tests.interfaces_node`; the input's first line is a JSON list such as
`["std_msgs/msg/String"]`. It says `ready` when all endpoints are there.
"""

import json
import sys
import threading
from importlib import import_module

NODE = 'interfaces'


def topic_of(interface: str) -> str:
    """The topic, service or action on which the node uses the interface `package/kind/Name`."""
    return '/' + interface.lower().replace('/', '_')


def load(interface: str) -> type:
    """The Python class of the interface `package/kind/Name`."""
    package, kind, name = interface.split('/')
    return getattr(import_module(f'{package}.{kind}'), name)


def main() -> None:
    import rclpy
    from rclpy.action import ActionServer
    from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor

    wanted = json.loads(sys.stdin.readline())
    rclpy.init()
    node = rclpy.create_node(NODE)
    servers = []
    for name in wanted:
        kind, topic, interface = name.split('/')[1], topic_of(name), load(name)
        if kind == 'msg':
            servers.append(node.create_publisher(interface, topic, 1))
        elif kind == 'srv':
            servers.append(node.create_service(interface, topic, lambda request, response: response))
        else:
            # No goal is ever sent.
            servers.append(ActionServer(node, interface, topic, lambda goal: None))
    executor = SingleThreadedExecutor()
    executor.add_node(node)

    def end_with_input():
        sys.stdin.read()
        rclpy.try_shutdown()

    watcher = threading.Thread(target=end_with_input)
    watcher.start()
    print('ready', flush=True)
    try:
        executor.spin()
    except ExternalShutdownException:
        pass
    watcher.join()


if __name__ == '__main__':
    main()
