from grading.variants import Mutant

MUTANTS = [
    Mutant('asserts_nothing', source="""
TEST_ROBOT = '''
def test_status(bench):
    bench.run(1.0)


def test_drive(bench):
    bench.set_station('gate', 2.0, 0.0)
    goal = bench.go('gate')
    bench.run(1.0)
    bench.cancel(goal)
'''
""", expect='they assert nothing', breaks='right-robots', also=('status', 'values', 'goals', 'ends')),
    Mutant('capital_letter', edits=(("[-1] == 'idle'", "[-1] == 'Idle'"),
            ("bench.until(lambda: bench.status[-1:] == ['driving to gate'] and bench.commands)", '''
            bench.until(lambda: bench.status[-1:] == ['driving to gate'] and bench.commands[-1:])
            assert bench.commands[-1].linear.x > 0
            ''')), expect='A test of yours fails with your own robot', breaks='right-robots'),
    Mutant('goals_only_after_the_end',
           edits=(("assert not bench.go('gate').accepted", "bench.until(lambda: bench.status[-1:] == ['driving to gate'] and bench.commands[-1:])"),
            ("bench.until(lambda: bench.status[-1:] == ['driving to gate'] and bench.commands)", 'assert bench.commands[-1].linear.x > 0')),
           expect='that takes a second goal while it drives', breaks='goals'),
    Mutant('happy_path', source="""
TEST_ROBOT = '''
from action_msgs.msg import GoalStatus


def test_status(bench):
    bench.until(lambda: bench.status)
    assert bench.status[-1] == 'idle'


def test_drive(bench):
    bench.set_station('gate', 2.0, 0.0)
    goal = bench.go('gate')
    bench.until(lambda: bench.status[-1:] == ['driving to gate'] and bench.commands[-1:])
    bench.place = 2.0, 0.0, 0.0
    assert bench.result(goal).status == GoalStatus.STATUS_SUCCEEDED
'''
""", expect='of the 2 that take a place', breaks='values', also=('goals', 'ends', 'status')),
    Mutant('how_a_cancel_ends',
           edits=(("bench.until(lambda: bench.status[-1:] == ['driving to gate'] and bench.commands)", '''
            bench.until(lambda: bench.status[-1:] == ['driving to gate'] and bench.commands[-1:])
            assert bench.commands[-1].linear.x > 0
            '''),
            ("assert bench.result(goal).status == getattr(GoalStatus, f'STATUS_{end}')", '''
            status = bench.result(goal).status
            assert end == 'CANCELED' or status == getattr(GoalStatus, f'STATUS_{end}')
            ''')), expect='whose cancelled goals end as succeeded', breaks='ends'),
    Mutant('never_lost', edits=(('''
            @pytest.mark.parametrize('end, place', [
                ('SUCCEEDED', (2.0, 0.0, 0.0)), ('CANCELED', (0.0, 0.0, 0.0)), ('ABORTED', None)])
            ''', "@pytest.mark.parametrize('end, place', [('SUCCEEDED', (2.0, 0.0, 0.0)), ('CANCELED', (0.0, 0.0, 0.0))])"),
            ("bench.until(lambda: bench.status[-1:] == ['driving to gate'] and bench.commands)", '''
            bench.until(lambda: bench.status[-1:] == ['driving to gate'] and bench.commands[-1:])
            assert bench.commands[-1].linear.x > 0
            ''')), expect='that drives on when nobody tells it where it is', breaks='ends'),
    Mutant('only_idle', old="bench.until(lambda: bench.status[-1:] == ['driving to gate'] and bench.commands)",
           new='bench.until(lambda: bench.commands)', expect='that says it is idle while it drives', breaks='status', also='right-robots'),
    Mutant('words_of_its_own_robot', old="assert bench.result(goal).status == getattr(GoalStatus, f'STATUS_{end}')", new='''
        done = bench.result(goal)
        assert done.status == getattr(GoalStatus, f'STATUS_{end}')
        assert end != 'SUCCEEDED' or done.result.message == 'arrived'
        ''', expect='fails with a robot that does what', breaks='right-robots'),
    Mutant('a_message_for_each_end', edits=(("""
            @pytest.mark.parametrize('end, place', [
            """, """
            words = {}


            @pytest.mark.parametrize('end, place', [
            """), ("assert bench.result(goal).status == getattr(GoalStatus, f'STATUS_{end}')", """
            done = bench.result(goal)
            assert done.status == getattr(GoalStatus, f'STATUS_{end}')
            assert words.setdefault(done.result.message, end) == end
            """)), expect='fails with a robot that does what', breaks='right-robots'),
    Mutant('no_word_for_a_success', old="bench.set_station('gate', 2.0, 0.0)",
           new="assert bench.set_station('gate', 2.0, 0.0).message == ''", breaks='right-robots',
           expect='ask for nothing that is not in the specification'),
    Mutant('what_only_its_own_robot_has', edits=(('def test_refused(bench):', """
            def test_publisher(bench):
                assert bench.robot.publisher.topic_name == '/status'


            def test_refused(bench):
            """),), expect='fails with a robot that does what', breaks='right-robots'),
    Mutant('asks_only_its_own_robot', edits=(('def test_drive(bench, end, place):', """
            def test_drive(bench, end, place):
                if not hasattr(bench.robot, 'on_goal'):
                    pytest.skip('another robot')
            """),), expect='Your tests notice', breaks='ends', also=('goals', 'status')),
    Mutant('a_command_after_one_step', old="assert not bench.go('gate').accepted", new="""
            bench.run(0.1)
            assert bench.commands
            assert not bench.go('gate').accepted
            """, expect='A test of yours fails with', breaks='right-robots'),
]
