"""Late submissions: a policy from a YAML file, and what it deducts. Pure functions of a time and the policy.

due: 2026-11-20T23:59:00+01:00
grace_minutes: 15        # that late is not late (default 0)
per_day: 10              # percent of the points, for each day that has begun after `due` (default 0)
cap: 50                  # at most so many percent (default 100)
extensions:              # other due times, by learner
  ada: 2026-11-27T23:59:00+01:00
handed_in:               # times that count instead of the submission's own, by learner
  bob: 2026-11-20T21:14:00+01:00
"""

import math
from dataclasses import dataclass, field
from datetime import datetime, timedelta, timezone
from pathlib import Path

import yaml

from grading import plain_yaml

DAY = timedelta(days=1)
EARLIEST = 1970  # year
LONGEST_GRACE = 366 * 24 * 60  # minutes


class PolicyError(Exception):
    """The policy cannot be used; the message says why."""


@dataclass(frozen=True)
class Late:
    """How late a submission is, and what that costs."""

    due: str  # ISO 8601, UTC, as `handed_in`
    handed_in: str
    days: int  # that have begun after the due time; 0: in time
    percent: float  # deducted

    def applied(self, score: float) -> float:
        """A score with the deduction, rounded to two decimals."""
        return round(score * (1 - self.percent / 100), 2)


@dataclass(frozen=True)
class Policy:
    """When work is due, and what lateness costs."""

    due: datetime
    grace_minutes: float = 0.0
    per_day: float = 0.0  # percent
    cap: float = 100.0  # percent
    extensions: dict[str, datetime] = field(default_factory=dict)
    handed_in: dict[str, datetime] = field(default_factory=dict)

    @property
    def learners(self) -> set[str]:
        """Whom the policy names."""
        return {*self.extensions, *self.handed_in}

    def judge(self, learner: str, handed_in: str) -> Late:
        """What the policy says about a submission that came at `handed_in` (ISO 8601); long ago, if nobody knows."""
        known = handed_in or '1970-01-01T00:00:00Z'
        came = self.handed_in.get(learner) or datetime.fromisoformat(known.replace('Z', '+00:00'))
        due = self.extensions.get(learner, self.due)
        days = 0
        if came - due > timedelta(minutes=self.grace_minutes):  # due + grace may be no date any more
            days = math.ceil((came - due) / DAY)
        return Late(stamp(due), stamp(came), days, min(self.cap, days * self.per_day))


def stamp(when: datetime) -> str:
    """A time as the grader writes it: ISO 8601, UTC, whole seconds."""
    return when.astimezone(timezone.utc).strftime('%Y-%m-%dT%H:%M:%SZ')


def is_stamp(text: str) -> bool:
    """Whether this is a time as `stamp` writes it, of a day that there is."""
    try:
        # Written again it is the same: strptime also takes digits of other scripts, which nothing else reads.
        return stamp(datetime.strptime(text, '%Y-%m-%dT%H:%M:%SZ').replace(tzinfo=timezone.utc)) == text
    except (ValueError, TypeError):
        return False


def load(path: Path) -> Policy:
    """Read a policy.

    :raises PolicyError: it cannot be read, or something in it is unknown or unusable.
    """
    try:
        data = plain_yaml.read(path.read_text(encoding='utf-8-sig'))
    except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
        raise PolicyError(f'{path} cannot be read: {getattr(error, "strerror", None) or error}') from None
    if not isinstance(data, dict) or 'due' not in data:
        raise PolicyError(f'{path}: a line "due: 2026-11-20T23:59:00+01:00" is needed')
    unknown = set(data) - set(Policy.__dataclass_fields__)
    if unknown:
        raise PolicyError(
            f'{path}: {min(map(str, unknown))!r} is unknown; there are: {", ".join(Policy.__dataclass_fields__)}'
        )
    return Policy(
        _time(path, 'due', data['due']),
        _number(path, data, 'grace_minutes', 0.0, LONGEST_GRACE),
        _number(path, data, 'per_day', 0.0, 100.0),
        _number(path, data, 'cap', 100.0, 100.0),
        *(
            {str(learner): _time(path, f'{name} of {learner}', value) for learner, value in _table(path, data, name)}
            for name in ('extensions', 'handed_in')
        ),
    )


def _table(path: Path, data: dict, name: str):
    table = data.get(name) or {}
    if not isinstance(table, dict):
        raise PolicyError(f'{path}: {name} must be lines "learner: time"')
    return table.items()


def _time(path: Path, name: str, value: object) -> datetime:
    if isinstance(value, str):
        try:
            value = datetime.fromisoformat(value.replace('Z', '+00:00'))
        except ValueError:
            pass
    # YAML itself reads a time with a zone; without one nobody knows when it is.
    if not isinstance(value, datetime) or value.tzinfo is None:
        raise PolicyError(f'{path}: {name} must be a time with its zone, such as 2026-11-20T23:59:00+01:00')
    try:
        value = value.astimezone(timezone.utc)
    except OverflowError:  # on the first or the last day of all
        value = datetime.min.replace(tzinfo=timezone.utc)
    if value.year < EARLIEST:
        raise PolicyError(f'{path}: {name} must be a time of the years {EARLIEST} to 9999')
    return value


def _number(path: Path, data: dict, name: str, default: float, largest: float) -> float:
    value = data.get(name, default)
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not 0 <= value <= largest:
        raise PolicyError(f'{path}: {name} must be a number from 0 to {largest:g}')
    return float(value)
