# expect: That is its bottom
# rejected by: test_weight
# Exercise 6.6: a crate
def crate(mass, length, width, height):
    middle = f'<origin xyz="0 0 {height / 2}"/>'
    shape = f'<geometry><box size="{length} {width} {height}"/></geometry>'
    collision = f'<collision>{middle}{shape}</collision>'
    ixx = mass / 12 * (width**2 + height**2)
    iyy = mass / 12 * (length**2 + height**2)
    izz = mass / 12 * (length**2 + width**2)
    inertial = f'''<inertial><mass value="{mass}"/>
        <inertia ixx="{ixx}" iyy="{iyy}" izz="{izz}" ixy="0" ixz="0" iyz="0"/>
    </inertial>'''
    return f'''<robot name="crate"><link name="crate">
        <visual>{middle}{shape}</visual>
        {collision}
        {inertial}
    </link></robot>'''
