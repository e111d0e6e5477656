"""Exercise 7.3's graphs: drawn as endpoints, and made of real nodes."""

import time
from contextlib import ExitStack
from difflib import get_close_matches

import rclpy
from rclpy.context import Context
from rclpy.exceptions import ROSInterruptException
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.qos_overriding_options import QoSOverridingOptions, QoSPolicyKind
from rosidl_runtime_py.utilities import get_message, get_service

from helpers.checks.chapter_07.findings import compare
from helpers.programs.faults.words import misspelt
from helpers.runner import about, expect
from helpers.runner.values import EnumAsName, EnumAsNumber

ROOMS = ('kitchen', 'cellar', 'attic', 'garage', 'hall')
TOPICS = ('temperature', 'odom', 'scan', 'battery', 'joystick', 'wheel_speed', 'humidity')
SERVICES = ('open_door', 'calibrate', 'take_picture', 'reset_map')
MESSAGES = ('std_msgs/msg/String', 'std_msgs/msg/Int32', 'std_msgs/msg/Float32', 'std_msgs/msg/Bool')
REQUESTS = ('std_srvs/srv/Trigger', 'std_srvs/srv/Empty', 'std_srvs/srv/SetBool')
STRONG = {'reliability': 'RELIABLE', 'durability': 'TRANSIENT_LOCAL'}
WEAK = {'reliability': 'BEST_EFFORT', 'durability': 'VOLATILE'}
DESCRIPTION = '/robot_description'
ROLES = ('publisher', 'subscription')  # of topics
CAUSES = ('name', 'nobody', 'type', 'reliability', 'durability')
WHY = {
    'name': 'A name that nobody sends on, and one of the same type that is nearly the same: `nearest` finds it.',
    'nobody': 'Nobody publishes or serves the name, and no name of the same type is near.',
    'type': 'The same name with two types: nothing is ever delivered.',
    'reliability': 'Only a subscription that asks for RELIABLE and is offered BEST_EFFORT gets nothing; the other way '
    'round it fits.',
    'durability': 'Only a subscription that asks for TRANSIENT_LOCAL and is offered VOLATILE gets nothing; the other '
    'way round it fits.',
}


def draw(random, *faults: str) -> tuple[list[dict], list[tuple]]:
    """Endpoints with these faults, among healthy ones, and the findings that are right.

    A fault is a cause; after ``service`` or ``description`` and a space, one of a service or of /robot_description.
    ``both`` is a topic of which neither policy fits.
    """
    while True:
        endpoints, expected = _draw(random, faults)
        if _unambiguous(endpoints, expected):
            random.shuffle(endpoints)
            return endpoints, expected


