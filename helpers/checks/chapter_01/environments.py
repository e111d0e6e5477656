"""Environments with faults and without, most of them drawn: for exercise 1.2."""

from dataclasses import dataclass
from random import Random

from helpers.runner import about, expect
from helpers.runner.first_call import FirstCall

DISTROS = ('foxy', 'humble', 'iron', 'jazzy', 'kilted', 'lyrical')
INVENTED = ('meadow', 'nimbus', 'orchard')  # nobody knows what a distribution will be called
KNOWN_TOO = ('rolling', 'noetic')  # of which the other cases name none
PEOPLE = ('ada', 'linus', 'grace', 'alan')
PYTHONS = ('3.8', '3.10', '3.11', '3.12', '3.13')
RANGES = ('SUBNET', 'LOCALHOST', 'SYSTEM_DEFAULT')
BAD_DOMAINS = ('-1', '102', '232', '233', '1000', '5.0', 'seven', 'domain 3', '0x10', '7th', '²')
BAD_RANGES = ('LOCAL', 'localhost', 'off', 'ON', 'SUBNETS', 'SUB', 'OFFLINE', ' LOCALHOST', 'SUBNET ')
LETTERS = 'Names of folders are compared letter by letter: a capital letter makes another name.'
ANY_NAME = 'Two distributions are in the path: whatever stands behind /opt/ros/ is the name of one.'
OTHER_PATHS = 'Of the variables with paths only AMENT_PREFIX_PATH and PYTHONPATH count here.'
PREFIX, PYTHON, DOMAIN, RANGE = 'AMENT_PREFIX_PATH', 'PYTHONPATH', 'ROS_DOMAIN_ID', 'ROS_AUTOMATIC_DISCOVERY_RANGE'
# The rules of each variable; the first one is broken if a good value is called a fault
_RULES = {
    PREFIX: ('workspace', 'mixed', 'ros-distro', 'not-sourced'),
    PYTHON: ('python',),
    DOMAIN: ('domain',),
    RANGE: ('unknown', 'off'),
}


@dataclass(frozen=True)
class Case:
    """One environment, what is wrong with it, and the rule that a wrong answer breaks."""

    rule: str
    environ: dict
    wanted: dict
    why: str = ''
    python: str = '3.12'


def healthy(random: Random, distro: str, python: str = '3.12', workspaces: int | None = None) -> dict:
    """An environment with nothing wrong: a distribution, perhaps workspaces above it, perhaps a domain and a range."""
    count = random.randint(0, 2) if workspaces is None else workspaces
    folders = [f'/home/{random.choice(PEOPLE)}/{random.choice(DISTROS)}_ws/install' for _ in range(count)]
    prefixes = [*folders, f'/opt/ros/{distro}']
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


def other(random: Random, values, *but):
    """One of the values that is none of `but`."""
    return random.choice([value for value in values if value not in but])


def cases(random: Random) -> list[Case]:
    """Environments for each rule; those with one fault come first."""
    distro = random.choice(DISTROS)
    good = healthy(random, distro)
    return [
        *_missing(distro),
        Case('dictionary', healthy(random, distro, workspaces=0), {}, 'Nothing is wrong with it.'),
        *_workspaces(random),
        *_prefixes(random, distro, good),
        *_pythons(random, distro),
        *_domains(random, good),
        *_ranges(random, good),
        *_long_prefixes(random),
        *_long_pythons(random),
        Case('workspace', {**healthy(random, distro, workspaces=0), **_others(random, distro)}, {}, OTHER_PATHS),
        Case('python', {PREFIX: f'/opt/ros/{distro}', **_others(random, distro)}, {}, OTHER_PATHS),
    ]


