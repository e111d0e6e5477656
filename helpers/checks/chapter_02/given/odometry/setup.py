from setuptools import find_packages, setup

setup(
    name='odometry',
    version='0.1.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/odometry']),
        ('share/odometry', ['package.xml']),
    ],
    entry_points={'console_scripts': ['report = odometry.report:main']},
)
