"""Hidden tests of exercise 4.2, a careful camera."""

from math import inf, nan, nextafter

import pytest
from rclpy.qos import DurabilityPolicy, QoSProfile
from sensor_msgs.msg import CameraInfo
from sensor_msgs.srv import SetCameraInfo

from helpers.checks.chapter_03.endpoints import check_lifespan
from helpers.checks.chapter_04.cameras import OTHER_MODELS, check_drawn, check_own_topic, check_unheard, fill_others
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('4.2'), pytest.mark.wiring(type='publish', qos='latched', namespace='names')]

WORDS = 'size', 'focal length', 'principal point', 'distortion'
LATCHED = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def info(width=640, height=480, fx=500.0, fy=510.0, cx=320.0, cy=240.0, model='plumb_bob', d=5, bend=0.01, last=1.0):
    return CameraInfo(
        width=width, height=height, distortion_model=model, d=[bend] * d, k=[fx, 0.0, cx, 0.0, fy, cy, 0.0, 0.0, last]
    )


def camera(learner):
    heard = learner.listen('/camera_info', CameraInfo, LATCHED)
    learner.start('Camera')
    return heard, learner.client('/set_camera_info', SetCameraInfo)


def refused(client, word, hint='', rule='', **changes):
    with about('always'):
        answer = client.call(camera_info=info(**changes))
    rule = rule or word.replace(' ', '-')
    expect(not answer.success, f'A calibration with {changes} was accepted. {hint}', rule)
    expect(
        answer.status_message == word,
        f'A calibration with {changes} was refused with {answer.status_message!r}, expected {word!r}. {hint}',
        rule,
    )


def accepted(client, rule, hint='', **changes):
    with about('always'):
        answer = client.call(camera_info=info(**changes))
    if answer.status_message in WORDS:
        rule = answer.status_message.replace(' ', '-')
    expect(answer.success, f'A calibration with {changes} was refused with {answer.status_message!r}. {hint}', rule)
    expect(answer.status_message == '', f'An accepted calibration got the message {answer.status_message!r}.', 'accept')


@pytest.mark.rules('always', 'size', 'focal-length', 'principal-point', 'distortion', 'accept', 'latched')
@about('always')
def test_every_rule(learner):
    """Each rule is checked, and named by its word.

    Look at the list of words.
    """
    _, client = camera(learner)
    low = -learner.random.uniform(0.1, 9.0)
    refused(client, 'size', height=0, cy=0.0)
    refused(client, 'size', width=0, cx=0.0)
    refused(client, 'focal length', fx=0.0)
    refused(client, 'focal length', 'k[4] is the second focal length.', fy=low)
    refused(client, 'principal point', cx=low)
    refused(client, 'principal point', cy=480.5)
    refused(client, 'principal point', cx=641.0)
    for name in OTHER_MODELS:
        refused(client, 'distortion', model=name)
    for count in (0, 4, 6, 8):
        refused(client, 'distortion', d=count)
    refused(client, 'focal length', 'Both must be positive.', fx=low, fy=low)
    for value in (0.001, 1e200):
        accepted(client, 'focal-length', 'Every positive, finite number is a focal length.', fx=value, fy=value)
    accepted(client, 'distortion', 'Five zeros are five numbers.', bend=0.0)
    accepted(client, 'distortion', 'The five numbers themselves are not checked.', bend=inf)
    for last in (1.5, nan):
        accepted(client, 'focal-length', 'Other places of k are not checked.', last=last)
    accepted(client, 'accept')


@pytest.mark.rules('order', 'size')
def test_the_first_broken_rule_decides(learner):
    """If several rules are broken, the first one of the list is named.

    Keep the order of the specification.
    """
    _, client = camera(learner)
    hint = 'Several rules are broken: name the first one of the list.'
    refused(client, 'size', hint, 'order', width=0, fx=-1.0, model='')
    refused(client, 'focal length', hint, 'order', fy=0.0, cx=-1.0, d=0)
    refused(client, 'principal point', hint, 'order', cy=-1.0, d=0)


@pytest.mark.weight(2)
@pytest.mark.rules('nan', 'focal-length')
@about('nan')
def test_numbers_that_are_none(learner):
    """nan and infinity are refused.

    Every comparison with nan is false: write what must be true.
    """
    _, client = camera(learner)
    refused(client, 'focal length', 'A focal length must be finite.', fy=inf)
    refused(client, 'focal length', 'A focal length must be finite.', fx=inf)
    for place, word in {
        'fx': 'focal length',
        'fy': 'focal length',
        'cx': 'principal point',
        'cy': 'principal point',
    }.items():
        refused(client, word, 'Every comparison with nan is false.', 'nan', **{place: nan})


