"""What `./course lab` and `./course shell` have in common: this copy's own folders and its own ROS domain."""

import os

from environment.setup import startup
from helpers import paths
from helpers.kernel import domains

# Set by the script `course` if the user has chosen no domain: what is in ROS_DOMAIN_ID is then this copy's own.
UNCHOSEN = 'COURSE_DOMAIN_UNCHOSEN'


def enter(environ=os.environ) -> None:
    """Complete `environ`. What the user has set stays; on a JupyterHub, the domain of the user."""
    prefix = str(paths.ROOT / '.venv')
    startup.keep_to_the_folder(environ, prefix, startup.JUPYTER)
    if environ.pop(UNCHOSEN, '') and not environ.get('JUPYTERHUB_USER'):
        environ['ROS_DOMAIN_ID'] = str(domains.of_copy(paths.ROOT, paths.ROOT / '.venv' / startup.DOMAIN))


def leave(environ) -> None:
    """Take the course's defaults out of `environ` again; what the user has set otherwise stays."""
    for name, value in startup.DEFAULTS.items():
        if environ.get(name) == value:
            del environ[name]
    if environ.get('FASTRTPS_DEFAULT_PROFILES_FILE') == str(paths.ROOT / '.venv' / startup.PROFILE):
        del environ['FASTRTPS_DEFAULT_PROFILES_FILE']
    if environ.pop(UNCHOSEN, ''):
        environ.pop('ROS_DOMAIN_ID', None)
    environ[startup.STOCK] = '1'
