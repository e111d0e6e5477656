from setuptools import setup

package_name = 'tf2_ros'

setup(
    name=package_name,
    version='0.36.4',
    packages=['tf2_ros_executables'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='Maintainers of the ROS 2 course',
    maintainer_email='maintainers@ros2-course.example.org',
    description='The programs of tf2: static_transform_publisher, tf2_echo, tf2_monitor, buffer_server.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={
        'console_scripts': [
            'buffer_server = tf2_ros_executables.buffer_server:main',
            'static_transform_publisher = tf2_ros_executables.static_transform_publisher:main',
            'tf2_echo = tf2_ros_executables.tf2_echo:main',
            'tf2_monitor = tf2_ros_executables.tf2_monitor:main',
        ]
    },
)
