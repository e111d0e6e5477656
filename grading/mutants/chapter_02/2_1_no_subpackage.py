# expect: The folder greeter/power is not installed
# rejected by: test_battery
# Exercise 2.1: entry points
GREETER_SETUP = '''
from setuptools import find_packages, setup

setup(
    name='greeter',
    version='0.1.0',
    packages=['greeter'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/greeter']),
        ('share/greeter', ['package.xml']),
    ],
    entry_points={
        'console_scripts': [
            'hello = greeter.hello:main',
            'goodbye = greeter.farewell:main',
            'battery = greeter.power.battery:report',
        ],
    },
)
'''
