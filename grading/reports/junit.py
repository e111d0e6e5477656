"""`junit/<learner>.xml`: one test case per test. An `error` is the grader's fault, a `failure` the learner's."""

from xml.etree import ElementTree

from grading.record import Record
from helpers.runner import results, verdicts


def dumps(record: Record) -> str:
    """The report as XML text."""
    cases = []
    for exercise in record.exercises:
        if not exercise.tests:
            cases.append((exercise.id, exercise.title, exercise.verdict, exercise.message))
        cases += [(exercise.id, test.test, test.verdict, test.message or test.expected) for test in exercise.tests]
    kinds = [_kind(verdict) for _, _, verdict, _ in cases]
    suite = ElementTree.Element('testsuite', name=record.learner, tests=str(len(cases)),
                                failures=str(kinds.count('failure')), errors=str(kinds.count('error')),
                                skipped=str(kinds.count('skipped')))
    for (exercise, name, verdict, message), kind in zip(cases, kinds, strict=True):
        case = ElementTree.SubElement(suite, 'testcase', classname=f'exercise {exercise}', name=name)
        if kind:
            ElementTree.SubElement(case, kind, message=verdict).text = message
    ElementTree.indent(suite)
    return ElementTree.tostring(suite, encoding='unicode', xml_declaration=True) + '\n'


def _kind(verdict: str) -> str:
    if verdict == verdicts.PASSED:
        return ''
    if verdict == results.NOT_ATTEMPTED:
        return 'skipped'
    return 'error' if verdict == verdicts.GRADER_ERROR else 'failure'
