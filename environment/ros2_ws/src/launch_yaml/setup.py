from setuptools import find_packages, setup

setup(
    name='launch_yaml',
    version='3.4.5',
    packages=find_packages(),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/launch_yaml']),
        ('share/launch_yaml', ['package.xml']),
    ],
    install_requires=['setuptools'],
    extras_require={'test': ['pytest']},
    zip_safe=True,
    maintainer='ROS 2 course maintainers',
    maintainer_email='maintainers@ros2-course.example.org',
    description='Launch files in YAML.',
    license='Apache-2.0',
    entry_points={'launch.frontend.parser': ['yaml = launch_yaml:Parser']},
)
