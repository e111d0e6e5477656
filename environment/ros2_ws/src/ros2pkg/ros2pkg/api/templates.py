"""The text of the files that `ros2 pkg create` writes."""

from collections.abc import Iterable
from xml.sax.saxutils import escape, quoteattr


def package_xml(
    *,
    name: str,
    package_format: int,
    description: str,
    maintainer: str,
    email: str,
    license_name: str,
    build_type: str,
    buildtool_depends: Iterable[str],
    depends: Iterable[str],
    test_depends: Iterable[str],
) -> str:
    """Return package.xml."""
    lines = [
        '<?xml version="1.0"?>',
        f'<?xml-model href="http://download.ros.org/schema/package_format{package_format}.xsd" '
        'schematypens="http://www.w3.org/2001/XMLSchema"?>',
        f'<package format="{package_format}">',
        f'  <name>{name}</name>',
        '  <version>0.0.0</version>',
        f'  <description>{escape(description)}</description>',
        f'  <maintainer email={quoteattr(email)}>{escape(maintainer)}</maintainer>',
        f'  <license>{escape(license_name)}</license>',
        '',
    ]
    for tag, names in (('buildtool_depend', buildtool_depends), ('depend', depends), ('test_depend', test_depends)):
        entries = [f'  <{tag}>{each}</{tag}>' for each in names]
        if entries:
            lines += [*entries, '']
    lines += ['  <export>', f'    <build_type>{build_type}</build_type>', '  </export>', '</package>']
    return _text(lines)


def setup_py(
    *, name: str, maintainer: str, email: str, description: str, license_name: str, node_name: str | None
) -> str:
    """Return setup.py of an ament_python package."""
    scripts = [f"            '{node_name} = {name}.{node_name}:main'"] if node_name else []
    return _text(
        [
            'from setuptools import find_packages, setup',
            '',
            f"package_name = '{name}'",
            '',
            'setup(',
            '    name=package_name,',
            "    version='0.0.0',",
            "    packages=find_packages(exclude=['test']),",
            '    data_files=[',
            "        ('share/ament_index/resource_index/packages',",
            "            ['resource/' + package_name]),",
            "        ('share/' + package_name, ['package.xml']),",
            '    ],',
            "    install_requires=['setuptools'],",
            '    zip_safe=True,',
            f'    maintainer={maintainer!r},',
            f'    maintainer_email={email!r},',
            f'    description={description!r},',
            f'    license={license_name!r},',
            "    tests_require=['pytest'],",
            '    entry_points={',
            "        'console_scripts': [",
            *scripts,
            '        ],',
            '    },',
            ')',
        ]
    )


def setup_cfg(name: str) -> str:
    """Return setup.cfg of an ament_python package, which puts its executables where `ros2 run` looks."""
    return _text(['[develop]', f'script_dir=$base/lib/{name}', '[install]', f'install_scripts=$base/lib/{name}'])


def python_main(name: str) -> str:
    """Return the module of a new Python node."""
    return _text(['def main():', f"    print('Hi from {name}.')", '', '', "if __name__ == '__main__':", '    main()'])


_HEADER = """# Copyright 2026 ROS 2 course maintainers
#
# Licensed under the Apache License, Version 2.0 (the "License");
# you may not use this file except in compliance with the License.
# You may obtain a copy of the License at
#
#     http://www.apache.org/licenses/LICENSE-2.0
#
# Unless required by applicable law or agreed to in writing, software
# distributed under the License is distributed on an "AS IS" BASIS,
# WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
# See the License for the specific language governing permissions and
# limitations under the License.

"""
TESTS = {
    'test_copyright.py': _HEADER
    + """from ament_copyright.main import main
import pytest


# Remove the `skip` decorator once the source file(s) have a copyright header
@pytest.mark.skip(reason='No copyright header has been placed in the generated source file.')
@pytest.mark.copyright
@pytest.mark.linter
def test_copyright():
    rc = main(argv=['.', 'test'])
    assert rc == 0, 'Found errors'
""",
    'test_flake8.py': _HEADER
    + """from ament_flake8.main import main_with_errors
import pytest


@pytest.mark.flake8
@pytest.mark.linter
def test_flake8():
    rc, errors = main_with_errors(argv=[])
    assert rc == 0, f'Found {len(errors)} code style errors / warnings:\\n' + '\\n'.join(errors)
""",
    'test_pep257.py': _HEADER
    + """from ament_pep257.main import main
import pytest


@pytest.mark.linter
@pytest.mark.pep257
def test_pep257():
    rc = main(argv=['.', 'test'])
    assert rc == 0, 'Found code style errors / warnings'
""",
}


