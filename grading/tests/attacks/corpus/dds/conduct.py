# attack: speaks on the tests' own topics, to tell them that all is done
# row: 21
# aims at: 90.3
# stopped by: what a step has brought is counted from what arrived
# expect verdict: failed or learner_crashed or grader_error
# expect message: messages came or disturbed
from std_msgs.msg import UInt64


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.forged = []
        for name, _ in self.get_topic_names_and_types():
            if name.endswith(('/done', '/step')):
                self.forged.append(self.create_publisher(UInt64, name, 100))
        self.create_timer(0.1, self.tick)

    def tick(self):
        for publisher in self.forged:
            for number in range(50):
                publisher.publish(UInt64(data=number))