def _workspaces(random: Random) -> list[Case]:
    made = []
    for count in (1, 2):
        environ = healthy(random, random.choice(DISTROS), workspaces=count)
        made.append(Case('workspace', environ, {}, 'The folders below /home are workspaces; their names say nothing.'))
    course = {PREFIX: f'/home/{random.choice(PEOPLE)}/ros2-course/.venv', 'ROS_DISTRO': random.choice(DISTROS)}
    distro = random.choice(DISTROS)
    copies = [
        {PREFIX: f'{place}/opt/ros/{other(random, DISTROS, distro)}:/opt/ros/{distro}'}
        for place in (f'/home/{random.choice(PEOPLE)}', '/srv')
    ]
    nameless = {PREFIX: f'/home/{random.choice(PEOPLE)}/{random.choice(DISTROS)}_ws/install:{course[PREFIX]}'}
    return [
        *made,
        Case('workspace', course, {}, 'A prefix outside of /opt/ros is a prefix, too.'),
        Case('workspace', nameless, {}, 'There are only workspaces, and ROS_DISTRO is missing: nothing is mixed.'),
        *[Case('workspace', copy, {}, 'Only what begins with /opt/ros/ belongs to a distribution.') for copy in copies],
    ]


def _prefixes(random: Random, distro: str, good: dict) -> list[Case]:
    second = other(random, DISTROS, distro)
    more = random.sample([one for one in DISTROS if one not in (distro, second)], 3)
    two = [f'/opt/ros/{distro}', f'/opt/ros/{second}']
    mixed = {PREFIX: 'mixed'}
    sourced = 'Two distributions are in the path; ROS_DISTRO tells only which one was sourced last.'
    of_another = 'AMENT_PREFIX_PATH names one distribution; what is in PYTHONPATH does not count for it.'
    inside = f'/opt/ros/{distro}/opt/extra:/opt/ros/{distro}'
    thrice = f'/opt/ros/{distro}:{inside}'
    longer = f'{distro}{random.choice(("_old", "-test", "2"))}'  # a name that begins like the other one
    said = f'/home/{random.choice(PEOPLE)}/{second}_ws/install:/opt/ros/{distro}'  # only a workspace has that name
    return [
        Case('not-sourced', {}, {PREFIX: 'not sourced'}),
        Case('not-sourced', {PREFIX: ''}, {PREFIX: 'not sourced'}),
        Case('not-sourced', {**good, PREFIX: ''}, {PREFIX: 'not sourced'}),
        Case('mixed', {**good, PREFIX: good[PREFIX] + f':/opt/ros/{second}'}, mixed, sourced),
        Case('mixed', {**good, PREFIX: ':'.join(two[::-1]), 'ROS_DISTRO': second}, mixed, sourced),
        *[
            Case('mixed', {PREFIX: f'/opt/ros/{distro}:/opt/ros/{one}', 'ROS_DISTRO': one}, mixed, sourced)
            for one in more  # of so many pairs, few know more than one by heart
        ],
        *[
            Case('mixed', {PREFIX: f'{two[0]}:/opt/ros/{one}'}, mixed, ANY_NAME)
            for one in (random.choice(INVENTED), *KNOWN_TOO)
        ],
        Case('mixed', {PREFIX: f'{two[0]}:/opt/ros/{distro.capitalize()}'}, mixed, LETTERS),
        Case('mixed', {PREFIX: ':'.join(two)}, mixed, 'Two distributions are in the path.'),
        Case('mixed', {PREFIX: ':'.join(two), 'ROS_DISTRO': ''}, mixed, 'Two distributions are in the path.'),
        *[
            Case('mixed', {PREFIX: ':'.join(two + [f'/opt/ros/{more[0]}']), **said}, mixed, 'Three are in the path.')
            for said in ({}, {'ROS_DISTRO': random.choice((distro, second, more[0]))})
        ],
        Case('mixed', {PREFIX: f'{two[0]}:{two[1]}/opt/extra'}, mixed, 'Two distributions are in the path.'),
        Case('mixed', {PREFIX: inside, 'ROS_DISTRO': distro}, {}, 'Both folders belong to one distribution.'),
        Case('mixed', {PREFIX: thrice, 'ROS_DISTRO': distro}, {}, 'All three folders belong to one distribution.'),
        Case('mixed', {PREFIX: two[0], PYTHON: f'{two[1]}/lib/python3.12/site-packages'}, {}, of_another),
        *[
            Case('ros-distro', environ, mixed, 'Path and ROS_DISTRO name two distributions.')
            for environ in ({**good, 'ROS_DISTRO': second}, {PREFIX: said, 'ROS_DISTRO': second})
        ],
        *[
            Case('ros-distro', {PREFIX: f'/opt/ros/{one}', 'ROS_DISTRO': two}, mixed, 'These are two names.')
            for one, two in ((distro, longer), (longer, distro))
        ],
        *[
            Case('ros-distro', {PREFIX: f'/opt/ros/{distro}', 'ROS_DISTRO': one}, mixed, LETTERS)
            for one in (distro.capitalize(), distro.upper())
        ],
        Case('ros-distro', {PREFIX: '/opt/ros/Meadow', 'ROS_DISTRO': 'Meadow'}, {}, LETTERS),
    ]


