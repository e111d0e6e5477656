# expect: does not say that it needs wheel_math
# rejected by: test_order
# told by: test_both_are_built
# Exercise 2.4: a library and its user
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
)
