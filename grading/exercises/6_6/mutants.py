from grading.variants import Mutant

CRATE = 'test_crate'

MUTANTS = [
    Mutant('collision_at_the_frame', breaks='place', seen_by=CRATE,
           old='collision>{middle}{shape}<', new='collision>{shape}<',
           expect='the <collision> needs an <origin>, too', rejected_by='test_fall'),
    Mutant('grams', breaks='mass', seen_by=CRATE,
           old='value="{mass}"/', new='value="{1000 * mass}"/', expect='has the mass',
           rejected_by='test_weight'),
    Mutant('half_sides', breaks='collision', seen_by=CRATE,
           old="collision = f'<collision>{middle}{shape}</collision>'", new='''
        half = f'<box size="{length / 2} {width / 2} {height / 2}"/>'
        collision = f'<collision>{middle}<geometry>{half}</geometry></collision>'
        ''', expect='A <box> has whole sides, not half ones', rejected_by='test_fall'),
    Mutant('inertia_of_one', breaks='inertia', seen_by=CRATE,
           old='{ixx}" iyy="{iyy}" izz="{izz}', new='1" iyy="1" izz="1',
           expect='the inertia of a large table', rejected_by='test_weight'),
    Mutant('mass_at_the_frame', breaks='centre', seen_by=CRATE,
           old='>{middle}<', new='><', expect='That is its bottom', rejected_by='test_weight'),
    Mutant('no_collision', breaks='collision', seen_by=CRATE,
           old="collision = f'<collision>{middle}{shape}</collision>'", new="collision = ''",
           expect='It has no <collision>', rejected_by='test_fall'),
    Mutant('no_inertial', breaks='mass', seen_by=CRATE,
           old="</inertial>'''", new="""
        </inertial>'''
        inertial = ''
        """, expect='weighs next to nothing', rejected_by='test_weight'),
    Mutant('no_twelfth', breaks='inertia', seen_by=CRATE,
           old='''
        ixx = mass / 12 * (width**2 + height**2)
        iyy = mass / 12 * (length**2 + height**2)
        izz = mass / 12 * (length**2 + width**2)
        ''', new='''
        ixx = mass * (width**2 + height**2)
        iyy = mass * (length**2 + height**2)
        izz = mass * (length**2 + width**2)
        ''', expect='Divide by 12', rejected_by='test_weight'),
    Mutant('no_xml', breaks='urdf', also=('mass', 'inertia', 'centre', 'collision', 'place'), seen_by=CRATE,
           old="}</collision>'", new="}'", expect='cannot be simulated', rejected_by='test_fall'),
    Mutant('own_axis', breaks='inertia', seen_by=CRATE,
           old='''
        ixx = mass / 12 * (width**2 + height**2)
        iyy = mass / 12 * (length**2 + height**2)
        izz = mass / 12 * (length**2 + width**2)
        ''', new='''
        ixx = mass / 12 * length**2
        iyy = mass / 12 * width**2
        izz = mass / 12 * height**2
        ''', expect='The side along an axis does not count for it', rejected_by='test_weight'),
    Mutant('inertia_of_the_example', breaks='inertia', seen_by=CRATE,
           old='{ixx}" iyy="{iyy}" izz="{izz}', new='0.065" iyy="0.1" izz="0.125',
           expect='the inertia about x, y and z is',
           rejected_by='test_weight'),
    Mutant('length_and_width_exchanged', breaks='inertia', seen_by=CRATE, old='{ixx}" iyy="{iyy}"',
           new='{iyy}" iyy="{ixx}"', expect='the inertia about x, y and z is', rejected_by='test_weight'),
    Mutant('mass_of_the_example', breaks='mass', seen_by=CRATE, old='value="{mass}"/', new='value="6.0"/',
           expect='has the mass', rejected_by='test_weight'),
    Mutant('no_visual', breaks='visual', seen_by=CRATE, old='<visual>{middle}{shape}</visual>', new='',
           expect='cannot be seen', rejected_by='test_fall'),
    Mutant('sides_exchanged', breaks='collision', seen_by=CRATE,
           old="collision = f'<collision>{middle}{shape}</collision>'", new="""
        box = f'<geometry><box size="{width} {length} {height}"/></geometry>'
        collision = f'<collision>{middle}{box}</collision>'
        """, expect='its <collision> reaches from', rejected_by='test_fall'),
]
