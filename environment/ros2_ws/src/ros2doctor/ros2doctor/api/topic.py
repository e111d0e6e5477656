"""Topics that lack a publisher or a subscriber."""

from ros2cli.node.strategy import NodeStrategy

from ros2doctor.api import DoctorCheck, DoctorReport, Report, Result, visible_topics
from ros2doctor.api.format import doctor_warn


class TopicCheck(DoctorCheck):
    """Look for topics with only one side."""

    def category(self):
        """Return the category."""
        return 'topic'

    def check(self):
        """Compare the counts."""
        result = Result()
        with NodeStrategy(None) as node:
            for topic in visible_topics(node):
                publishers, subscribers = node.count_publishers(topic), node.count_subscribers(topic)
                if publishers > subscribers:
                    doctor_warn(f'Publisher without subscriber detected on {topic}.')
                    result.add_warning()
                elif publishers < subscribers:
                    doctor_warn(f'Subscriber without publisher detected on {topic}.')
                    result.add_warning()
        return result


class TopicReport(DoctorReport):
    """Report the counts of each topic."""

    def category(self):
        """Return the category."""
        return 'topic'

    def report(self):
        """Count publishers and subscribers."""
        report = Report('TOPIC LIST')
        with NodeStrategy(None) as node:
            topics = visible_topics(node)
            counts = [(each, node.count_publishers(each), node.count_subscribers(each)) for each in topics]
        for topic, publishers, subscribers in counts or [('none', 0, 0)]:
            report.add_to_report('topic', topic)
            report.add_to_report('publisher count', publishers)
            report.add_to_report('subscriber count', subscribers)
        return report
