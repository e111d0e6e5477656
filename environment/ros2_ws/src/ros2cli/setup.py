from setuptools import find_packages, setup

package_name = 'ros2cli'

setup(
    name=package_name,
    version='0.32.0',
    packages=find_packages(),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        ('share/ros2cli/environment', ['completion/ros2-argcomplete.bash', 'completion/ros2-argcomplete.zsh']),
    ],
    install_requires=['setuptools'],
    zip_safe=False,
    maintainer='ROS 2 course maintainers',
    maintainer_email='maintainers@ros2-course.example.org',
    description='The ros2 command: finds its commands as plug-ins, and gives them a node that has seen the graph.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={
        'console_scripts': ['ros2 = ros2cli.cli:main'],
        'ros2cli.command': [
            'component = ros2cli.command.component:ComponentCommand',
            'daemon = ros2cli.command.daemon:DaemonCommand',
            'extension_points = ros2cli.command.extensions:ExtensionPointsCommand',
            'extensions = ros2cli.command.extensions:ExtensionsCommand',
            'multicast = ros2cli.command.multicast:MulticastCommand',
        ],
        'ros2cli.daemon.verb': [
            'start = ros2cli.command.daemon:StartVerb',
            'status = ros2cli.command.daemon:StatusVerb',
            'stop = ros2cli.command.daemon:StopVerb',
        ],
        'ros2component.verb': [
            'list = ros2cli.command.component:ListVerb',
            'load = ros2cli.command.component:LoadVerb',
            'standalone = ros2cli.command.component:StandaloneVerb',
            'types = ros2cli.command.component:TypesVerb',
            'unload = ros2cli.command.component:UnloadVerb',
        ],
        'ros2multicast.verb': [
            'receive = ros2cli.command.multicast:ReceiveVerb',
            'send = ros2cli.command.multicast:SendVerb',
        ],
        'ros2cli.extension_point': [
            'ros2cli.command = ros2cli.command:CommandExtension',
            'ros2cli.daemon.verb = ros2cli.verb:VerbExtension',
        ],
    },
)
