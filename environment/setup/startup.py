"""Runs when a Python of the course's environment starts (`course.pth` calls `start` in a copy of this file).

It makes every program that is started with `.venv/bin/python` see ROS as if `.venv/setup.bash` had been sourced, and
gives the variables below their defaults. Standard library only, and quick: every process pays for it.
"""

import os
import sys

# Of every process of the course: `helpers` gives them where this file has not run, the runner gives them to tests.
DEFAULTS = {
    # Hear and be heard on this machine only: a classroom shares one network.
    'ROS_AUTOMATIC_DISCOVERY_RANGE': 'LOCALHOST',
    # A wrong field type is an error at the assignment, not an obscure one at the publishing.
    'ROS_PYTHON_CHECK_FIELDS': '1',
    # Notebooks show log output as plain text; a line as short as it can be.
    'RCUTILS_COLORIZED_OUTPUT': '0',
    'RCUTILS_CONSOLE_OUTPUT_FORMAT': '[{severity}] [{name}]: {message}',
    # numpy's thread pool would start a thread per core in each node's process.
    'OPENBLAS_NUM_THREADS': '1',
}
OF_ROS = {'ROS_DISTRO': 'jazzy', 'ROS_VERSION': '2', 'ROS_PYTHON_VERSION': '3'}
# Announcements that come often: how Fast DDS finds others quickly. `kernel.install` puts the file there.
PROFILE = os.path.join('share', 'course', 'fastdds.xml')
# Beside the environment: what programs would write into the home of their user, where other copies find it. Those of
# Jupyter are for `./course lab` and `./course shell` only: another server has its own.
HOME = '.home'
FOLDERS = {'ROS_HOME': 'ros', 'IPYTHONDIR': 'ipython', 'MPLCONFIGDIR': 'matplotlib'}
JUPYTER = {
    'JUPYTER_CONFIG_DIR': 'jupyter/config',
    'JUPYTER_DATA_DIR': 'jupyter/data',
    'JUPYTER_RUNTIME_DIR': 'jupyter/runtime',
    'JUPYTERLAB_SETTINGS_DIR': 'jupyter/settings',
    'JUPYTERLAB_WORKSPACES_DIR': 'jupyter/workspaces',
    'npm_config_cache': 'npm',
}  # a part of JupyterLab asks npm, where there is one, and that writes a log
DOMAIN = os.path.join('.course', 'domain')  # the ROS domain of this copy, which `helpers.kernel.domains` chooses
# Of the wheels: the module that `ros_wheels_bootstrapper.pth` loads in every process, and what tells it to do nothing.
BOOTSTRAPPER, GUARD = 'ros_wheels_bootstrapper', '_ROS_WHEELS_BOOTSTRAP_COMPLETE'
STOCK = 'COURSE_STOCK'  # set by `./course shell --stock`: ROS with its own defaults


def activate(environ=os.environ, prefix=sys.prefix):
    """Complete `environ` for the ROS installation `prefix`."""
    if not environ.get(STOCK):
        give_defaults(environ, prefix)
    keep_to_the_folder(environ, prefix, FOLDERS)
    prefixes = [p for p in environ.get('AMENT_PREFIX_PATH', '').split(os.pathsep) if p]
    if prefix not in prefixes:
        # Others are workspaces that stand on this prefix, unless it stands on a stock ROS itself.
        underlay = os.path.isdir(os.path.join(prefix, 'share', 'rclpy'))
        environ['AMENT_PREFIX_PATH'] = os.pathsep.join([*prefixes, prefix] if underlay else [prefix, *prefixes])
    drop_foreign_guard(environ, prefix)
    choose_generator(environ, prefix)
    if 'ipykernel_launcher' in sys.orig_argv:
        complete_kernel(environ, prefix)


def give_defaults(environ, prefix):
    """What differs from a stock ROS; README has it as a table."""
    for name, value in DEFAULTS.items():
        environ.setdefault(name, value)
    profile = os.path.join(prefix, PROFILE)
    if os.path.exists(profile):
        environ.setdefault('FASTRTPS_DEFAULT_PROFILES_FILE', profile)
    share_the_machine(environ)
    try:
        with open(os.path.join(prefix, DOMAIN)) as file:
            environ.setdefault('ROS_DOMAIN_ID', file.read().strip())
    except OSError:  # none yet: 0, as everywhere
        pass


def keep_to_the_folder(environ, prefix, folders):
    """Let programs write into the course's folder what they would write into the user's home.

    Not where that folder is somebody else's, as with one installation for many users, and not for a learner's program
    that a check or a grader runs: it has a home of its own.
    """
    root = os.path.dirname(prefix)
    if environ.get('COURSE_RUNNER') or not os.access(os.path.join(root, 'course'), os.W_OK):
        return
    home = os.path.join(root, HOME)
    try:
        os.makedirs(home, exist_ok=True)  # IPython makes its folder only in one that is there
    except OSError:  # a file is in the way
        return
    for name, folder in folders.items():
        environ.setdefault(name, os.path.join(home, folder))


