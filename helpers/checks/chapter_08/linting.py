"""What the tests of exercise 8.1 share: packages as dictionaries, and the comparison of findings."""

from helpers.runner import expect


def package_xml(name: str) -> str:
    """The text of a package.xml for a package with this name."""
    return (f'<?xml version="1.0"?>\n<package format="3">\n  <name>{name}</name>\n  <version>0.1.0</version>\n'
            '  <description>A robot</description>\n  <maintainer email="a@example.com">A</maintainer>\n'
            '  <license>Apache-2.0</license>\n</package>\n')


def bad_names(learner, files: dict[str, str]) -> list[tuple]:
    """What the learner's function reports for these files, as (path, kind, name)."""
    found = learner.call('find_bad_names', files)
    expect(isinstance(found, list) and all(isinstance(one, (list, tuple)) and len(one) == 3 for one in found),
           f'find_bad_names returned {found!r:.200}, expected a list of [path, kind, name].')
    return [tuple(one) for one in found]


def compare(found: list[tuple], expected: list[tuple], where: str = '') -> None:
    """Fail with the first finding that is missing or too many; `where` tells what it shows."""
    def shown(finding):
        path, kind, name = finding
        return f'the {kind} {name!r} in {path}'

    missing = [one for one in expected if one not in found]
    expect(not missing, f'Not reported: {missing and shown(missing[0])}. {where}')
    extra = [one for one in found if one not in expected]
    expect(not extra, f'Reported, though nothing is wrong with it: {extra and shown(extra[0])}. {where}')
