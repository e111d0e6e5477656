from setuptools import find_packages, setup

package_name = 'ros2param'

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
    description='The param command of ros2: read, write, save and load the parameters of nodes.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={
        'ros2cli.command': ['param = ros2param.command.param:ParamCommand'],
        'ros2cli.extension_point': ['ros2param.verb = ros2param.verb:VerbExtension'],
        'ros2param.verb': [
            'delete = ros2param.verb.delete:DeleteVerb',
            'describe = ros2param.verb.describe:DescribeVerb',
            'dump = ros2param.verb.dump:DumpVerb',
            'get = ros2param.verb.get:GetVerb',
            'list = ros2param.verb.list:ListVerb',
            'load = ros2param.verb.load:LoadVerb',
            'set = ros2param.verb.set:SetVerb',
        ],
    },
)