def complete_kernel(environ, prefix):
    """Give a kernel what `./course lab` would have given it: JupyterHub and VS Code start it by themselves.

    Its cells call programs, such as `ros2`, by their names.
    """
    first = os.path.join(prefix, 'bin')
    folders = environ.get('PATH', os.defpath).split(os.pathsep)
    if first not in folders:
        environ['PATH'] = os.pathsep.join([first, *folders])
    for name, value in OF_ROS.items():
        environ.setdefault(name, value)
    drop_settings_of_another_ros(environ, prefix)
    # A kernel asks the programs of its cells for colours (FORCE_COLOR), and from 3.13 on Python's tracebacks have some:
    # what a program prints is to be the same text everywhere.
    environ.setdefault('PYTHON_COLORS', '0')


def drop_settings_of_another_ros(environ, prefix):
    """Replace what many have in their .bashrc for an older ROS of theirs, or for one with other parts.

    With a middleware that is not here rcl ends each program (status 102) before it can say anything, and so each
    kernel. With a discovery server nodes know only those that it knows. ROS_LOCALHOST_ONLY brings two warnings in each
    program; LOCALHOST is the same. This is for what a person starts; a program that is started with such a value meets
    what it meets on every Jazzy.
    """
    environ.pop('ROS_DISCOVERY_SERVER', None)
    environ.pop('ROS_SUPER_CLIENT', None)
    if environ.get('ROS_LOCALHOST_ONLY') == '1':
        del environ['ROS_LOCALHOST_ONLY']
        environ['ROS_AUTOMATIC_DISCOVERY_RANGE'] = 'LOCALHOST'
    folders = [*environ.get('AMENT_PREFIX_PATH', '').split(os.pathsep), prefix]
    library = f'lib{environ.get("RMW_IMPLEMENTATION")}.so'
    if not any(os.path.exists(os.path.join(folder, 'lib', library)) for folder in folders if folder):
        environ.pop('RMW_IMPLEMENTATION', None)


def choose_generator(environ, prefix):
    """Let CMake, and so `colcon build`, work where the machine has no make: with the Ninja of the environment.

    Its compilers come without make on Debian and Ubuntu. A build folder that exists keeps what made it.
    """
    folders = environ.get('PATH', os.defpath).split(os.pathsep)
    if not any(os.access(os.path.join(folder, 'make'), os.X_OK) for folder in folders if folder) and os.access(
        os.path.join(prefix, 'bin', 'ninja'), os.X_OK
    ):
        environ.setdefault('CMAKE_GENERATOR', 'Ninja')


def share_the_machine(environ, user=None):
    """On a JupyterHub give each user a ROS domain: their nodes would hear each other's on the machine they share.

    From 1 to 100, by the user's number (`user`, os.getuid()); hubs number their users one after the other.
    """
    if environ.get('JUPYTERHUB_USER'):
        environ.setdefault('ROS_DOMAIN_ID', str(1 + (os.getuid() if user is None else user) % 100))


def drop_foreign_guard(environ, prefix):
    """Let the wheels' bootstrapper do its work when only another environment's has been done.

    The bootstrapper sets LD_LIBRARY_PATH, starts Python anew and sets a guard, so that it does so once. A process
    started from another such environment inherits the guard together with that environment's libraries.
    """
    libraries = [p for p in environ.get('LD_LIBRARY_PATH', '').split(os.pathsep) if p]
    own = os.path.join(prefix, 'lib')
    if own in libraries:
        return
    environ.pop(GUARD, None)
    kept = [p for p in libraries if not of_wheels(p)]
    if kept != libraries:
        environ['LD_LIBRARY_PATH'] = os.pathsep.join(kept)


def spare_the_bootstrapper(environ, prefix, packages, modules=sys.modules):
    """Leave the wheels' bootstrapper out where the libraries are known already, as in a terminal of the course.

    It would start Python anew or, with its guard set, load pathlib for nothing: either way this start takes more than
    twice as long.

    :param packages: the directory site-packages of `prefix`
    """
    known = {os.path.realpath(path) for path in environ.get('LD_LIBRARY_PATH', '').split(os.pathsep) if path}
    if os.path.realpath(os.path.join(prefix, 'lib')) not in known:
        return
    if not environ.get(GUARD):
        with os.scandir(packages) as entries:
            libraries = [entry.path for entry in entries if of_wheels(entry.path)]
        if not libraries or not known.issuperset(map(os.path.realpath, libraries)):
            return  # without any, ROS is not that of the wheels
        environ[GUARD] = '1'
    modules.setdefault(BOOTSTRAPPER, type(sys)(BOOTSTRAPPER))


def of_wheels(directory):
    """Whether `directory` is a library directory of a virtual environment that holds the ROS wheels."""
    head, tail = os.path.split(directory.rstrip('/'))
    if tail.startswith('ros_') and tail.endswith('.libs'):
        return os.path.basename(head) == 'site-packages'
    return tail == 'lib' and os.path.exists(os.path.join(head, 'pyvenv.cfg'))


def print_settings_of_another_ros():
    """Print the lines by which a shell drops them, when it has read the user's own start-up file."""
    left = dict(os.environ)
    drop_settings_of_another_ros(left, sys.prefix)
    for name in os.environ.keys() - left.keys():
        print('unset', name)
    for name, value in left.items() - os.environ.items():
        print(f'export {name}={value}')


def start():
    """Complete the environment of this process, if its Python is that of a virtual environment."""
    if sys.prefix != sys.base_prefix:
        activate()
        spare_the_bootstrapper(os.environ, sys.prefix, os.path.dirname(__file__))


if __name__ == '__main__':
    print_settings_of_another_ros()
