from glob import glob

from setuptools import find_packages, setup

setup(
    name='launch_testing',
    version='3.4.5',
    packages=find_packages(),
    py_modules=['launch_testing_pytest_entrypoint'],
    data_files=[
        # One build for two packages: the other one is a function of CMake.
        (
            'share/ament_index/resource_index/packages',
            ['resource/launch_testing', 'resource/launch_testing_ament_cmake'],
        ),
        ('share/launch_testing', ['package.xml']),
        ('share/launch_testing_ament_cmake', ['manifests/launch_testing_ament_cmake/package.xml']),
        ('lib/launch_testing', sorted(glob('example_processes/*'))),
        ('share/launch_testing_ament_cmake/cmake', ['cmake/launch_testing_ament_cmakeConfig.cmake']),
    ],
    install_requires=['setuptools'],
    extras_require={'test': ['pytest']},
    zip_safe=True,
    maintainer='ROS 2 course maintainers',
    maintainer_email='maintainers@ros2-course.example.org',
    description='Tests of a launched system: unittest cases that run while it runs, and after its end.',
    license='Apache-2.0',
    entry_points={
        'console_scripts': ['launch_test = launch_testing.launch_test:main'],
        'pytest11': ['launch_testing = launch_testing_pytest_entrypoint'],
    },
)
