from glob import glob

from setuptools import setup

package_name = 'mujoco_world'

setup(
    name=package_name,
    version='0.1.0',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        *((f'share/{package_name}/{folder}', glob(f'{folder}/*.*')) for folder in ('config', 'launch', 'scenes')),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='Maintainers of the ROS 2 course',
    maintainer_email='maintainers@ros2-course.example.org',
    description="A simulated robot in a simulated world: MuJoCo's physics on ROS topics.",
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={'console_scripts': ['world = mujoco_world.node:main']},
)
