# attack: destroys the hidden node through which the tests conduct its process
# row: 21
# aims at: 90.3
# stopped by: a test that cannot be conducted is no pass
# expect verdict: failed or learner_crashed or grader_error
# expect message: messages came or disturbed or raised or ended by itself
import gc


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_timer(0.5, self.tick)

    def tick(self):
        for thing in gc.get_objects():
            if type(thing).__name__ == 'Conductor':
                thing.node.destroy_node()
