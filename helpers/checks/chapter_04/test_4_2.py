"""Visible tests of exercise 4.2, a careful camera."""

from math import inf, nan, nextafter

import pytest
from rclpy.qos import DurabilityPolicy, QoSProfile
from sensor_msgs.msg import CameraInfo
from sensor_msgs.srv import SetCameraInfo

from helpers.checks.chapter_03.endpoints import check_lifespan
from helpers.checks.chapter_04.cameras import (
    HINTS,
    OTHER_MODELS,
    check_drawn,
    check_own_topic,
    check_unheard,
    fill_others,
)
from helpers.checks.chapter_04.names import check_names
from helpers.runner import about, expect

pytestmark = [pytest.mark.exercise('4.2'), pytest.mark.wiring(type='publish', qos='latched', namespace='names')]

LIMITS = 'The limits are allowed: k[2] goes from 0 to the width of the request, k[5] to its height.'
WORDS = 'size', 'focal length', 'principal point', 'distortion'
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class Calibrations:
    """Makes calibrations of a camera whose size is drawn, and judges the answers to them."""

    def __init__(self, learner, client):
        self.draw, self.client = learner.random, client
        self.width, self.height = self.draw.randint(900, 1600), self.draw.randint(300, 600)

    def info(
        self, width=None, height=None, fx=500.0, fy=510.0, cx=None, cy=None, skew=0.0, model='plumb_bob', d=5, bend=None
    ):
        width, height = self.width if width is None else width, self.height if height is None else height
        cx, cy = self.draw.uniform(10, 290) if cx is None else cx, self.height / 3 if cy is None else cy
        return CameraInfo(
            width=width,
            height=height,
            distortion_model=model,
            d=[self.draw.uniform(-1, 1) if bend is None else bend] * d,
            k=[fx, skew, cx, 0.0, fy, cy, 0.0, 0.0, 1.0],
        )

    def refused(self, word, rule='', hint='', **changes):
        """Expect that a calibration with these changes is refused with this word."""
        with about('always'):
            answer = self.client.call(camera_info=self.info(**changes))
        rule = rule or word.replace(' ', '-')
        expect(
            not answer.success,
            f'A calibration of {self.width} x {self.height} with {_text(changes)} was accepted. {hint}',
            rule,
        )
        expect(
            answer.status_message == word,
            f'A calibration of {self.width} x {self.height} with {_text(changes)} '
            f'was refused with {answer.status_message!r}, expected {word!r}. {hint}',
            rule,
        )

    def accepted(self, rule, hint='', **changes):
        """Expect that a calibration with these changes is accepted; returns it."""
        info = self.info(**changes)
        with about('always'):
            answer = self.client.call(camera_info=info)
        if answer.status_message in WORDS:
            rule = answer.status_message.replace(' ', '-')
        if rule == 'principal-point':
            hint = LIMITS
        expect(
            answer.success,
            f'A calibration of {self.width} x {self.height} with {_text(changes)} breaks no rule '
            f'and was refused with {answer.status_message!r}. {hint}',
            rule,
        )
        expect(
            answer.status_message == '',
            f'An accepted calibration got the message {answer.status_message!r}, expected an empty one.',
            'accept',
        )
        return info


def _text(changes):
    names = {
        'fx': 'k[0]',
        'fy': 'k[4]',
        'cx': 'k[2]',
        'cy': 'k[5]',
        'model': 'distortion_model',
        'd': 'len(d)',
        'bend': 'd[0]',
        'skew': 'k[1]',
    }
    told = {name: repr(value) if isinstance(value, str) else _short(value) for name, value in changes.items()}
    return ', '.join(f'{names.get(name, name)} = {value}' for name, value in told.items()) or 'good numbers'


def _short(value: float) -> str:
    """The number with few digits, but with all of them where they alone tell it from a whole number."""
    text = f'{value!r:.7}'
    return repr(value) if 'e' in repr(value) or float(text).is_integer() else text