def _draw(random, faults):
    endpoints, expected = [], []
    topics, services = random.sample(TOPICS, len(TOPICS)), random.sample(SERVICES, len(SERVICES))
    messages = list(MESSAGES)

    def end(role, node, name, kind, **qos):
        policies = ('', '') if role in ('server', 'client') else ('RELIABLE', 'VOLATILE')
        endpoints.append(
            {'role': role, 'node': node, 'name': name, 'type': kind, **dict(zip(STRONG, policies, strict=True)), **qos}
        )

    for number, fault in enumerate(faults or ['healthy']):
        where, _, cause = fault.rpartition(' ')
        space = random.choice(['', f'/{random.choice(ROOMS)}'])
        sender, receiver = f'{space}/sender_{number}', f'{random.choice(["", space])}/receiver_{number}'
        service = where == 'service'
        roles = ('server', 'client') if service else ('publisher', 'subscription')
        kind, other = random.sample(REQUESTS if service else messages, 2)
        name = f'/{services.pop()}' if service else DESCRIPTION if where else f'{space}/{topics.pop()}'
        name_of_fault = 'waiting' if service else 'no_model' if where else 'no_data'
        asked, offered, wanted = name, {}, {}
        if cause == 'name':
            last = name.rpartition('/')[2]
            asked = random.choice([name.replace(last, misspelt(last, random)), f'/{random.choice(ROOMS)}_robot/{last}'])
            asked = name.replace(last, misspelt(last, random)) if where == 'description' else asked
            name_of_fault = 'no_data' if where == 'description' else name_of_fault
        elif cause == 'healthy':
            wanted = random.choice([{}, WEAK])
            offered = random.choice([{}, STRONG])
        else:
            policies = {'both': STRONG, 'nobody': {}, 'type': {}}.get(cause, [cause])
            offered, wanted = {p: WEAK[p] for p in policies}, {p: STRONG[p] for p in policies}
        if cause != 'nobody':
            end(roles[0], sender, name, kind, **offered)
        end(roles[1], receiver, asked, other if cause == 'type' else kind, **wanted)
        evidence = {'name': name, 'nobody': '', 'type': kind}
        for policy in offered if cause not in ('healthy',) else ():
            expected.append((name_of_fault, f'{receiver} {asked}', policy, WEAK[policy]))
        if cause in evidence:
            expected.append((name_of_fault, f'{receiver} {asked}', cause, evidence[cause]))
    # What is healthy: nobody hears it, nobody asks, and somebody asks for less than is offered.
    end('publisher', '/lonely', f'/{topics.pop()}', random.choice(MESSAGES), **random.choice([STRONG, WEAK]))
    end('server', '/idle', f'/{services.pop()}', random.choice(REQUESTS))
    name, kind = f'/{topics.pop()}', random.choice(MESSAGES)
    end('publisher', '/generous', name, kind, **STRONG)
    end('subscription', '/modest', name, kind, **WEAK)
    end('subscription', '/strict', name, kind, **STRONG)
    return endpoints, expected


def _unambiguous(endpoints, expected) -> bool:
    """Whether no name but the right one is near to one that nobody sends on, also for those who measure otherwise."""
    for _, where, cause, evidence in expected:
        if cause not in ('name', 'nobody'):
            continue
        name = where.split()[1]
        mine = next(end for end in endpoints if end['name'] == name)
        names = {
            end['name'] for end in endpoints if end['role'] in ('publisher', 'server') and end['type'] == mine['type']
        } - {name}
        same_end = {other for other in names if other.rpartition('/')[2] == name.rpartition('/')[2]}
        close = set(get_close_matches(name, names, 5, 0.6)) | same_end
        right = {evidence} if cause == 'name' else set()
        if close != right or (right and not same_end and not get_close_matches(name, right, 1, 0.78)):
            return False
    return True


def diagnose(learner, *faults: str, rule: str = '') -> None:
    """Draw a graph, ask the learner's diagnose_graph, and fail with words if it does not find what is expected."""
    endpoints, expected = draw(learner.random, *faults)
    named = {finding[1].split()[1] for finding in expected} | {finding[3] for finding in expected}
    given = '\n'.join(str(end) for end in endpoints if end['name'] in named)
    compare(learner.call('diagnose_graph', endpoints), expected, WHY, rule, given, _of_one_that_offers(endpoints))


def _of_one_that_offers(endpoints: list[dict]):
    """For `compare`: why a finding about a publisher or a server is none, and the rule that says so."""

    def why(finding) -> tuple[str, str]:
        node, _, name = finding[1].partition(' ')
        roles = {end['role'] for end in endpoints if (end['node'], end['name']) == (node, name)}
        offers = len(roles) == 1 and roles <= {'publisher', 'server'}
        return (f'{node} is a {roles.pop()} there: one that nobody uses is no finding.', 'fits') if offers else ('', '')

    return why


