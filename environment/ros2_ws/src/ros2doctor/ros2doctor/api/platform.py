"""The operating system, and which ROS distribution this is."""

import os
import platform

from ros2doctor.api import DoctorCheck, DoctorReport, Report, Result
from ros2doctor.api.format import doctor_error, doctor_warn

# What rosdistro's index says of the distributions a learner may meet (REP 2000); stock asks over the network.
_ACTIVE = {
    'humble': {'rhel': ['8'], 'ubuntu': ['jammy']},
    'jazzy': {'debian': ['bookworm'], 'rhel': ['9'], 'ubuntu': ['noble']},
    'kilted': {'debian': ['bookworm'], 'rhel': ['9'], 'ubuntu': ['noble']},
    'lyrical': {'debian': ['trixie'], 'rhel': ['10'], 'ubuntu': ['resolute']},
    'rolling': {'debian': ['trixie'], 'rhel': ['10'], 'ubuntu': ['resolute']},
}
_END_OF_LIFE = ('ardent', 'bouncy', 'crystal', 'dashing', 'eloquent', 'foxy', 'galactic', 'iron')


def _distribution():
    return os.environ.get('ROS_DISTRO', '').lower()


class PlatformCheck(DoctorCheck):
    """Look at ROS_DISTRO."""

    def category(self):
        """Return the category."""
        return 'platform'

    def check(self):
        """Check that it names a distribution that is still supported."""
        result = Result()
        name = _distribution()
        if not name:
            doctor_error('ROS_DISTRO is not set.')
            result.add_error()
        elif name in _END_OF_LIFE:
            doctor_warn(
                f'Distribution {name} is no longer supported or deprecated. '
                'To get the latest features, download the latest version at '
                'https://docs.ros.org/en/rolling/Installation.html'
            )
            result.add_warning()
        elif name not in _ACTIVE:
            doctor_warn(f'Distribution name {name} is not found')
            result.add_warning()
        return result


class PlatformReport(DoctorReport):
    """Report the operating system."""

    def category(self):
        """Return the category."""
        return 'platform'

    def report(self):
        """Collect what Python knows."""
        report = Report('PLATFORM INFORMATION')
        report.add_to_report('system', platform.system())
        report.add_to_report('platform info', platform.platform())
        report.add_to_report('release', platform.release())
        report.add_to_report('processor', platform.processor() or platform.machine())
        return report


class RosdistroReport(DoctorReport):
    """Report the ROS distribution."""

    def category(self):
        """Return the category."""
        return 'platform'

    def report(self):
        """Collect what is known of it."""
        report = Report('ROS 2 INFORMATION')
        name = _distribution()
        report.add_to_report('distribution name', name or 'not set')
        if name in _ACTIVE or name in _END_OF_LIFE:
            report.add_to_report('distribution type', 'ros2')
            report.add_to_report('distribution status', 'active' if name in _ACTIVE else 'end-of-life')
        if name in _ACTIVE:
            report.add_to_report('release platforms', _ACTIVE[name])
        return report
