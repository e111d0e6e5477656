from grading.variants import Alternative

ALTERNATIVES = [
    Alternative('argparse', edits=(('import sys', 'from argparse import ArgumentParser'),
            ('from wheel_math.geometry import distance', 'from wheel_math import geometry'),
            ("print(f'{distance(int(sys.argv[1])):.3f} m')", '''
            parser = ArgumentParser()
            parser.add_argument('ticks', type=int)
            print('%.3f m' % geometry.distance(parser.parse_args().ticks))
            '''))),
    Alternative('depend', edits=(('from wheel_math.geometry import distance', 'import wheel_math.geometry'),
            ("'{distance(", "'{wheel_math.geometry.distance("),
            ('<exec_depend>wheel_math</exec_depend>', '<depend>wheel_math</depend>'))),
    Alternative('in_quotes', source="""
REPORT_PY = '''
import sys

from wheel_math.geometry import distance


def main():
    print(f'{distance(int(sys.argv[1])):.3f} m')
'''
WHEEL_MATH_XML = package_xml(
    'wheel_math', 'ament_python',
)
ODOMETRY_XML = package_xml(
    'odometry', 'ament_python',
    '<exec_depend>wheel_math</exec_depend>',
)
"""),
]
