"""Hidden tests of exercise 1.2, read an environment. Most environments are drawn afresh."""

import pytest

from helpers.runner import expect

pytestmark = pytest.mark.exercise('1.2')

DISTROS = ('foxy', 'humble', 'iron', 'jazzy', 'kilted', 'lyrical')
PEOPLE = ('ada', 'linus', 'grace', 'alan')
RANGES = ('SUBNET', 'LOCALHOST', 'SYSTEM_DEFAULT')
PREFIX, PYTHON, DOMAIN, RANGE = 'AMENT_PREFIX_PATH', 'PYTHONPATH', 'ROS_DOMAIN_ID', 'ROS_AUTOMATIC_DISCOVERY_RANGE'


def healthy(random, distro, python):
    """An environment with nothing wrong: a distribution, perhaps workspaces above it, perhaps a domain and a range."""
    workspaces = [f'/home/{random.choice(PEOPLE)}/{random.choice(DISTROS)}_ws/install'
                  for _ in range(random.randint(0, 2))]
    prefixes = [*workspaces, f'/opt/ros/{distro}']
    environ = {
        'HOME': f'/home/{random.choice(PEOPLE)}',
        'ROS_DISTRO': distro,
        PREFIX: ':'.join(prefixes),
        PYTHON: ':'.join(f'{prefix}/lib/python{python}/site-packages' for prefix in prefixes),
    }
    if random.random() < 0.5:
        environ[DOMAIN] = str(random.randint(1, 100))
    if random.random() < 0.5:
        environ[RANGE] = random.choice(RANGES)
    return environ


def other(random, values, *but):
    return random.choice([value for value in values if value not in but])


def spoil(random, environ, distro, python, faults):
    """Put these faults in."""
    for fault in faults.values():
        match fault:
            case 'not sourced':
                environ.pop(PREFIX)
            case 'mixed':
                environ[PREFIX] += f':/opt/ros/{other(random, DISTROS, distro)}'
            case 'other Python':
                wrong = other(random, ('3.8', '3.10', '3.11', '3.12', '3.13'), python)
                environ[PYTHON] += f':/opt/ros/{distro}/lib/python{wrong}/site-packages'
            case 'not a domain':
                environ[DOMAIN] = random.choice(['-1', '102', '233', '5.0', 'seven', 'domain 3', '0x10'])
            case 'off':
                environ[RANGE] = 'OFF'
            case 'unknown':
                environ[RANGE] = random.choice(['LOCAL', 'localhost', 'ON', 'SUBNETS'])
    return environ


def ask(learner, environ, python='3.12'):
    got = learner.call('diagnose', environ, python)
    expect(isinstance(got, dict), f'diagnose returned {got!r}, expected a dictionary, also when nothing is wrong.')
    return got


def shown(environ):
    return ', '.join(f'{name}={value}' for name, value in environ.items())


@pytest.mark.weight(2)
def test_healthy(learner):
    """Nothing is wrong with these environments: workspaces, any distribution, any Python that fits.

    A workspace folder may be called anything. Only /opt/ros/NAME is a distribution.
    """
    for _ in range(6):
        distro, python = learner.random.choice(DISTROS), learner.random.choice(('3.8', '3.10', '3.12', '3.14'))
        environ = healthy(learner.random, distro, python)
        got = ask(learner, environ, python)
        if got.get(PREFIX) == 'mixed':
            expect(False, f'AMENT_PREFIX_PATH={environ[PREFIX]} is called mixed. The folders below /home are '
                          'workspaces; their names say nothing.')
        expect(got == {}, f'You name {got}, but nothing is wrong with {shown(environ)} and Python {python}.')
    prefix = {PREFIX: '/home/ada/ros2-course/.venv', 'ROS_DISTRO': 'jazzy'}
    got = ask(learner, prefix)
    expect(got == {}, f'A prefix outside of /opt/ros is a prefix, too: {shown(prefix)} is fine, and you name {got}.')


def test_empty_is_like_missing(learner):
    """An empty variable is like a missing one: no fault, but for AMENT_PREFIX_PATH.

    environ.get(name, '') treats both in the same way.
    """
    empty = {PREFIX: '/opt/ros/jazzy', 'ROS_DISTRO': '', PYTHON: '', DOMAIN: '', RANGE: ''}
    got = ask(learner, empty)
    expect(got == {}, f'Empty variables are no faults; you name {got}.')
    for environ in ({}, {PREFIX: ''}):
        got = ask(learner, environ)
        expect(got == {PREFIX: 'not sourced'}, f'{environ or "No variable at all"}: you name {got}, expected '
                                               "{'AMENT_PREFIX_PATH': 'not sourced'}.")


