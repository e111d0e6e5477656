# expect: do not compute the distance again
# rejected by: test_other_numbers
# Exercise 2.4: a library and its user
REPORT_PY = '''
import sys

import math


def main():
    print(f'{2 * math.pi * 0.033 * int(sys.argv[1]) / 360:.3f} m')
'''
WHEEL_MATH_XML = package_xml(
    'wheel_math', 'ament_python',
)
ODOMETRY_XML = package_xml(
    'odometry', 'ament_python',
    '<exec_depend>wheel_math</exec_depend>',
)
