from setuptools import find_packages, setup

setup(
    name='wheel_math',
    version='0.1.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/wheel_math']),
        ('share/wheel_math', ['package.xml']),
    ],
)
