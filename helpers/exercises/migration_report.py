"""What `migrate` tells of the work that it has carried over, or why it could not."""

from dataclasses import dataclass, field
from pathlib import Path


class MigrationError(Exception):
    """Nothing can be carried over; the message names the lack and the remedy."""


@dataclass(frozen=True)
class CarriedOver:
    """What became of one exercise."""

    exercise: str  # its id in this version; in the old one if it is gone
    said: str
    lost: bool = False  # the learner has to do something


@dataclass
class MigrationReport:
    """What was carried over."""

    exercises: list[CarriedOver] = field(default_factory=list)
    own: dict[str, int] = field(default_factory=dict)  # cells of the learner's own, by notebook
    notes: list[str] = field(default_factory=list)
    written: list[Path] = field(default_factory=list)  # notebooks
    packages: list[Path] = field(default_factory=list)  # folders that were made
    backup: Path | None = None  # the folder with the notebooks as they were before

    def sort(self) -> None:
        """Put the exercises into their order."""
        self.exercises.sort(key=lambda one: [int(part) for part in one.exercise.split('.')])
