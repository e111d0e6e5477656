"""Checks and reports: plug-ins of the groups `ros2doctor.checks` and `ros2doctor.report`."""

from collections.abc import Iterator
from typing import Any

from ros2cli.entry_points import get_entry_points

from ros2doctor.api.format import doctor_warn


class Result:
    """How many errors and warnings a check has found; it has printed them."""

    def __init__(self) -> None:
        """Begin with none."""
        self.error = 0
        self.warning = 0

    def add_error(self) -> None:
        """Count an error."""
        self.error += 1

    def add_warning(self) -> None:
        """Count a warning."""
        self.warning += 1


class DoctorCheck:
    """Base class of a check."""

    def category(self) -> str:
        """Return the word that stands for the check in the summary."""
        raise NotImplementedError

    def check(self) -> Result:
        """Look for problems and print them."""
        raise NotImplementedError


class Report:
    """A heading and lines of a name and a value."""

    def __init__(self, name: str) -> None:
        """Begin with no lines."""
        self.name = name
        self.items: list[tuple[str, Any]] = []

    def add_to_report(self, item_name: str, item_info: Any) -> None:
        """Add a line."""
        self.items.append((item_name, item_info))


class DoctorReport:
    """Base class of a report."""

    def category(self) -> str:
        """Return the category of the check that this report is about."""
        raise NotImplementedError

    def report(self) -> Report:
        """Collect the facts."""
        raise NotImplementedError


def _load(group: str, kind: str) -> Iterator[tuple[str, Any]]:
    for name, entry_point in sorted(get_entry_points(group).items()):
        try:
            yield name, entry_point.load()()
        except Exception as e:  # one broken plug-in must not take the others down
            doctor_warn(f'Fail to load {kind} {name}: {e}')


def run_checks(*, include_warnings: bool = False, exclude_packages: bool = False) -> tuple[set[str], int, int]:
    """
    Run all checks.

    :param include_warnings: a warning makes a check fail as well.
    :param exclude_packages: leave out the check of packages.
    :return: the categories that failed, how many checks failed, and how many there were.
    """
    failed_categories: set[str] = set()
    failed = total = 0
    for name, check in _load('ros2doctor.checks', 'check entry point'):
        if exclude_packages and name == 'PackageCheck':
            continue
        try:
            result = check.check()
        except Exception as e:  # a check that breaks has found out nothing
            doctor_warn(f'Fail to call {name}: {e}')
            continue
        total += 1
        if result.error or (include_warnings and result.warning):
            failed += 1
            failed_categories.add(check.category())
    return failed_categories, failed, total


def generate_reports(*, categories: Any = None, exclude_packages: bool = False) -> list[Report]:
    """Return all reports, or those of some categories; with ``exclude_packages`` without that of packages."""
    reports = []
    for name, report in _load('ros2doctor.report', 'report entry point'):
        if exclude_packages and name == 'PackageReport':
            continue
        if categories is None or report.category() in categories:
            try:
                reports.append(report.report())
            except Exception as e:
                doctor_warn(f'Fail to call {name}: {e}')
    return reports


def visible_topics(node: Any) -> list[str]:
    """Return the topics of the graph without hidden ones and those that every node has."""
    from ros2topic.api import get_topic_names

    return [name for name in get_topic_names(node=node) if name not in ('/parameter_events', '/rosout')]
