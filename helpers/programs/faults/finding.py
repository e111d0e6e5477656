"""The form in which a fault tells what it is: the one that chapter 7 uses for all findings.

Earlier versions of the course gave faults the numbers of a table, such as ``'A7.6'``, where a finding has a name now,
and called that part ``row``. Answers that were written so go on to work.
"""

from collections.abc import Iterable
from typing import NamedTuple

#: The faults in the order of the chapter, and the words for their causes. Most of these stand on the cards of exercises
#: 7.1 to 7.6; the others are said in the text.
CAUSES: dict[str, tuple[str, ...]] = {
    'no_ros2': ('not sourced',),
    'no_colcon': ('PATH', 'missing', 'name'),
    'no_source': ('missing', 'release', 'key', 'component', 'malformed'),
    'mixed_distros': ('other',),
    'unseen': ('domain', 'range'),
    'no_program': ('missing', 'file', 'name', 'module', 'function', 'folder'),
    'no_data': ('name', 'nobody', 'type', 'reliability', 'durability'),
    'waiting': ('name', 'nobody', 'type', 'server'),
    'no_model': ('name', 'nobody', 'type', 'durability', 'unknown'),
    'too_slow': ('rate',),
    'no_parameter': ('parameter',),
    'hang': ('call', 'spin', 'busy'),
    'falls': ('collision', 'inertial', 'mass', 'inertia'),
    'no_transform': ('unknown', 'two parents', 'exchanged', 'not connected', 'old'),
    'wrong_time': ('no clock', 'other clock'),
}
_NAMES = {
    'A7.1': 'no_source',
    'A7.2': 'no_ros2',
    'A7.3': 'no_colcon',
    'A7.4': 'no_program',
    'A7.5': 'mixed_distros',
    'A7.6': 'no_data',
    'A7.7': 'unseen',
    'A7.8': 'waiting',
    'A7.9': 'hang',
    'A7.10': 'no_model',
    'A7.11': 'falls',
    'A7.12': 'no_transform',
    'A7.13': 'wrong_time',
    'A7.14': 'too_slow',
    'A7.15': 'no_parameter',
}
_NUMBERS = {name: number for number, name in _NAMES.items()}


def name_of(fault: str) -> str:
    """The name of a fault of which the name or the earlier number is given; what is neither stays as it is."""
    fault = str(fault)  # a plain text: the first part of a finding compares itself by this function
    return _NAMES.get(fault, fault)


def number_of(fault: str) -> str:
    """The number that a fault had in earlier versions; what never had one stays as it is."""
    name = name_of(fault)
    return _NUMBERS.get(name, name)


class _FaultText(str):
    """The first part of a finding, as it was written: a name or an earlier number; each is equal to the other."""

    # Two texts that are equal should have one hash, and cannot here: that of a plain 'A7.6' is Python's. So it is the
    # hash of what was written, and an answer with numbers finds its findings in sets and dictionaries with numbers.
    __slots__ = ()
    __hash__ = str.__hash__

    def __eq__(self, other: object) -> bool:
        return isinstance(other, str) and name_of(self) == name_of(other)

    def __ne__(self, other: object) -> bool:
        return not self == other


class _Finding(NamedTuple):
    fault: str  #: a name of the table in section 7.2, as ``'no_data'``
    where: str  #: the culprit: in a staged system the file that must change
    cause: str  #: a word from the exercises' cards, as ``'reliability'``
    evidence: str  #: what a tool or the file shows of it; '' if the fault is that something is missing


class Finding(_Finding):
    """What is wrong, where, why, and what shows it: ``Finding(fault, where, cause, evidence)``, four texts.

    ``fault`` is always the name, ``row`` always the earlier number; ``finding[0]`` is what was written.
    """

    __slots__ = ()

    def __new__(cls, *parts: str, **named: str) -> 'Finding':
        if 'row' in named:
            named['fault'] = named.pop('row')
        fault, *others = _Finding(*parts, **named)
        return tuple.__new__(cls, (_FaultText(fault) if isinstance(fault, str) else fault, *others))

    @classmethod
    def _make(cls, iterable: Iterable[str]) -> 'Finding':
        return cls(*iterable)

    @property
    def fault(self) -> str:  # type: ignore[override]
        """The name of the fault, as ``'no_data'``."""
        return _FaultText(name_of(self[0]))

    @property
    def row(self) -> str:
        """The number that the fault had in earlier versions, as ``'A7.6'``."""
        return _FaultText(number_of(self[0]))
