from setuptools import find_packages, setup

package_name = 'ros2doctor'

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
    description='The doctor command of ros2 (also wtf): check the set-up and report what is there.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={
        'ros2cli.command': [
            'doctor = ros2doctor.command.doctor:DoctorCommand',
            'wtf = ros2doctor.command.doctor:WtfCommand',
        ],
        'ros2doctor.checks': [
            'NetworkCheck = ros2doctor.api.network:NetworkCheck',
            'PackageCheck = ros2doctor.api.package:PackageCheck',
            'PlatformCheck = ros2doctor.api.platform:PlatformCheck',
            'QoSCompatibilityCheck = ros2doctor.api.qos_compatibility:QoSCompatibilityCheck',
            'TopicCheck = ros2doctor.api.topic:TopicCheck',
        ],
        'ros2doctor.report': [
            'NetworkReport = ros2doctor.api.network:NetworkReport',
            'PackageReport = ros2doctor.api.package:PackageReport',
            'PlatformReport = ros2doctor.api.platform:PlatformReport',
            'QoSCompatibilityReport = ros2doctor.api.qos_compatibility:QoSCompatibilityReport',
            'RMWReport = ros2doctor.api.rmw:RMWReport',
            'RosdistroReport = ros2doctor.api.platform:RosdistroReport',
            'TopicReport = ros2doctor.api.topic:TopicReport',
        ],
        'ros2cli.extension_point': ['ros2doctor.verb = ros2doctor.verb:VerbExtension'],
        'ros2doctor.verb': ['hello = ros2doctor.verb.hello:HelloVerb'],
    },
)
