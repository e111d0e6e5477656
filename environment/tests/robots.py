"""Small robot descriptions."""

ARM = """<?xml version="1.0" encoding="utf-8"?>
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <material name="blue"><color rgba="0 0 1 1"/></material>
  <link name="base">
    <visual>
      <origin xyz="0 0 0.1" rpy="0 0 1.5707963267948966"/>
      <geometry><box size="0.2 0.3 0.4"/></geometry>
      <material name="blue"/>
    </visual>
    <visual><geometry><sphere radius="0.05"/></geometry></visual>
    <collision><geometry><cylinder radius="0.1" length="0.5"/></geometry></collision>
    <inertial>
      <mass value="2"/><inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="3"/>
    </inertial>
  </link>
  <link name="upper"/>
  <link name="slider"/>
  <link name="finger"/>
  <link name="camera">
    <visual>
      <geometry><mesh filename="package://somewhere/camera.stl" scale="1 2 3"/></geometry>
      <material name=""><color rgba="1 0 0 0.5"/></material>
    </visual>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="base"/><child link="upper"/>
    <origin xyz="0 0 1" rpy="0 0 1.5707963267948966"/>
    <axis xyz="0 2 0"/>
    <limit lower="0.5" upper="1.5" effort="1" velocity="1"/>
    <safety_controller k_velocity="1" soft_lower_limit="0.7"/>
  </joint>
  <joint name="lift" type="prismatic">
    <parent link="upper"/><child link="slider"/>
    <origin rpy="0 1.5707963267948966 0"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
  <joint name="grip" type="continuous">
    <parent link="slider"/><child link="finger"/>
    <axis xyz="0 0 1"/>
    <mimic joint="shoulder" multiplier="-2" offset="0.25"/>
  </joint>
  <joint name="camera_joint" type="fixed">
    <parent link="base"/><child link="camera"/>
    <origin xyz="0.1 0 0.2"/>
  </joint>
</robot>
"""


def robot(*parts: str) -> str:
    """Return a robot with the links a and b, and what is given."""
    return '<robot name="r">\n<link name="a"/>\n<link name="b"/>\n' + '\n'.join(parts) + '\n</robot>'


def joint(kind: str = 'fixed', inside: str = '', parent: str = 'a', child: str = 'b', name: str = 'j') -> str:
    """Return a joint."""
    return f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>{inside}</joint>'
