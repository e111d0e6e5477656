"""Publishers and subscriptions of a topic whose quality of service does not fit."""

from rclpy.qos import QoSCompatibility, qos_check_compatible
from ros2cli.node.strategy import NodeStrategy

from ros2doctor.api import DoctorCheck, DoctorReport, Report, Result, visible_topics
from ros2doctor.api.format import doctor_error, doctor_warn


def _pairs():
    """Return (topic, publisher, subscription, compatibility, reason) of each pair."""
    with NodeStrategy(None) as node:
        return [
            (topic, publisher, subscription, *qos_check_compatible(publisher.qos_profile, subscription.qos_profile))
            for topic in visible_topics(node)
            for publisher in node.get_publishers_info_by_topic(topic)
            for subscription in node.get_subscriptions_info_by_topic(topic)
        ]


def _reason_alone(reason):
    """Return the reason without "ERROR: " or "WARNING: " in front."""
    level, _, text = reason.partition(': ')
    return text if level.lower() in ('error', 'warning') else reason


class QoSCompatibilityCheck(DoctorCheck):
    """Look for pairs that cannot talk."""

    def category(self):
        """Return the category."""
        return 'middleware'

    def check(self):
        """Ask rclpy about each pair."""
        result = Result()
        for topic, _, _, compatibility, reason in _pairs():
            if compatibility == QoSCompatibility.WARNING:
                doctor_warn(f"QoS compatibility warning found on topic '{topic}': {_reason_alone(reason)}")
                result.add_warning()
            elif compatibility == QoSCompatibility.ERROR:
                doctor_error(f"QoS compatibility error found on topic '{topic}': {_reason_alone(reason)}")
                result.add_error()
        return result


class QoSCompatibilityReport(DoctorReport):
    """Report all pairs."""

    def category(self):
        """Return the category."""
        return 'middleware'

    def report(self):
        """Collect the pairs."""
        report = Report('QOS COMPATIBILITY LIST')
        for topic, publisher, subscription, compatibility, reason in _pairs():
            report.add_to_report('topic [type]', f'{topic} [{publisher.topic_type}]')
            report.add_to_report('publisher node', publisher.node_name)
            report.add_to_report('subscriber node', subscription.node_name)
            report.add_to_report('compatibility status', 'OK' if compatibility == QoSCompatibility.OK else reason)
        if not report.items:
            report.add_to_report('compatibility status', 'No publisher/subscriber pairs found')
        return report
