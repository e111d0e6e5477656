# expect: A comma is missing
# rejected by: test_only_these_programs
# Exercise 2.1: entry points
GREETER_SETUP = '''
from setuptools import find_packages, setup

setup(
    name='greeter',
    version='0.1.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/greeter']),
        ('share/greeter', ['package.xml']),
    ],
    entry_points={
        'console_scripts': [
            'hello = greeter.hello:main',
            'goodbye = greeter.farewell:main'
            'battery = greeter.power.battery:report',
        ],
    },
)
'''
