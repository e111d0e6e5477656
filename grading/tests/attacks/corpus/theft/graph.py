# attack: reads names of tests and their topics from the ROS graph
# row: 22
# aims at: 90.3
# stopped by: the tests' names are random for each test
# expect verdict: failed
# expect message: messages came
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_timer(0.5, self.tick)

    def tick(self):
        names = [*self.get_node_names(), *(name for name, _ in self.get_topic_names_and_types()),
                 *(name for name, _ in self.get_service_names_and_types())]
        search(repr(names), 'the graph')
        for name in names:
            if any(word in name for word in ('test', 'grade', 'hidden', 'prefix')):
                tell('SEEN', name)
