# expect: A right folder does not excuse a wrong one
# rejected by: test_python
# Exercise 1.2: read an environment
RANGES = ('SUBNET', 'LOCALHOST', 'OFF', 'SYSTEM_DEFAULT')


def diagnose(environ, python='3.12'):
    faults = {}
    prefixes = environ.get('AMENT_PREFIX_PATH', '')
    parts = [folder.split('/') for folder in prefixes.split(':')]
    distros = {part[3] for part in parts if part[:3] == ['', 'opt', 'ros'] and len(part) > 3}
    if not prefixes:
        faults['AMENT_PREFIX_PATH'] = 'not sourced'
    elif distros and len(distros | {environ.get('ROS_DISTRO') or min(distros)}) > 1:
        faults['AMENT_PREFIX_PATH'] = 'mixed'
    folders = environ.get('PYTHONPATH', '').replace(':', '/').split('/')
    if folders != [''] and 'python3.' in environ.get('PYTHONPATH', '') and f'python{python}' not in folders:
        faults['PYTHONPATH'] = 'other Python'
    domain = environ.get('ROS_DOMAIN_ID', '')
    if domain and not (domain.isdecimal() and int(domain) <= 101):
        faults['ROS_DOMAIN_ID'] = 'not a domain'
    reach = environ.get('ROS_AUTOMATIC_DISCOVERY_RANGE') or 'SUBNET'
    if reach == 'OFF' or reach not in RANGES:
        faults['ROS_AUTOMATIC_DISCOVERY_RANGE'] = 'off' if reach == 'OFF' else 'unknown'
    return faults