def other_type(learner) -> None:
    """A near name of another type is not what was meant; fails with words if the learner's diagnose_graph says so."""
    name = learner.random.choice(TOPICS)
    kind, other = learner.random.sample(MESSAGES, 2)
    ends = [('publisher', '/sender', f'/{name}', kind), ('subscription', '/receiver', f'/robot/{name}', other)]
    endpoints = [{'role': role, 'node': node, 'name': topic, 'type': one, **STRONG} for role, node, topic, one in ends]
    compare(
        learner.call('diagnose_graph', endpoints),
        [('no_data', f'/receiver /robot/{name}', 'nobody', '')],
        {**WHY, 'name': 'Only a name with the same type can be meant.'},
        'nobody',
        str(endpoints),
    )


def same_name(learner) -> None:
    """Each of two nodes with one name, and each name of a node, is a finding; fails with words if one is missed."""
    names, kind = learner.random.sample(TOPICS, 2), learner.random.choice(MESSAGES)
    endpoints = [
        {'role': 'subscription', 'node': node, 'name': f'/{topic}', 'type': kind, **STRONG}
        for node, topic in (('/one', names[0]), ('/other', names[0]), ('/one', names[1]))
    ]
    compare(
        learner.call('diagnose_graph', endpoints),
        [('no_data', f'{end["node"]} {end["name"]}', 'nobody', '') for end in endpoints],
        {'nobody': 'Every subscription is judged, also where two have one name, or one node.'},
        'all',
        str(endpoints),
    )


def other_description(learner) -> None:
    """A topic whose name only begins or ends with robot_description is one as others, and so is a service of that name.

    Fails with words if diagnose_graph says `no_model`.
    """
    space, kind = learner.random.choice(ROOMS), learner.random.choice(MESSAGES)
    for name in (f'/{space}{DESCRIPTION}', f'{DESCRIPTION}_{space}'):
        compare(
            learner.call(
                'diagnose_graph', [{'role': 'subscription', 'node': '/receiver', 'name': name, 'type': kind, **STRONG}]
            ),
            [('no_data', f'/receiver {name}', 'nobody', '')],
            {'nobody': f'The fault `no_model` is only for the name {DESCRIPTION}.'},
            'fault',
        )
    client = {'role': 'client', 'node': '/receiver', 'name': DESCRIPTION, 'type': REQUESTS[0]}
    compare(
        learner.call('diagnose_graph', [{**client, 'reliability': '', 'durability': ''}]),
        [('waiting', f'/receiver {DESCRIPTION}', 'nobody', '')],
        {'nobody': f'The fault `no_model` is only for the topic {DESCRIPTION}: a service may have that name, too.'},
        'fault',
        str(client),
    )


def two_deaf(learner) -> None:
    """Who gets nothing was not meant by another one who gets nothing; fails with words if diagnose_graph says so."""
    name, kind = learner.random.choice(TOPICS), learner.random.choice(MESSAGES)
    endpoints = [
        {'role': 'subscription', 'node': node, 'name': topic, 'type': kind, **STRONG}
        for node, topic in (('/one', f'/{name}'), ('/other', f'/robot/{name}'))
    ]
    compare(
        learner.call('diagnose_graph', endpoints),
        [('no_data', f'{end["node"]} {end["name"]}', 'nobody', '') for end in endpoints],
        {**WHY, 'nobody': 'The name that is near has no publisher either: it cannot be meant.'},
        'nobody',
        str(endpoints),
    )


