from setuptools import find_packages, setup

setup(
    name='launch_ros',
    version='0.26.8',
    packages=find_packages(),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/launch_ros']),
        ('share/launch_ros', ['package.xml']),
    ],
    install_requires=['setuptools'],
    extras_require={'test': ['pytest']},
    zip_safe=True,
    maintainer='ROS 2 course maintainers',
    maintainer_email='maintainers@ros2-course.example.org',
    description='ROS for launch files.',
    license='Apache-2.0',
    entry_points={'launch.frontend.launch_extension': ['launch_ros = launch_ros']},
)
