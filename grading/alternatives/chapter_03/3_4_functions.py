# Exercise 3.4: a latched map
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
