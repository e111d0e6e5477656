from setuptools import find_packages, setup

package_name = 'ros2run'

setup(
    name=package_name,
    version='0.32.0',
    packages=find_packages(),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=False,
    maintainer='ROS 2 course maintainers',
    maintainer_email='maintainers@ros2-course.example.org',
    description='The run command of ros2: start an executable of a package.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={'ros2cli.command': ['run = ros2run.command.run:RunCommand']},
)