def cmake_lists(*, name: str, depends: list[str], node_name: str | None, library_name: str | None) -> str:
    """Return CMakeLists.txt of an ament_cmake package."""
    lines = [
        'cmake_minimum_required(VERSION 3.8)',
        f'project({name})',
        '',
        'if(CMAKE_COMPILER_IS_GNUCXX OR CMAKE_CXX_COMPILER_ID MATCHES "Clang")',
        '  add_compile_options(-Wall -Wextra -Wpedantic)',
        'endif()',
        '',
        '# find dependencies',
        'find_package(ament_cmake REQUIRED)',
    ]
    if library_name:
        lines.append('find_package(ament_cmake_ros REQUIRED)')
    lines += [f'find_package({each} REQUIRED)' for each in depends] or [
        '# uncomment the following section in order to fill in',
        '# further dependencies manually.',
        '# find_package(<dependency> REQUIRED)',
    ]
    if library_name:
        lines += ['', *_library(name, depends, library_name)]
    if node_name:
        lines += ['', *_executable(node_name, depends, library_name)]
    lines += [
        '',
        'if(BUILD_TESTING)',
        '  find_package(ament_lint_auto REQUIRED)',
        '  # the following line skips the linter which checks for copyrights',
        '  # comment the line when a copyright and license is added to all source files',
        '  set(ament_cmake_copyright_FOUND TRUE)',
        '  # the following line skips cpplint (only works in a git repo)',
        '  # comment the line when this package is in a git repo and when',
        '  # a copyright and license is added to all source files',
        '  set(ament_cmake_cpplint_FOUND TRUE)',
        '  ament_lint_auto_find_test_dependencies()',
        'endif()',
    ]
    if library_name:
        lines += [
            '',
            'ament_export_include_directories(',
            '  "include/${PROJECT_NAME}"',
            ')',
            'ament_export_libraries(',
            f'  {library_name}',
            ')',
            'ament_export_targets(',
            '  export_${PROJECT_NAME}',
            ')',
        ]
    return _text([*lines, '', 'ament_package()'])


def plain_cmake_lists(*, name: str, depends: list[str], node_name: str | None, library_name: str | None) -> str:
    """Return CMakeLists.txt of a package that is built without ament."""
    lines = [
        'cmake_minimum_required(VERSION 3.8)',
        f'project({name})',
        '',
        *(f'set({name}_{part}_VERSION 0)' for part in ('MAJOR', 'MINOR', 'PATCH')),
        f'set({name}_VERSION',
        f'  ${{{name}_MAJOR_VERSION}}.${{{name}_MINOR_VERSION}}.${{{name}_PATCH_VERSION}})',
        '',
        'if(CMAKE_COMPILER_IS_GNUCXX OR CMAKE_CXX_COMPILER_ID MATCHES "Clang")',
        '  add_compile_options(-Wall -Wextra -Wpedantic)',
        'endif()',
        '',
        '# find dependencies',
    ]
    lines += [f'find_package({each} REQUIRED)' for each in depends] or [
        '# uncomment the following section in order to fill in',
        '# further dependencies manually.',
        '# find_package(<dependency> REQUIRED)',
    ]
    targets = [each for each in (library_name, node_name) if each]
    if library_name:
        lines += [
            '',
            f'add_library({library_name} SHARED src/{library_name}.cpp)',
            f'add_library({name}::{library_name} ALIAS {library_name})',
            f'target_compile_features({library_name} PUBLIC c_std_99 cxx_std_17)  # Require C99 and C++17',
            *_plain_include(library_name, depends),
            '',
            '# Causes the visibility macros to use dllexport rather than dllimport,',
            '# which is appropriate when building the dll but not consuming it.',
            f'target_compile_definitions({library_name} PRIVATE "{name.upper()}_BUILDING_LIBRARY")',
            '',
            'install(DIRECTORY include/ DESTINATION include)',
            f'install(TARGETS {library_name}',
            f'  EXPORT export_{name}',
            '  ARCHIVE DESTINATION lib',
            '  LIBRARY DESTINATION lib',
            '  RUNTIME DESTINATION bin)',
        ]
    if node_name:
        lines += [
            '',
            f'add_executable({node_name} src/{node_name}.cpp)',
            f'target_compile_features({node_name} PUBLIC c_std_99 cxx_std_17)  # Require C99 and C++17',
            *_plain_include(node_name, depends),
            *([f'target_link_libraries({node_name} {library_name})'] if library_name else []),
            '',
            f'install(TARGETS {node_name}',
            f'  EXPORT export_{name}',
            '  DESTINATION lib/${PROJECT_NAME})',
        ]
    return _text(lines + (_plain_export(name) if targets else []))


