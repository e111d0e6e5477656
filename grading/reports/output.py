"""Everything in the folder of results that is made from the records: one report of each kind per learner, the
gradebook, and the class summary.
"""

from collections.abc import Iterable, Mapping
from pathlib import Path

from environment.setup import whole_file
from grading import gradebook, reports, similarity
from grading.record import Record
from grading.reports import summary
from helpers.exercises.manifest import Exercise


def write_all(
    records: Iterable[Record],
    exercises: Iterable[Exercise],
    output: Path,
    prints: Mapping[str, Mapping[str, Iterable[int] | None]] | None = None,
) -> None:
    """Write the files into `output`.

    :param prints: by learner, the fingerprints of each exercise's cell (`similarity.of_submission`), to find those that
        are alike.
    """
    records, exercises = list(records), list(exercises)
    for record in records:
        for folder, suffix, make in reports.KINDS:
            whole_file.update(output / folder / f'{record.learner}{suffix}', make(record))
    whole_file.update(output / 'gradebook.csv', gradebook.dumps(records, exercises))
    alike = similarity.find(prints or {}, similarity.stubs_of(exercises))
    seen = summary.data(records, exercises, alike)
    seen['notes'] += similarity.not_compared(prints or {})
    whole_file.update(output / 'summary.json', summary.dumps(seen))
    whole_file.update(output / 'summary.html', summary.html(seen))
