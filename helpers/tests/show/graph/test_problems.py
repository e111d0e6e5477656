"""What does not fit, in words; and what fits, in silence."""

import re
from xml.etree import ElementTree

import pytest
from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy

from helpers.kernel.qos import fit, mismatches, words
from helpers.show.graph.drawing import GraphPicture
from helpers.show.graph.links import Link
from helpers.show.graph.model import Graph
from helpers.show.graph.problems import misspelt

STRING, INT = 'std_msgs/msg/String', 'std_msgs/msg/Int32'
PLAIN = QoSProfile(depth=10)
BEST_EFFORT = QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT)
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def pub(node, name, kind=STRING, qos=PLAIN):
    return Link(node, 'publisher', name, kind, qos)


def sub(node, name, kind=STRING, qos=PLAIN):
    return Link(node, 'subscription', name, kind, qos)


def graph(*links, nodes=()):
    return Graph(7, tuple(sorted({*nodes, *(link.node for link in links)} if links else nodes)), links)


def problems(*links, **arguments):
    return [(problem.kind, problem.text) for problem in graph(*links, **arguments).problems]


@pytest.mark.parametrize(
    'links',
    [
        (pub('/a', '/chatter'), sub('/b', '/chatter')),
        (pub('/a', '/scan', qos=PLAIN), sub('/b', '/scan', qos=BEST_EFFORT)),
        (pub('/a', '/map', qos=LATCHED), sub('/b', '/map')),
        (pub('/a', '/turtle1/pose'), sub('/b', '/turtle1/pose'), pub('/c', '/turtle2/pose')),
        (pub('/a', '/odom'), sub('/b', '/scan')),
        (Link('/b', 'server', '/add', STRING),),
        (),
    ],
    ids=['a pair', 'offers more', 'latched for all', 'numbered names', 'other names', 'no client yet', 'nothing'],
)
def test_what_fits_is_not_reported(links):
    assert problems(*links) == []


@pytest.mark.parametrize(
    'kind, fragments, links',
    [
        (
            'type',
            ['/a publishes std_msgs/msg/String', '/b expects std_msgs/msg/Int32'],
            (pub('/a', '/chatter'), sub('/b', '/chatter', INT)),
        ),
        ('type', ['2 types'], (pub('/a', '/chatter'), pub('/b', '/chatter', INT))),
        (
            'qos',
            ['reliability: /a offers BEST_EFFORT, /b asks for RELIABLE'],
            (pub('/a', '/scan', qos=BEST_EFFORT), sub('/b', '/scan')),
        ),
        (
            'qos',
            ['durability: /a offers VOLATILE, /b asks for TRANSIENT_LOCAL'],
            (pub('/a', '/map'), sub('/b', '/map', qos=LATCHED)),
        ),
        (
            'name',
            ['/a publishes on /chater', '/b subscribes to /chatter'],
            (pub('/a', '/chater'), sub('/b', '/chatter')),
        ),
        ('name', ['/chater', '/chatter'], (pub('/a', '/chater'), pub('/c', '/chatter'), sub('/b', '/chatter'))),
        ('name', ['/robot/scan', '/scan'], (pub('/a', '/robot/scan'), sub('/b', '/scan'))),
        (
            'name',
            ['/a asks for /ad_two_ints', '/b serves /add_two_ints'],
            (Link('/a', 'client', '/ad_two_ints', STRING), Link('/b', 'server', '/add_two_ints', STRING)),
        ),
        ('no server', ['/add', '/a would wait for ever'], (Link('/a', 'client', '/add', STRING),)),
        (
            'servers',
            ['/add has 2 servers: /a, /b'],
            (Link('/a', 'server', '/add', STRING), Link('/b', 'server', '/add', STRING)),
        ),
    ],
)
def test_what_does_not_fit_is_said_in_words(kind, fragments, links):
    ((found, text),) = problems(*links)
    assert found == kind
    for fragment in fragments:
        assert fragment in text


def test_two_nodes_of_one_name():
    assert problems(nodes=['/twin', '/twin']) == [('nodes', '2 nodes have the name /twin. Tools take them for one.')]


def test_misspelt():
    assert misspelt('/chatter', '/chater') and misspelt('/load', '/laod') and misspelt('/Scan', '/scan')
    assert not misspelt('/scan', '/scan') and not misspelt('/a/scan', '/scan') and not misspelt('/odom', '/map')


def test_every_policy_that_rclpy_minds_is_named():
    """`mismatches` gives the reasons for which `qos_check_compatible` is the judge."""
    slow, fast = QoSProfile(depth=1, deadline=Duration(seconds=2)), QoSProfile(depth=1, deadline=Duration(seconds=0.5))
    manual = QoSProfile(depth=1, liveliness=LivelinessPolicy.MANUAL_BY_TOPIC)
    lease = QoSProfile(depth=1, liveliness_lease_duration=Duration(seconds=1))
    assert mismatches(slow, fast) == [('deadline', '2 s', '0.5 s')]
    assert mismatches(PLAIN, fast) == [('deadline', 'no limit', '0.5 s')]
    profiles = [PLAIN, BEST_EFFORT, LATCHED, slow, fast, manual, lease]
    for offered in profiles:
        for requested in profiles:
            assert fit(offered, requested) == (not mismatches(offered, requested)), (words(offered), words(requested))


def test_the_picture_shows_all_and_marks_what_is_wrong():
    shown = GraphPicture(
        graph(
            pub('/a', '/scan', qos=BEST_EFFORT),
            sub('/b', '/scan'),
            Link('/b', 'server', '/<go>', STRING),
            Link('/b', 'server', '/stop', STRING),
        )
    )
    bundle = shown._repr_mimebundle_()
    svg = ElementTree.fromstring(re.search(r'<svg.*?</svg>', bundle['text/html'], re.DOTALL)[0])
    texts = [element.text for element in svg.iter('{http://www.w3.org/2000/svg}text')]
    for text in ('/a', '/b', '/scan', 'best effort', '/<go>', '/stop', '1'):
        assert text in texts
    red = [path for path in svg.iter('{http://www.w3.org/2000/svg}g') if path.get('color')]
    assert len(red) == 2, 'the two edges that do not fit'
    assert 'asks for RELIABLE' in bundle['text/html'].partition('</svg>')[2]
    assert bundle['text/plain'].splitlines()[0] == 'Domain 7: 2 nodes, 1 topic, 2 services, 1 problem'
    assert '  publishes /scan [std_msgs/msg/String] (reliability BEST_EFFORT, durability VOLATILE)' in str(shown)


def test_an_empty_graph():
    for namespace, where in (('/', ''), ('/robot', ' in the namespace /robot')):
        empty = GraphPicture(Graph(7, (), (), namespace))
        assert str(empty) == f'Domain 7: no node is running{where}.'
        page = empty._repr_mimebundle_()['text/html']
        assert str(empty) in page and '<svg' not in page, 'an empty picture would be a blank strip'
