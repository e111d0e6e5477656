"""The report of a launch test."""

from __future__ import annotations

import unittest
from xml.etree import ElementTree

from launch_testing.loader import TestRun


def unittestResultsToXml(
    *, name: str = 'launch_test', test_results: dict[TestRun | str, unittest.TestResult]
) -> ElementTree.ElementTree:
    """Return the results as JUnit's XML: a suite for each run or name of a run, a case for each of unittest."""
    root = ElementTree.Element('testsuites', {'name': name})
    suites = [_suite(run, result) for run, result in test_results.items()]
    root.extend(suites)
    for key in ('tests', 'failures', 'errors', 'skipped'):
        root.set(key, str(sum(int(suite.get(key)) for suite in suites)))
    root.set('time', f'{sum(float(suite.get("time")) for suite in suites):.3f}')
    return ElementTree.ElementTree(root)


def _suite(run: TestRun | str, result: unittest.TestResult) -> ElementTree.Element:
    suite = ElementTree.Element('testsuite', {'name': str(run)})
    told = {}
    for tag, entries in (('failure', result.failures), ('error', result.errors), ('skipped', result.skipped)):
        told.update({str(case): (tag, text) for case, text in entries})
    for case in run.all_cases() if isinstance(run, TestRun) else _cases(result):
        element = ElementTree.SubElement(
            suite,
            'testcase',
            {
                'classname': f'{type(case).__module__}.{type(case).__name__}',
                'name': case._testMethodName,
                'time': f'{result.seconds.get(case, 0.0):.3f}',
            },
        )
        tag, text = told.pop(str(case), (None, ''))
        if tag is None and case not in result.seconds:  # such as one whose setUpClass failed
            tag = 'skipped'
        if tag is not None:
            ElementTree.SubElement(element, tag, {'message': text.strip().rpartition('\n')[2]}).text = text
    for name, (tag, text) in told.items():  # what is no case, such as setUpClass
        element = ElementTree.SubElement(suite, 'testcase', {'classname': str(run), 'name': name, 'time': '0'})
        ElementTree.SubElement(element, tag, {'message': text.strip().rpartition('\n')[2]}).text = text
    suite.set('tests', str(len(suite)))
    for key, tag in (('failures', 'failure'), ('errors', 'error'), ('skipped', 'skipped')):
        suite.set(key, str(len(suite.findall(f'testcase/{tag}'))))
    suite.set('time', f'{sum(result.seconds.values()):.3f}')
    return suite


def _cases(result: unittest.TestResult) -> list[unittest.TestCase]:
    """Return the cases that a result knows, each once."""
    told = [case for case, _ in (*result.failures, *result.errors, *result.skipped) if hasattr(case, '_testMethodName')]
    return list(dict.fromkeys([*result.seconds, *told]))
