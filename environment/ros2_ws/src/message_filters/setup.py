from setuptools import find_packages, setup

package_name = 'message_filters'

setup(
    name=package_name,
    version='4.11.7',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=False,
    maintainer='ROS 2 course maintainers',
    maintainer_email='maintainers@ros2-course.example.org',
    description='Filters for streams of messages: caches, and synchronisers by time stamp.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
)
