"""Installed packages and their versions. Stock compares them with rosdistro's; this works without a network."""

from pathlib import Path
from xml.etree import ElementTree

from ros2doctor.api import DoctorCheck, DoctorReport, Report, Result
from ros2doctor.api.format import doctor_error, doctor_warn


def get_local_package_versions():
    """Return the version of each package; an empty text if its manifest cannot be read."""
    from ament_index_python import get_packages_with_prefixes

    versions = {}
    for name, prefix in sorted(get_packages_with_prefixes().items()):
        try:
            root = ElementTree.parse(Path(prefix, 'share', name, 'package.xml')).getroot()
            versions[name] = (root.findtext('version') or '').strip()
        except (OSError, ElementTree.ParseError):
            versions[name] = ''
    return versions


class PackageCheck(DoctorCheck):
    """Look for packages, and for those without a readable manifest."""

    def category(self):
        """Return the category."""
        return 'package'

    def check(self):
        """Check all packages on AMENT_PREFIX_PATH."""
        result = Result()
        versions = get_local_package_versions()
        if not versions:
            doctor_error('local package info is not found.')
            result.add_error()
        missing = [name for name, version in versions.items() if not version]
        if missing:
            doctor_warn(
                f'Cannot find local versions of packages: {" ".join(missing)}. '
                'Use `ros2 doctor --report` to see full list.'
            )
            result.add_warning()
        return result


class PackageReport(DoctorReport):
    """Report the version of each package."""

    def category(self):
        """Return the category."""
        return 'package'

    def report(self):
        """Collect the versions."""
        report = Report('PACKAGE VERSIONS')
        for name, version in get_local_package_versions().items():
            report.add_to_report(name, f'latest=N/A, local={version}')
        return report
