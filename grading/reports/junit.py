"""`junit/<learner>.xml`: one test case per test. An `error` is the grader's fault, a `failure` the learner's."""

from xml.etree import ElementTree

from grading.record import Record
from grading.reports.safe import line, visible
from helpers.runner import results, verdicts


def dumps(record: Record) -> str:
    """The report as XML text."""
    cases = []
    for exercise in record.exercises:
        name = f'exercise {exercise.id}'
        if not exercise.tests:
            cases.append((name, exercise.title, exercise.verdict, exercise.message, 0.0))
        cases += [
            (name, test.test, test.verdict, test.message or test.expected, test.seconds) for test in exercise.tests
        ]
    kinds = [_kind(verdict) for _, _, verdict, _, _ in cases]
    counts = {
        'tests': str(len(cases)),
        'failures': str(kinds.count('failure')),
        'errors': str(kinds.count('error')),
        'skipped': str(kinds.count('skipped')),
        'time': f'{sum(case[4] for case in cases):.3f}',
    }
    root = ElementTree.Element('testsuites', {name: counts[name] for name in counts if name != 'skipped'})
    suite = ElementTree.SubElement(root, 'testsuite', {'name': line(record.learner), **counts})
    properties = ElementTree.SubElement(suite, 'properties')
    for name, value in (
        ('source', record.source),
        ('sandbox', record.sandbox),
        ('key', record.key),
        ('seed', record.seed),
        ('status', record.status),
    ):
        ElementTree.SubElement(properties, 'property', name=name, value=line(value))
    for (identity, name, verdict, message, seconds), kind in zip(cases, kinds, strict=True):
        case = ElementTree.SubElement(
            suite, 'testcase', classname=line(identity), name=line(name), time=f'{seconds:.3f}'
        )
        if kind:
            # What CI systems show first is the attribute; a `skipped` has no type.
            told = ElementTree.SubElement(case, kind, message=line(message.partition('\n')[0] or verdict, 500))
            told.text = visible(message)
            if kind != 'skipped':
                told.set('type', verdict)
    ElementTree.indent(root)
    # Written by hand: ElementTree would declare the encoding of this machine's locale.
    return f'<?xml version="1.0" encoding="utf-8"?>\n{ElementTree.tostring(root, encoding="unicode")}\n'


def _kind(verdict: str) -> str:
    if verdict == verdicts.PASSED:
        return ''
    if verdict == results.NOT_ATTEMPTED:
        return 'skipped'
    return 'error' if verdict == verdicts.GRADER_ERROR else 'failure'
