"""The command `ros2 run`."""

import pytest

from environment.tests.running import PATIENCE


@pytest.fixture
def overlay(ros2, tmp_path):
    """A prefix with the package `tools` whose programs are the given shell scripts."""
    index = tmp_path / 'share' / 'ament_index' / 'resource_index' / 'packages'
    index.mkdir(parents=True)
    (index / 'tools').touch()
    programs = tmp_path / 'lib' / 'tools'

    def make(**scripts: str):
        for name, script in scripts.items():
            path = programs / name.replace('__', '/')
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(f'#!/bin/sh\n{script}\n')
            path.chmod(0o755)
        environ = {**ros2.environ, 'AMENT_PREFIX_PATH': f'{tmp_path}:{ros2.environ.get("AMENT_PREFIX_PATH", "")}'}
        return type(ros2)(environ, tmp_path)

    return make


def test_run_passes_arguments_on(overlay):
    here = overlay(args='for each; do echo "$each"; done')
    assert here.lines('run', 'tools', 'args', 'a b', '--ros-args', '-r', '__node:=x', '-p', 'n:=1', '--help') == [
        'a b',
        '--ros-args',
        '-r',
        '__node:=x',
        '-p',
        'n:=1',
        '--help',
    ]
    assert here.lines('run', '--prefix', 'echo "before the"', 'tools', 'args', 'after') == [
        f'before the {here.directory}/lib/tools/args after'
    ]


def test_run_says_what_is_missing(overlay):
    here = overlay(a__twice='exit 0', b__twice='exit 0')
    assert here.error('run', 'not_a_package', 'x') == "Package 'not_a_package' not found"
    assert here.error('run', 'tools', 'nothing') == 'No executable found'
    multiple = here.error('run', 'tools', 'twice').splitlines()
    assert multiple[0] == 'Multiple executables found:'
    assert [line.rpartition('/lib/')[2] for line in multiple[1:]] == ['tools/a/twice', 'tools/b/twice']


def test_run_ends_with_the_status_of_the_program(overlay):
    here = overlay(three='exit 3', killed='kill -SEGV $$')
    done = here.run('run', 'tools', 'three')
    assert (done.returncode, done.stdout) == (3, '[ros2run]: Process exited with failure 3\n')
    done = here.run('run', 'tools', 'killed')
    assert (done.returncode, done.stdout) == (256 - 11, '[ros2run]: Segmentation fault\n')


def test_run_ends_its_program(overlay):
    here = overlay(wait='trap "echo interrupted; exit 0" INT; echo waiting; while true; do sleep 0.05; done')
    with here.start('run', 'tools', 'wait') as running:
        running.wait_for_output('waiting', PATIENCE)
        running.stop(PATIENCE)  # Ctrl+C: to the whole group, as a terminal does
        assert running.lines == ['waiting', 'interrupted']
        assert running.returncode == 0
