"""Programs with frames for `test_runner`: what a test hears on tf, and what it tells."""

from helpers.tests.small import Case

HEAD = """\
from geometry_msgs.msg import TransformStamped
from rclpy.time import Time
from tf2_ros import Buffer, StaticTransformBroadcaster, TransformBroadcaster, TransformException, TransformListener

def message(parent, child, x, stamp):
    transform = TransformStamped(child_frame_id=child)
    transform.header.frame_id, transform.header.stamp = parent, stamp.to_msg()
    transform.transform.translation.x = x
    return transform

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
"""
SENDS = (
    HEAD
    + """\
        self.moving, static = TransformBroadcaster(self), StaticTransformBroadcaster(self)
        static.sendTransform([message('moving', 'a', 10.0, Time()), message('a', 'b', 100.0, Time())])
        self.create_timer(0.5, self.tick)

    def tick(self):
        now = self.get_clock().now()
        self.moving.sendTransform(message('map', 'moving', now.nanoseconds / 1e9, now))
"""
)
ASKS = (
    HEAD
    + """\
        self.p = self.create_publisher(Float64, 'x', 10)
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.create_timer(0.5, self.tick)

    def tick(self):
        try:
            now = self.get_clock().now()
            found = self.buffer.lookup_transform('map', 'tip', now)
            self.p.publish(Float64(data=found.transform.translation.x))
        except TransformException as error:
            self.get_logger().info(type(error).__name__)
"""
)

CASES = {
    'what is broadcast, at exact times': Case(
        SENDS,
        """
early = learner.tf_listener()
learner.start('Talker')
learner.run(2.1)
assert early.moving.stamps == [0.5, 1.0, 1.5, 2.0]
assert [round(early.matrix('map', 'b', seconds)[0, 3], 6) for seconds in (0.5, 1.25, 2.0)] == [110.5, 111.25, 112.0]
assert early.matrix('map', 'b')[0, 3] == 112.0
assert early.matrix('map', 'b', 2.01) is None and early.matrix('map', 'c') is None
late = learner.tf_listener()
learner.settle()
assert sorted(late.static_transforms) == ['a', 'b'] and not late.transforms
""",
    ),
    'transforms for a listener, at given stamps': Case(
        ASKS,
        """
from helpers.runner.frames import pose
heard, tf = learner.listen('/x', Float64), learner.tf_broadcaster()
learner.start('Talker')
tf.fix('base', 'tip', pose(x=1.0))
tf.send('map', 'base', pose(x=0.0, yaw=0.0), 0.4)
learner.run(0.4)
tf.send('map', 'base', pose(x=2.0, yaw=0.0), 0.6)
learner.run(0.2)
assert [round(value, 6) for value in heard.data] == [2.0], heard.data
tf.send('map', 'base', pose(x=5.0, yaw=3.141592653589793))
learner.run(0.5)
assert len(heard) == 1 and 'ExtrapolationException' in learner.output, learner.output
""",
    ),
    'broken transforms are no fault of the test': Case(
        SENDS.replace('x, stamp):\n', "x, stamp):\n    x = float('nan')\n"),
        """
heard = learner.tf_listener()
learner.start('Talker')
learner.run(1.0)
expect(heard.matrix('map', 'moving') is not None, 'Not a number.')
""",
        'failed',
        ('Not a number.',),
    ),
    'no transforms at all': Case(
        HEAD,
        """
heard = learner.tf_listener()
learner.start('Talker')
learner.run(1.0)
expect(heard.transforms, 'Nothing.')
""",
        'failed',
        ('no publisher on /tf or /tf_static.',),
    ),
    'static transforms that are not latched': Case(
        HEAD
        + """\
        from tf2_msgs.msg import TFMessage
        self.p = self.create_publisher(TFMessage, '/tf_static', 10)
""",
        """
learner.tf_listener()
learner.start('Talker')
learner.run(1.0)
""",
        'failed',
        ('offers durability VOLATILE',),
    ),
    'matrices and messages': Case(
        'def Talker(): pass\n',
        """
import numpy as np
from helpers.runner.frames import pose, to_matrix, to_message
there = pose(1.0, 2.0, 3.0, roll=0.1, pitch=-0.4, yaw=2.5)
assert np.allclose(to_matrix(to_message('map', 'laser', there, 1.5)), there)
left = pose(x=2.0, yaw=np.pi / 2)
assert np.allclose(left @ (1.0, 0.0, 0.0, 1.0), (2.0, 1.0, 0.0, 1.0))
""",
    ),
}
