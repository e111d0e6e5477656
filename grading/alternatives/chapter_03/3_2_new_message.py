# Exercise 3.2: from centimetres to metres
METRE = 100.0  # cm


class RangeToMetres(Node):
    def __init__(self):
        super().__init__('range_to_metres')
        self.out = self.create_publisher(Range, 'sonar', 10)
        self.create_subscription(Range, 'sonar_cm', lambda msg: self.out.publish(self.converted(msg)), 10)

    @staticmethod
    def converted(msg):
        return Range(header=msg.header, radiation_type=msg.radiation_type, field_of_view=msg.field_of_view,
                     min_range=msg.min_range / METRE, max_range=msg.max_range / METRE, range=msg.range / METRE,
                     variance=msg.variance / METRE / METRE)
