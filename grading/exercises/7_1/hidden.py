"""Hidden tests of exercise 7.1, a machine. Every machine is drawn."""

import pytest

from helpers.checks.chapter_07 import machines
from helpers.runner import about, expect

pytestmark = pytest.mark.exercise('7.1')
APT, SHELL = machines.CAUSES[:3], machines.CAUSES[3:]


def check(learner, *causes, rule='', **form):
    machines.diagnose(learner, *machines.draw(learner.random, *causes, plain=not rule, **form), rule)


@pytest.mark.rules('missing', 'release', 'key', 'not-sourced', 'path', 'other', 'domain', 'range')
def test_healthy_machine(learner):
    """A machine without a fault gives an empty list.

    Comments do nothing, and of several lines that set one variable, the last one holds.
    """
    for _ in range(5):
        check(learner)
    files, want, _ = machines.draw(learner.random, 'key', 'other', 'range', plain=True)
    expect(
        learner.call('diagnose_machine', files, want) != [],
        f'A machine with three faults gives an empty list, too. The team wants {want}.',
    )


@pytest.mark.rules('missing', 'release', 'key')
def test_apt(learner):
    """Every fault of apt's file is found, and its evidence is the line.

    The card says which causes of `no_source` there are.
    """
    for cause in APT:
        check(learner, cause)


@pytest.mark.rules('not-sourced', 'path', 'other', 'domain', 'range')
@pytest.mark.weight(2)
def test_each_fault_of_a_shell(learner):
    """Every fault of the .bashrc is found where it is alone.

    The causes of no_ros2, no_colcon, mixed_distros and unseen, for other distributions, folders and domains.
    """
    for cause in SHELL:
        for form in machines.FORMS.get(cause, [{}]):
            for _ in range(2):
                check(learner, cause, **form)


@pytest.mark.rules('comments', 'sources', 'variables', 'missing', 'release', 'key', 'not-sourced', 'path', 'domain')
def test_lines(learner):
    """Lines are read as a shell reads them: comments, prefixes, with and without `export`.

    `active(text)` gives the lines that do something; `SETUP` is a pattern for lines that source ROS.
    """
    for line, rule in (('   # source {}', 'comments'), ('. {}', 'sources'), ('{}', 'variables')):
        (distro, codename), (older, _) = learner.random.sample(machines.RELEASES, 2)
        domain = learner.random.randint(1, 101)
        want, source = {'distro': distro, 'codename': codename, 'domain': domain}, f'. /srv/opt/ros/{distro}/setup.sh'
        lines = (
            [f'PATH=/opt/tool{domain}', f'ROS_DOMAIN_ID={domain}']
            if rule == 'variables'
            else [f'export ROS_DOMAIN_ID={domain}', line.format(f'~/opt/ros/{older}/setup.sh')]
        )
        expected = {
            'sources': [('mixed_distros', '.bashrc', 'other', lines[1])],
            'variables': [('no_colcon', '.bashrc', 'PATH', lines[0])],
            'comments': [],
        }[rule]
        source = source if rule == 'sources' else f'source /opt/ros/{distro}/setup.bash'
        files = {
            'ros2.list': f'deb [signed-by=/k.gpg] http://packages.ros.org/ros2/ubuntu {codename} main\n',
            '.bashrc': '\n'.join([source, *lines]),
        }
        if rule == 'comments':
            files['ros2.list'] += f'  # deb http://old.example {older} main\n'
        with about(rule):
            machines.diagnose(learner, files, want, expected, rule)
    machines.judge_rare_lines(learner)


@pytest.mark.rules('all')
def test_several_faults(learner):
    """Several faults at once are several findings.

    Do not return after the first one.
    """
    for _ in range(5):
        check(learner, *learner.random.sample(SHELL, 3), learner.random.choice(APT), rule='all')
    check(learner, 'not sourced', 'other', 'release', 'key', rule='all')
    machines.diagnose(learner, *machines.twice(learner.random), 'all')
    files, want, expected = machines.draw(learner.random, 'range')
    distro, _ = learner.random.choice([one for one in machines.RELEASES if one[0] != want['distro']])
    lines = [f'source /opt/ros/{distro}/setup.bash', f'. /opt/ros/{distro}/setup.sh']
    files['.bashrc'] += '\n'.join(lines)
    machines.diagnose(
        learner, files, want, [*expected, *[('mixed_distros', '.bashrc', 'other', line) for line in lines]], 'all'
    )


def repair(learner, causes, **form):
    files, want, expected = machines.draw(learner.random, *causes, **form)
    machines.diagnose(learner, files, want, expected, 'all')
    with about('repaired'):
        repaired = learner.call('repair_machine', files, want)
    machines.try_out(learner, files, repaired, want)


@pytest.mark.rules('repaired', 'kept', 'folders')
@pytest.mark.weight(2)
def test_repaired_shell(learner):
    """A shell with the repaired .bashrc finds everything, and keeps what was right.

    A line can be dropped, changed or added. The folders of a PATH stay.
    """
    for causes in (SHELL, learner.random.sample(SHELL, 2)):
        repair(learner, causes)
    repair(learner, ['domain'], way='both')
    machines.judge_rare_repairs(learner)


@pytest.mark.rules('repaired', 'kept')
def test_repaired_source(learner):
    """The repaired ros2.list is for the right release and names a key; one that was right stays.

    DEB is a line that is right; it wants the codename.
    """
    for causes in (['missing'], ['release', 'key'], []):
        repair(learner, causes)
