# expect: A callback that spins
# rejected by: test_one_thread[spin]
# Exercise 7.4: a program that stands still
def diagnose_stacks(stacks, files):
    found = []
    for thread in re.split(THREAD, stacks):
        calls = re.findall(FRAME, thread)
        paths = [Path(file) for file, _, _ in calls]
        mine = [i for i, path in enumerate(paths) if path.name in files and path.parent.name != 'rclpy']
        if not mine:
            continue
        own = mine[0]
        newer = {(path.name, call[2]) for path, call in zip(paths[:own], calls) if path.parent.name == 'rclpy'}
        cause = 'server' if ('client.py', 'wait_for_service') in newer else ''
        if 'await_or_execute' in [function for _, _, function in calls[own:]] and not cause:
            spins = 'executors.py' in [name for name, _ in newer]
            cause = 'call' if newer else 'busy'
        file, line, function = calls[own]
        source = files[Path(file).name].splitlines()[int(line) - 1].strip()
        found += [Finding('A7.8' if cause == 'server' else 'A7.9', function, cause, source)] if cause else []
    return found


CLIENT_PY = '''
import sys, rclpy
from std_srvs.srv import Trigger

rclpy.init()
node, patience = rclpy.create_node('client'), float(sys.argv[2])
client = node.create_client(Trigger, sys.argv[1])
if not client.wait_for_service(timeout_sec=patience):
    sys.exit(f'no server for {sys.argv[1]}')
future = client.call_async(Trigger.Request())
rclpy.spin_until_future_complete(node, future, timeout_sec=patience)
if not future.done():
    sys.exit('no answer')
print('answer:', future.result().message)
'''
