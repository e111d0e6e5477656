"""What all processes of a check share."""

import json
import subprocess
import sys

from helpers.runner import start_processes

NODE = """
import json

import psutil
import rclpy

rclpy.init()
node = rclpy.create_node('node')
sockets = psutil.Process().net_connections('udp')
print(json.dumps(sorted({place.laddr.ip for place in sockets})))
"""


def test_a_check_neither_speaks_nor_listens_in_the_network(domain, tmp_path):
    """In a class all machines check at once, and all take the first free domain: it is the same one on many."""
    done = subprocess.run(
        [sys.executable, '-c', NODE],
        env=start_processes.environment(domain, str(tmp_path)),
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 0 and done.stderr == '', done
    assert json.loads(done.stdout) == ['127.0.0.1', '239.255.0.1'], 'Fast DDS sends from all other addresses, too'
