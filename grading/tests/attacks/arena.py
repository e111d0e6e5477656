"""A small course to be attacked: two functions and a talker, secrets that no attack may find, and a batch's grading.

One attack is one row of a file of the corpus: a name, a header, and the text of an exercise's cell. A batch of them is
graded at once, with an honest learner among them, as `grade` grades a class.
"""

import html
import json
import os
import re
import secrets
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import psutil
import pytest

from grading import grading_run, reference, sandbox, submissions
from grading.record import Record
from helpers.exercises import notebooks
from helpers.exercises import program as programs
from helpers.exercises.manifest import Exercise, stub_digest
from helpers.tests import small

HERE = Path(__file__).resolve().parent
CORPUS = HERE / 'corpus'
HONEST = 'zoe'  # she hands in with every batch
_HEADER = re.compile(r'# ([a-z ]+): (.*)')

TITLES = {'90.1': 'a sum', '90.2': 'a mirror', '90.3': 'a talker'}
STUBS = {
    '90.1': 'def total(numbers):\n    pass\n',
    '90.2': 'def flip(text):\n    pass\n',
    '90.3': 'class Talker(Node):\n    pass\n',
}
NAMES = {'90.1': 'total', '90.2': 'flip', '90.3': 'Talker'}
POINTS = 10.0
TALKER = """\
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.prefix = self.declare_parameter('prefix', 'n').value
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.count = 0
        self.create_timer(0.5, self.tick)

    def tick(self):
        self.publisher.publish(String(data=f'{self.prefix}{self.count}'))
        self.count += 1
"""
SOLVED = {
    '90.1': 'def total(numbers):\n    return sum(numbers)\n',
    '90.2': 'def flip(text):\n    return text[::-1]\n',
    '90.3': TALKER,
}
# The tests wait less for what never comes, so that many attacks can be judged.
PATIENCE = """
from helpers.runner import plugin
from helpers.runner.timeouts import Timeouts
plugin.TIMEOUTS, plugin.AGAIN = Timeouts(3.0, 3.0, 3.0, 3.0), Timeouts(1.5, 1.5, 1.5, 1.5)
"""
VISIBLE = {
    '90.1': '''
def test_known(learner):
    """total adds the numbers of a list.

    Look at the first and the last one.
    """
    for numbers, right in (([1, 2, 3], 6), ([], 0)):
        got = learner.call('total', numbers)
        expect(got == right, f'total({numbers}) gives {str(got)[:80]}.')
''',
    '90.2': '''
def test_known(learner):
    """flip turns a text around.

    Look at the ends.
    """
    got = learner.call('flip', 'abc')
    expect(got == 'cba', f'flip gives {str(got)[:80]}.')
''',
    '90.3': '''
def test_rate(learner):
    """The talker speaks twice a second.

    Look at the period.
    """
    heard = learner.listen('/chatter', String)
    learner.start('Talker')
    learner.run(2.0)
    expect(heard.data == ['n0', 'n1', 'n2', 'n3'], f'{len(heard)} messages came in 2 s.')
''',
}
HIDDEN = {
    '90.1': '''
@pytest.mark.weight(3)
def test_drawn(learner):
    """total adds up whatever numbers there are.

    Look at the loop.
    """
    secret = CANARY + ' in a frame'
    for _ in range(3):
        numbers = [learner.random.randint(-1000, 1000) for _ in range(5)] + [5000]
        got = learner.call('total', numbers)
        # Computes with what it gets, and looks into it, as tests do.
        expect(round(got - sum(numbers)) == 0, f'The total of six numbers is wrong: {str(got)[:80]}.')
''',
    '90.2': '''
@pytest.mark.weight(3)
def test_drawn(learner):
    """flip turns any text around.

    Look at long ones.
    """
    for _ in range(3):
        text = ''.join(learner.random.choices('abcdefgh', k=20))
        got = learner.call('flip', text)
        expect(got == text[::-1], f'A text of 20 letters becomes {str(got)[:80]}.')
''',
    '90.3': '''
@pytest.mark.weight(3)
def test_prefix(learner):
    """The talker puts its parameter before the number.

    Look at the parameter.
    """
    prefix = ''.join(learner.random.choices('abcdefgh', k=8))
    heard = learner.listen('/chatter', String)
    learner.start('Talker', parameters={'prefix': prefix})
    learner.run(2.0)
    expect(heard.data == [f'{prefix}{number}' for number in range(4)],
           f'{len(heard)} messages came in 2 s, or others than expected.')
''',
}


