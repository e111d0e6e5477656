"""Names that a fault draws, so that no two systems are alike."""

ROBOTS = ('rover', 'crawler', 'porter', 'scout', 'picker', 'tanker', 'ranger', 'walker')
#: What a sensor measures: topic, node, unit.
SENSORS = (
    ('temperature', 'thermometer', 'degrees'),
    ('pressure', 'barometer', 'hectopascal'),
    ('battery', 'battery_monitor', 'percent'),
    ('wheel_speed', 'encoder', 'ticks'),
    ('distance', 'sonar', 'centimetres'),
    ('humidity', 'hygrometer', 'percent'),
    ('heading', 'compass', 'degrees'),
    ('load', 'scale', 'grams'),
)
LISTENERS = ('display', 'logger', 'dashboard', 'supervisor', 'alarm', 'recorder')
ROOMS = ('kitchen', 'cellar', 'garage', 'attic', 'lab', 'hall', 'garden', 'workshop')
#: Services: name, server, client.
SERVICES = (
    ('check_battery', 'battery_guard', 'mission'),
    ('open_gripper', 'gripper', 'picker'),
    ('reset_odometry', 'odometer', 'navigator'),
    ('calibrate', 'scale', 'loader'),
    ('start_pump', 'pump', 'gardener'),
    ('lock_door', 'door', 'watchman'),
)
SENSOR_FRAMES = ('laser', 'camera', 'gps', 'imu', 'sonar', 'gripper')


def misspelt(word: str, random) -> str:
    """A name that looks like ``word`` and is not: two letters change places, or one is missing or too much."""
    ways = [word[:i] + word[i + 1] + word[i] + word[i + 2 :] for i in range(1, len(word) - 1) if word[i] != word[i + 1]]
    ways += [word[:i] + word[i + 1 :] for i in range(2, len(word))]
    ways += [word.removesuffix('s') if word.endswith('s') else word + 's']
    return random.choice(sorted({way for way in ways if way != word and not way.endswith('_') and '__' not in way}))
