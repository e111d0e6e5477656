from glob import glob

from setuptools import setup

package_name = 'demo_nodes_cpp'
programs = {
    'add_two_ints_client': 'services:add_two_ints_client',
    'add_two_ints_client_async': 'services:add_two_ints_client',
    'add_two_ints_server': 'services:add_two_ints_server',
    'introspection_client': 'services:introspection_client',
    'introspection_service': 'services:introspection_service',
    'listener': 'topics:listener',
    'listener_best_effort': 'topics:listener_best_effort',
    'one_off_timer': 'timers:one_off_timer',
    'parameter_blackboard': 'parameter_blackboard:main',
    'reuse_timer': 'timers:reuse_timer',
    'talker': 'topics:talker',
}

setup(
    name=package_name,
    version='0.33.5',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        *((f'share/{package_name}/{folder}', glob(f'{folder}/*_launch.*')) for folder in glob('launch/*')),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='Maintainers of the ROS 2 course',
    maintainer_email='maintainers@ros2-course.example.org',
    description='In Python: programs of demo_nodes_cpp that the official tutorials run.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={'console_scripts': [f'{name} = {package_name}.{place}' for name, place in programs.items()]},
)
