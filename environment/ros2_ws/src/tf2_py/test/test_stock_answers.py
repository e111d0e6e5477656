"""
The buffer answers as the C++ BufferCore of stock Jazzy did.

`tf2_answers.jsonl.gz` has one JSON value per line: `{"seed": n}` begins a random tree; every other line is
`[[operation, arguments…], answer]`. An answer is `["ok", value]` or `["err", class, text]`.
"""

import gzip
import json
from pathlib import Path

import pytest
from rclpy.duration import Duration
from rclpy.time import Time
from tf2_py import BufferCore, TransformException

from environment.tests.tf2_messages import transform

ANSWERS = Path(__file__).with_name('tf2_answers.jsonl.gz')
TOLERANCE = 1e-9


def _at(nanoseconds):
    return Time(nanoseconds=nanoseconds)


def _values(stamped):
    stamp, rotation = stamped.header.stamp, stamped.transform.rotation
    translation = stamped.transform.translation
    return {
        'x': [translation.x, translation.y, translation.z],
        'q': [rotation.x, rotation.y, rotation.z, rotation.w],
        't': stamp.sec * 10**9 + stamp.nanosec,
        'f': [stamped.header.frame_id, stamped.child_frame_id],
    }


def _set(core, parent, child, stamp, xyz, xyzw, static):
    message = transform(parent, child, 0.0, xyz, xyzw)
    message.header.stamp = _at(stamp).to_msg()
    (core.set_transform_static if static else core.set_transform)(message, 'set')


OPERATIONS = {
    'set': _set,
    'lookup': lambda core, target, source, at: _values(core.lookup_transform_core(target, source, _at(at))),
    'full': lambda core, target, at, source, source_at, fixed: _values(
        core.lookup_transform_full_core(target, _at(at), source, _at(source_at), fixed)
    ),
    'can': lambda core, target, source, at: list(core.can_transform_core(target, source, _at(at))),
    'canfull': lambda core, target, at, source, source_at, fixed: list(
        core.can_transform_full_core(target, _at(at), source, _at(source_at), fixed)
    ),
    'lct': lambda core, a, b: core.get_latest_common_time(a, b).nanoseconds,
    'yaml': lambda core: core.all_frames_as_yaml(),
    'string': lambda core: core.all_frames_as_string(),
    'clear': lambda core: core.clear(),
    'vel': lambda core, tracking, observation, at, window: [
        list(part) for part in core.lookupVelocityCore(tracking, observation, _at(at), Duration(nanoseconds=window))
    ],
}


def _perform(core, operation, arguments):
    try:
        return ['ok', OPERATIONS[operation](core, *arguments)]
    except TransformException as error:
        return ['err', type(error).__name__, str(error)]


def _same(operation, stock, ours):
    if stock[0] == 'err' and stock[1] == 'ExtrapolationException':
        return ours[:2] == stock[:2]  # the wording differs between the patches of Jazzy
    if operation in ('can', 'canfull') and 'extrapolation' in stock[1][1]:
        return ours[0] == 'ok' and ours[1][0] == stock[1][0]
    return _close(stock, ours)


def _close(a, b):
    if isinstance(a, dict):
        return isinstance(b, dict) and a.keys() == b.keys() and all(_close(a[key], b[key]) for key in a)
    if isinstance(a, list):
        return isinstance(b, list) and len(a) == len(b) and all(map(_close, a, b))
    if isinstance(a, float):
        return isinstance(b, (int, float)) and (abs(a - b) <= TOLERANCE * max(1.0, abs(a)))
    return a == b


def _records():
    with gzip.open(ANSWERS, 'rt') as lines:
        trees = []
        for line in lines:
            record = json.loads(line)
            if isinstance(record, dict):
                trees.append((record['seed'], []))
            else:
                trees[-1][1].append(record)
    return trees


def _differences(seed, records):
    core = None
    for index, ((operation, *arguments), stock) in enumerate(records):
        if operation == 'new':
            core = BufferCore(*(Duration(nanoseconds=length) for length in arguments if length is not None))
            continue
        ours = _perform(core, operation, arguments)
        if operation == 'vel' and stock[0] == ours[0] == 'ok':
            # Frames that are static relative to each other: nothing but rounding, divided by almost no time.
            if records[index + 1 : index + 2] == [[['lct', arguments[1], arguments[0]], ['ok', 0]]]:
                continue
            # A velocity is a small difference over a short time: its last digits are noise.
            stock, ours = ([*answer[1][0], *answer[1][1]] for answer in (stock, ours))
            if ours != pytest.approx(stock, rel=1e-5, abs=1e-5):
                yield f'seed {seed}: {operation} {arguments}\n  stock {stock}\n  here  {ours}'
        elif not _same(operation, stock, ours):
            yield f'seed {seed}: {operation} {arguments}\n  stock {stock}\n  here  {ours}'


def test_every_answer_is_the_same(logged):
    trees = _records()
    assert sum(len(records) for _, records in trees) == 13_856
    differences = [text for seed, records in trees for text in _differences(seed, records)]
    assert not differences, '\n'.join([f'{len(differences)} answers differ:', *differences[:5]])
    complaints = logged().splitlines()
    # The data has transforms of each kind that must be refused; stock logs each, and so do we.
    for kind in (
        'TF_SELF_TRANSFORM',
        'TF_NO_FRAME_ID',
        'TF_NO_CHILD_FRAME_ID',
        'TF_NAN_INPUT',
        'TF_DENORMALIZED_QUATERNION',
        'TF_OLD_DATA',
    ):
        assert any(kind in line for line in complaints), kind


def test_the_comparison_notices_a_difference():
    seed, records = _records()[0]
    spoiled = []
    for (operation, *arguments), stock in records:
        if operation == 'lookup' and stock[0] == 'ok':
            stock = ['ok', {**stock[1], 't': stock[1]['t'] + 1}]
        spoiled.append([[operation, *arguments], stock])
    assert list(_differences(seed, spoiled))
