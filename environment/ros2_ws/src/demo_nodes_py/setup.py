from setuptools import setup

package_name = 'demo_nodes_py'
programs = {
    'add_two_ints_client': 'services:add_two_ints_client',
    'add_two_ints_client_async': 'services:add_two_ints_client_async',
    'add_two_ints_server': 'services:add_two_ints_server',
    'async_param_client': 'parameter_client:main',
    'introspection': 'services:introspection',
    'listener': 'topics:listener',
    'listener_qos': 'topics:listener_qos',
    'listener_serialized': 'topics:listener_serialized',
    'matched_event_detect': 'matched_events:main',
    'set_parameters_callback': 'parameters:main',
    'talker': 'topics:talker',
    'talker_qos': 'topics:talker_qos',
    'use_logger_service': 'logger_levels:main',
}

setup(
    name=package_name,
    version='0.33.5',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml', 'params.yaml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='Maintainers of the ROS 2 course',
    maintainer_email='maintainers@ros2-course.example.org',
    description='The Python programs that the demos of the official documentation run.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={'console_scripts': [f'{name} = {package_name}.{place}' for name, place in programs.items()]},
)
