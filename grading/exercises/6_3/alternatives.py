from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('transform_full', source='''
import tf2_geometry_msgs


class CupFinder(Node):
    """The buffer transforms a point: the origin of the cup."""

    def __init__(self):
        super().__init__('cup_finder')
        self.buffer = Buffer(Duration(seconds=35.0))
        self.listener = TransformListener(self.buffer, self)

    def where_was(self, seconds):
        origin = PointStamped()
        origin.header.frame_id = 'cup'
        origin.header.stamp = (self.get_clock().now() - Duration(seconds=seconds)).to_msg()
        try:
            return self.buffer.transform_full(origin, 'base_link', Time(), 'map')
        except TransformException as error:
            self.get_logger().info(f'not known: {error}')
'''),
    Alternative('two_steps', source='''
from tf2_geometry_msgs import do_transform_point


class CupFinder(Node):
    """First into the map at that time, then into the robot as it stands now."""

    def __init__(self):
        super().__init__('cup_finder')
        self.buffer = Buffer(cache_time=Duration(seconds=60), node=self)
        self.listener = TransformListener(self.buffer, self)

    def where_was(self, seconds):
        then = Time(nanoseconds=self.get_clock().now().nanoseconds - round(seconds * 1e9),
                    clock_type=self.get_clock().clock_type)
        if not self.buffer.can_transform('map', 'cup', then):
            return None
        if not self.buffer.can_transform('base_link', 'map', Time()):
            return None
        in_map = do_transform_point(PointStamped(), self.buffer.lookup_transform('map', 'cup', then))
        map_in_robot = self.buffer.lookup_transform('base_link', 'map', Time())
        return do_transform_point(in_map, map_in_robot)
'''),
    Alternative('exactly_thirty', old='(seconds=31)', new='(seconds=30)'),
]
