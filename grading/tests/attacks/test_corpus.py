"""Every attack of the corpus: no mark gained, nothing found, nothing left, nothing changed, nobody else hurt."""

import itertools
import re
from functools import cache

import pytest

from grading.tests.attacks import arena

pytestmark = pytest.mark.early
ATTACKS = arena.attacks()
MOST = 8  # attacks in a batch, so that no sample gets a whole large family
_HANDLERS = re.compile(r'<[^>]*\son\w+\s*=', re.IGNORECASE)


def learner(attack):
    """The name under which an attack is handed in."""
    return f'{attack.family}-{attack.name}'


def batches():
    """The attacks that are graded together, by name: those of one family, and not too many."""
    found = {}
    for family, attacks in itertools.groupby(ATTACKS, key=lambda attack: attack.family):
        whole = list(attacks)
        for part in range(0, len(whole), MOST):
            found[f'{family}-{part // MOST}'] = whole[part : part + MOST]
    return found


BATCHES = batches()


def drawn(name, *values, id):
    """Parameters that run if the seed draws their batch: the whole of it, or nothing, is graded."""
    return pytest.param(*values, marks=pytest.mark.one_of(16, group=list(BATCHES).index(name)), id=id)


@pytest.fixture(scope='module')
def batch_of(tmp_path_factory):
    """The batch of a name, graded when it is first asked for."""

    @cache
    def graded(name):
        cookie = arena.new_cookie()
        works = {
            f'{learner(attack)}.ipynb': arena.notebook({attack.aim: attack.source}, cookie) for attack in BATCHES[name]
        }
        return arena.grade_batch(tmp_path_factory.mktemp(name), works, cookie)

    return graded


@pytest.mark.timeout(600)
@pytest.mark.parametrize(
    ('among', 'attack'),
    [drawn(name, name, attack, id=learner(attack)) for name, attacks in BATCHES.items() for attack in attacks],
)
def test_attack(batch_of, among, attack):
    batch = batch_of(among)
    name = learner(attack)
    record, exercise = batch.records[name], batch.exercise(name, attack.aim)
    # No mark gained
    assert exercise.verdict in attack.verdicts, _story(batch, name)
    assert exercise.score == attack.points, _story(batch, name)
    assert record.score == attack.points
    # One clear line in the feedback
    page = batch.page(name)
    fragments = attack.header['expect message'].split(' or ')
    messages = '\n'.join(test.message for test in exercise.tests) + exercise.message
    assert any(fragment in messages for fragment in fragments), _story(batch, name)
    assert any(fragment in page for fragment in fragments), page
    if 'expect page' in attack.header:
        assert attack.header['expect page'] in page
    # ... and in the log
    lines = [line for line in batch.log if f' {name}: ' in line]
    assert any(f'{name}: {record.status}' in line for line in lines), batch.log
    # Nothing found, nothing touched
    told = '\n'.join(test.output for test in exercise.tests)
    assert not [line for line in told.splitlines() if line.startswith(('FOUND', 'SEEN', 'TOUCHED'))], told
    assert batch.canary not in arena.everything(batch, name)


@pytest.mark.timeout(600)
@pytest.mark.parametrize('name', [drawn(name, name, id=name) for name in BATCHES])
def test_the_others(batch_of, name):
    """Around a batch of attacks: the honest learner, the processes, the files, the pages."""
    batch = batch_of(name)
    assert batch.records[arena.HONEST].score == 30, _story(batch, arena.HONEST)
    assert not batch.left
    assert not batch.planted
    assert batch.victims == {'victim.txt': 'untouched'}
    for path in batch.output.rglob('*'):
        if path.is_file():
            assert path.stat().st_size < 2**20, path
            text = path.read_text(encoding='utf-8')
            assert not re.search(r'[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]', text), path
            if path.suffix == '.html':
                assert '<script' not in text.lower() and 'javascript:' not in _tags(text), path
                assert not _HANDLERS.search(text), path
    assert all(re.match(r'\d{4}-\d\d-\d\d \d\d:\d\d:\d\d|    ', line) for line in batch.log), batch.log


def test_the_search_finds_what_is_not_hidden(tmp_path):
    """Without the sandbox an attack does find the secrets: the tests above could fail."""
    thieves = [attack for attack in ATTACKS if attack.family == 'theft' and attack.name == 'processes']
    works = {f'{learner(attack)}.ipynb': arena.notebook({attack.aim: attack.source}) for attack in thieves}
    patience = arena.PATIENCE.replace('3.0', '60.0')  # it searches every process of the machine
    batch = arena.grade_batch(tmp_path, works, used='none', patience=patience)
    told = '\n'.join(test.output for attack in thieves for test in batch.exercise(learner(attack), attack.aim).tests)
    assert f'FOUND {batch.canary}' in told


def _tags(text):
    return ' '.join(re.findall(r'<[^>]*>', text)).lower()


def _story(batch, name):
    """What is needed to understand a failure."""
    tests = [
        (test.test, test.verdict, test.message[:300], test.output[-300:], test.fault[-800:])
        for exercise in batch.records[name].exercises
        for test in exercise.tests
    ]
    return '\n'.join(map(str, [batch.records[name].status, *tests, *batch.records[name].log, *batch.log[-5:]]))
