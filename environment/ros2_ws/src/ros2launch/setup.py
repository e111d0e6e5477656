from setuptools import find_packages, setup

setup(
    name='ros2launch',
    version='0.26.8',
    packages=find_packages(),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/ros2launch']),
        ('share/ros2launch', ['package.xml']),
    ],
    install_requires=['setuptools'],
    extras_require={'test': ['pytest']},
    zip_safe=True,
    maintainer='ROS 2 course maintainers',
    maintainer_email='maintainers@ros2-course.example.org',
    description='The launch command of ros2.',
    license='Apache-2.0',
    entry_points={'ros2cli.command': ['launch = ros2launch.command.launch:LaunchCommand']},
)