def neighbours(learner) -> None:
    """Rules `name`, `type` and `fits` where names, types or nodes are shared; fails with words if one is broken.

    Meant is also a name that another one hears, that the node itself publishes, or whose policies do not fit either.
    Two types may have the same last word, and a node may hear itself. A name with a capital letter is another one.
    Where the name is published with another type, no near one was meant.
    """
    random = learner.random
    one, two, three, four, five = random.sample(TOPICS, 5)
    kind, other = random.choice(['String', 'Int32', 'Float32']), 'example_interfaces'
    ends = [
        ('publisher', '/sender', f'/{one}', f'std_msgs/msg/{kind}', STRONG),
        ('subscription', '/hears', f'/{one}', f'std_msgs/msg/{kind}', STRONG),
        ('subscription', '/deaf', f'/robot/{one}', f'std_msgs/msg/{kind}', WEAK),
        ('publisher', '/both', f'/robot/{two}', MESSAGES[3], WEAK),
        ('subscription', '/both', f'/{two}', MESSAGES[3], STRONG),
        ('publisher', '/echo', f'/{three}', MESSAGES[3], STRONG),
        ('subscription', '/echo', f'/{three}', MESSAGES[3], STRONG),
        ('publisher', '/sender', f'/{four}', f'{other}/msg/{kind}', STRONG),
        ('subscription', '/typed', f'/{four}', f'std_msgs/msg/{kind}', STRONG),
        ('publisher', '/sender', f'/robot/{four}', f'std_msgs/msg/{kind}', STRONG),
        ('publisher', '/sender', f'/{five.capitalize()}', MESSAGES[3], STRONG),
        ('subscription', '/small', f'/{five}', MESSAGES[3], STRONG),
    ]
    endpoints = [{'role': role, 'node': node, 'name': name, 'type': of, **qos} for role, node, name, of, qos in ends]
    expected = [
        ('no_data', f'/deaf /robot/{one}', 'name', f'/{one}'),
        ('no_data', f'/both /{two}', 'name', f'/robot/{two}'),
        ('no_data', f'/typed /{four}', 'type', f'{other}/msg/{kind}'),
        ('no_data', f'/small /{five}', 'name', f'/{five.capitalize()}'),
    ]
    random.shuffle(endpoints)
    healthy = [end for end in endpoints if end['name'] == f'/{three}']
    with about('fits'):
        compare(learner.call('diagnose_graph', healthy), [], WHY, 'fits', '\n'.join(map(str, healthy)))
    compare(learner.call('diagnose_graph', endpoints), expected, WHY, given='\n'.join(map(str, endpoints)))


def topic_and_service(learner) -> None:
    """Topics and services have names of their own; fails with words if diagnose_graph takes one for the other."""
    topic, service = learner.random.choice(TOPICS), learner.random.choice(SERVICES)
    ends = [
        ('publisher', '/sender', f'/{service}', MESSAGES[0]),
        ('client', '/asker', f'/{service}', REQUESTS[0]),
        ('server', '/helper', f'/{topic}', REQUESTS[0]),
        ('subscription', '/receiver', f'/{topic}', MESSAGES[0]),
    ]
    endpoints = [
        {'role': role, 'node': node, 'name': name, 'type': kind, 'reliability': '', 'durability': ''}
        | (STRONG if kind in MESSAGES else {})
        for role, node, name, kind in ends
    ]
    learner.random.shuffle(endpoints)
    compare(
        learner.call('diagnose_graph', endpoints),
        [('waiting', f'/asker /{service}', 'nobody', ''), ('no_data', f'/receiver /{topic}', 'nobody', '')],
        {**WHY, 'nobody': 'A publisher serves no client, and a server publishes nothing, also under the same name.'},
        'nobody',
        '\n'.join(map(str, endpoints)),
    )


def started_again(learner, fault: str, seconds: float, rule: str, apart: bool = False) -> None:
    """Start a deaf node again with the learner's arguments, and fail with words if it does not hear.

    Names without a leading slash mean something else in a namespace, where the node is.

    :param apart: the node is in no namespace, but the name that it uses is.
    """
    deaf = ['', '']
    while deaf[0].count('/') != (1 if apart else 2) or (apart and deaf[1].count('/') < 2):
        endpoints, expected = draw(learner.random, fault)
        deaf = expected[0][1].split()
    mine = next(end for end in endpoints if [end['node'], end['name']] == deaf)
    other = next(end for end in endpoints if end['node'].endswith('/sender_0'))
    arguments = learner.call('repair_finding_of_graph', list(expected[0]))
    with System(learner.context.get_domain_id()) as system, about(rule):
        publisher, heard = system.add(other), restart(system, mine, arguments)
        expect(
            heard.hears(publisher, seconds),
            f'For {expected[0]} repair_graph gave {arguments}: started again with that, {deaf[0]} still hears nothing.',
            rule,
        )
    value = arguments[1].rpartition(':=')[2]
    expect(
        value == value.lower(),
        f'For {expected[0]} repair_graph gave {arguments}. The value is in small letters: {value.lower()}.',
        rule,
    )