@pytest.mark.rules(
    'always', 'size', 'focal-length', 'principal-point', 'distortion', 'nan', 'order', 'accept', 'publish', 'unchanged'
)
@about('always')
def test_words(learner):
    """Each broken rule gives its word; what breaks none is accepted.

    Set success to False and status_message to the word, and return the response, on every path.
    """
    heard = learner.listen('/camera_info', CameraInfo)
    learner.start('Camera')
    some = Calibrations(learner, learner.client('/set_camera_info', SetCameraInfo))
    width, height, low = some.width, some.height, -learner.random.uniform(0.1, 9.0)
    some.accepted('accept')
    some.refused('size', width=0, cx=0.0)
    some.refused('size', height=0, cy=0.0)
    some.accepted('size', 'A width and a height of 1 are allowed.', width=1, height=1, cx=0.5, cy=0.5)
    for place in ('fx', 'fy'):
        for value in (0.0, low):
            some.refused('focal length', **{place: value})
        some.refused('focal length', hint='A focal length must be finite.', **{place: inf})
        some.accepted('focal-length', **{place: 0.001})
        some.accepted('focal-length', 'A focal length has no upper limit.', **{place: 1e200})
    some.refused('focal length', hint='Both must be positive.', fx=low, fy=low)
    some.accepted('focal-length', 'A focal length has no upper limit.', fx=1e200, fy=1e200)
    _look_at_limits(some, low)
    for changes in (*({'model': name} for name in OTHER_MODELS), {'d': 0}, {'d': 4}, {'d': 6}, {'d': 8}):
        some.refused('distortion', hint=HINTS['distortion'], **changes)
    some.accepted(
        'size', 'A picture may be higher than it is wide.', width=height, height=width, cx=0.5, cy=height + 0.5
    )
    for bend in (inf, nan, -1e9):
        some.accepted('distortion', 'The five numbers themselves are not checked.', bend=bend)
    some.accepted('distortion', 'Five zeros are five numbers: a camera that does not distort.', bend=0.0)
    for place, word in (
        ('fx', 'focal length'),
        ('fy', 'focal length'),
        ('cx', 'principal point'),
        ('cy', 'principal point'),
    ):
        some.refused(word, 'nan', 'Every comparison with nan is false: write what must be true.', **{place: nan})
    some.accepted('accept', 'Only k[0], k[2], k[4] and k[5] are checked, and no other place of k.', skew=nan)
    hint = 'Several rules are broken: the first one of the list decides.'
    some.refused('size', 'order', hint, width=0, fx=low)
    some.refused('size', 'order', hint, height=0, d=3)
    some.refused('focal length', 'order', hint, fy=0.0, cy=low, model='')
    some.refused('focal length', 'order', hint, fy=low, cx=low)
    some.refused('principal point', 'order', hint, cx=low, d=0)
    some.accepted('accept', 'It came after some that were refused.')
    large = learner.random.randint(20_000, 2**32 - 1)
    for size in (large, 2**32 - 1):
        some.accepted('accept', 'A size has no upper limit.', width=size, height=size)
    check_drawn(learner, some.client, heard, 60)


def _look_at_limits(some, low):
    """The limits of the principal point, from both sides, and the least focal lengths; `low` is less than 0."""
    for place, most in (('cx', float(some.width)), ('cy', float(some.height))):
        for value in (0.0, most):
            some.accepted('principal-point', LIMITS, **{place: value})
        for value in (low, most + 0.5, inf, -inf):
            some.refused('principal point', **{place: value})
        for value in (nextafter(most, inf), nextafter(0.0, -1.0)):
            some.refused('principal point', hint=f'{LIMITS} Compare without rounding.', **{place: value})
    for place in ('fx', 'fy'):
        some.accepted('focal-length', 'Each number above 0 is positive.', **{place: 5e-324})
        some.refused('focal length', hint='Each number below 0 is negative.', **{place: -5e-324})


