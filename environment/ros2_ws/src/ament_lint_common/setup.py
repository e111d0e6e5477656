from glob import glob

from setuptools import find_packages, setup

# One build for what upstream spreads over these packages: a build of each would cost more than all they do.
PACKAGES = [
    'ament_lint_auto',
    'ament_lint_common',
    'ament_copyright',
    'ament_cmake_copyright',
    'ament_xmllint',
    'ament_cmake_xmllint',
    'ament_lint_cmake',
    'ament_cmake_lint_cmake',
]


def data_files():
    """The index entry, the manifest and the CMake files of each package."""
    yield 'share/ament_index/resource_index/packages', [f'resource/{name}' for name in PACKAGES]
    for name in PACKAGES:
        yield f'share/{name}', ['package.xml' if name == 'ament_lint_common' else f'manifests/{name}/package.xml']
        if files := glob(f'cmake/{name}/*.cmake'):
            yield f'share/{name}/cmake', files


setup(
    name='ament_lint_common',
    version='0.17.3',
    packages=find_packages(exclude=['test']),
    package_data={'ament_copyright': ['texts/*.txt']},
    data_files=list(data_files()),
    install_requires=['setuptools'],
    zip_safe=False,
    maintainer='ROS 2 course maintainers',
    maintainer_email='maintainers@ros2-course.example.org',
    description='The linters that ROS packages commonly name, those that PyPI lacks included.',
    license='Apache-2.0',
    extras_require={'test': ['pytest']},
    entry_points={
        'console_scripts': [
            'ament_copyright = ament_copyright.main:main',
            'ament_lint_cmake = ament_lint_cmake.main:main',
            'ament_xmllint = ament_xmllint.main:main',
        ],
        'pytest11': [
            'ament_copyright = ament_copyright.pytest_marker',
            'ament_lint_cmake = ament_lint_cmake.pytest_marker',
            'ament_xmllint = ament_xmllint.pytest_marker',
        ],
    },
)
