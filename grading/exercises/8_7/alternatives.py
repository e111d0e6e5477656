from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('declares_at_once', source='''
class StationKeeper(Node):
    def __init__(self, **options):
        super().__init__('delivery_robot', **options)
        self.state = 'idle'
        self.stations = {}
        self.declare_parameters('', [
            ('max_linear', 0.5, bounded('m/s', 0.05, 1.0)), ('max_angular', 1.0, bounded('rad/s', 0.1, 2.0)),
            ('tolerance', 0.1, bounded('m', 0.02, 0.5)), ('timeout', 60.0, bounded('s', 1.0, 600.0)),
            ('status_period', 0.5, bounded('s', 0.1, 10.0))])
        qos = QoSProfile(depth=1)
        qos.durability = DurabilityPolicy.TRANSIENT_LOCAL
        self.out = self.create_publisher(String, 'status', qos)
        self.timer = self.create_timer(self.get_parameter('status_period').value, self.tell)
        self.service = self.create_service(SetStation, 'set_station', self.on_set_station)

    def value(self, name):
        return self.get_parameter(name).value

    def place(self, name):
        return self.stations[name] if name in self.stations else None

    def tell(self):
        self.out.publish(String(data=self.state))

    def on_set_station(self, request, response):
        if not request.name:
            response.message = 'a station needs a name'
            return response
        for number in (request.x, request.y):
            if math.isnan(number) or math.isinf(number):
                response.message = f'{number} is no place'
                return response
        self.stations[request.name] = (request.x, request.y)
        response.success = True
        return response
'''),
    Alternative('a_dataclass_for_a_station', imports='from dataclasses import dataclass', edits=(
        ('class StationKeeper(Node):', """
@dataclass(frozen=True)
class Station:
    x: float
    y: float


class StationKeeper(Node):
"""), ('self.stations[request.name] = request.x, request.y', 'self.stations[request.name] = Station(request.x, request.y)'),
        ('return self.stations.get(name)', """
        station = self.stations.get(name)
        return (station.x, station.y) if station else None
""")), alone=True),
    Alternative('a_named_tuple_for_a_place', imports="""
        from typing import NamedTuple


        class Place(NamedTuple):
            x: float
            y: float
        """, old='self.stations[request.name] = request.x, request.y',
        new='self.stations[request.name] = Place(request.x, request.y)'),
]
