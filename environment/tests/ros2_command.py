"""Run the real `ros2` beside real nodes, each test module in a ROS domain of its own."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from environment.tests.running import PATIENCE, ROS2
from helpers.kernel import domains
from helpers.programs.processes import background

NODES = Path(__file__).with_name('command_nodes.py')


class Ros2:
    """Runs `ros2` in one environment."""

    def __init__(self, environ: dict[str, str], directory: Path):
        self.environ = environ
        self.directory = directory

    def run(self, *argv: str, stdin: str = '', cwd: Path | None = None) -> subprocess.CompletedProcess:
        """Run a command line to its end."""
        return subprocess.run(
            [ROS2, *argv],
            input=stdin,
            capture_output=True,
            text=True,
            timeout=2 * PATIENCE,
            env=self.environ,
            cwd=cwd or self.directory,
        )

    def output(self, *argv: str, **kwargs) -> str:
        """Run a command line that must succeed and say nothing on stderr; return what it prints."""
        done = self.run(*argv, **kwargs)
        assert (done.returncode, done.stderr) == (0, ''), done
        return done.stdout

    def lines(self, *argv: str, **kwargs) -> list[str]:
        """Return what such a command prints, line by line."""
        return self.output(*argv, **kwargs).splitlines()

    def error(self, *argv: str, status: int = 1, **kwargs) -> str:
        """Run a command line that must fail; return what it says on stderr."""
        done = self.run(*argv, **kwargs)
        assert done.returncode == status, done
        assert 'Traceback' not in done.stderr, done
        return done.stderr.rstrip('\n')

    def start(self, *argv: str):
        """Start a command line in the background; it ends with the block it is used in."""
        return background([ROS2, *argv], env=self.environ, cwd=self.directory)


@pytest.fixture(scope='module')
def ros2(tmp_path_factory):
    """The command in a domain that no other module has."""
    directory = tmp_path_factory.mktemp('ros2')
    with domains.claim() as domain_id:
        environ = {
            **os.environ,
            'ROS_DOMAIN_ID': str(domain_id),
            'ROS_AUTOMATIC_DISCOVERY_RANGE': 'LOCALHOST',
            'ROS_LOG_DIR': str(directory / 'log'),
            'COLUMNS': '200',
            'PYTHONDONTWRITEBYTECODE': '1',
        }
        yield Ros2(environ, directory)


@pytest.fixture(scope='module')
def node(ros2):
    """Start nodes of command_nodes.py: ``node('robot')`` returns when it is ready; they end with the module."""
    started = []

    def start(name: str):
        process = background([sys.executable, str(NODES), name], env=ros2.environ)
        started.append(process)
        process.wait_for_output('ready', timeout=PATIENCE)
        return process

    yield start
    for process in started:
        process.stop()


@pytest.fixture(scope='module')
def robot(node):
    """The node `robot`, of a module's own."""
    return node('robot')


@pytest.fixture(scope='module')
def several_nodes(node):
    """Nodes with services, actions, parameters and a lifecycle, of a module's own."""
    for name in ('robot', 'worker', 'managed', 'adder'):
        node(name)
