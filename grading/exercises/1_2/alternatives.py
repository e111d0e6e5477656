from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('one_function_each', source='''
from pathlib import PurePosixPath


def folders(path):
    return [PurePosixPath(folder) for folder in path.split(':') if folder]


def prefix_fault(environ, python):
    path = environ.get('AMENT_PREFIX_PATH')
    if not path:
        return 'not sourced'
    found = [folder.parts[3] for folder in folders(path) if folder.parts[:3] == ('/', 'opt', 'ros')]
    named = [environ['ROS_DISTRO']] if found and environ.get('ROS_DISTRO') else []
    return 'mixed' if len({*found, *named}) > 1 else None


def python_fault(environ, python):
    for folder in folders(environ.get('PYTHONPATH', '')):
        for part in folder.parts:
            if part.startswith('python') and '.' in part and part[6:] != python:
                return 'other Python'
    return None


def domain_fault(environ, python):
    text = environ.get('ROS_DOMAIN_ID', '')
    return None if text in {'', *map(str, range(102))} else 'not a domain'


def range_fault(environ, python):
    known = {'': None, 'SUBNET': None, 'LOCALHOST': None, 'SYSTEM_DEFAULT': None, 'OFF': 'off'}
    return known.get(environ.get('ROS_AUTOMATIC_DISCOVERY_RANGE', ''), 'unknown')


def diagnose(environ, python='3.12'):
    judges = {'AMENT_PREFIX_PATH': prefix_fault, 'PYTHONPATH': python_fault, 'ROS_DOMAIN_ID': domain_fault,
              'ROS_AUTOMATIC_DISCOVERY_RANGE': range_fault}
    found = {name: judge(environ, python) for name, judge in judges.items()}
    return {name: fault for name, fault in found.items() if fault}
'''),
    Alternative('regex', source=r'''
import re


def diagnose(environ, python='3.12'):
    faults = {}

    def value(name):
        return environ.get(name) or ''

    prefix, domain = value('AMENT_PREFIX_PATH'), value('ROS_DOMAIN_ID')
    distros = set(re.findall(r'(?:^|:)/opt/ros/([^/:]+)', prefix))
    if prefix == '':
        faults['AMENT_PREFIX_PATH'] = 'not sourced'
    elif len(distros) > 1 or distros and value('ROS_DISTRO') and distros != {value('ROS_DISTRO')}:
        faults['AMENT_PREFIX_PATH'] = 'mixed'
    if set(re.findall(r'/python(\d+\.\d+)(?=[/:]|$)', value('PYTHONPATH'))) - {python}:
        faults['PYTHONPATH'] = 'other Python'
    if domain and not re.fullmatch(r'\d{1,2}|100|101', domain):
        faults['ROS_DOMAIN_ID'] = 'not a domain'
    match value('ROS_AUTOMATIC_DISCOVERY_RANGE'):
        case '' | 'SUBNET' | 'LOCALHOST' | 'SYSTEM_DEFAULT':
            pass
        case 'OFF':
            faults['ROS_AUTOMATIC_DISCOVERY_RANGE'] = 'off'
        case _:
            faults['ROS_AUTOMATIC_DISCOVERY_RANGE'] = 'unknown'
    return faults
'''),
    Alternative('comprehension', source='''
from collections import ChainMap
from functools import partial


def of_distribution(folder):
    match folder.split('/'):
        case ['', 'opt', 'ros', name, *_]:
            return {name}
    return set()


def other_python(python, folder):
    parts = (part.removeprefix('python') for part in folder.split('/') if part.startswith('python'))
    return any('.' in version and version != python for version in parts)


def judgements(settings, python):
    path, reach = settings['AMENT_PREFIX_PATH'], settings['ROS_AUTOMATIC_DISCOVERY_RANGE']
    named = set().union(*map(of_distribution, path.split(':')))
    yield 'AMENT_PREFIX_PATH', 'not sourced', not path
    yield 'AMENT_PREFIX_PATH', 'mixed', len(named | ({settings['ROS_DISTRO']} - {''} if named else set())) > 1
    yield 'PYTHONPATH', 'other Python', any(map(partial(other_python, python), settings['PYTHONPATH'].split(':')))
    domain = settings['ROS_DOMAIN_ID']
    try:
        yield 'ROS_DOMAIN_ID', 'not a domain', bool(domain) and int(domain) not in range(102)
    except ValueError:
        yield 'ROS_DOMAIN_ID', 'not a domain', True
    yield 'ROS_AUTOMATIC_DISCOVERY_RANGE', 'off', reach == 'OFF'
    known = ('', 'OFF', 'SUBNET', 'LOCALHOST', 'SYSTEM_DEFAULT')
    yield 'ROS_AUTOMATIC_DISCOVERY_RANGE', 'unknown', reach not in known


def diagnose(environ, python='3.12'):
    names = ('AMENT_PREFIX_PATH', 'PYTHONPATH', 'ROS_DISTRO', 'ROS_DOMAIN_ID', 'ROS_AUTOMATIC_DISCOVERY_RANGE')
    settings = ChainMap(environ, dict.fromkeys(names, ''))
    return {name: fault for name, fault, wrong in judgements(settings, python) if wrong}
'''),
]
