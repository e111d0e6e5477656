from setuptools import find_packages, setup

package_name = 'ros2action'

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
    description='The action command of ros2: list, inspect and send goals to actions.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={
        'ros2cli.command': ['action = ros2action.command.action:ActionCommand'],
        'ros2cli.extension_point': ['ros2action.verb = ros2action.verb:VerbExtension'],
        'ros2action.verb': [
            'info = ros2action.verb.info:InfoVerb',
            'list = ros2action.verb.list:ListVerb',
            'send_goal = ros2action.verb.send_goal:SendGoalVerb',
            'type = ros2action.verb.type:TypeVerb',
        ],
    },
)
