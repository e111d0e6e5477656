from grading.variants import Mutant

WHEEL_MATH = '<description>wheel_math</description>'
NEEDS = '<exec_depend>wheel_math</exec_depend>'
PRINT = "print(f'{distance(int(sys.argv[1])):.3f} m')"
IMPORT = 'from wheel_math.geometry import distance'
LIBRARY_ENDS = """
      <export><build_type>ament_python</build_type></export>
    </package>

    %%answer ODOMETRY_XML ros2_ws/src/odometry/package.xml
    """

MUTANTS = [
    Mutant('circle', old=WHEEL_MATH, new=f'{WHEEL_MATH} <exec_depend>odometry</exec_depend>', expect='in a circle', breaks='order'),
    Mutant('prints_as_an_error', old=":.3f} m')", new=":.3f} m', file=sys.stderr)",
           expect='printed nothing on the standard output', breaks='prints'),
    Mutant('computes_itself', edits=((IMPORT, 'import math'),
            ('distance(int(sys.argv[1]))', '2 * math.pi * 0.033 * int(sys.argv[1]) / 360')),
           expect='do not compute the distance again', breaks='library'),
    Mutant('imports_and_computes_itself', old='distance(int(sys.argv[1]))', new='int(sys.argv[1]) * 0.000575959',
           expect='do not compute the distance again', breaks='library'),
    Mutant('computes_itself_without_the_library', old=IMPORT, new="""
        try:
            from wheel_math.geometry import distance
        except ImportError:
            def distance(ticks):
                return 2 * 3.141592653589793 * 0.033 * ticks / 360
        """, expect='has no function distance', breaks='library'),
    Mutant('from_the_package', old=IMPORT, new='from wheel_math import distance',
           expect='The function distance is in the module wheel_math.geometry', breaks='library'),
    Mutant('from_the_module_only', old=IMPORT, new='from geometry import distance',
           expect='The function distance is in the module wheel_math.geometry', breaks='library'),
    Mutant('only_the_example', old='int(sys.argv[1])', new='360', expect='must come from the command line',
           breaks='argument'),
    Mutant('text_for_number', old='int(sys.argv[1])', new='sys.argv[1]', expect='make a number of it with int()',
           breaks='argument'),
    Mutant('name_of_the_program', old='sys.argv[1]', new='sys.argv[0]', expect='with: ValueError',
           breaks='argument'),
    Mutant('second_argument', old='sys.argv[1]', new='sys.argv[2]', expect='with: IndexError', breaks='argument'),
    Mutant('two_decimals', old=':.3f', new=':.2f', expect='three decimals, a space and m', breaks='prints'),
    Mutant('thousands', old=':.3f', new=':,.3f', expect='three decimals, a space and m', breaks='prints'),
    Mutant('when_it_is_imported', old='''
        def main():
            print(f'{distance(int(sys.argv[1])):.3f} m')
        ''', new='''
        print(f'{distance(int(sys.argv[1])):.3f} m')


        def main():
            pass
        ''', expect='`import odometry.report` already does something', breaks='prints', also='argument'),
    Mutant('rounded', old='{distance(int(sys.argv[1])):.3f}', new='{round(distance(int(sys.argv[1])), 3)}',
           expect='three decimals, a space and m', breaks='prints'),
    Mutant('no_unit', old=':.3f} m', new=':.3f}', expect='without the unit', breaks='prints'),
    Mutant('millimetres', old='distance(int(sys.argv[1])):.3f} m', new='1000 * distance(int(sys.argv[1])):.3f} mm',
           expect='three decimals, a space and m', breaks='prints'),
    Mutant('a_line_more', old=PRINT, new=f"""
        print(sys.argv[1], 'ticks')
        {PRINT}
        """, expect='printed 2 lines', breaks='prints'),
    Mutant('returned', old=PRINT, new="return f'{distance(int(sys.argv[1])):.3f} m'",
           expect='what main returns, but for None and 0', breaks='prints'),
    Mutant('module_declared', old=NEEDS, new='<exec_depend>wheel_math.geometry</exec_depend>', expect='names a Python module',
           breaks='needs'),
    Mutant('needed_to_build_only', old=NEEDS, new='<build_depend>wheel_math</build_depend>',
           expect='It is imported when the program runs', breaks='needs'),
    Mutant('needed_for_tests_only', old=NEEDS, new='<test_depend>wheel_math</test_depend>',
           expect='It is imported when the program runs', breaks='needs'),
    Mutant('nothing_declared', old=NEEDS, new='', expect='does not say that it needs wheel_math', breaks='needs'),
    Mutant('library_declares_more', old=WHEEL_MATH, new=f'{WHEEL_MATH} <exec_depend>rclpy</exec_depend>',
           expect='wheel_math declares rclpy', breaks='nothing-else'),
    Mutant('program_declares_more', old=NEEDS, new=f'{NEEDS} <depend>std_msgs</depend>',
           expect='odometry declares std_msgs', breaks='nothing-else'),
    Mutant('library_for_cmake', old=LIBRARY_ENDS, new=LIBRARY_ENDS.replace('python', 'cmake'),
           expect='The build type in WHEEL_MATH_XML is ament_cmake', breaks='build-type'),
    Mutant('library_without_a_name', old='<name>wheel_math</name> ', new='',
           expect='must contain exactly one "name" tag', breaks='build-type'),
    Mutant('package_xml_of_no_format', old='<package format="3">', new='<package formatx="3">', count=2,
           expect='must not have the following attributes: formatx', breaks='build-type'),
    Mutant('forwards_only', old='int(sys.argv[1])', new='abs(int(sys.argv[1]))', expect='your program asks distance for',
           breaks='argument'),
    Mutant('tool_of_another_build_type', old=WHEEL_MATH,
           new=f'{WHEEL_MATH} <buildtool_depend>ament_cmake</buildtool_depend>',
           expect='wheel_math declares ament_cmake', breaks='nothing-else'),
    Mutant('read_with_the_module', edits=(('def main():', """
            ticks = int(sys.argv[1]) if len(sys.argv) > 1 else 0


            def main():
            """), ('distance(int(sys.argv[1]))', 'distance(ticks)')),
           expect='Read sys.argv inside of main', breaks='argument'),
    Mutant('filled_up_with_spaces', old=':.3f', new=':12.3f', expect='spaces stand before the number', breaks='prints'),
    Mutant('distance_without_sign', old='distance(int(sys.argv[1]))', new='abs(distance(int(sys.argv[1])))',
           expect='and so is the distance', breaks='library', also='argument'),
    Mutant('line_without_an_end', old=":.3f} m')", new=":.3f} m', end='')", expect='without the end of the line',
           breaks='prints'),
    Mutant('cut_off', old='{distance(int(sys.argv[1])):.3f}', new='{int(distance(int(sys.argv[1])) * 1000) / 1000:.3f}',
           expect='expected', breaks='library'),
    Mutant('needed_for_documents', old=NEEDS, new=f'{NEEDS} <doc_depend>doxygen</doc_depend>',
           expect='odometry declares doxygen', breaks='nothing-else'),
    Mutant('needed_in_humble', old=NEEDS, new=f'{NEEDS} <exec_depend condition="$ROS_DISTRO == humble">rclpy</exec_depend>',
           expect='odometry declares rclpy', breaks='nothing-else'),
    Mutant('an_empty_line_before', old=PRINT, new=f"""
        print()
        {PRINT}
        """, expect='and 1 empty line', breaks='prints'),
    Mutant('format_of_whole_numbers', old=':.3f', new=':.3d', expect='.3f for three decimals', breaks='prints'),
    Mutant('the_program_itself', old='sys.argv[1]', new='sys.argv[0]', expect='sys.argv[0] is the program itself',
           breaks='argument'),
    Mutant('an_import_of_nothing', old=IMPORT, new=f'''
        import numpy as np

        {IMPORT}
        ''', expect='report.py imports numpy, and package.xml of odometry does not declare it', breaks='needs'),
    Mutant('message_not_declared', old=IMPORT, new=f'''
        from std_msgs.msg import Float64

        {IMPORT}
        ''', expect='report.py imports std_msgs', breaks='needs'),
    Mutant('space_behind_the_unit', old=':.3f} m', new=':.3f} m ', expect='a space stands behind the unit', breaks='prints'),
    Mutant('no_more_than_eight_digits', old='int(sys.argv[1])', new='int(sys.argv[1][-8:])',
           expect='your program asks distance for', breaks='argument'),
    Mutant('first_number_kept', edits=(('def main():', '''
            seen = []


            def main():
            '''), (PRINT, '''
            seen.append(int(sys.argv[1]))
            print(f'{distance(seen[0]):.3f} m')
            ''')), expect='both times it printed', breaks='argument'),
    Mutant('status_of_an_error', old=PRINT, new=f'{PRINT}; return True', expect='let main return nothing', breaks='prints',
           also='library'),
]