def _long_prefixes(random: Random) -> list[Case]:
    """Paths of up to seven folders: of one distribution or of two, with workspaces in any place between them."""
    first, second, third = random.sample(DISTROS, 3)
    mine = [f'/opt/ros/{first}', f'/opt/ros/{first}/opt/extra', f'/opt/ros/{first}/']
    places = ('/opt/ros2', '/opt', '/srv/ros', '/opt/rosbots', f'/home/{random.choice(PEOPLE)}/ros')
    elsewhere = [f'{place}/{other(random, DISTROS, first)}' for place in random.sample(places, 4)]
    two = [elsewhere[0], *mine[:2], elsewhere[1], f'/opt/ros/{second}', elsewhere[2]]
    within = [mine[0], elsewhere[0], f'/opt/ros/{second}/lib', elsewhere[1], mine[1]]
    one = [elsewhere[0], *random.sample([*mine, *elsewhere[1:3]], 5), elsewhere[3]]
    mixed, alone = {PREFIX: 'mixed'}, 'All that is in /opt/ros is of one distribution; the other folders are elsewhere.'
    both = f'There is {first}, and there is {second}, with other folders between them.'
    return [
        *[Case('workspace', {PREFIX: f'{folder}:{mine[0]}'}, {}, alone) for folder in elsewhere],
        Case('workspace', {PREFIX: ':'.join(one), 'ROS_DISTRO': first}, {}, alone),
        *[
            Case('mixed', {PREFIX: ':'.join(folders), **said}, mixed, both)
            for folders in (two, two[::-1], within)
            for said in ({}, {'ROS_DISTRO': random.choice((first, second))})
        ],
        Case('ros-distro', {PREFIX: ':'.join(one), 'ROS_DISTRO': third}, mixed, 'Path and ROS_DISTRO name two.'),
    ]


def _long_pythons(random: Random) -> list[Case]:
    """Three folders of which one is for another Python, in each place, and at each depth."""
    python, wrong = random.sample(('3.9', '3.10', '3.11', '3.13'), 2)
    same_minor = f'{random.choice((2, 4))}.{python.partition(".")[2]}'
    good = [f'/home/{random.choice(PEOPLE)}/{name}/python{python}' for name in ('tools', 'lib')]
    all_right = {PREFIX: f'/opt/ros/{random.choice(DISTROS)}', PYTHON: ':'.join([*good, f'/usr/lib/python{python}'])}
    made = [Case('python', all_right, {}, 'All three folders are for this Python: each name ends at a colon.', python)]
    for place, (version, rest) in enumerate(
        ((wrong, ''), (same_minor, '/site-packages'), (wrong, '/dist-packages/deep/in/it'))
    ):
        folders = list(good)
        folders.insert(place, f'/usr/lib/python{version}{rest}')
        environ = {PREFIX: f'/opt/ros/{random.choice(DISTROS)}', PYTHON: ':'.join(folders)}
        why = f'One of its three folders is for Python {version}.'
        made.append(Case('python', environ, {PYTHON: 'other Python'}, why, python))
    return made


def _pythons(random: Random, distro: str) -> list[Case]:
    made = []
    for python in ('3.12', random.choice(('3.10', '3.11')), '3.1'):
        wrong = '3.12' if python == '3.1' else other(random, PYTHONS, python)
        folder = f'/opt/ros/{distro}/lib/python{wrong}/site-packages'
        environ = healthy(random, distro, python)
        both = [environ[PYTHON], folder]
        random.shuffle(both)
        fault = {PYTHON: 'other Python'}
        made += [
            Case('python', environ, {}, 'All folders are for this Python.', python),
            Case('python', {**environ, PYTHON: folder}, fault, 'Its only folder is for another Python.', python),
            Case(
                'python',
                {**environ, PYTHON: ':'.join(both)},
                fault,
                'A right folder does not excuse a wrong one.',
                python,
            ),
        ]
    good, elsewhere = healthy(random, distro), f'/home/{random.choice(PEOPLE)}/tools_ws/install/lib'
    made += [
        Case(
            'python',
            {**good, PYTHON: f'{good[PYTHON]}:{elsewhere}/python{wrong}/site-packages'},
            {PYTHON: 'other Python'},
            f'One of its folders is for Python {wrong}; it is no folder of a distribution, and counts all the same.',
        )
        for wrong in ('2.7', '3.1', '3.8', random.choice(('3.10', '3.11', '3.13')))
    ]
    return [*made, *_odd_pythons(random, healthy(random, distro), elsewhere)]


