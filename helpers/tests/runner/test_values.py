"""Values of a learner's program as the tests get them: they equal what was sent, and tell its type if it counts."""

from collections import namedtuple
from enum import Enum

import pytest
from rclpy.duration import Duration
from rclpy.qos import QoSProfile, ReliabilityPolicy, qos_profile_sensor_data
from std_msgs.msg import Header

from helpers.runner.values import (
    EnumAsName,
    EnumAsNumber,
    NamedTupleAsList,
    SentAsTuple,
    SetAsList,
    TupleAsList,
    decode,
    encode,
    encode_result,
)

Pair = namedtuple('Pair', 'name value')
Colour = Enum('Colour', 'RED GREEN')


class Reason(str, Enum):
    OK = 'supported'


class Share(float, Enum):
    HALF = 0.5


def sent(value):
    return decode(encode(value))


@pytest.mark.parametrize(
    'value',
    [None, True, 3, 0.5, 'ä', b'\0', [1, [2]], {'a': {1: 2}}, Duration(seconds=2), Header(frame_id='map')],
    ids=lambda value: type(value).__name__,
)
def test_a_value_equals_what_was_sent(value):
    assert sent(value) == value and type(sent(value)) is type(value)


def test_a_member_of_an_enumeration_is_its_name_and_is_told_from_a_text():
    assert sent(Colour.GREEN) == 'GREEN' and isinstance(sent(Colour.GREEN), EnumAsName)
    assert sent({'colour': [Colour.RED]}) == {'colour': ['RED']} and not isinstance(sent('GREEN'), EnumAsName)


def test_a_member_that_is_a_text_or_a_number_equals_it_as_in_the_program():
    assert sent([Reason.OK, Share.HALF]) == ['supported', 0.5] and type(sent(Reason.OK)) is str
    assert sent({Reason.OK: 1}) == {'supported': 1}
    reliable = sent(ReliabilityPolicy.RELIABLE)
    assert reliable == 1 and isinstance(reliable, EnumAsNumber) and reliable.name == 'RELIABLE'
    assert f'{reliable} {reliable!r}' == '1 1'


def test_a_tuple_arrives_as_one_only_if_that_is_wanted():
    assert sent({'row': SentAsTuple((1, 'a'))})['row'] == (1, 'a') and sent((1, 'a')) == [1, 'a']
    assert {sent(SentAsTuple((1, 2))): 'a key'} == {(1, 2): 'a key'}


def test_what_a_function_returns_is_told_from_a_list():
    assert type(decode(encode_result((1, 2)))) is TupleAsList and type(decode(encode_result([1, 2]))) is list
    assert type(decode(encode_result(Pair('a', 1)))) is NamedTupleAsList
    assert type(sent({2, 1})) is SetAsList and sent({2, 1}) == [1, 2]


def test_a_profile_keeps_its_policies():
    assert sent(qos_profile_sensor_data) == qos_profile_sensor_data != sent(QoSProfile(depth=5))


@pytest.mark.parametrize('text', [{'$enum': 3}, {'$new': 1}, {'$msg': 'os/system/x', 'cdr': ''}])
def test_what_no_program_of_ours_sends_is_refused(text):
    with pytest.raises(ValueError, match='a value'):
        decode(text)
