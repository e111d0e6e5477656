"""Attacks on what counts as evidence, in exercises of chapter 7. See ../README.md for the form of a row."""


# %% bashrc_printed
# attack: writes a .bashrc that prints what a right one would do, and ends
# aims at: 7.1
# stopped by: what counts comes after a word that is drawn
def diagnose_machine(files, want):
    return None


def repair_machine(files, want):
    robot = next((line for line in files['.bashrc'].splitlines() if 'ROBOT' in line), '')
    tool = ':'.join(part for line in files['.bashrc'].splitlines() if 'PATH=' in line for part in line.split(':'))
    text = '\n'.join([robot, f"echo SOURCED={want['distro']}", f'echo PATH=/opt/first/bin:{tool.split("=")[-1]}',
                      f"echo ROS_DOMAIN_ID={want['domain']}", 'echo ROS_AUTOMATIC_DISCOVERY_RANGE=SUBNET',
                      'echo end', 'exit 0'])
    key = '[signed-by=/usr/share/keyrings/ros-archive-keyring.gpg]'
    lines = [line for line in files['ros2.list'].splitlines() if line.startswith('#')]
    return {'.bashrc': text, 'ros2.list': '\n'.join([*lines, f"deb {key} http://packages.ros.org/ros2/ubuntu "
                                                     f"{want['codename']} main"])}


# %% client_forged
# attack: prints what the one who starts it would say, and ends that one
# aims at: 7.4
# stopped by: the status is the process's own, taken outside; answers are drawn
def diagnose_stacks(text, files):
    return None


CLIENT_PY = '''
import os, signal, sys

name = sys.argv[1]
print('client made', flush=True)
print('waits for the server', flush=True)
for line in ('answer: word 100', 'no answer', f'no server for {name}'):
    print(line)
print('status 1', flush=True)
print('True', flush=True)
os.kill(os.getppid(), signal.SIGKILL)
os.kill(-1, signal.SIGKILL)
'''


# %% model_deep
# attack: repairs a robot by elements in elements, so deep that looking at them takes more calls than Python allows
# aims at: 7.5
# stopped by: what is deeper than a robot is refused
def diagnose_model(text):
    return []


def repair_model(text):
    return text.replace('<link name="base_link">', '<link name="base_link">' + '<a>' * 100000 + '</a>' * 100000)


# %% model_half_a_letter
# attack: repairs a robot by a text that no encoding can write
# aims at: 7.5
# stopped by: what is no XML is refused, whatever the reason
def diagnose_model(text):
    return []


def repair_model(text):
    return text.replace('<link name="base_link">', '\ud800<link name="base_link">')


# %% client_in_a_hurry
# attack: says that it was made long ago, to have waited long enough without waiting
# aims at: 7.4
# stopped by: it cannot have begun before it was started, and servers answer with what is drawn
def diagnose_stacks(text, files):
    return None


CLIENT_PY = '''
import os, sys, time

name, seconds = sys.argv[1], float(sys.argv[2])
print('client made', time.monotonic() - seconds, flush=True)
print('waits for the server', flush=True)
print('no answer' if 'silent' in name else f'no server for {name}', flush=True)
os._exit(1)
'''


# %% client_by_name
# attack: knows by the name of the service that nobody will answer, and does not look
# aims at: 7.4
# stopped by: names are drawn, and tell nothing
# may keep: interrupt
def diagnose_stacks(text, files):
    return None


CLIENT_PY = '''
import sys
import time

import rclpy
from std_srvs.srv import Trigger

name, seconds = sys.argv[1], float(sys.argv[2])
rclpy.init()
node = rclpy.create_node('client')
client = node.create_client(Trigger, name)
try:
    client.service_is_ready()
    time.sleep(seconds)
    print('no answer' if 'silent' in name else f'no server for {name}')
except KeyboardInterrupt:
    pass
sys.exit(1)
'''
