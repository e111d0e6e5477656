from setuptools import find_packages, setup

package_name = 'ros2node'

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
    description='The node command of ros2: which nodes there are and what they offer.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={
        'ros2cli.command': ['node = ros2node.command.node:NodeCommand'],
        'ros2cli.extension_point': ['ros2node.verb = ros2node.verb:VerbExtension'],
        'ros2node.verb': ['info = ros2node.verb.info:InfoVerb', 'list = ros2node.verb.list:ListVerb'],
    },
)
