# attack: sets parameters of every node that it finds
# row: 20
# aims at: 90.3
# stopped by: the tests' node has no parameter services
# expect verdict: failed
# expect message: messages came
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_timer(0.5, self.tick)

    def tick(self):
        own = (self.get_name(),)
        for name, kinds in self.get_service_names_and_types():
            if name.endswith('set_parameters') and not name.startswith(tuple(f'/{node}/' for node in own)):
                tell('SEEN', name)
