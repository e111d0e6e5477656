from grading.variants import Alternative

# With the numbers that faults had before they had names.
ALTERNATIVES = [
    Alternative('classes', source=r"""
def state(newer, older):
    for file, function in newer:
        if file.endswith('/rclpy/client.py') and function == 'wait_for_service':
            return 'server'
    if not any(function == 'await_or_execute' for _, function in older):
        return None
    for file, function in newer:
        if file.endswith('/rclpy/client.py') and function == 'call':
            return 'call'
    return 'spin' if any(file.endswith('/rclpy/executors.py') for file, _ in newer) else 'busy'


def diagnose_stacks(stacks, files):
    found = []
    for block in stacks.split('(most recent call first):')[1:]:
        newer, calls = [], re.findall(FRAME, block)
        while calls and ('/rclpy/' in calls[0][0] or Path(calls[0][0]).name not in files):
            newer.append((calls[0][0], calls.pop(0)[2]))
        cause = state(newer, [(file, function) for file, _, function in calls]) if calls else None
        if cause:
            file, number, function = calls[0]
            line = files[Path(file).name].split('\n')[int(number) - 1].strip()
            found.append(Finding({'server': 'A7.8'}.get(cause, 'A7.9'), function, cause, line))
    return found


CLIENT_PY = '''
import sys
import time
import rclpy
from std_srvs.srv import Trigger


def wait(node, condition, patience):
    end = time.monotonic() + patience
    while rclpy.ok() and not condition() and time.monotonic() < end:
        rclpy.spin_once(node, timeout_sec=0.05)
    return condition()


def main(name, patience):
    rclpy.init()
    node = rclpy.create_node('client')
    client = node.create_client(Trigger, name)
    if not wait(node, client.service_is_ready, patience):
        print(f'no server for {name}')
        return 1
    future = client.call_async(Trigger.Request())
    done = wait(node, future.done, patience)
    print(f'answer: {future.result().message}' if done else 'no answer')
    return 0 if done else 1


if __name__ == '__main__':
    sys.exit(main(sys.argv[1], float(sys.argv[2])))
'''
"""),
]
