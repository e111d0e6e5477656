from setuptools import setup

package_name = 'tf2_tools'

setup(
    name=package_name,
    version='0.36.4',
    packages=['tf2_tools'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='Maintainers of the ROS 2 course',
    maintainer_email='maintainers@ros2-course.example.org',
    description='view_frames: the tree of frames as a picture.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={'console_scripts': ['view_frames = tf2_tools.view_frames:main']},
)