def _odd_pythons(random: Random, good: dict, elsewhere: str) -> list[Case]:
    """Folders with names that are nearly a Python's, or with several, or in unusual places."""
    tools = {**good, PYTHON: '/home/ada/python/tools:/home/ada/my.python3:/usr/lib/python3/dist-packages'}
    within = {
        **good,
        PYTHON: f'{good[PYTHON]}:/home/{random.choice(PEOPLE)}/mypython{random.choice(("2.7", "3.10"))}/lib',
    }
    one, ten = random.sample(('3.1', '3.10'), 2)
    return [
        Case(
            'python',
            {PREFIX: good[PREFIX], PYTHON: f'{elsewhere}/python{ten}/site-packages'},
            {PYTHON: 'other Python'},
            '3.1 and 3.10 are two versions. Compare texts: as numbers the two are equal.',
            one,
        ),
        Case(
            'python',
            {PREFIX: good[PREFIX], PYTHON: f'/srv/{random.choice(PEOPLE)}/python3.10/site-packages'},
            {PYTHON: 'other Python'},
            'One part of its folder is python3.10, whatever the part before it is called.',
        ),
        *[
            Case(
                'python',
                {PREFIX: good[PREFIX], PYTHON: f'/opt/python{above}/lib/python{below}/site-packages'},
                {PYTHON: 'other Python'},
                'A part pythonX.Y counts wherever it stands: here there are two, and one is for another Python.',
            )
            for above, below in (('3.12', '3.10'), ('3.10', '3.12'))
        ],
        Case(
            'python',
            {PREFIX: good[PREFIX], PYTHON: f'/srv/Python{random.choice(("2.7", "3.10"))}/lib:{good[PYTHON]}'},
            {},
            'Names of folders are compared letter by letter: a part with a capital P is not pythonX.Y.',
        ),
        Case('python', tools, {}, 'PYTHONPATH has no part pythonX.Y: python3 alone is none.'),
        Case('python', within, {}, 'No part is pythonX.Y and nothing more, as it stands between two slashes.'),
    ]


def _domains(random: Random, good: dict) -> list[Case]:
    fine = ['0', '100', '101', str(random.randint(1, 100))]
    return [
        *[Case('domain', {**good, DOMAIN: text}, {}, 'That is a domain.') for text in fine],
        *[
            Case('domain', {**good, DOMAIN: text}, {DOMAIN: 'not a domain'}, 'Domains are whole numbers, 0 to 101.')
            for text in BAD_DOMAINS
        ],
    ]


def _ranges(random: Random, good: dict) -> list[Case]:
    return [
        *[Case('unknown', {**good, RANGE: text}, {}, 'That is one of the four.') for text in RANGES],
        *[
            Case('off', {**good, **more, RANGE: 'OFF'}, {RANGE: 'off'}, 'With OFF, nodes do not find each other.')
            for more in ({}, {'ROS_LOCALHOST_ONLY': '1'})
        ],
        *[
            Case('unknown', {**good, RANGE: text}, {RANGE: 'unknown'}, 'That is none of the four, letter by letter.')
            for text in BAD_RANGES
        ],
    ]


def _missing(distro: str) -> list[Case]:
    path = {PREFIX: f'/opt/ros/{distro}'}
    empty = {**path, 'ROS_DISTRO': '', PYTHON: '', DOMAIN: '', RANGE: ''}
    return [
        Case('missing', path, {}, 'What is missing is no fault.'),
        Case('missing', empty, {}, 'Empty is like missing.'),
    ]


