from setuptools import setup

package_name = 'tf_transformations'

setup(
    name=package_name,
    version='1.1.0',
    packages=['tf_transformations'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='Maintainers of the ROS 2 course',
    maintainer_email='maintainers@ros2-course.example.org',
    description='Quaternions, Euler angles and matrices: the functions of tf.transformations, x y z w.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
)
