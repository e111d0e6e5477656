from setuptools import setup

package_name = 'robot_state_publisher'

setup(
    name=package_name,
    version='3.3.3',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='Maintainers of the ROS 2 course',
    maintainer_email='maintainers@ros2-course.example.org',
    description='From a robot description and the positions of its joints to the transforms of its links.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={'console_scripts': ['robot_state_publisher = robot_state_publisher.node:main']},
)
