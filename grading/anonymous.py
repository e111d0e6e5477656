"""Ids instead of names: an HMAC of the learner's id, with a salt that stays with the instructor.

Salt and map are kept in `DIR-private`, beside the folder of results DIR, so that DIR itself can be passed on.
"""

import csv
import hashlib
import hmac
import io
import re
import secrets
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from environment.setup import whole_file
from grading.submission import is_notebook
from grading.unit import Unit


class AnonymousError(Exception):
    """The private files cannot be used; the message says why."""


def private(output: Path) -> Path:
    """The private folder that belongs to a folder of results."""
    output = output.absolute()
    return output.with_name(f'{output.name}-private')


def pseudonyms(learners: Iterable[str], output: Path) -> dict[str, str]:
    """The pseudonym of each learner, and of those whom the map knows from earlier runs. Writes salt and map.

    :raises AnonymousError: the private folder cannot be written, or is damaged.
    """
    folder = private(output)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        folder.chmod(0o700)
        salt_file, map_file = folder / 'salt', folder / 'learners.csv'
        if not salt_file.exists():
            whole_file.update(salt_file, secrets.token_hex(32) + '\n', sync=True)
            salt_file.chmod(0o600)
        salt = bytes.fromhex(salt_file.read_text().strip())
        if len(salt) < 16:
            raise ValueError('the salt is too short')
        known = {}
        if map_file.exists():
            rows = csv.DictReader(io.StringIO(map_file.read_text(encoding='utf-8'), newline=''), strict=True)
            known = {row['learner']: row['pseudonym'] for row in rows}
        known |= {learner: pseudonym(learner, salt) for learner in learners}
        if len(set(known.values())) < len(known):
            raise ValueError('two learners have the same pseudonym: remove the salt')
        text = io.StringIO()
        writer = csv.writer(text, lineterminator='\n')
        writer.writerow(['pseudonym', 'learner'])
        writer.writerows(sorted((name, learner) for learner, name in known.items()))
        whole_file.update(map_file, text.getvalue(), sync=True)
        map_file.chmod(0o600)
    except (OSError, ValueError, KeyError, csv.Error) as error:
        reason = getattr(error, 'strerror', None) or error
        raise AnonymousError(f'{folder} cannot be used ({reason}): repair or remove it') from None
    return known


def sealed(text: str, output: Path) -> str:
    """The pseudonym of a learner or of another text; `pseudonyms` has made the salt."""
    return pseudonym(text, bytes.fromhex((private(output) / 'salt').read_text().strip()))


def pseudonym(learner: str, salt: bytes) -> str:
    """The pseudonym of one learner: 10 hexadecimal digits."""
    return 'learner-' + hmac.new(salt, learner.encode(), hashlib.sha256).hexdigest()[:10]


def without_names(unit: Unit) -> Unit:
    """The work with other names for notebooks that are not called as the course's: learners write theirs into them,
    and a message may tell what a file is called.
    """
    known = {exercise.notebook for exercise in unit.course.exercises}
    own = sorted(name for name in {*unit.files, *unit.unusable} - known if is_notebook(name))
    # What a name begins with says to which chapter it belongs.
    others = {
        name: f'{name[:3] if re.match("[0-9]{2}_", name) else ""}notebook-{number}.ipynb'
        for number, name in enumerate(own, 1)
    }

    def told(text: str) -> str:
        for name in sorted(others, key=len, reverse=True):
            text = text.replace(name, others[name])
        return text

    return replace(
        unit,
        files={others.get(name, name): data for name, data in unit.files.items()},
        unusable={others.get(name, name): told(why) for name, why in unit.unusable.items()},
        problem=told(unit.problem),
    )