def _plain_include(target: str, depends: list[str]) -> list[str]:
    directories = [f'  ${{{each}_INCLUDE_DIRS}}' for each in depends]
    libraries = [f'target_link_libraries({target}', *(f'  ${{{each}_LIBRARIES}}' for each in depends), ')']
    return [
        f'target_include_directories({target} PUBLIC',
        '  $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>',
        '  $<INSTALL_INTERFACE:include>',
        *directories,
        ')',
        *(libraries if depends else []),
    ]


def _plain_export(name: str) -> list[str]:
    return [
        '',
        '# export targets',
        f'export(EXPORT export_{name}',
        f'  FILE "${{PROJECT_BINARY_DIR}}/export_{name}.cmake")',
        '',
        f'# Create the {name}Config.cmake',
        'set(CONF_INCLUDE_DIRS "${CMAKE_INSTALL_PREFIX}/include")',
        f'configure_file({name}Config.cmake.in',
        f'  "${{PROJECT_BINARY_DIR}}/${{CMAKE_FILES_DIRECTORY}}/{name}Config.cmake" @ONLY)',
        '',
        f'# Create the {name}ConfigVersion.cmake',
        f'configure_file({name}ConfigVersion.cmake.in',
        f'  "${{PROJECT_BINARY_DIR}}/{name}ConfigVersion.cmake" @ONLY)',
        '',
        'install(FILES',
        f'  "${{PROJECT_BINARY_DIR}}/${{CMAKE_FILES_DIRECTORY}}/{name}Config.cmake"',
        f'  "${{PROJECT_BINARY_DIR}}/{name}ConfigVersion.cmake"',
        '  DESTINATION "share/${PROJECT_NAME}/cmake" COMPONENT dev)',
        f'install(EXPORT export_{name}',
        '  DESTINATION "share/${PROJECT_NAME}/cmake"',
        f'  FILE export_{name}.cmake',
        '  COMPONENT dev)',
    ]


def plain_cmake_config(name: str, library_name: str | None) -> str:
    """Return the template of the file that find_package() reads."""
    lines = [
        f'get_filename_component({name}_CMAKE_DIR "${{CMAKE_CURRENT_LIST_FILE}}" PATH)',
        f'set({name}_INCLUDE_DIRS "@CONF_INCLUDE_DIRS@")',
        '',
        f'include("${{{name}_CMAKE_DIR}}/export_{name}.cmake")',
    ]
    return _text(lines + ([f'set({name}_LIBRARIES {library_name})'] if library_name else []))


def plain_cmake_config_version(name: str) -> str:
    """Return the template of the file that says to find_package() whether the version fits."""
    return _text(
        [
            f'set(PACKAGE_VERSION "@{name}_VERSION@")',
            '',
            'if("${PACKAGE_VERSION}" VERSION_LESS "${PACKAGE_FIND_VERSION}")',
            '  set(PACKAGE_VERSION_COMPATIBLE FALSE)',
            'else()',
            '  set(PACKAGE_VERSION_COMPATIBLE TRUE)',
            '  if("${PACKAGE_VERSION}" VERSION_EQUAL "${PACKAGE_FIND_VERSION}")',
            '    set(PACKAGE_VERSION_EXACT TRUE)',
            '  endif()',
            'endif()',
        ]
    )


def _target_depends(target: str, depends: list[str]) -> list[str]:
    if not depends:
        return []
    return ['ament_target_dependencies(', f'  {target}', *(f'  "{each}"' for each in depends), ')']


def _include_directories(target: str) -> list[str]:
    return [
        f'target_include_directories({target} PUBLIC',
        '  $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>',
        '  $<INSTALL_INTERFACE:include/${PROJECT_NAME}>)',
    ]