def asks_again(learner, seconds: float) -> None:
    """Rule `remapping` for a client: started again with the learner's arguments, it finds the server that was meant."""
    endpoints, expected = draw(learner.random, 'service name')
    deaf = expected[0][1].split()
    mine = next(end for end in endpoints if [end['node'], end['name']] == deaf)
    other = next(end for end in endpoints if end['node'].endswith('/sender_0'))
    with about('remapping'):
        arguments = learner.call('repair_finding_of_graph', list(expected[0]))
    with System(learner.context.get_domain_id()) as system, about('remapping'):
        system.add(other)
        client = restart(system, mine, arguments)
        expect(
            client.wait_for_service(seconds),
            f'For {expected[0]} repair_graph gave {arguments}: started again with that, {deaf[0]} finds no server.',
            'remapping',
        )


def publishers_beside(subscription: dict, space: str) -> list[dict]:
    """Two publishers on the topic of a subscription: one of the same node, and one of a node in this namespace."""
    own = {**subscription, 'role': 'publisher'}
    return [own, {**own, 'node': f'{space}/second_mouth'}]


def like_usual_ones(node: str, kind: str) -> list[dict]:
    """Subscriptions of which `usual` is false, with names that are a little like those of which it is true."""
    space = node.rpartition('/')[0]
    names = (f'{space}/clock', f'{space}/_internal/rosout')
    return [{'role': 'subscription', 'node': node, 'name': name, 'type': kind, **STRONG} for name in names]


def read(learner, there: list[dict], secret: dict) -> None:
    """Start nodes with these endpoints, and fail with words if the learner's read_topics sees anything else.

    :param secret: an endpoint of which `usual` is true.
    """
    with System(learner.context.get_domain_id()) as system, about('read'):
        for endpoint in (secret, *there):
            system.add(endpoint)
        seen = learner.call('endpoints_here', len(there), 5.0)
        # One more than there are: it reads again and again, and what is kept from call to call comes twice.
        again = learner.call('endpoints_here', len(there) + 1, 0.6)
    check_read(seen, there)
    _check_once(again, there)


def _check_once(seen: list[dict], there: list[dict]) -> None:
    """Fail with words if an endpoint is in the list more often than it is there."""
    for end in seen:
        times = seen.count(end)
        expect(
            times <= max(1, there.count(end)),
            f'You have {end} {times} times: one endpoint for each. Do you read a topic once for each of its types, or '
            'keep a list from call to call (`found=[]` after `def`)?',
            'read',
        )


def check_read(seen, there: list[dict]) -> None:
    """Fail with words if `seen`, by the learner's read_topics, is anything else than the endpoints that are there."""
    expect(isinstance(seen, list) and all(isinstance(end, dict) for end in seen), f'You return {seen!r}.', 'read')
    for end in seen:
        members = [key for key, value in end.items() if isinstance(value, EnumAsName | EnumAsNumber)]
        expect(
            not members,
            f'You have {end}, whose {members and members[0]} is a member of an enumeration, and no string: write '
            '`.name` for its name.',
            'read',
        )
        expect(
            not str(end.get('node')).rpartition('/')[2].startswith('_'),
            f'You have {end}, which is left out by `usual`.',
            'usual',
        )
    for end in seen:
        expect(
            end.get('role') in ROLES,
            f'You have {end}, whose role is {end.get("role")!r}. For a topic there are {" and ".join(ROLES)}.',
            'read',
        )
    _check_once(seen, there)
    for endpoint in there:
        twins = [
            end
            for end in seen
            if (end.get('role'), end.get('name')) == (endpoint['role'], endpoint['name'])
            and end.get('node') != '/_secret'
            and end not in there
        ]
        # Several may have this name: what was meant is the one that differs least.
        twin = min(twins, key=lambda one: sum(one.get(key) != endpoint[key] for key in endpoint), default=None)
        wrong = [key for key in endpoint if twin and twin.get(key) != endpoint[key]]
        expect(
            endpoint in seen,
            f'There is {endpoint}; ' + (f'you have {twin}.' if twin else 'you have it not.'),
            'node-name' if wrong == ['node'] else 'read',
        )
    for end in seen:
        expect(end in there, f'You have {end}, which is not there.', 'read')


