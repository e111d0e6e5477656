from glob import glob

from setuptools import setup

package_name = 'urdf_launch'

setup(
    name=package_name,
    version='0.1.1',
    packages=[],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        (f'share/{package_name}/launch', glob('launch/*.launch.py')),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='Maintainers of the ROS 2 course',
    maintainer_email='maintainers@ros2-course.example.org',
    description='Launch files that publish a robot description, and show it.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
)