@pytest.mark.weight(2)
def test_mixed(learner):
    """Two distributions are mixed: in the path, or in the path and in ROS_DISTRO.

    Who sources Humble and then Jazzy has ROS_DISTRO=jazzy, and both in the path.
    """
    random = learner.random
    distro = random.choice(DISTROS)
    environ = spoil(random, healthy(random, distro, '3.12'), distro, '3.12', {PREFIX: 'mixed'})
    got = ask(learner, environ)
    expect(got.get(PREFIX) == 'mixed', f'{shown(environ)}: two distributions are in AMENT_PREFIX_PATH, and you name '
                                       f'{got}. ROS_DISTRO tells only which one was sourced last.')
    environ = {**healthy(random, distro, '3.12'), 'ROS_DISTRO': other(random, DISTROS, distro)}
    got = ask(learner, environ)
    expect(got == {PREFIX: 'mixed'}, f'{shown(environ)}: the path and ROS_DISTRO name two distributions; '
                                     f'you name {got}.')
    inside = {PREFIX: '/opt/ros/jazzy/opt/extra:/opt/ros/jazzy', 'ROS_DISTRO': 'jazzy'}
    got = ask(learner, inside)
    expect(got == {}, f'{shown(inside)}: both folders belong to one distribution; you name {got}.')


def test_python(learner):
    """One folder for another Python is enough, also beside a right one.

    Compare the part pythonX.Y of every folder, as a whole.
    """
    random = learner.random
    for python in ('3.12', '3.10', '3.1'):
        distro = random.choice(DISTROS)
        wrong = '3.12' if python == '3.1' else other(random, ('3.8', '3.11', '3.13'), python)
        good = healthy(random, distro, python)
        folder = f'/opt/ros/{distro}/lib/python{wrong}/site-packages'
        got = ask(learner, {**good, PYTHON: folder}, python)
        expect(got == {PYTHON: 'other Python'}, f'PYTHONPATH={folder} with Python {python}: you name {got}.')
        both = f'{good[PYTHON]}:{folder}'
        got = ask(learner, {**good, PYTHON: both}, python)
        expect(got == {PYTHON: 'other Python'}, f'PYTHONPATH={both} with Python {python}: you name {got}. '
                                                'A right folder does not excuse a wrong one.')
    plain = {**healthy(random, 'jazzy', '3.12'), PYTHON: '/home/ada/python/tools:/home/ada/my.python3'}
    got = ask(learner, plain)
    expect(got == {}, f'PYTHONPATH={plain[PYTHON]} has no part pythonX.Y; you name {got}.')


@pytest.mark.weight(2)
def test_domain(learner):
    """0 and 101 are domains; -1, 102, 5.0 and words are not.

    text.isdecimal() is true for digits only; then int(text) works.
    """
    good = healthy(learner.random, 'jazzy', '3.12')
    for text in ('0', '101', str(learner.random.randint(1, 100))):
        got = ask(learner, {**good, DOMAIN: text})
        expect(got == {}, f'ROS_DOMAIN_ID={text} is a domain (0 to 101); you name {got}.')
    for text in ('-1', '102', '232', '300', '5.0', 'seven', '7a'):
        got = ask(learner, {**good, DOMAIN: text})
        expect(got == {DOMAIN: 'not a domain'},
               f'ROS_DOMAIN_ID={text} is no whole number from 0 to 101; you name {got}.')


def test_range(learner):
    """OFF is 'off'; a value that ROS does not know is 'unknown'. The three others are fine.

    ROS distinguishes capital and small letters here.
    """
    good = healthy(learner.random, 'jazzy', '3.12')
    for text in RANGES:
        got = ask(learner, {**good, RANGE: text})
        expect(got == {}, f'ROS_AUTOMATIC_DISCOVERY_RANGE={text} is fine; you name {got}.')
    for text, fault in (('OFF', 'off'), ('LOCAL', 'unknown'), ('localhost', 'unknown'), ('off', 'unknown')):
        got = ask(learner, {**good, RANGE: text})
        expect(got == {RANGE: fault},
               f'ROS_AUTOMATIC_DISCOVERY_RANGE={text} gives {got}, expected {{{RANGE!r}: {fault!r}}}.')


@pytest.mark.weight(2)
def test_several_faults(learner):
    """Several faults at once are all named, and nothing else.

    One `if` for each variable; an early return hides the others.
    """
    random = learner.random
    choices = {PREFIX: ('not sourced', 'mixed'), PYTHON: ('other Python',), DOMAIN: ('not a domain',),
               RANGE: ('off', 'unknown')}
    for count in (2, 3, 4, 4):
        variables = random.sample(list(choices), count)
        faults = {variable: random.choice(choices[variable]) for variable in variables}
        distro, python = random.choice(DISTROS), random.choice(('3.10', '3.12'))
        environ = spoil(random, healthy(random, distro, python), distro, python, faults)
        got = ask(learner, environ, python)
        expect(len(got) >= count, f'{shown(environ)}, Python {python}: {count} things are wrong, and you name {got}. '
                                  'Do not stop at the first fault.')
        expect(got == faults, f'{shown(environ)}, Python {python}: you name {got}, expected {faults}.')
