from glob import glob

from setuptools import setup

package_name = 'turtle_tf2_py'
programs = (
    'dynamic_frame_tf2_broadcaster',
    'fixed_frame_tf2_broadcaster',
    'static_turtle_tf2_broadcaster',
    'turtle_tf2_broadcaster',
    'turtle_tf2_listener',
    'turtle_tf2_message_broadcaster',
)

setup(
    name=package_name,
    version='0.5.0',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        (f'share/{package_name}/launch', glob('launch/*.launch.py')),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='Maintainers of the ROS 2 course',
    maintainer_email='maintainers@ros2-course.example.org',
    description='One turtle follows another: the programs of the tf2 tutorials.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={'console_scripts': [f'{name} = {package_name}.{name}:main' for name in programs]},
)
