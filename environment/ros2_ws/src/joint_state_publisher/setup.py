from setuptools import setup

package_name = 'joint_state_publisher'

setup(
    name=package_name,
    version='2.4.0',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='Maintainers of the ROS 2 course',
    maintainer_email='maintainers@ros2-course.example.org',
    description='Publishes positions for all joints of a robot description.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={'console_scripts': ['joint_state_publisher = joint_state_publisher.node:main']},
)
