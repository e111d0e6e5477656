from setuptools import find_packages, setup

package_name = 'ros2bag'

setup(
    name=package_name,
    version='0.26.7',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=False,
    maintainer='ROS 2 course maintainers',
    maintainer_email='maintainers@ros2-course.example.org',
    description='The bag command of ros2: record, play, inspect and reindex bags.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={
        'ros2cli.command': ['bag = ros2bag.command.bag:BagCommand'],
        'ros2cli.extension_point': ['ros2bag.verb = ros2bag.verb:VerbExtension'],
        'ros2bag.verb': [
            'burst = ros2bag.verb.burst:BurstVerb',
            'convert = ros2bag.verb.convert:ConvertVerb',
            'info = ros2bag.verb.info:InfoVerb',
            'list = ros2bag.verb.list:ListVerb',
            'play = ros2bag.verb.play:PlayVerb',
            'record = ros2bag.verb.record:RecordVerb',
            'reindex = ros2bag.verb.reindex:ReindexVerb',
        ],
    },
)
