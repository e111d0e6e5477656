# expect: is there one buffer, with one listener, for the life of the node?
# rejected by: test_again
# Exercise 6.3: where was the cup?
class CupFinder(Node):
    def __init__(self):
        super().__init__('cup_finder')
        self.buffer = Buffer(Duration(seconds=31))
        self.listener = TransformListener(self.buffer, self)

    def where_was(self, seconds):
        self.buffer = Buffer(Duration(seconds=31))
        self.listener = TransformListener(self.buffer, self)
        then = self.get_clock().now() - Duration(seconds=seconds)
        try:
            found = self.buffer.lookup_transform_full('base_link', Time(), 'cup', then, 'map')
        except TransformException:
            return None
        point = PointStamped(header=found.header)
        place = found.transform.translation
        point.point.x, point.point.y, point.point.z = place.x, place.y, place.z
        return point
