"""One learner's graded work as data: what `results/<learner>.json` holds, and all reports are made from."""

import json
import os
from dataclasses import dataclass, field
from pathlib import Path

from helpers.runner import verdicts
from helpers.runner.results import ExerciseResult

SCHEMA = 1


@dataclass
class Record:
    """The result of one submission."""

    learner: str
    source: str  # the submission's file name
    key: str  # of the submission, the tests and the grader: the same key, the same result
    sandbox: str
    exercises: list[ExerciseResult]
    log: list[str] = field(default_factory=list)  # for the instructor

    @property
    def points(self) -> float:
        """All points there are."""
        return sum(exercise.points for exercise in self.exercises)

    @property
    def score(self) -> float | None:
        """The points reached; None while a grader's fault leaves some unknown."""
        scores = [exercise.score for exercise in self.exercises]
        return None if None in scores else round(sum(scores), 2)

    @property
    def status(self) -> str:
        """graded, invalid (nothing could be graded) or grader_error (to be graded again)."""
        kinds = {exercise.verdict for exercise in self.exercises}
        if verdicts.GRADER_ERROR in kinds:
            return 'grader_error'
        return 'invalid' if kinds == {verdicts.INVALID_SUBMISSION} else 'graded'

    def dumps(self) -> str:
        """The record as JSON text."""
        return json.dumps({
            'schema': SCHEMA, 'learner': self.learner, 'source': self.source, 'key': self.key, 'sandbox': self.sandbox,
            'status': self.status, 'score': self.score, 'points': self.points,
            'exercises': [exercise.as_dict() for exercise in self.exercises], 'log': self.log,
        }, indent=1, ensure_ascii=False) + '\n'

    @classmethod
    def load(cls, path: Path) -> 'Record | None':
        """Read a record; None if there is none that can be used."""
        try:
            data = json.loads(path.read_text(encoding='utf-8'))
            if data['schema'] != SCHEMA:
                return None
            return cls(data['learner'], data['source'], data['key'], data['sandbox'],
                       [ExerciseResult.from_dict(row) for row in data['exercises']], data['log'])
        except (OSError, ValueError, KeyError, TypeError, AttributeError):
            return None


def write(path: Path, text: str) -> None:
    """Write a file as a whole or not at all, also if the process is killed."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f'.{path.name}.{os.getpid()}')
    with open(temporary, 'w', encoding='utf-8', newline='') as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())
    os.replace(temporary, path)