@pytest.mark.rules('names', 'publish', 'unchanged', 'latched')
@about('publish')
def test_published(learner):
    """Each good calibration is published once, as it came; a bad one changes nothing; late programs get the last one.

    Publish request.camera_info itself, after all rules have been checked.
    """
    draw = learner.random
    space = draw.choice(['/left', '/right', '/head/front'])
    node, client = _start(learner, space)
    heard, some = learner.listen(f'{space}/camera_info', CameraInfo), Calibrations(learner, client)
    learner.run(0.2)
    early = learner.late_listener(heard.topic, CameraInfo, LATCHED)  # it gets what the constructor has published, too
    expect(
        not heard.messages and not early.messages,
        'Something was published on camera_info before a calibration was set.',
        'publish',
    )
    for publisher in learner.endpoints(heard.topic).publishers:
        check_lifespan(publisher, 'latched')
    last = _set_three(some, heard)
    for changes in ({'width': 0}, {'fx': -1.0}, {'cx': -1.0}, {'d': 3}):
        client.call(camera_info=some.info(**changes))
        expect(
            len(heard) == 3,
            f'After three good calibrations one with {_text(changes)} came, and a message was '
            'published: a calibration that is refused is not published.',
            'unchanged',
        )
    learner.run(61.0, step=10.0)
    expect(len(heard) == 3, 'With no new calibration, camera_info was published again.', 'publish')
    _listen_late(learner, heard.topic, last)
    check_own_topic(learner, node, client, heard, some.info())
    check_unheard(learner, some.info(), node)


def _start(learner, space):
    """Start the camera in a namespace; returns it and a client of its service, which is there as its topic is."""
    node = learner.start('Camera', remap={'__ns': space})
    expect(
        node.name == f'{space}/camera',
        f'In the namespace {space} your node is called {node.name}, expected {space}/camera.',
        'names',
    )
    client = learner.client(f'{space}/set_camera_info', SetCameraInfo)
    learner.settle()
    check_names(learner, space, client, publisher='camera_info')
    return node, client


def _set_three(some, heard):
    """Set three good calibrations, the third one the second again: each is published once. Returns the last one."""
    draw = some.draw
    for number in range(1, 4):
        if number == 2:
            info = some.info()  # nothing in its header: as it came
        elif number == 1:
            info = some.info(fx=draw.uniform(100, 900))
            fill_others(info, draw)
        expect(
            some.client.call(camera_info=info).success,
            'A calibration that breaks no rule was refused. Header, binning, roi, r, p and the other places of k are '
            'not checked.',
            'publish',
        )
        expect(
            heard.messages,
            'The calibration was accepted, and nothing was published on camera_info.',
            'publish',
            hint=True,
        )
        expect(
            heard.messages[-1] == info,
            'What was published is not the calibration as it came: '
            f'{_differences(heard.messages[-1], info)}. Publish the message of the '
            'request itself.',
            'publish',
        )
        expect(len(heard) == number, f'{number} good calibrations were published {len(heard)} times.', 'publish')
    return info


def _listen_late(learner, topic, last):
    """Who begins to listen now gets the last good calibration, and no other."""
    with about('latched'):
        late = learner.late_listener(topic, CameraInfo)  # would take ten
    expect(late.messages, 'A program that starts later gets no calibration: offer TRANSIENT_LOCAL.', 'latched')
    expect(
        len(late) == 1,
        f'A program that starts later gets {len(late)} calibrations, expected the last one only: use depth 1.',
        'latched',
    )
    expect(
        late.messages == [last],
        'A program that starts later gets another calibration than the last good one.',
        'unchanged',
    )


def _differences(one, other):
    names = [name for name in one.get_fields_and_field_types() if str(getattr(one, name)) != str(getattr(other, name))]
    return f'{" and ".join(names)} differ{"s" if len(names) == 1 else ""}'