class System:
    """Real nodes for endpoints, each in a participant of its own; use it in a `with` block."""

    def __init__(self, domain_id: int):
        self.domain_id = domain_id
        self._stack = ExitStack()
        self._executor: SingleThreadedExecutor | None = None

    def __enter__(self) -> 'System':
        return self

    def __exit__(self, kind, error, tb) -> None:
        self._stack.close()

    def add(self, endpoint: dict, arguments=()):
        """Make the endpoint's node with these ROS arguments. Returns the publisher, list of messages, or client."""
        context = Context()
        context.init(domain_id=self.domain_id)
        self._stack.callback(context.try_shutdown)
        space, _, name = endpoint['node'].rpartition('/')
        node = Node(
            name,
            namespace=space,
            context=context,
            use_global_arguments=False,
            start_parameter_services=False,
            enable_rosout=False,
            cli_args=['--ros-args', *arguments] if arguments else None,
        )
        self._stack.callback(node.destroy_node)
        executor = SingleThreadedExecutor(context=context)
        executor.add_node(node)
        self._stack.callback(executor.shutdown, 1)
        if endpoint['role'] == 'server':
            return node.create_service(get_service(endpoint['type']), endpoint['name'], lambda _, response: response)
        if endpoint['role'] == 'client':
            return node.create_client(get_service(endpoint['type']), endpoint['name'])
        qos = QoSProfile(
            depth=5,
            reliability=ReliabilityPolicy[endpoint['reliability']],
            durability=DurabilityPolicy[endpoint['durability']],
        )
        kind = get_message(endpoint['type'])
        if endpoint['role'] == 'publisher':
            return node.create_publisher(kind, endpoint['name'], qos)
        heard = Heard(executor)
        node.create_subscription(
            kind,
            endpoint['name'],
            heard.append,
            qos,
            qos_overriding_options=QoSOverridingOptions([QoSPolicyKind.RELIABILITY, QoSPolicyKind.DURABILITY]),
        )
        return heard


class Heard(list):
    """The messages of a subscription, while its `executor` is spun."""

    def __init__(self, executor):
        super().__init__()
        self.executor = executor

    def hears(self, publisher, timeout: float) -> bool:
        """Whether a message of the publisher arrives within `timeout` seconds."""
        end = time.monotonic() + timeout
        while not self and time.monotonic() < end:
            publisher.publish(publisher.msg_type())
            self.executor.spin_once(timeout_sec=0.05)
        return bool(self)


def restart(system: System, endpoint: dict, arguments):
    """Make the endpoint's node with the learner's arguments; fail with words if they are none."""
    fits = (
        isinstance(arguments, list)
        and len(arguments) == 2
        and all(isinstance(one, str) for one in arguments)
        and arguments[0] in ('-r', '--remap', '-p', '--param')
    )
    expect(fits, f'repair_graph returned {arguments!r}; expected two texts, the first one -r or -p.')
    try:
        return system.add(endpoint, arguments)
    except (rclpy._rclpy_pybind11.RCLError, ROSInterruptException, ValueError, RuntimeError) as error:
        expect(False, f'The node does not start with {" ".join(arguments)}: {error}')
