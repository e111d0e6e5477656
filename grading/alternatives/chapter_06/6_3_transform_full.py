# Exercise 6.3: where was the cup?
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
