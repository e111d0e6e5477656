# attack: names its node like the tests' node
# row: 21
# aims at: 90.3
# stopped by: the tests know their own endpoints by participant
# expect verdict: failed
# expect message: messages came
class Talker(Node):
    def __init__(self):
        probe = Node('probe')
        end = time.monotonic() + 1
        names = []
        while not names and time.monotonic() < end:
            names = [name for name in probe.get_node_names() if name.endswith('_t')]
            time.sleep(0.01)
        probe.destroy_node()
        super().__init__(names[0] if names else 'talker')
