"""The form in which a fault tells what it is: the one that chapter 7 uses for all findings."""

from typing import NamedTuple


class Finding(NamedTuple):
    """A cause, its place, and what shows it. Equal to a finding of the chapter with the same four parts."""

    row: str  #: of the chapter's table, as ``'A7.6'``
    where: str  #: the culprit: in a staged system the file that must change
    cause: str  #: a word from the exercises' cards, as ``'reliability'``
    evidence: str  #: what a tool or the file shows of it; '' if the fault is that something is missing


#: The words for a cause, by row. Most stand on the cards of exercises 7.1 to 7.6; the others are said in the text.
CAUSES: dict[str, tuple[str, ...]] = {
    'A7.1': ('missing', 'release', 'key', 'component', 'malformed'),
    'A7.2': ('not sourced',),
    'A7.3': ('PATH', 'missing', 'name'),
    'A7.4': ('missing', 'file', 'name', 'module', 'function', 'folder'),
    'A7.5': ('other',),
    'A7.6': ('name', 'nobody', 'type', 'reliability', 'durability'),
    'A7.7': ('domain', 'range'),
    'A7.8': ('name', 'nobody', 'type', 'server'),
    'A7.9': ('call', 'spin', 'busy'),
    'A7.10': ('name', 'nobody', 'type', 'durability', 'unknown'),
    'A7.11': ('collision', 'inertial', 'mass', 'inertia'),
    'A7.12': ('unknown', 'two parents', 'exchanged', 'not connected', 'old'),
    'A7.13': ('no clock', 'other clock'),
    'A7.14': ('rate',),
    'A7.15': ('parameter',),
}
