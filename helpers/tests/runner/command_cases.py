"""Files, builds and commands of the learner's for `test_runner`: right, wrong, endless and loud."""

from helpers.tests.small import Case

TEXTS = """
Talker = None
TEXT = '''
print('hello')
'''
NUMBER = {'a': [1, 2.5, None]}
"""
PACKAGE = """
from pathlib import Path
from helpers.runner.workspaces import package
greeter = package(Path(expect.__code__.co_filename).parents[1] / 'checks' / 'chapter_02' / 'given' / 'greeter')
setup = ("from setuptools import setup; setup(name='greeter', packages=['greeter'], {more} data_files=["
         "('share/ament_index/resource_index/packages', ['resource/greeter']), ('share/greeter', ['package.xml'])])")
"""

CASES = {
    'what a cell binds to names': Case(
        TEXTS,
        """
expect(learner.text('TEXT') == "print('hello')\\n", learner.text('TEXT'))
expect(learner.value('NUMBER') == {'a': [1, 2.5, None]}, str(learner.value('NUMBER')))
""",
    ),
    'a text that is none': Case(TEXTS, "learner.text('NUMBER')", 'invalid_submission', ('`NUMBER` must be a text',)),
    'a text that is too long': Case(
        'Talker = None\nTEXT = 70000 * "x"', "learner.text('TEXT')", 'invalid_submission', ('longer than',)
    ),
    'a text that is not there': Case(
        TEXTS, "learner.text('OTHER')", 'invalid_submission', ('does not define `OTHER`',)
    ),
    'files are written, commands run with ROS': Case(
        TEXTS,
        """
ws = learner.workspace({'src/a/b.py': learner.text('TEXT')})
done = ws.run('python3', 'src/a/b.py')
expect((done.status, done.lines, done.last_line) == (0, ['hello'], 'hello'), str(done))
done = ws.run('sh', '-c', 'echo told >&2; echo $AMENT_PREFIX_PATH; exit 3')
expect(done.status == 3 and done.lines[0] == 'told' and done.lines[1], str(done))
learner.workspace({'src/a/b.py': learner.text('TEXT')}).run('touch', 'kept')
expect(ws.run('ls', 'kept').status == 0, 'the same files are another workspace')
expect(learner.workspace({'src/a/b.py': 'other'}).run('ls', 'kept').status != 0, 'other files are the same workspace')
""",
        output='$ python3 src/a/b.py\nhello',
    ),
    'what only reads runs once for the same files': Case(
        TEXTS,
        """
count = 'sh', '-c', 'echo x >> told; wc -l < told'
first = learner.workspace({'c': ''}).once(*count)
again = learner.workspace({'c': ''})
expect(again.once(*count) == first and first.lines == ['1'], str(first))
expect(again.run(*count).lines == ['2'], 'the command has run again')
expect('wc -l' in again.transcript[0], str(again.transcript))
expect(learner.workspace({'c': 'other'}).once('cat', 'c').output == 'other', 'other files have the same answers')
""",
    ),
    'a command that does not end, and what it has started': Case(
        TEXTS,
        """
ws = learner.workspace({'a': ''})
ws.run('sh', '-c', 'sleep 600 & echo $! > child; sleep 600', timeout=1.0)
""",
        'timeout',
        ('did not end within 1 s',),
    ),
    'only the end of a long output is kept': Case(
        TEXTS,
        """
done = learner.workspace({}).run('sh', '-c', 'yes | head -n 100000; echo end')
expect(len(done.output) <= 32 * 1024 and done.last_line == 'end', str(len(done.output)))
""",
    ),
    'a build, once for the same files': Case(
        TEXTS,
        PACKAGE
        + """
files = {**greeter, 'src/greeter/setup.py': setup.format(more='')}
first = learner.workspace(files).build()
expect(learner.workspace(files).build() is first and first.status == 0, first.output)
ws = learner.workspace(files)
expect('greeter/share/greeter/package.xml' in ws.installed(), str(ws.installed()))
expect(ws.run('ros2', 'pkg', 'prefix', 'greeter').status == 0, 'it is not sourced')
""",
    ),
    'a build that fails says why': Case(
        TEXTS,
        PACKAGE
        + """
ws = learner.workspace({**greeter, 'src/greeter/setup.py': setup.format(more='entry_points=1 2')})
expect(ws.build(check=False).status != 0, 'it was built')
ws.build()
""",
        'failed',
        ('colcon build failed: setup.py, line ', ': SyntaxError'),
        details='entry_points=1 2',
    ),
}
