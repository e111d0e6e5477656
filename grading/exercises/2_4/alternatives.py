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
    Alternative('build_type_for_ros_1_and_2', edits=(
        ('import sys', 'from sys import argv'), ('sys.argv[1]', 'argv[-1]'),
        ("""
        <exec_depend>wheel_math</exec_depend>
        <export><build_type>ament_python</build_type></export>
        """, """
        <depend>wheel_math</depend>
        <export>
          <build_type condition="$ROS_VERSION == 1">catkin</build_type>
          <build_type condition="$ROS_VERSION == 2">ament_python</build_type>
        </export>
        """))),
    Alternative('without_arguments_of_ros', edits=(('from wheel_math.geometry import distance', '''
            from rclpy.utilities import remove_ros_args

            from wheel_math.geometry import distance
            '''),
            ('int(sys.argv[1])', 'int(remove_ros_args(sys.argv)[1])'),
            ('<exec_depend>wheel_math</exec_depend>', '<exec_depend>wheel_math</exec_depend> <exec_depend>rclpy</exec_depend>'))),
    Alternative('of_a_dataclass', edits=(('import sys', '''
            import sys
            from dataclasses import dataclass
            '''),
            ('def main():', '''
            @dataclass
            class Report:
                ticks: int

                def __str__(self):
                    return f'{distance(self.ticks):.3f} m'


            def main():
            '''),
            ("print(f'{distance(int(sys.argv[1])):.3f} m')", "sys.stdout.write(f'{Report(int(sys.argv[1]))}\\n')"))),
]