@dataclass(frozen=True)
class Attack:
    """One row of the corpus."""

    name: str
    family: str
    header: dict[str, str]
    source: str

    @property
    def aim(self) -> str:
        """The exercise that it attacks."""
        return self.header['aims at']

    @property
    def points(self) -> float:
        """The points that it gets rightly: for what it has solved besides."""
        return float(self.header.get('expect points', '0'))

    @property
    def verdicts(self) -> set[str]:
        """One of these is expected."""
        return set(self.header['expect verdict'].split(' or '))


def read(path: Path) -> list[Attack]:
    """The attacks of a file: each begins with `# %% name`.

    The header ends with the first line that is no `# key: value`.
    """
    found = []
    for part in re.split(r'^# %% ', path.read_text(encoding='utf-8'), flags=re.MULTILINE)[1:]:
        name, *lines = part.rstrip().splitlines(keepends=True)
        header = {}
        while lines and (line := _HEADER.fullmatch(lines[0].rstrip('\n'))):
            header[line[1]] = line[2]
            lines.pop(0)
        found.append(Attack(name.strip(), path.stem, header, ''.join(lines) + '\n'))
    return found


def attacks() -> list[Attack]:
    """The corpus."""
    return [attack for path in sorted(CORPUS.glob('*.py')) for attack in read(path)]


def exercises() -> tuple[Exercise, ...]:
    """The three exercises."""
    return tuple(
        small.exercise(number, (NAMES[id],), POINTS, title=TITLES[id], stub=stub_digest(STUBS[id]))
        for number, id in enumerate(TITLES, 1)
    )


def notebook(cells: dict[str, str], cookie: str = 'cookie') -> bytes:
    """A notebook with the tools of the attacks and these cells by exercise; the others are left as they were given."""
    tools = (HERE / 'attack_tools.py').read_text(encoding='utf-8').replace("COOKIE = 'cookie'", f"COOKIE = '{cookie}'")
    return small.notebook(
        small.IMPORTS, tools, *(f'# Exercise {id}: {TITLES[id]}\n{cells.get(id, STUBS[id])}' for id in TITLES)
    )


@dataclass
class Batch:
    """What became of some submissions that were graded together."""

    folder: Path
    cookie: str
    canary: str
    records: dict[str, Record] = field(default_factory=dict)
    left: list[str] = field(default_factory=list)  # processes that are still there
    planted: list[Path] = field(default_factory=list)  # files with the cookie's name
    victims: dict[str, str] = field(default_factory=dict)  # what the bystanders' files hold now
    seconds: float = 0.0

    @property
    def output(self) -> Path:
        """The grader's output folder."""
        return self.folder / 'out'

    @property
    def log(self) -> list[str]:
        """The lines of the grader's log."""
        return (self.output / 'run.log').read_text(encoding='utf-8').splitlines()

    def page(self, learner: str) -> str:
        """The text of a learner's feedback, without mark-up."""
        text = (self.output / 'feedback' / f'{learner}.html').read_text(encoding='utf-8')
        return html.unescape(re.sub(r'<[^>]*>', '', re.sub(r'<style.*?</style>', '', text, flags=re.DOTALL)))

    def exercise(self, learner: str, id: str):
        """A learner's result in one exercise."""
        return next(result for result in self.records[learner].exercises if result.id == id)


def choose() -> str:
    """The sandbox in which attacks are graded. Where it does not work the test is skipped, but not in CI."""
    problem = sandbox.problem()
    if problem and os.environ.get('CI') != 'true':
        pytest.skip(problem)
    assert not problem
    return sandbox.DEFAULT


