# Exercise 2.4: a library and its user
REPORT_PY = '''
import sys

import wheel_math.geometry


def main():
    print(f'{wheel_math.geometry.distance(int(sys.argv[1])):.3f} m')
'''
WHEEL_MATH_XML = package_xml(
    'wheel_math', 'ament_python',
)
ODOMETRY_XML = package_xml(
    'odometry', 'ament_python',
    '<depend>wheel_math</depend>',
)
