from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('entry_points_as_text', source="""
GREETER_SETUP = \"""
from setuptools import find_packages, setup

setup(
    name='greeter',
    version='0.1.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/greeter']),
        ('share/greeter', ['package.xml']),
    ],
    entry_points='''
        [console_scripts]
        hello=greeter.hello:main
        goodbye=greeter.farewell:main
        battery=greeter.power.battery:report
    ''',
)
\"""
"""),
    Alternative('made_in_a_loop', old='''
        'hello = greeter.hello:main',
        'goodbye = greeter.farewell:main',
        'battery = greeter.power.battery:report',
        ''', new='''
        name + ' = greeter.' + function for name, function in
        {'hello': 'hello:main', 'goodbye': 'farewell:main', 'battery': 'power.battery:report'}.items()
        '''),
]
