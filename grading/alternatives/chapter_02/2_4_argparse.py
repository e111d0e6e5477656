# Exercise 2.4: a library and its user
REPORT_PY = '''
from argparse import ArgumentParser

from wheel_math import geometry


def main():
    parser = ArgumentParser()
    parser.add_argument('ticks', type=int)
    print('%.3f m' % geometry.distance(parser.parse_args().ticks))
'''
WHEEL_MATH_XML = package_xml(
    'wheel_math', 'ament_python',
)
ODOMETRY_XML = package_xml(
    'odometry', 'ament_python',
    '<exec_depend>wheel_math</exec_depend>',
)
