from setuptools import setup

package_name = 'sensor_msgs_py'

setup(
    name=package_name,
    version='5.3.6',
    packages=['sensor_msgs_py'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='Maintainers of the ROS 2 course',
    maintainer_email='maintainers@ros2-course.example.org',
    description='Read and make point clouds with numpy.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
)
