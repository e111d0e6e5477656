from glob import glob

from setuptools import setup

name = 'delivery_robot'
setup(
    name=name,
    version='0.1.0',
    packages=[name],
    data_files=[
        ('share/ament_index/resource_index/packages', [f'resource/{name}']),
        (f'share/{name}', ['package.xml']),
        (f'share/{name}/launch', glob('launch/*.launch.py')),
        (f'share/{name}/config', glob('config/*.yaml')),
    ],
    extras_require={'test': ['pytest']},
    entry_points={'console_scripts': [f'robot = {name}.main:main']},
)
