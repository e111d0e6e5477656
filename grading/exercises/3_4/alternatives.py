from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('functions', source='''
from rclpy.qos import QoSDurabilityPolicy, QoSProfile
from nav_msgs.msg import OccupancyGrid

profile = QoSProfile(depth=1)
profile.durability = QoSDurabilityPolicy.TRANSIENT_LOCAL


def MapServer(rows):
    node = rclpy.create_node('map_server')
    grid = OccupancyGrid()
    for row in rows:
        for letter in row:
            grid.data.append(100 if letter == '#' else 0 if letter == '.' else -1)
    grid.info.width = len(rows[0])
    grid.info.height = len(rows)
    grid.info.resolution = 0.1
    grid.header.frame_id = 'map'
    node.create_publisher(OccupancyGrid, 'map', profile).publish(grid)
    return node


def MapReader():
    node = rclpy.create_node('map_reader')
    walls = node.create_publisher(Int32, 'walls', profile)
    node.create_subscription(OccupancyGrid, 'map',
                             lambda grid: walls.publish(Int32(data=sum(c == 100 for c in grid.data))), profile)
    return node
'''),
    Alternative('numpy', source='''
import numpy as np
from nav_msgs.msg import OccupancyGrid
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import Int32


def latched_profile():
    return QoSProfile(reliability=ReliabilityPolicy.RELIABLE, durability=DurabilityPolicy.TRANSIENT_LOCAL,
                      history=HistoryPolicy.KEEP_LAST, depth=1)


class MapServer(Node):
    def __init__(self, rows):
        super().__init__('map_server')
        letters = np.array([list(row) for row in rows])
        cells = np.select([letters == '#', letters == '.'], [100, 0], default=-1).astype(np.int8)
        grid = OccupancyGrid()
        grid.header.frame_id = 'map'
        grid.header.stamp = self.get_clock().now().to_msg()
        grid.info.height, grid.info.width = cells.shape
        grid.info.resolution = 0.1
        grid.data = cells.flatten().tolist()
        self.create_publisher(OccupancyGrid, 'map', latched_profile()).publish(grid)


class MapReader(Node):
    def __init__(self):
        super().__init__('map_reader')
        walls = self.create_publisher(Int32, 'walls', latched_profile())

        def on_map(grid):
            walls.publish(Int32(data=int(np.sum(np.array(grid.data) == 100))))

        self.create_subscription(OccupancyGrid, 'map', on_map, latched_profile())
'''),
]
