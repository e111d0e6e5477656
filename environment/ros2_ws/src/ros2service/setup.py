from setuptools import find_packages, setup

package_name = 'ros2service'

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
    description='The service command of ros2: list, inspect and call services.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={
        'ros2cli.command': ['service = ros2service.command.service:ServiceCommand'],
        'ros2cli.extension_point': ['ros2service.verb = ros2service.verb:VerbExtension'],
        'ros2service.verb': [
            'call = ros2service.verb.call:CallVerb',
            'echo = ros2service.verb.echo:EchoVerb',
            'find = ros2service.verb.find:FindVerb',
            'info = ros2service.verb.info:InfoVerb',
            'list = ros2service.verb.list:ListVerb',
            'type = ros2service.verb.type:TypeVerb',
        ],
    },
)
