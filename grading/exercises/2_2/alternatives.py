from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('depend_and_names', edits=(('from setuptools import setup', '''
            from setuptools import setup

            name = 'line_follower'
            '''),
            ("/line_follower',", "/' + name,"),
            ('<exec_depend>geometry_msgs</exec_depend>', '<depend>geometry_msgs</depend>'))),
    Alternative('find_packages_and_glob', edits=(('from setuptools import setup', '''
            from glob import glob

            from setuptools import find_packages, setup
            '''),
            ("packages=['line_follower', 'line_follower.filters'],", 'packages=find_packages(),'),
            ("['config/gains.yaml']", "glob('config/*.yaml')"))),
    Alternative('in_quotes', edits=(
        ('%%answer FOLLOWER_SETUP ros2_ws/src/line_follower/setup.py', "FOLLOWER_SETUP = '''"),
        ('%%answer FOLLOWER_CFG ros2_ws/src/line_follower/setup.cfg', "'''\nFOLLOWER_CFG = '''\n"),
        ('%%answer FOLLOWER_XML ros2_ws/src/line_follower/package.xml', "'''\nFOLLOWER_XML = '''\n"),
        ('</package>', "</package>'''"))),
    Alternative('as_ros2_pkg_create_writes_it', old="entry_points={'console_scripts': ['follow = line_follower.follow:main']},", new='''
        install_requires=['setuptools', 'PyYAML>=5'], zip_safe=True, tests_require=['pytest'],
        maintainer='You', maintainer_email='you@example.com', license='Apache-2.0', description='It steers.',
        entry_points={'console_scripts': ['follow = line_follower.follow:main']},
        '''),
    Alternative('namespace_packages', edits=(
        ('from setuptools import setup', 'from setuptools import find_namespace_packages, setup'),
        ("packages=['line_follower', 'line_follower.filters'],", "packages=find_namespace_packages(include=['line_follower*']),"),
        ("entry_points={'console_scripts': ['follow = line_follower.follow:main']},",
         "entry_points='[console_scripts]\\nfollow=line_follower.follow:main',"))),
]
