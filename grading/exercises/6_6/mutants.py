from grading.variants import Mutant

CRATE = 'test_crate'

MUTANTS = [
    Mutant('three_digits', breaks='inertia', old='"{ixx}" iyy="{iyy}" izz="{izz}"',
           new='"{ixx:.3g}" iyy="{iyy:.3g}" izz="{izz:.3g}"', expect='Do not round the numbers'),
    Mutant('long_side_first', breaks='collision', old="collision = f'<collision>{middle}{shape}</collision>'", new='''
        box = f'<box size="{max(length, width)} {min(length, width)} {height}"/>'
        collision = f'<collision>{middle}<geometry>{box}</geometry></collision>'
        ''', expect='Length and width are exchanged'),
    Mutant('collision_at_the_frame', breaks='place', old='collision>{middle}{shape}<', new='collision>{shape}<',
           expect='the <collision> needs an <origin>, too'),
    Mutant('grams', breaks='mass', old='value="{mass}"/', new='value="{1000 * mass}"/', expect='has the mass'),
    Mutant('half_sides', breaks='collision', old="collision = f'<collision>{middle}{shape}</collision>'", new='''
        half = f'<box size="{length / 2} {width / 2} {height / 2}"/>'
        collision = f'<collision>{middle}<geometry>{half}</geometry></collision>'
        ''', expect='A <box> has whole sides, not half ones'),
    Mutant('inertia_of_one', breaks='inertia', old='{ixx}" iyy="{iyy}" izz="{izz}', new='1" iyy="1" izz="1',
           expect='the inertia of a large table'),
    Mutant('mass_at_the_frame', breaks='centre', old='>{middle}<', new='><', expect='That is its bottom'),
    Mutant('no_collision', breaks='collision', old="collision = f'<collision>{middle}{shape}</collision>'",
           new="collision = ''", expect='It has no <collision>'),
    Mutant('no_inertial', breaks='mass', old="</inertial>'''", new="""
        </inertial>'''
        inertial = ''
        """, expect='weighs next to nothing'),
    Mutant('no_twelfth', breaks='inertia', old='''
        ixx = mass / 12 * (width**2 + height**2)
        iyy = mass / 12 * (length**2 + height**2)
        izz = mass / 12 * (length**2 + width**2)
        ''', new='''
        ixx = mass * (width**2 + height**2)
        iyy = mass * (length**2 + height**2)
        izz = mass * (length**2 + width**2)
        ''', expect='Divide by 12'),
    Mutant('no_xml', breaks='urdf', also=('mass', 'inertia', 'centre', 'collision', 'place'), old="}</collision>'",
           new="}'", expect='cannot be simulated'),
    Mutant('own_axis', breaks='inertia', old='''
        ixx = mass / 12 * (width**2 + height**2)
        iyy = mass / 12 * (length**2 + height**2)
        izz = mass / 12 * (length**2 + width**2)
        ''', new='''
        ixx = mass / 12 * length**2
        iyy = mass / 12 * width**2
        izz = mass / 12 * height**2
        ''', expect='The side along an axis does not count for it'),
    Mutant('product_for_a_sum', breaks='inertia', old='izz = mass / 12 * (length**2 + width**2)',
           new='izz = mass / 12 * (length**2 * width**2)', expect='together less than the third'),
    Mutant('inertia_of_the_example', breaks='inertia', old='{ixx}" iyy="{iyy}" izz="{izz}',
           new='0.065" iyy="0.1" izz="0.125', expect='the inertia about x, y and z is'),
    Mutant('length_and_width_exchanged', breaks='inertia', old='{ixx}" iyy="{iyy}"', new='{iyy}" iyy="{ixx}"',
           expect='the inertia about x, y and z is'),
    Mutant('mass_of_the_example', breaks='mass', old='value="{mass}"/', new='value="6.0"/', expect='has the mass'),
    Mutant('no_visual', breaks='visual', old='<visual>{middle}{shape}</visual>', new='', expect='cannot be seen'),
    Mutant('sides_exchanged', breaks='collision', old="collision = f'<collision>{middle}{shape}</collision>'", new="""
        box = f'<geometry><box size="{width} {length} {height}"/></geometry>'
        collision = f'<collision>{middle}{box}</collision>'
        """, expect='its <collision> reaches from'),
    Mutant('turned', breaks='place', old='collision>{middle}{shape}<',
           new='collision><origin xyz="0 0 {height / 2}" rpy="0 0 1.5708"/>{shape}<', also='collision',
           expect='is it turned by an rpy'),
    Mutant('another_link', breaks='urdf', old='link name="crate"', new='link name="box"',
           also=('collision', 'mass'), expect='expected one link with the name crate'),
    Mutant('two_links', breaks='urdf', old='</link></robot>',
           new='</link><link name="lid"/><joint name="hinge" type="fixed"><parent link="crate"/><child link="lid"/>'
               '</joint></robot>', also=('collision', 'mass'), expect='has the links crate, lid'),
    Mutant('rounded', breaks='inertia', old='{ixx}" iyy="{iyy}" izz="{izz}', new='{ixx:.3f}" iyy="{iyy:.3f}" izz="{izz:.3f}',
           expect='Do not round'),
    Mutant('visual_at_the_frame', breaks='visual', old='<visual>{middle}{shape}', new='<visual>{shape}',
           expect='is not the one that was given'),
    Mutant('mass_in_whole_grams', breaks='mass', old='value="{mass}"/', new='value="{mass:.3f}"/', expect='has the mass'),
    Mutant('a_second_collision', breaks='collision', old="collision = f'<collision>{middle}{shape}</collision>'", new="""
        collision = f'<collision>{middle}{shape}</collision>'
        collision += f'<collision>{middle}<geometry><sphere radius="{height / 100}"/></geometry></collision>'
        """, expect='what touches is a box and a sphere'),
    Mutant('a_barrel', breaks='collision', old="collision = f'<collision>{middle}{shape}</collision>'", new="""
        barrel = f'<cylinder radius="{width / 2}" length="{height}"/>'
        collision = f'<collision>{middle}<geometry>{barrel}</geometry></collision>'
        """, expect='what touches is a cylinder'),
    Mutant('products_that_are_not_0', breaks='inertia', old='ixy="0"', new='ixy="{ixx / 100}"',
           expect='the products ixy, ixz and iyz of a box'),
    Mutant('mass_is_turned', breaks='inertia', edits=(("""
        inertial = f'''<inertial>{middle}<mass value="{mass}"/>
        """, """
        turned = middle.replace('"/', '" rpy="0 0 1.5708"/')
        inertial = f'''<inertial>{turned}<mass value="{mass}"/>
        """),), expect='Those about x and y are exchanged'),
    Mutant('the_first_one_again', breaks='mass', also='urdf', source="""
from functools import cache


@cache
def once():
    return {}


def crate(mass, length, width, height):
    if once():
        return once()['text']
    middle = f'<origin xyz="0 0 {height / 2}"/>'
    shape = f'<geometry><box size="{length} {width} {height}"/></geometry>'
    a, b, c = (side**2 * mass / 12 for side in (length, width, height))
    inertia = f'<inertia ixx="{b + c}" iyy="{a + c}" izz="{a + b}" ixy="0" ixz="0" iyz="0"/>'
    inertial = f'<inertial>{middle}<mass value="{mass}"/>{inertia}</inertial>'
    once()['text'] = f'''<robot name="crate"><link name="crate"><visual>{middle}{shape}</visual>
        <collision>{middle}{shape}</collision>{inertial}</link></robot>'''
    return once()['text']
""", expect='gave the same text'),
    Mutant('mass_of_the_call_before', breaks='mass', edits=(("""
        inertial = f'''<inertial>{middle}<mass value="{mass}"/>
        """, """
        crate.mass = getattr(crate, 'mass', mass)
        inertial = f'''<inertial>{middle}<mass value="{crate.mass}"/>
        """),), expect='which was called before'),
    Mutant('mass_of_three_digits', breaks='mass', old='value="{mass}"/', new='value="{mass:.3g}"/',
           expect='Do not round the mass'),
]
