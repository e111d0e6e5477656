from setuptools import find_packages, setup

setup(
    name='launch_pytest',
    version='3.4.5',
    packages=find_packages(),
    py_modules=['launch_pytest_entrypoint'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/launch_pytest']),
        ('share/launch_pytest', ['package.xml']),
    ],
    install_requires=['setuptools'],
    extras_require={'test': ['pytest']},
    zip_safe=True,
    maintainer='ROS 2 course maintainers',
    maintainer_email='maintainers@ros2-course.example.org',
    description='Tests of a launched system, as fixtures of pytest.',
    license='Apache-2.0',
    entry_points={'pytest11': ['launch_pytest = launch_pytest_entrypoint']},
)
