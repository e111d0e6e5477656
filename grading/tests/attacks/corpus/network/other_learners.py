# attack: listens to other submissions on their domains
# row: 27
# aims at: 90.3
# stopped by: a network of its own for each submission
# expect verdict: failed
# expect message: messages came
from rclpy.context import Context


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        own = self.get_node_names()
        for domain in range(0, 4):
            context = Context()
            context.init(domain_id=domain)
            node = Node(f'spy{domain}', context=context)
            time.sleep(0.3)
            for name in node.get_node_names():
                if name not in own and not name.startswith(('spy', '_', 'talker')):
                    tell('SEEN', name)
            node.destroy_node()
            context.try_shutdown()