def grade_batch(
    folder: Path,
    works: dict[str, bytes],
    cookie: str | None = None,
    *,
    jobs: int = 2,
    used: str | None = None,
    patience: str = PATIENCE,
    more: Callable[[Path], None] = lambda incoming: None,
) -> Batch:
    """Grade files by name, and the honest learner's notebook, with secrets all around them that nobody may read.

    `patience` begins each file of tests. `more` may put other things among the submissions.
    """
    used = used or choose()
    batch = Batch(folder, cookie or new_cookie(), f'CANARY-{secrets.token_hex(8)}')
    incoming = folder / 'incoming'
    incoming.mkdir()
    for name, data in {**works, f'{HONEST}.ipynb': notebook(SOLVED)}.items():
        (incoming / name).write_bytes(data)
    more(incoming)
    home = folder / 'home'
    home.mkdir()
    (home / 'secret.txt').write_text(batch.canary)
    victim = folder / 'victim.txt'
    victim.write_text('untouched')
    os.chmod(victim, 0o666)  # nothing but the sandbox protects it
    saved = {name: os.environ.get(name) for name in ('HOME', 'GRADER_TOKEN')}
    # Its argument is for everybody to see who sees other processes.
    bystander = subprocess.Popen([sys.executable, '-c', 'import time; time.sleep(300)', batch.canary])
    os.environ |= {'HOME': str(home), 'GRADER_TOKEN': batch.canary}
    begin = time.monotonic()
    patched = pytest.MonkeyPatch()
    patched.setattr(reference, 'program', lambda exercise: programs.build(_right(), exercise).as_dict())
    try:
        course = _course(folder, batch.canary, used, patience)
        graded = grading_run.grade(submissions.find([incoming]), course, batch.output, jobs)
    finally:
        patched.undo()
        for name, value in saved.items():
            os.environ.pop(name, None)
            if value is not None:
                os.environ[name] = value
        bystander.kill()
        bystander.wait()
    batch.seconds = time.monotonic() - begin
    batch.records = {record.learner: record for record in graded}
    batch.left = _left(batch.cookie)
    batch.planted = _planted(batch)
    batch.victims = {victim.name: victim.read_text()}
    return batch


def new_cookie() -> str:
    """A name for what attacks leave behind; at most 15 letters, so that it can name a process."""
    return f'ck{secrets.token_hex(6)}'


def _right() -> list[notebooks.NotebookCell]:
    return notebooks.parse(notebook(SOLVED), small.NOTEBOOK)


def _course(folder: Path, canary: str, used: str, patience: str) -> grading_run.Course:
    for number, id in enumerate(TITLES, 1):
        small.write_tests(folder, patience + VISIBLE[id], number)
        small.write_tests(folder, f'{patience}CANARY = {canary!r}\n{HIDDEN[id]}', number, kind='exercises')
    return grading_run.Course(exercises(), folder / 'checks', folder / 'exercises', used)


def _left(cookie: str, patience: float = 3.0) -> list[str]:
    """Processes that carry the cookie. One that is about to end is waited for; all others are ended."""

    def those():
        found = []
        for process in psutil.process_iter():
            try:
                if (
                    cookie in process.name() or any(cookie in word for word in process.cmdline())
                ) and process.status() != psutil.STATUS_ZOMBIE:
                    found.append(process)
            except psutil.Error:
                continue
        return found

    deadline = time.monotonic() + patience
    while (found := those()) and time.monotonic() < deadline:
        psutil.wait_procs(found, timeout=0.2)
    for process in found:
        process.kill()
    return [str(process) for process in found]


def _planted(batch: Batch) -> list[Path]:
    """Files that attacks have left, in places where they could lie; they are removed."""
    root = HERE.parents[2]
    places = [
        Path('/tmp'),
        Path('/var/tmp'),
        Path('/dev/shm'),
        Path.home(),
        root,
        root / 'helpers' / 'runner',
        root / 'helpers' / 'checks',
        root / 'grading' / 'exercises',
        batch.folder,
        batch.folder / 'home',
        batch.output,
        batch.output / 'results',
    ]
    found = [place / batch.cookie for place in places if (place / batch.cookie).exists()]
    for path in found:
        path.unlink()
    return found


def everything(batch: Batch, learner: str) -> str:
    """All that the grader has written about one learner."""
    texts = [json.dumps(batch.records[learner].exercises[0].as_dict())]
    texts += [path.read_text(encoding='utf-8') for path in sorted(batch.output.rglob(f'{learner}.*'))]
    return '\n'.join(texts + [line for line in batch.log if learner in line])
