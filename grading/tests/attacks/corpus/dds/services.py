# attack: offers services under the names of the tests' node
# row: 21
# aims at: 90.3
# stopped by: the tests ask no service of their own
# expect verdict: failed
# expect message: messages came
from rcl_interfaces.srv import GetParameters, SetParameters


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        for name in self.get_node_names():
            self.create_service(SetParameters, f'/{name}/set_parameters', lambda request, response: response)
            self.create_service(GetParameters, f'/{name}/get_parameters', lambda request, response: response)
