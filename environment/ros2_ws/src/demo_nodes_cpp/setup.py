from glob import glob

from setuptools import setup

package_name = 'demo_nodes_cpp'
here, there = package_name, 'demo_nodes_py'
programs = {
    'add_two_ints_client': f'{there}.services:add_two_ints_client_async',  # logs what the C++ client logs
    'add_two_ints_client_async': f'{there}.services:add_two_ints_client_async',
    'add_two_ints_server': f'{there}.services:add_two_ints_server',
    'introspection_client': f'{here}.introspection:client',
    'introspection_service': f'{here}.introspection:service',
    'listener': f'{there}.topics:listener',
    'listener_best_effort': f'{here}.topics:listener_best_effort',
    'one_off_timer': f'{here}.timers:one_off_timer',
    'parameter_blackboard': f'{here}.parameter_blackboard:main',
    'reuse_timer': f'{here}.timers:reuse_timer',
    'talker': f'{here}.topics:talker',
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
    entry_points={'console_scripts': [f'{name} = {place}' for name, place in programs.items()]},
)
