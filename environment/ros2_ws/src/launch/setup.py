from setuptools import find_packages, setup

setup(
    name='launch',
    version='3.4.5',
    packages=find_packages(),
    data_files=[('share/ament_index/resource_index/packages', ['resource/launch']), ('share/launch', ['package.xml'])],
    install_requires=['setuptools'],
    extras_require={'test': ['pytest']},
    zip_safe=True,
    maintainer='ROS 2 course maintainers',
    maintainer_email='maintainers@ros2-course.example.org',
    description='Starts, watches and ends the processes of a robot system.',
    license='Apache-2.0',
)