def _library(name: str, depends: list[str], library_name: str) -> list[str]:
    return [
        f'add_library({library_name} src/{library_name}.cpp)',
        f'add_library({name}::{library_name} ALIAS {library_name})',
        f'target_compile_features({library_name} PUBLIC c_std_99 cxx_std_17)  # Require C99 and C++17',
        *_include_directories(library_name),
        *_target_depends(library_name, depends),
        '',
        '# Causes the visibility macros to use dllexport rather than dllimport,',
        '# which is appropriate when building the dll but not consuming it.',
        f'target_compile_definitions({library_name} PRIVATE "{name.upper()}_BUILDING_LIBRARY")',
        '',
        'install(',
        '  DIRECTORY include/',
        '  DESTINATION include/${PROJECT_NAME}',
        ')',
        'install(',
        f'  TARGETS {library_name}',
        '  EXPORT export_${PROJECT_NAME}',
        '  ARCHIVE DESTINATION lib',
        '  LIBRARY DESTINATION lib',
        '  RUNTIME DESTINATION bin',
        ')',
    ]


def _executable(node_name: str, depends: list[str], library_name: str | None) -> list[str]:
    lines = [f'add_executable({node_name} src/{node_name}.cpp)', *_include_directories(node_name)]
    if library_name:
        lines.append(f'target_link_libraries({node_name} {library_name})')
    else:
        lines.append(f'target_compile_features({node_name} PUBLIC c_std_99 cxx_std_17)  # Require C99 and C++17')
        lines += _target_depends(node_name, depends)
    return [*lines, '', f'install(TARGETS {node_name}', '  DESTINATION lib/${PROJECT_NAME})']


def cpp_main(name: str) -> str:
    """Return the source of a new C++ node."""
    return _text(
        [
            '#include <cstdio>',
            '',
            'int main(int argc, char ** argv)',
            '{',
            '  (void) argc;',
            '  (void) argv;',
            '',
            f'  printf("hello world {name} package\\n");',
            '  return 0;',
            '}',
        ]
    )


def _class_name(library_name: str) -> str:
    return ''.join(part.capitalize() for part in library_name.split('_'))


def cpp_header(name: str, library_name: str) -> str:
    """Return the header of a new C++ library."""
    guard, class_name = f'{name.upper()}__{library_name.upper()}_HPP_', _class_name(library_name)
    return _text(
        [
            f'#ifndef {guard}',
            f'#define {guard}',
            '',
            f'#include "{name}/visibility_control.h"',
            '',
            f'namespace {name}',
            '{',
            '',
            f'class {class_name}',
            '{',
            'public:',
            f'  {class_name}();',
            '',
            f'  virtual ~{class_name}();',
            '};',
            '',
            f'}}  // namespace {name}',
            '',
            f'#endif  // {guard}',
        ]
    )


def cpp_library(name: str, library_name: str) -> str:
    """Return the source of a new C++ library."""
    class_name = _class_name(library_name)
    return _text(
        [
            f'#include "{name}/{library_name}.hpp"',
            '',
            f'namespace {name}',
            '{',
            '',
            f'{class_name}::{class_name}()',
            '{',
            '}',
            '',
            f'{class_name}::~{class_name}()',
            '{',
            '}',
            '',
            f'}}  // namespace {name}',
        ]
    )


def visibility_control(name: str) -> str:
    """Return the header that says which symbols a C++ library shows."""
    upper = name.upper()
    guard = f'{upper}__VISIBILITY_CONTROL_H_'

    def define(what: str, gnu: str, depth: int) -> str:
        return f'{"  " * depth}#define {upper}_{what} {gnu}'.rstrip()

    return _text(
        [
            f'#ifndef {guard}',
            f'#define {guard}',
            '',
            '#if defined _WIN32 || defined __CYGWIN__',
            '  #ifdef __GNUC__',
            define('EXPORT', '__attribute__ ((dllexport))', 2),
            define('IMPORT', '__attribute__ ((dllimport))', 2),
            '  #else',
            define('EXPORT', '__declspec(dllexport)', 2),
            define('IMPORT', '__declspec(dllimport)', 2),
            '  #endif',
            f'  #ifdef {upper}_BUILDING_LIBRARY',
            define('PUBLIC', f'{upper}_EXPORT', 2),
            '  #else',
            define('PUBLIC', f'{upper}_IMPORT', 2),
            '  #endif',
            define('PUBLIC_TYPE', f'{upper}_PUBLIC', 1),
            define('LOCAL', '', 1),
            '#else',
            define('EXPORT', '__attribute__ ((visibility("default")))', 1),
            define('IMPORT', '', 1),
            define('PUBLIC', '__attribute__ ((visibility("default")))', 1),
            define('LOCAL', '__attribute__ ((visibility("hidden")))', 1),
            define('PUBLIC_TYPE', '', 1),
            '#endif',
            '',
            f'#endif  // {guard}',
        ]
    )


def _text(lines: list[str]) -> str:
    return '\n'.join(lines) + '\n'
