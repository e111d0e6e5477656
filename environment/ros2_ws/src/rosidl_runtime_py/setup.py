from setuptools import find_packages, setup

package_name = 'rosidl_runtime_py'

setup(
    name=package_name,
    version='0.13.1',
    packages=find_packages(),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=False,
    maintainer='ROS 2 course maintainers',
    maintainer_email='maintainers@ros2-course.example.org',
    description='Convert between ROS messages, dictionaries, YAML and CSV, and look interfaces up by name.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
)
