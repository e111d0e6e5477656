# Exercise 1.2: read an environment
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
