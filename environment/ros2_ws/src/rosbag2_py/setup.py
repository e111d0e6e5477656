from setuptools import find_packages, setup

package_name = 'rosbag2_py'

setup(
    name=package_name,
    version='0.26.7',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=False,
    maintainer='ROS 2 course maintainers',
    maintainer_email='maintainers@ros2-course.example.org',
    description='Reads, writes, records and plays bags of messages.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
)
