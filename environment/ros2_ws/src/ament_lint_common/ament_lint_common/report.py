"""What each linter does: find the files to check, and write a JUnit file about them."""

import os
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree


@dataclass(frozen=True)
class Case:
    """One line of a report: what was checked, and what was found (`None` if nothing)."""

    name: str
    problem: str | None = None
    details: str = ''


def find_files(paths: Iterable[str], matches: Callable[[str], bool], excludes: Iterable[str] = ()) -> list[str]:
    """
    Return the files to check, in the order of the paths.

    A file is taken as it is named. Of a directory: what `matches` by its name, without directories that hold a file
    AMENT_IGNORE, and without those whose name begins with a dot or an underscore.
    """
    excluded = set(excludes)
    found = []
    for path in paths:
        if os.path.isfile(path):
            found.append(path)
            continue
        for folder, folders, files in os.walk(path):
            if 'AMENT_IGNORE' in (*folders, *files):
                folders.clear()
                continue
            folders[:] = sorted(name for name in folders if name[0] not in '._' and name not in excluded)
            found += [os.path.join(folder, name) for name in sorted(files) if matches(name)]
    normal = (os.path.normpath(path) for path in found)
    return [path for path in normal if path not in excluded and os.path.basename(path) not in excluded]


def write_xunit(file: str, cases: list[Case], seconds: float) -> None:
    """
    Write a JUnit file.

    Its suite has upstream's name: `<folder>.<file without .xunit.xml>`, from `<folder>/<file>`.
    """
    path = Path(file)
    name = f'{path.parent.name}.{path.name.removesuffix(".xml").removesuffix(".xunit")}'
    suite = ElementTree.Element(
        'testsuite',
        {
            'name': name,
            'tests': str(len(cases)),
            'errors': '0',
            'failures': str(sum(case.problem is not None for case in cases)),
            'time': f'{seconds:.3f}',
        },
    )
    for case in cases:
        element = ElementTree.SubElement(suite, 'testcase', {'name': case.name, 'classname': name})
        if case.problem is not None:
            ElementTree.SubElement(element, 'failure', {'message': case.problem}).text = case.details
    checked = ElementTree.SubElement(suite, 'system-out')
    checked.text = 'Checked:' + ''.join(f'\n* {case.name}' for case in cases)
    ElementTree.indent(suite)
    path.parent.mkdir(parents=True, exist_ok=True)
    ElementTree.ElementTree(suite).write(path, encoding='utf-8', xml_declaration=True)
