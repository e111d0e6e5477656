from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('element_tree_and_cylinder', source='''
from xml.etree import ElementTree as tree


def scout(radius, separation, mast):
    """Made of elements. A round body, a pole below the laser, motors with limits."""
    robot = tree.Element('robot', name='round')

    def body(name, place='0 0 0', turn='0 0 0', mass=None, moments=(), **shape):
        link = tree.SubElement(robot, 'link', name=name)
        if not shape:
            return
        (kind, sizes), = shape.items()
        for part in ('visual', 'collision', 'inertial')[:2 if mass is None else 3]:
            element = tree.SubElement(link, part)
            tree.SubElement(element, 'origin', xyz=place, rpy=turn)
            if part != 'inertial':
                geometry = tree.SubElement(element, 'geometry')
                tree.SubElement(geometry, kind, {key: str(value) for key, value in sizes.items()})
        if mass is not None:
            tree.SubElement(element, 'mass', value=str(mass))
            values = dict(zip(('ixx', 'iyy', 'izz'), map(str, moments)), ixy='0', ixz='0', iyz='0')
            tree.SubElement(element, 'inertia', values)

    def fixed(child, parent, xyz):
        joint = tree.SubElement(robot, 'joint', name=f'{child}_joint', type='fixed')
        tree.SubElement(joint, 'parent', link=parent)
        tree.SubElement(joint, 'child', link=child)
        tree.SubElement(joint, 'origin', xyz=xyz)
        return joint

    body('base_footprint')
    side = mass = 2.5
    r, h = separation / 2 - 0.03, 0.05
    across = mass * (3 * r**2 + h**2) / 12
    body('base_link', f'-0.05 0 0.02', mass=mass, moments=(across, across, mass * r**2 / 2),
         cylinder={'radius': r, 'length': h})
    fixed('base_link', 'base_footprint', f'0 0 {radius}')
    for side, sign in (('left', 1), ('right', -1)):
        # The origin of <inertial> is turned with the cylinder: so its third moment is that of the axle.
        across = 0.3 * (3 * radius**2 + 0.01**2) / 12
        body(f'{side}_wheel', turn='-1.570796 0 0', mass=0.3, moments=(across, across, 0.3 * radius**2 / 2),
             cylinder={'radius': radius, 'length': 0.01})
        joint = fixed(f'{side}_wheel', 'base_link', f'0 {sign * separation / 2} 0')
        joint.set('type', 'continuous')
        tree.SubElement(joint, 'axis', xyz='0 2 0')
        tree.SubElement(joint, 'limit', effort='2', velocity='20')
    body('caster', sphere={'radius': 0.02})
    fixed('caster', 'base_link', f'-0.12 0 {0.02 - radius}')
    body('pole', f'0 0 {(mast - 0.05) / 2}', cylinder={'radius': 0.01, 'length': mast - 0.1 - radius})
    fixed('pole', 'base_link', '0 0 0')
    body('laser')
    fixed('laser', 'base_link', f'0 0 {mast - radius}')
    friction = tree.SubElement(robot, 'gazebo', reference='caster')
    tree.SubElement(friction, 'mu1').text = tree.SubElement(friction, 'mu2').text = '0.0'
    sensor = tree.SubElement(tree.SubElement(robot, 'gazebo', reference='laser'), 'sensor', name='eye', type='gpu_lidar')
    lidar = tree.SubElement(sensor, 'lidar')
    tree.SubElement(tree.SubElement(tree.SubElement(lidar, 'scan'), 'horizontal'), 'samples').text = '180'
    reach = tree.SubElement(lidar, 'range')
    tree.SubElement(reach, 'min').text, tree.SubElement(reach, 'max').text = '0.1', '12'
    plugin = tree.SubElement(tree.SubElement(robot, 'gazebo'), 'plugin', filename='gz-sim-diff-drive-system',
                             name='gz::sim::systems::DiffDrive')
    for key, value in (('left_joint', 'left_wheel_joint'), ('right_joint', 'right_wheel_joint'),
                       ('wheel_separation', separation), ('wheel_radius', radius),
                       ('max_linear_acceleration', 1.0), ('max_angular_acceleration', 4.0)):
        tree.SubElement(plugin, key).text = str(value)
    return tree.tostring(robot, encoding='unicode')
'''),
    Alternative('the_robot_of_the_course', source='''
import re


def scout(radius, separation, mast):
    """The course's robot, with other numbers; its camera stays."""
    text = mobile_robot_description.urdf()
    text = text.replace('<origin xyz="0 0 0.08"/>', f'<origin xyz="0 0 {radius}"/>')
    text = text.replace('cylinder radius="0.08"', f'cylinder radius="{radius}"')
    across, axle = 0.5 * (3 * radius**2 + 0.004**2) / 12, 0.5 * radius**2 / 2
    text = text.replace('ixx="0.0009" iyy="0.0016" izz="0.0009"', f'ixx="{across}" iyy="{axle}" izz="{across}"')
    text = text.replace('0 0.18 0', f'0 {separation / 2} 0').replace('0 -0.18 0', f'0 {-separation / 2} 0')
    text = text.replace('-0.12 0 -0.05', f'-0.12 0 {0.03 - radius}')
    text = text.replace('0.05 0 0.126', f'0 0 {mast - radius}')
    text = text.replace('<collision><origin xyz="0 0 0.043"/>', '<collision><origin xyz="-0.03 0 0.043"/>')
    text = text.replace('xyz="-0.03 0 0.02"', 'xyz="-0.03 0 0.043"')
    text = text.replace('>0.36<', f'>{separation}<').replace('<wheel_radius>0.08<', f'<wheel_radius>{radius}<')
    return text
'''),
    Alternative('one_text_and_sphere', source='''
def scout(radius, separation, mast):
    """One text. The body is a ball on a tray; the caster is as large as the axle is high."""
    def inertia(x, y, z):
        return f'<inertia ixx="{x}" ixy="0" ixz="0" iyy="{y}" iyz="0" izz="{z}"/>'

    wheel = f"""<visual><origin rpy="-1.570796 0 0"/><geometry><cylinder radius="{radius}" length="0.01"/></geometry></visual>
      <collision><origin rpy="-1.570796 0 0"/><geometry><cylinder radius="{radius}" length="0.01"/></geometry></collision>
      <inertial><mass value="1.0"/>{inertia(radius**2 / 4, radius**2 / 2, radius**2 / 4)}</inertial>"""
    ball = 0.4 * 4.0 * 0.05**2
    return f"""<?xml version="1.0"?>
    <robot name="ball">
      <link name="laser"/>
      <link name="base_link">
        <collision><origin xyz="-0.07 0 0.03"/><geometry><sphere radius="0.05"/></geometry></collision>
        <inertial><mass value="4.0"/><origin xyz="-0.07 0 0.03"/>{inertia(ball, ball, ball)}</inertial>
      </link>
      <link name="base_footprint"/>
      <link name="caster"><collision><geometry><sphere radius="{radius}"/></geometry></collision></link>
      <link name="left_wheel">{wheel}</link>
      <link name="right_wheel">{wheel}</link>
      <joint name="to_the_axle" type="fixed">
        <parent link="base_footprint"/><child link="base_link"/><origin xyz="0 0 {radius}"/>
      </joint>
      <joint name="left_wheel_joint" type="continuous">
        <parent link="base_link"/><child link="left_wheel"/><axis xyz="0 1 0"/><origin xyz="0 {separation / 2} 0"/>
      </joint>
      <joint name="right_wheel_joint" type="continuous">
        <parent link="base_link"/><child link="right_wheel"/><axis xyz="0 1 0"/><origin xyz="0 {-separation / 2} 0"/>
      </joint>
      <joint name="behind" type="fixed">
        <parent link="base_link"/><child link="caster"/><origin xyz="-0.2 0 0"/>
      </joint>
      <joint name="above" type="fixed">
        <parent link="base_link"/><child link="laser"/><origin xyz="0 0 {mast - radius}"/>
      </joint>
      <gazebo reference="caster"><mu1>0</mu1></gazebo>
      <gazebo reference="laser">
        <sensor name="laser" type="gpu_lidar"><lidar>
          <scan><horizontal><samples>720</samples><min_angle>0</min_angle><max_angle>6.27</max_angle></horizontal></scan>
          <range><min>0.1</min><max>6.0</max></range>
        </lidar></sensor>
      </gazebo>
      <gazebo><plugin name="gz::sim::systems::DiffDrive" filename="gz-sim-diff-drive-system">
        <wheel_radius>{radius}</wheel_radius><wheel_separation>{separation}</wheel_separation>
        <left_joint>left_wheel_joint</left_joint><right_joint>right_wheel_joint</right_joint>
      </plugin></gazebo>
    </robot>"""
'''),
]
