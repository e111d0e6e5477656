"""The verb `ros2 pkg create`."""

import datetime
import getpass
import os
import re
import shutil
import subprocess
import sys

from ros2pkg.verb import VerbExtension

_NAME = re.compile(r'[A-Za-z][A-Za-z0-9_-]*')


class CreateVerb(VerbExtension):
    """Create a new ROS 2 package."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        parser.add_argument('package_name', help='Name of the package')
        parser.add_argument(
            '--package-format',
            '--package_format',
            type=int,
            default=3,
            choices=[2, 3],
            help='Format of package.xml (default: 3)',
        )
        parser.add_argument('--description', default='TODO: Package description', help='Description in package.xml')
        parser.add_argument(
            '--license',
            default='TODO: License declaration',
            help="Licence in package.xml; any text, but a file LICENSE is written only for those that '?' lists",
        )
        parser.add_argument(
            '--destination-directory', default=os.curdir, help='Where to create the directory of the package'
        )
        parser.add_argument(
            '--build-type',
            default='ament_cmake',
            choices=['cmake', 'ament_cmake', 'ament_python'],
            help='How the package is built (default: ament_cmake)',
        )
        parser.add_argument('--dependencies', nargs='+', default=[], help='Packages that it depends on')
        parser.add_argument('--maintainer-email', help="E-mail address of the maintainer (default: git's user.email)")
        parser.add_argument(
            '--maintainer-name', default=getpass.getuser(), help='Name of the maintainer (default: who you are)'
        )
        parser.add_argument('--node-name', help='Name of an executable to begin with')
        parser.add_argument('--library-name', help='Name of a library to begin with')

    def main(self, *, args):
        """Print what is created, and create it."""
        from ament_copyright import get_licenses

        licenses = {license_.spdx: license_ for license_ in get_licenses().values()}
        if args.license == '?':
            print('Supported licenses:\n' + '\n'.join(licenses))
            return 0
        error = _problem(args)
        if error:
            return error
        email = args.maintainer_email or _git_email() or f'{args.maintainer_name}@todo.todo'
        node_name = args.node_name
        if node_name and node_name == args.library_name:
            node_name += '_node'
            print('[WARNING] node name can not be equal to the library name', file=sys.stderr)
            print(f'[WARNING] renaming node to {node_name}', file=sys.stderr)
        _announce(args, email, node_name)
        try:
            root = _Writer(args.destination_directory).folder(args.package_name)
            if args.build_type == 'ament_python':
                _create_ament_python(root, args, email, node_name)
            else:
                _create_cmake(root, args, email, node_name)
            if args.license in licenses:
                notice = f'Copyright {datetime.date.today().year} {args.maintainer_name}'
                texts = licenses[args.license].license_files
                root.silent_file('LICENSE', ''.join(texts).replace('{copyright}', notice))
        except OSError as e:
            return f'unable to create {e.filename}: {e.strerror}'
        if args.license not in licenses:
            print(
                f"\n[WARNING]: Unknown license '{args.license}'.  This has been set in the package.xml, but "
                'no LICENSE file has been created.\nIt is recommended to use one of the ament '
                'license identifiers:\n' + '\n'.join(licenses)
            )
        return None


def _problem(args):
    """Return why the package cannot be created, or None."""
    for name in (args.package_name, *args.dependencies):
        if not _NAME.fullmatch(name):
            return (
                f"Aborted since '{name}' is not a valid package name: it may have letters, digits, "
                'underscores and dashes, and begins with a letter.'
            )
    if args.build_type == 'ament_python':
        if args.package_name == 'test':
            # Its sources and its tests would be in one directory.
            return (
                "Aborted since 'ament_python' packages can't be named 'test'. Please choose a different package name."
            )
        if not args.package_name.isidentifier():
            return f"Aborted since '{args.package_name}' is not a valid name of a Python package."
        for name in (args.node_name, args.library_name):
            if name and not name.isidentifier():
                return f"Aborted since '{name}' is not a valid name of a Python module."
    path = os.path.join(args.destination_directory, args.package_name)
    if os.path.exists(path):
        return (
            f'\nAborted!\nThe directory already exists: {path}\nEither remove the directory or choose a '
            'different destination directory or package name'
        )
    return None


def _git_email():
    git = shutil.which('git')
    if git is None:
        return ''
    return subprocess.run([git, 'config', 'user.email'], stdout=subprocess.PIPE, text=True).stdout.strip()


def _announce(args, email, node_name):
    print('going to create a new package')
    print('package name:', args.package_name)
    print('destination directory:', os.path.abspath(args.destination_directory))
    print('package format:', args.package_format)
    print('version: 0.0.0')
    print('description:', args.description)
    print('maintainer:', [f'{args.maintainer_name} <{email}>'])
    print('licenses:', [args.license])
    print('build type:', args.build_type)
    print('dependencies:', args.dependencies)
    if node_name:
        print('node_name:', node_name)
    if args.library_name:
        print('library_name:', args.library_name)


def _create_manifest(root, args, email, buildtool_depends, test_depends):
    from ros2pkg.api import templates

    root.file(
        'package.xml',
        templates.package_xml(
            name=args.package_name,
            package_format=args.package_format,
            description=args.description,
            maintainer=args.maintainer_name,
            email=email,
            license_name=args.license,
            build_type=args.build_type,
            buildtool_depends=buildtool_depends,
            depends=args.dependencies,
            test_depends=test_depends,
        ),
    )


def _create_ament_python(root, args, email, node_name):
    from ros2pkg.api import templates

    name = args.package_name
    _create_manifest(root, args, email, [], ['ament_copyright', 'ament_flake8', 'ament_pep257', 'python3-pytest'])
    print('creating source folder')
    source = root.folder(name)
    root.file(
        'setup.py',
        templates.setup_py(
            name=name,
            maintainer=args.maintainer_name,
            email=email,
            description=args.description,
            license_name=args.license,
            node_name=node_name,
        ),
    )
    root.file('setup.cfg', templates.setup_cfg(name))
    root.folder('resource').file(name, '')
    source.file('__init__.py', '')
    tests = root.folder('test')
    for file_name, text in templates.TESTS.items():
        tests.file(file_name, text)
    if node_name:
        source.file(f'{node_name}.py', templates.python_main(name))
    if args.library_name:
        source.folder(args.library_name).file('__init__.py', '')


def _create_cmake(root, args, email, node_name):
    """Create a package of C++, built with ament or with CMake alone."""
    from ros2pkg.api import templates

    name, library_name = args.package_name, args.library_name
    texts = {'name': name, 'depends': args.dependencies, 'node_name': node_name, 'library_name': library_name}
    ament = args.build_type == 'ament_cmake'
    tool = ('ament_cmake_ros' if library_name else 'ament_cmake') if ament else 'cmake'
    _create_manifest(root, args, email, [tool], ['ament_lint_auto', 'ament_lint_common'] if ament else [])
    print('creating source and include folder')
    source = root.folder('src')
    include = root.folder(os.path.join('include', name))
    if ament:
        root.file('CMakeLists.txt', templates.cmake_lists(**texts))
    else:
        root.file('CMakeLists.txt', templates.plain_cmake_lists(**texts))
        if node_name or library_name:
            root.file(f'{name}Config.cmake.in', templates.plain_cmake_config(name, library_name))
            root.file(f'{name}ConfigVersion.cmake.in', templates.plain_cmake_config_version(name))
    if node_name:
        source.file(f'{node_name}.cpp', templates.cpp_main(name))
    if library_name:
        include.file(f'{library_name}.hpp', templates.cpp_header(name, library_name))
        source.file(f'{library_name}.cpp', templates.cpp_library(name, library_name))
        include.file('visibility_control.h', templates.visibility_control(name))


class _Writer:
    """Creates files and folders in a folder and says so."""

    def __init__(self, path):
        self.path = path

    def folder(self, name):
        path = os.path.join(self.path, name)
        print('creating folder', path)
        os.makedirs(path, exist_ok=True)
        return _Writer(path)

    def file(self, name, text):
        print('creating', os.path.join(self.path, name))
        self.silent_file(name, text)

    def silent_file(self, name, text):
        with open(os.path.join(self.path, name), 'w', encoding='utf-8') as file:
            file.write(text)
