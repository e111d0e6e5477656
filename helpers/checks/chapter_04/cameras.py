"""Calibrations of exercise 4.2 that are drawn, and what the rules of its card say about each of them."""

from math import inf, nan, nextafter

from sensor_msgs.msg import CameraInfo
from sensor_msgs.srv import SetCameraInfo

from helpers.checks.chapter_03.apart import OTHER, check_own
from helpers.runner import about, expect

MODEL = 'plumb_bob'
OTHER_MODELS = (
    'equidistant',
    'rational_polynomial',
    'thin_prism_fisheye',
    'PLUMB_BOB',
    'Plumb_Bob',
    'plumb bob',
    'plumb-bob',
    ' plumb_bob',
    'plumb_bob ',
    'plumb_bob2',
    'plumb',
    'unknown',
    '',
)
PLACES = {'focal length': (0, 4), 'principal point': (2, 5)}
UNCHECKED = 1, 3, 6, 7, 8
ORDER = 'size', 'focal length', 'principal point', 'distortion'
HINTS = {
    'nan': 'Every comparison with nan is false: write what must be true.',
    'distortion': 'It must be plumb_bob, with five numbers; the numbers themselves are not checked.',
    'accept': 'Only the two sizes, k[0], k[2], k[4], k[5], the model and the count of d are checked.',
}


def broken(info: CameraInfo) -> list[str]:
    """The words of the rules that a calibration breaks, in the order of the card."""
    kept = {
        'size': info.width >= 1 and info.height >= 1,
        'focal length': all(0 < info.k[place] < inf for place in PLACES['focal length']),
        'principal point': 0 <= info.k[2] <= info.width and 0 <= info.k[5] <= info.height,
        'distortion': info.distortion_model == MODEL and len(info.d) == 5,
    }
    return [word for word in ORDER if not kept[word]]


def drawn(draw) -> tuple[CameraInfo, dict[str, object]]:
    """A calibration in which up to three places are unusual; and these places with their values."""
    width, height = draw.randint(2, 4000), draw.randint(2, 4000)
    k = [draw.uniform(100.0, 900.0), 0.0, draw.uniform(0.0, width), 0.0, draw.uniform(100.0, 900.0)]
    info = CameraInfo(width=width, height=height, distortion_model=MODEL)
    info.k = [*k, draw.uniform(0.0, height), 0.0, 0.0, 1.0]
    info.d = [draw.uniform(-1.0, 1.0) for _ in range(5)]
    unusual: dict[str, object] = {}
    for _ in range(draw.randint(0, 3)):
        name, value = draw.choice(_UNUSUAL)(draw, width, height)
        unusual[name] = value
    for name, value in unusual.items():
        _put(info, name, value)
    return info, unusual


def fill_others(info: CameraInfo, draw) -> None:
    """Give each field that no rule looks at a value of its own, so that it shows whether all are handed on."""
    info.header.frame_id = draw.choice(['left_eye', 'lens'])
    info.header.stamp.sec, info.header.stamp.nanosec = draw.randint(1, 99), draw.randint(1, 10**9 - 1)
    for place in UNCHECKED:
        info.k[place] = draw.uniform(1.5, 3.0)
    info.r = [draw.uniform(0.1, 0.9) for _ in range(9)]
    info.p = [draw.uniform(-60.0, -1.0) for _ in range(12)]
    info.binning_x, info.binning_y = draw.sample(range(20, 99), 2)
    info.roi.x_offset, info.roi.y_offset, info.roi.width, info.roi.height = draw.sample(range(9000, 65000), 4)
    info.roi.do_rectify = True


def _put(info, name, value):
    if name.startswith('k['):
        info.k[int(name[2:-1])] = value
    elif name == 'len(d)':
        info.d = [0.25] * value
    elif name == 'd[0]':
        info.d = [value, *list(info.d)[1:]] if len(info.d) else [value]
    else:
        setattr(info, name, value)


def _size(draw, width, height):
    return draw.choice(['width', 'height']), draw.choice([0, 0, 1, 2**31, 2**32 - 1])


def _focal_length(draw, width, height):
    bad = [0.0, -0.0, -draw.uniform(0.1, 900.0), -5e-324, inf, -inf, nan]
    return f'k[{draw.choice(PLACES["focal length"])}]', draw.choice([*bad, 5e-324, 1e-9, 1e308])


def _principal_point(draw, width, height):
    place, limit = draw.choice([(2, float(width)), (5, float(height))])
    bad = [
        nextafter(0.0, -1.0),
        -draw.uniform(0.001, 0.9),
        nextafter(limit, inf),
        limit + draw.random(),
        inf,
        -inf,
        nan,
    ]
    return f'k[{place}]', draw.choice([*bad, 0.0, -0.0, limit, nextafter(limit, 0.0)])