@pytest.mark.rules('principal-point', 'size')
@about('principal-point')
def test_limits_belong_to_it(learner):
    """The limits themselves are allowed: a size of 1, a principal point on the edge.

    At least 1, and less than or equal.
    """
    _, client = camera(learner)
    for changes in ({'cx': 0.0, 'cy': 480.0}, {'cx': 640.0, 'cy': 0.0}):
        accepted(client, 'principal-point', '0 and width are allowed for k[2].', **changes)
    accepted(client, 'size', 'A width of 1 is allowed.', width=1, height=1, cx=0.5, cy=0.5)
    width = learner.random.randint(2000, 90_000)
    accepted(client, 'principal-point', 'The limit of k[2] is the width of the request.', width=width, cx=width - 0.5)
    height = learner.random.randint(2000, 9000)
    accepted(client, 'principal-point', 'The limit of k[5] is its height.', height=height, cy=height - 0.5)
    refused(client, 'principal point', height=height, cx=640.5)
    for place, most in (('cx', float(width)), ('cy', float(height))):
        for value in (nextafter(most, inf), nextafter(0.0, -1.0)):
            hint = 'Compare the numbers as they are, without rounding.'
            refused(client, 'principal point', hint, width=width, height=height, **{place: value})


@pytest.mark.weight(2)
@pytest.mark.rules('unchanged')
def test_a_refusal_changes_nothing(learner):
    """A refused calibration is not published, and the last good one stays.

    Publish only after all rules have been checked.
    """
    heard, client = camera(learner)
    fx = learner.random.uniform(100, 900)
    client.call(camera_info=info(fx=fx))
    client.call(camera_info=info(d=3))
    client.call(camera_info=info(width=0))
    expect(
        len(heard) == 1,
        f'One good and two bad calibrations gave {len(heard)} messages on /camera_info, expected '
        '1: a calibration that is refused is not published.',
    )
    late = learner.late_listener('/camera_info', CameraInfo, LATCHED)
    expect(
        not late.messages or late.messages[-1].k[0] == fx,
        'A program that starts later gets another calibration than the last good one.',
    )


@pytest.mark.rules('latched', 'publish')
@about('publish')
def test_latched(learner):
    """Late subscribers get the last calibration, and only this one; nothing is published before the first.

    RELIABLE, TRANSIENT_LOCAL, depth 1.
    """
    heard, client = camera(learner)
    for publisher in learner.endpoints('/camera_info').publishers:
        check_lifespan(publisher, 'latched')
    learner.run(1.0)
    expect(not heard.messages, 'Something was published on /camera_info before a calibration was set.', 'publish')
    for number in range(3):
        client.call(camera_info=info(fx=100.0 + number))
    late = learner.late_listener('/camera_info', CameraInfo)  # would take ten
    expect(late.messages, 'A late subscriber gets nothing: offer TRANSIENT_LOCAL.', 'latched')
    expect(
        [message.k[0] for message in late.messages] == [102.0],
        'A late subscriber gets more than the last calibration: use depth 1.',
        'latched',
    )
    learner.run(61.0, step=10.0)
    check_unheard(learner, info(fx=learner.random.uniform(100.0, 900.0)))
    expect(len(heard) == 3, f'Three calibrations were set, and {len(heard)} messages came in a minute.', 'publish')


@pytest.mark.rules('publish')
def test_as_it_came(learner):
    """Header, binning and all other fields are published as they came.

    Publish the message of the request itself.
    """
    heard, client = camera(learner)
    message = info()
    fill_others(message, learner.random)
    client.call(camera_info=message)
    expect(
        heard.messages == [message],
        'What was published is not the calibration as it came: header, binning, roi, k, r or p differ.',
    )
    client.call(camera_info=message)
    expect(len(heard) == 2, f'The same calibration was set twice, and published {len(heard)} times, expected 2.')
    plain = info()
    plain.k[1] = learner.random.uniform(0.5, 2)
    client.call(camera_info=plain)
    expect(
        heard.messages[2:] == [plain],
        'A calibration with an empty header came, and what was published is not the calibration as it came.',
    )


@pytest.mark.rules('always', 'size', 'focal-length', 'principal-point', 'distortion', 'nan', 'order', 'accept')
def test_any_numbers(learner):
    """Whatever the numbers are, the rules decide, in their order."""
    heard, client = camera(learner)
    check_drawn(learner, client, heard, 100)


@pytest.mark.rules('names', 'publish')
def test_namespace(learner):
    """Two cameras in two namespaces do not disturb each other.

    Relative names, and state in the object.
    """
    eyes = {}
    for eye in ('/left', '/right'):
        node = learner.start('Camera', remap={'__ns': eye})
        expect(node.name == f'{eye}/camera', f'Your node is called {node.name}, expected {eye}/camera.', 'names')
        eyes[eye] = learner.listen(f'{eye}/camera_info', CameraInfo, LATCHED)
    client = learner.client('/right/set_camera_info', SetCameraInfo)
    learner.settle()
    expect(
        '/right/set_camera_info' in client.theirs(),
        'In the namespace /right your node has no service /right/set_camera_info: leave out the leading slash.',
        'names',
    )
    accepted(client, 'names')
    counts = [len(heard) for heard in eyes.values()]
    expect(counts == [0, 1], f'The right camera was calibrated; left and right published {counts} times.', 'names')
    check_own_topic(learner, node, client, eyes['/right'], info())
