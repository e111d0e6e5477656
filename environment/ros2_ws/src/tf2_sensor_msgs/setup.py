from setuptools import setup

package_name = 'tf2_sensor_msgs'

setup(
    name=package_name,
    version='0.36.4',
    packages=['tf2_sensor_msgs'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='Maintainers of the ROS 2 course',
    maintainer_email='maintainers@ros2-course.example.org',
    description='Transform the messages of sensor_msgs.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
)
