from setuptools import find_packages, setup

package_name = 'ros2lifecycle'

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
    description='The lifecycle command of ros2: read and change the state of managed nodes.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={
        'ros2cli.command': ['lifecycle = ros2lifecycle.command.lifecycle:LifecycleCommand'],
        'ros2cli.extension_point': ['ros2lifecycle.verb = ros2lifecycle.verb:VerbExtension'],
        'ros2lifecycle.verb': [
            'get = ros2lifecycle.verb.get:GetVerb',
            'list = ros2lifecycle.verb.list:ListVerb',
            'nodes = ros2lifecycle.verb.nodes:NodesVerb',
            'set = ros2lifecycle.verb.set:SetVerb',
        ],
    },
)
