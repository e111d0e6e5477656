"""What the tests of exercise 8.3 share: the learner's package, built, and what the governors in it report."""

import json
from pathlib import Path

from helpers.runner import expect
from helpers.runner.workspaces import Workspace, package

GIVEN = Path(__file__).with_name('given')
REPORT = 'report.txt'


def fleet(learner) -> Workspace:
    """The package with the learner's two files, built."""
    workspace = learner.workspace({
        **package(GIVEN / 'fleet'), 'src/fleet/config/fleet.yaml': learner.text('FLEET_YAML'),
        'src/fleet/launch/fleet.launch.py': learner.text('FLEET_LAUNCH')})
    workspace.build()
    return workspace


def launched(learner) -> dict[str, dict]:
    """What each governor reports after `ros2 launch`: name of the node → its names and parameters.

    It is launched once for all tests of a session, without the sources.
    """
    workspace = fleet(learner)
    done = workspace.run(
        'bash', '-c', f'if [ ! -e {REPORT} ]; then mv src sources; touch {REPORT}\n'
        f'FLEET_REPORT=$PWD/{REPORT} ros2 launch fleet fleet.launch.py > launch.txt 2>&1; mv sources src; fi\n'
        f'cat launch.txt; echo ---; cat {REPORT}')
    log, _, report = done.output.rpartition('---')
    expect('InvalidParameterTypeException' not in log, 'A governor did not start: a value in FLEET_YAML has the wrong '
                                                       'type. rate and max_linear are doubles: 1.0, and not 1.')
    expect('Error opening YAML file' not in log,
           'A governor did not start: the launch file names a parameter file that is not there. The sources of the '
           'package are gone, so name the installed file: FindPackageShare finds its folder.')
    expect("Couldn't parse params file" not in log,
           'A governor did not start: ROS cannot read FLEET_YAML. Look at the indentation, and at the two underscores '
           'of ros__parameters.')
    lines = [json.loads(line) for line in report.splitlines() if line.strip().startswith('{')]
    names = [line['node'] for line in lines]
    expect(names, f'`ros2 launch fleet fleet.launch.py` started no governor. Its output ends: {_last(log)}')
    expect(len(set(names)) == len(names), f'Several nodes have one name: {", ".join(sorted(names))}. Two robots need '
                                          'two namespaces.')
    return {line['node']: line for line in lines}


def alone(learner, namespace: str) -> dict:
    """What a governor reports that is started by itself, in this namespace, with the installed parameter file."""
    done = fleet(learner).run(
        'bash', '-c', f'ros2 run fleet governor --ros-args -r __ns:={namespace} '
        '--params-file $(ros2 pkg prefix --share fleet)/config/fleet.yaml')
    expect(done.last_line.startswith('{'), f'A governor with your parameter file ended with: {done.last_line}')
    return json.loads(done.last_line)


def _last(log: str) -> str:
    lines = [line.strip() for line in log.splitlines() if line.strip()]
    return lines[-1][:300] if lines else 'nothing'
