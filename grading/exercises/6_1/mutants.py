from grading.variants import Mutant

MUTANTS = [
    Mutant('a_tilt_of_0_is_none', breaks='tilt', old='math.radians(tilt)', new='math.radians(tilt or 20.0)',
           expect='made in a program that has others'),
    Mutant('a_height_of_0_is_none', breaks='places', old='self.broadcaster = StaticTransformBroadcaster(self)', new='''
           height = height or 1.0
           self.broadcaster = StaticTransformBroadcaster(self)
           ''', expect='made in a program that has others'),
    Mutant('one_height_for_all', breaks='places', old='self.broadcaster = StaticTransformBroadcaster(self)', new='''
           SensorMast.height = getattr(SensorMast, 'height', height)
           height = SensorMast.height
           self.broadcaster = StaticTransformBroadcaster(self)
           ''', expect='made in a program that has others'),
    Mutant('a_moment_later', breaks='late', edits=(
           ('self.broadcaster = StaticTransformBroadcaster(self)', '''
            self.broadcaster = StaticTransformBroadcaster(self)
            self.timer = self.create_timer(
                0.1, lambda: (self.timer.cancel(), self.broadcaster.sendTransform(self.frames)))
            '''), ('self.broadcaster.sendTransform([', 'self.frames = list([')),
           expect='Send the transforms in the constructor'),
    Mutant('never_steeper_than_45', breaks='tilt', old='math.radians(tilt)', new='math.radians(min(tilt, 45))',
           expect='the camera looks along'),
    Mutant('all_on_the_base', breaks='tree', also='optical', old='''
        transform('mast', 'lidar', z=height, roll=math.pi),
        transform('mast', 'camera', x=0.05, z=height - 0.1, pitch=math.radians(tilt)),
        transform('camera', 'camera_optical', roll=-math.pi / 2, yaw=-math.pi / 2),
        ''', new='''
        transform('base_link', 'lidar', z=height, roll=math.pi),
        transform('base_link', 'camera', x=0.05, z=height - 0.1, pitch=math.radians(tilt)),
        transform('base_link', 'camera_optical', roll=-math.pi / 2, yaw=-math.pi / 2),
        ''', expect='The parent of `lidar` is `base_link`'),
    Mutant('degrees', breaks='tilt', old='math.radians(tilt)', new='tilt', expect='The tilt was taken for radians'),
    Mutant('last_one_only', breaks='late', edits=(('''
            self.broadcaster = StaticTransformBroadcaster(self)
            self.broadcaster.sendTransform([
            ''', '''
            latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
            self.publisher = self.create_publisher(TFMessage, '/tf_static', latched)
            for message in (
            '''),
            ('])', '''
            ):
                self.publisher.publish(TFMessage(transforms=[message]))
            ''')), imports='''
        from rclpy.qos import DurabilityPolicy, QoSProfile
        from tf2_msgs.msg import TFMessage
        ''', expect='It gets the last message of each publisher'),
    Mutant('lidar_looks_back', breaks='lidar', old=', roll=math', new=', pitch=math',
           expect='The x axis of the lidar points along (-1, 0, 0)'),
    Mutant('looks_up', breaks='tilt', old='pitch=math.', new='pitch=-math.', expect='That is up.'),
    Mutant('on_tf', breaks='late', old='StaticTransformBroadcaster', new='TransformBroadcaster',
           expect='Your transforms went to /tf.'),
    Mutant('optical_is_camera', breaks='optical', old="', roll=-math.pi / 2, yaw=-math.pi / 2)", new="')",
           expect='The z axis of camera_optical points along (0, 0, 1)'),
    Mutant('place_in_base_link', breaks='places', old='0.05, z=height - 0.1', new='-0.05, z=height + 0.2', expect='`camera` is at'),
    Mutant('swapped', breaks='tree', old='''
        transform('base_link', 'mast', x=-0.1, z=0.3),
        transform('mast', 'lidar', z=height, roll=math.pi),
        transform('mast', 'camera', x=0.05, z=height - 0.1, pitch=math.radians(tilt)),
        transform('camera', 'camera_optical', roll=-math.pi / 2, yaw=-math.pi / 2),
        ''', new='''
        transform('mast', 'base_link', x=-0.1, z=0.3),
        transform('lidar', 'mast', z=height, roll=math.pi),
        transform('camera', 'mast', x=0.05, z=height - 0.1, pitch=math.radians(tilt)),
        transform('camera_optical', 'camera', roll=-math.pi / 2, yaw=-math.pi / 2),
        ''', expect='Parent and child are swapped'),
    Mutant('w_first', breaks='places', also=('tilt', 'lidar', 'optical'), source='''
def placed(parent, child, roll=0.0, pitch=0.0, yaw=0.0, **place):
    message = transform(parent, child, **place)
    x, y, z, w = map(float, quaternion_from_euler(roll, pitch, yaw))
    message.transform.rotation = Quaternion(x=w, y=x, z=y, w=z)
    return message


class SensorMast(Node):
    def __init__(self, height=1.0, tilt=20.0):
        super().__init__('sensor_mast')
        self.broadcaster = StaticTransformBroadcaster(self)
        self.broadcaster.sendTransform([
            placed('base_link', 'mast', x=-0.1, z=0.3),
            placed('mast', 'lidar', z=height, roll=math.pi),
            placed('mast', 'camera', x=0.05, z=height - 0.1, pitch=math.radians(tilt)),
            placed('camera', 'camera_optical', roll=-math.pi / 2, yaw=-math.pi / 2),
        ])
''', expect='In which order does a Quaternion have x, y, z and w?'),
    Mutant('another_name', breaks='name', old="('sensor_mast')", new="('mast')", expect='expected /sensor_mast'),
    Mutant('height_of_the_example', breaks='places', old="'lidar', z=height", new="'lidar', z=1.0",
           expect='`lidar` is at'),
    Mutant('tilt_of_the_example', breaks='tilt', old='math.radians(tilt)', new='math.radians(20.0)',
           expect='the camera looks along'),
    Mutant('lidar_stands', breaks='lidar', old=', roll=math.pi)', new=')', expect='The lidar stands upright'),
    Mutant('one_more_frame', breaks='tree', old="transform('base_link', 'mast', x=-0.1, z=0.3),", new='''
        transform('base_link', 'mast', x=-0.1, z=0.3),
        transform('map', 'base_link'),
        ''', expect='There is one more frame, `base_link`'),
    Mutant('optical_turned_by_positive_angles', breaks='optical', old='roll=-math.pi / 2, yaw=-math.pi / 2',
           new='roll=math.pi / 2, yaw=math.pi / 2', expect='axis of camera_optical points along'),
    Mutant('never_looks_up', old='pitch=math.radians(tilt)', new='pitch=math.radians(abs(tilt))',
           expect='with a negative tilt it looks up', breaks='tilt'),
    Mutant('never_below_the_mast', old='z=height - 0.1, pitch', new='z=max(0.0, height - 0.1), pitch',
           expect='`camera` is at', breaks='places'),
    Mutant('lidar_again_and_again', old='self.broadcaster.sendTransform([', new="""
        self.moving = TransformBroadcaster(self)
        self.create_timer(0.5, lambda: self.moving.sendTransform(transform('mast', 'lidar', z=height, roll=math.pi)))
        self.broadcaster.sendTransform([
        """, expect='also went to /tf', breaks='late', also=('places', 'tilt', 'tree', 'lidar', 'optical')),
    Mutant('camera_again_every_5_s', old='self.broadcaster.sendTransform([', new="""
        self.moving = TransformBroadcaster(self)
        self.create_timer(5.0, lambda: self.moving.sendTransform(transform('mast', 'camera', z=height, pitch=tilt)))
        self.broadcaster.sendTransform([
        """, expect='also went to /tf', breaks='late', also=('places', 'tilt', 'tree', 'lidar', 'optical')),
    Mutant('one_more_frame_later', old='self.broadcaster = StaticTransformBroadcaster(self)', new="""
        self.broadcaster = StaticTransformBroadcaster(self)
        self.timer = self.create_timer(3.0, lambda: self.broadcaster.sendTransform(transform('map', 'base_link')))
        """, expect='There is one more frame, `base_link`', breaks='tree'),
    Mutant('lidar_stands_up_later', old='self.broadcaster = StaticTransformBroadcaster(self)', new="""
        self.broadcaster = StaticTransformBroadcaster(self)
        self.timer = self.create_timer(4.0, lambda: self.broadcaster.sendTransform(transform('mast', 'lidar', z=height)))
        """, expect='The lidar stands upright', breaks='lidar'),
    Mutant('height_in_millimetres', old='self.broadcaster = StaticTransformBroadcaster(self)', new="""
        height = round(height, 3)
        self.broadcaster = StaticTransformBroadcaster(self)
        """, expect='made in a program that has others', breaks='places'),
    Mutant('never_further_up_than_90', breaks='tilt', old='math.radians(tilt)', new='math.radians(max(tilt, -90))',
           expect='made in a program that has others'),
    Mutant('never_further_down_than_180', breaks='tilt', old='math.radians(tilt)', new='math.radians(min(tilt, 180))',
           expect='made in a program that has others'),
]
