"""The middleware."""

from rclpy.utilities import get_rmw_implementation_identifier

from ros2doctor.api import DoctorReport, Report


class RMWReport(DoctorReport):
    """Report which middleware is used."""

    def category(self):
        """Return the category."""
        return 'middleware'

    def report(self):
        """Ask rclpy."""
        report = Report('RMW MIDDLEWARE')
        report.add_to_report('middleware name', get_rmw_implementation_identifier())
        return report