def _model(draw, width, height):
    return 'distortion_model', draw.choice(OTHER_MODELS)


def _count(draw, width, height):
    return 'len(d)', draw.choice([0, 1, 4, 6, 8, 12, 14])


def _bend(draw, width, height):
    return 'd[0]', draw.choice([0.0, nan, inf, -inf, 1e300])


def _unchecked(draw, width, height):
    return f'k[{draw.choice(UNCHECKED)}]', draw.choice([nan, inf, -1.0, 0.0, 7.5])


_UNUSUAL = _size, _focal_length, _principal_point, _model, _count, _bend, _unchecked


def check_drawn(learner, client, heard, count: int) -> None:
    """Expect that each of `count` drawn calibrations is answered and published as the card says.

    None breaks more than one rule, so it is clear which one an answer has missed.

    :param heard: what is published on `camera_info`.
    """
    story = ''
    for _ in range(count):
        info, unusual = drawn(learner.random)
        while len(broken(info)) > 1:
            info, unusual = drawn(learner.random)
        heard.clear()
        with about('always'):
            answer = client.call(camera_info=info)
        words = f'{story}A calibration of {info.width} x {info.height} with {text(unusual)}'
        _judge_answer(answer, info, words)
        _judge_publication(heard.messages, info, answer.success, words)
        story = f'After one that was {"accepted" if answer.success else "refused"}: '


def _judge_answer(answer: SetCameraInfo.Response, info: CameraInfo, words: str) -> None:
    wrong = broken(info)
    if not wrong:
        said = answer.status_message
        rule = said.replace(' ', '-') if said in ORDER else 'accept'
        expect(answer.success, f'{words} breaks no rule and was refused with {said!r}. {HINTS["accept"]}', rule)
        expect(not said, f'{words} was accepted with the message {said!r}, expected an empty one.', 'accept')
        return
    word = wrong[0]
    rule = 'nan' if any(info.k[place] != info.k[place] for place in PLACES.get(word, ())) else word.replace(' ', '-')
    expect(not answer.success, f'{words} was accepted, expected {word!r}. {HINTS.get(rule, "")}'.rstrip(), rule)
    if answer.status_message in ORDER and answer.status_message != word:  # a rule that is kept
        rule = answer.status_message.replace(' ', '-')
    expect(
        answer.status_message == word,
        f'{words} was refused with {answer.status_message!r}, expected {word!r}. {HINTS.get(rule, "")}'.rstrip(),
        rule,
    )


def _judge_publication(published, info, accepted, words) -> None:
    if not accepted:
        expect(not published, f'{words} was refused, and something was published all the same.', 'unchanged')
        return
    expect(
        len(published) == 1, f'{words} was accepted, and published {len(published)} times, expected once.', 'publish'
    )
    expect(
        str(published[0]) == str(info),  # the text, because nan is not equal to itself
        f'{words} was accepted, and what was published is not the calibration as it came.',
        'publish',
    )


def text(unusual) -> str:
    """The unusual places of a calibration, for a message."""
    told = (f'{name} = {value!r}' for name, value in unusual.items())
    return ', '.join(told) or 'good numbers'


def check_own_topic(learner, node, client, heard, info: CameraInfo) -> None:
    """A camera publishes on its own topic, which is `heard`, when another one has been made in another namespace.

    :param client, info: of the first camera's service, and a calibration that it accepts.
    """
    others = learner.listen(f'{OTHER}/camera_info', CameraInfo)
    with about('always'):
        learner.start('Camera', beside=node, remap={'__ns': OTHER})
        learner.settle()
        for recorded in (heard, others):
            recorded.clear()
        client.call(camera_info=info)
    story = 'The first one accepted a calibration'
    check_own('Camera', story, len(heard), len(others), 'camera_info', 'publisher', 'publish')


def check_unheard(learner, info: CameraInfo, node=None) -> None:
    """A calibration that is accepted while nobody listens reaches a program that starts later.

    :param node: the camera in whose program another one is made, which nobody has listened to.
    """
    space = '/unheard'
    learner.start('Camera', beside=node, remap={'__ns': space})
    client = learner.client(f'{space}/set_camera_info', SetCameraInfo)
    with about('latched'):
        learner.settle()
        client.call(camera_info=info)
        late = learner.late_listener(f'{space}/camera_info', CameraInfo)
    expect(
        len(late) == 1,  # what is in it is looked at elsewhere
        f'A calibration was accepted while nobody listened, and a program that starts later gets {len(late)} '
        'calibrations, expected one. Publish it also if nobody listens: TRANSIENT_LOCAL keeps it for those who '
        'come.',
        'latched',
    )