def _others(random: Random, distro: str) -> dict:
    """Variables that have to do with ROS, or had so in an older distribution, and of which the card says nothing."""
    second = other(random, DISTROS, distro)
    return {
        'ROS_LOCALHOST_ONLY': '1',
        'ROS_VERSION': '1',
        'ROS_PYTHON_VERSION': '2',
        'CMAKE_PREFIX_PATH': f'/opt/ros/{second}',
        'LD_LIBRARY_PATH': f'/opt/ros/{second}/lib',
        'PATH': f'/opt/ros/{second}/bin:/usr/lib/python2.7/bin',
    }


def several(random: Random, counts=(2, 3, 4, 4)) -> list[Case]:
    """Environments with so many faults at once; of those with four, one after the other has each kind of fault."""
    choices = {
        PREFIX: ('not sourced', 'mixed'),
        PYTHON: ('other Python',),
        DOMAIN: ('not a domain',),
        RANGE: ('off', 'unknown'),
    }
    made, full = [], random.randint(0, 1)
    for count in counts:
        variables = random.sample(list(choices), count)
        full += count == len(choices)
        faults = {
            variable: choices[variable][full % len(choices[variable])]
            if count == len(choices)
            else random.choice(choices[variable])
            for variable in variables
        }
        distro, python = random.choice(DISTROS), random.choice(('3.10', '3.12'))
        environ = healthy(random, distro, python)
        for variable, fault in faults.items():
            _spoil(random, environ, variable, fault, python)
        made.append(
            Case('every-fault', environ, faults, f'{count} things are wrong. Do not stop at the first one.', python)
        )
    return made


def _spoil(random: Random, environ: dict, variable: str, fault: str, python: str) -> None:
    distro = environ['ROS_DISTRO']
    match fault:
        case 'not sourced':
            environ.pop(PREFIX)
        case 'mixed':
            environ[PREFIX] += f':/opt/ros/{other(random, DISTROS, distro)}'
        case 'other Python':
            environ[PYTHON] += f':/opt/ros/{distro}/lib/python{other(random, PYTHONS, python)}/site-packages'
        case 'not a domain':
            environ[variable] = random.choice(BAD_DOMAINS)
        case 'off':
            environ[variable] = 'OFF'
        case 'unknown':
            environ[variable] = random.choice(BAD_RANGES)


def check(learner, asked: list[Case]) -> None:
    """`diagnose` says what is wrong with these environments, and nothing else."""
    first = FirstCall(learner, 'diagnose', 'dictionary')
    for case in asked:
        # The version is left out where it is the default: that must be 3.12.
        given = [] if case.python == '3.12' else [case.python]
        with about(case.rule):
            got = learner.call('diagnose', case.environ, *given)
        if got != case.wanted:
            first.check_again()
        first.note(got, case.environ, *given)
        shown = ', '.join(f'{name}={value}' for name, value in case.environ.items()) or 'no variable at all'
        expect(
            isinstance(got, dict),
            f'With {shown}, diagnose gives {got!r}; expected a dictionary, also when nothing is wrong.',
            'dictionary',
        )
        right = [name for name in got if not got[name]]
        expect(
            not right,
            f'With {shown}, diagnose gives {got}: {right and right[0]} is no fault, and must not be in the dictionary.',
            'dictionary',
        )
        names = sorted(map(repr, set(got) - set(_RULES)))  # of any types
        expect(
            not names,
            f'With {shown}, diagnose gives {got}. Its keys are the names of variables, and {names and names[0]} is '
            'none of the four that can be wrong.',
            'dictionary',
        )
        rule, why = _explained(case, got)
        expect(
            got == case.wanted,
            f'{why} With {shown} and Python {case.python}, diagnose gives {got}, expected {case.wanted}.'.lstrip(),
            rule,
        )
        first.check_unchanged()


def _explained(case: Case, got: dict) -> tuple[str, str]:
    """The rule that a wrong answer breaks, and a sentence on it."""
    wrong = [variable for variable in _RULES if got.get(variable) != case.wanted.get(variable)]
    mine = [variable for variable, rules in _RULES.items() if case.rule in rules]
    if not wrong or case.rule in ('missing', 'every-fault') or set(mine) & set(wrong):
        return case.rule, case.why
    return _RULES[wrong[0]][0], f'Nothing is wrong with {wrong[0]}.' if wrong[0] not in case.wanted else ''
