from setuptools import find_packages, setup

setup(
    name='launch_testing_ros',
    version='0.26.8',
    packages=find_packages(),
    py_modules=['launch_testing_ros_pytest_entrypoint'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/launch_testing_ros']),
        ('share/launch_testing_ros', ['package.xml']),
    ],
    install_requires=['setuptools'],
    extras_require={'test': ['pytest']},
    zip_safe=True,
    maintainer='ROS 2 course maintainers',
    maintainer_email='maintainers@ros2-course.example.org',
    description='What tests of launched ROS nodes need beside launch_testing.',
    license='Apache-2.0',
    entry_points={'pytest11': ['launch_testing_ros = launch_testing_ros_pytest_entrypoint']},
)
