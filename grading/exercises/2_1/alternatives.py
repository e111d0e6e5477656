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
    Alternative('a_dictionary_of_options', source="""
GREETER_SETUP = '''
from functools import partial
from pathlib import Path

import setuptools

PROGRAMS = {'hello': ('hello', 'main'), 'goodbye': ('farewell', 'main'), 'battery': ('power.battery', 'report')}
options = dict(name='greeter', version='0.1.0')
options |= {'packages': [str(path.parent).replace('/', '.') for path in Path('greeter').rglob('__init__.py')]}
options['install_requires'] = ['setuptools']
share = partial('share/{}'.format)
options['data_files'] = [
    (share('ament_index/resource_index/packages'), ['resource/greeter']),
    (share('greeter'), ['package.xml']),
]
options['entry_points'] = dict(console_scripts=[
    f'{name}=greeter.{module}:{function}' for name, (module, function) in PROGRAMS.items()
])

if __name__ == '__main__':
    setuptools.setup(**options)
'''
"""),
]
