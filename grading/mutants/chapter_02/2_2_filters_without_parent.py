# expect: as line_follower.filters
# rejected by: test_python_packages
# Exercise 2.2: repair a package
FOLLOWER_SETUP = '''
from setuptools import setup

setup(
    name='line_follower', version='0.1.0',
    packages=['line_follower', 'filters'], package_dir={'filters': 'line_follower/filters'},
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/line_follower']),
        ('share/line_follower', ['package.xml']),
        ('share/line_follower/config', ['config/gains.yaml']),
    ],
    entry_points={'console_scripts': ['follow = line_follower.follow:main']},
)
'''
FOLLOWER_CFG = '''
[develop]
script_dir=$base/lib/line_follower
[install]
install_scripts=$base/lib/line_follower
'''
FOLLOWER_XML = '''<package format="3">
  <name>line_follower</name> <version>0.1.0</version>
  <description>Steers along a line.</description>
  <maintainer email="you@example.com">You</maintainer> <license>Apache-2.0</license>
  <exec_depend>ament_index_python</exec_depend> <exec_depend>python3-yaml</exec_depend>
  <exec_depend>geometry_msgs</exec_depend>
  <export><build_type>ament_python</build_type></export>
</package>'''
