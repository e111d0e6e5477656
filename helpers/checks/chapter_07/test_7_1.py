"""Visible tests of exercise 7.1, a machine."""

import pytest

from helpers.checks.chapter_07 import machines
from helpers.checks.chapter_07.findings import rule_of
from helpers.runner import about, expect

pytestmark = pytest.mark.exercise('7.1')
DEB = 'deb [signed-by=/key.gpg] http://packages.ros.org/ros2/ubuntu {codename} main\n'


@pytest.mark.rules('missing', 'release', 'key', 'not-sourced', 'path', 'other', 'domain', 'range')
def test_each_cause(learner):
    """Each of the eight causes is found where it is alone, and nothing is found on a healthy machine.

    The card has a line for each cause.
    """
    for cause in machines.CAUSES:
        for form in machines.FORMS.get(cause, [{}]):
            with about(rule_of(cause)):
                machines.diagnose(learner, *machines.draw(learner.random, cause, plain=True, **form))
    machines.diagnose(learner, *machines.draw(learner.random, plain=True))


@pytest.mark.rules(
    'comments', 'sources', 'variables', 'all', 'missing', 'release', 'key', 'not-sourced', 'path', 'domain'
)
def test_lines(learner):
    """What a line does is read as a shell reads it, and each wrong line is a finding.

    `active(text)` gives the lines that do something; `SETUP` is a pattern for lines that source ROS.
    """
    random = learner.random
    (distro, codename), (older, _) = random.sample(machines.RELEASES, 2)
    want = {'distro': distro, 'codename': codename, 'domain': 0}
    deb, source = DEB.format(codename=codename), f'source /opt/ros/{distro}/setup.bash'

    def look(rule, lines, *expected, sources=deb):
        with about(rule):
            machines.diagnose(
                learner, {'ros2.list': sources, '.bashrc': '\n'.join(lines) + '\n'}, want, list(expected), rule
            )

    lost = ('no_ros2', '.bashrc', 'not sourced', '')
    for dash in ('# ', '  #'):
        look('comments', [dash + source], lost)
        look(
            'comments',
            [
                source,
                f'{dash}export ROS_DOMAIN_ID={random.randint(1, 99)}',
                f'{dash}PATH=/bin',
                f'{dash}ROS_AUTOMATIC_DISCOVERY_RANGE=OFF',
                f'{dash}source /opt/ros/{older}/setup.bash',
            ],
        )
        look('comments', [source], sources=f'{dash}deb http://old.example {older} main\n' + deb)
    line = f'. ~/opt/ros/{older}/setup.sh'
    look('comments', [source, f'   {line}  '], ('mixed_distros', '.bashrc', 'other', line))
    for word, folder, shell in (('.', '', 'bash'), ('source', '/home/ada', 'bash'), ('source', '', 'sh')):
        look('sources', [f'{word} {folder}/opt/ros/{distro}/setup.{shell}'])
    look('sources', ['source ~/.aliases', f'echo /opt/ros/{older}/setup.bash', source])
    for word in ('', 'export '):
        lines = [
            f'{word}PATH=/opt/tool{random.randint(10, 99)}/bin',
            f'{word}ROS_DOMAIN_ID={random.randint(1, 99)}',
            f'{word}ROS_AUTOMATIC_DISCOVERY_RANGE={random.choice(["OFF", "LOCALHOST"])}',
        ]
        look(
            'variables',
            [source, *lines],
            *[
                (fault, '.bashrc', cause, line)
                for fault, cause, line in zip(
                    ('no_colcon', 'unseen', 'unseen'), ('PATH', 'domain', 'range'), lines, strict=True
                )
            ],
        )
    lines = [f'source /opt/ros/{older}/setup.bash', f'. /opt/ros/{older}/setup.sh']
    look('all', lines, lost, *[('mixed_distros', '.bashrc', 'other', line) for line in lines])
    machines.judge_rare_lines(learner)
    machines.diagnose(learner, *machines.twice(random), 'all')
    machines.diagnose(learner, *machines.draw(random, *machines.CAUSES[1:]), 'all')


@pytest.mark.rules('repaired', 'kept', 'folders')
def test_repair(learner):
    """A machine with all faults is repaired, and everything else stays as it was.

    Each finding names the line that goes, or is changed; what is missing is added.
    """
    some = (machines.CAUSES[1:], ''), (['missing', 'other'], ''), (['release'], ''), (['domain'], 'both'), ([], '')
    for causes, way in some:
        files, want, expected = machines.draw(learner.random, *causes, way=way)
        machines.diagnose(learner, files, want, expected, 'all')
        with about('repaired'):
            repaired = learner.call('repair_machine', files, want)
        expect(not causes or repaired != files, 'repair_machine changed nothing.', 'repaired')
        machines.try_out(learner, files, repaired, want)
    machines.judge_rare_repairs(learner)
