# expect: In the namespace
# rejected by: test_relative_names
# Exercise 8.7: parameters, status and stations
class StationKeeper(Node):
    def __init__(self, **options):
        super().__init__('delivery_robot', **options)
        self.state = 'idle'
        self.stations = {}  # name: (x, y)
        for name, default, low, high, description in (
                ('max_linear', 0.5, 0.05, 1.0, 'fastest drive in m/s'),
                ('max_angular', 1.0, 0.1, 2.0, 'fastest turn in rad/s'),
                ('tolerance', 0.1, 0.02, 0.5, 'so near is there, in m'),
                ('timeout', 60.0, 1.0, 600.0, 'a drive that takes longer is given up, in s'),
                ('status_period', 0.5, 0.1, 10.0, 'from one status to the next in s')):
            self.declare_parameter(name, default, bounded(description, low, high))
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.publisher = self.create_publisher(String, '/status', latched)
        self.create_timer(self.value('status_period'), lambda: self.publisher.publish(String(data=self.state)))
        self.create_service(SetStation, 'set_station', self.on_set_station)

    def value(self, name):
        return self.get_parameter(name).value

    def place(self, name):
        return self.stations.get(name)

    def on_set_station(self, request, response):
        response.success = bool(request.name) and math.isfinite(request.x) and math.isfinite(request.y)
        if response.success:
            self.stations[request.name] = request.x, request.y
        else:
            response.message = 'name must not be empty, x and y must be finite'
        return response
