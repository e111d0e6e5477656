from setuptools import find_packages, setup

package_name = 'ros2interface'

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
    description='The interface command of ros2: show message, service and action definitions.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={
        'ros2cli.command': ['interface = ros2interface.command.interface:InterfaceCommand'],
        'ros2cli.extension_point': ['ros2interface.verb = ros2interface.verb:VerbExtension'],
        'ros2interface.verb': [
            'list = ros2interface.verb.list:ListVerb',
            'package = ros2interface.verb.package:PackageVerb',
            'packages = ros2interface.verb.packages:PackagesVerb',
            'proto = ros2interface.verb.proto:ProtoVerb',
            'show = ros2interface.verb.show:ShowVerb',
        ],
    },
)
