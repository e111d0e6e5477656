"""The reports, from records that are made by code: true to their schemas, harmless whatever they hold, readable."""

import csv
import io
import json
import re
import unicodedata
from collections import Counter
from html.parser import HTMLParser
from xml.etree import ElementTree

import jsonschema
import pytest

from grading import gradebook, reports, schemas
from grading.adjustments import Adjustment
from grading.late import Late
from grading.record import Attempt, Record
from grading.reports import feedback, gradescope, junit, safe, summary, where_to_read
from grading.similarity import Pair
from helpers.runner import results, verdicts
from helpers.runner.results import ExerciseResult, TestResult
from helpers.tests import small

HURT = (
    '<script>alert(1)</script><img src=x onerror="alert(1)">\x1b[31m\u202e\ufffe\x00]]>--></style></title>'
    '{{ 7 * 7 }} {% raw %} ` & &amp; \'" `<b>`'
)
SECRET = 'assert heard.data == [41, 42]  # hidden'
EXERCISES = [small.exercise(1), small.exercise(2, points=15), small.exercise(3, points=7)]


def test(verdict: str, hidden: bool = False, number: int = 0, exercise: str = '90.1', **changes) -> TestResult:
    """A test's result."""
    file = 'exercises/90_1/hidden' if hidden else 'checks/chapter_90/test_90_1'
    return TestResult(
        **{
            'test': f'{file}::test_{number}',
            'exercise': exercise,
            'hidden': hidden,
            'weight': 1,
            'verdict': verdict,
            'expected': 'It speaks.\n\nLook at the timer.',
            'seconds': 0.25,
            'hint': True,
            'message': '' if verdict == 'passed' else 'It said 3 words.',
            **changes,
        }
    )


test.__test__ = False


def record(learner: str = 'ada', first: list[TestResult] | None = None, **changes) -> Record:
    """A record: one exercise judged by tests, one not begun, one that cannot be run."""
    tests = first or [test('passed'), test('failed', True, 1), test('passed', True, 2)]
    return Record(
        **{
            'learner': learner,
            'source': 'x.zip',
            'key': 'k' * 64,
            'sandbox': 'none',
            'sha256': 's' * 64,
            'handed_in': '2026-11-20T10:00:00Z',
            'exercises': [
                results.scored(EXERCISES[0], tests),
                results.without_tests(EXERCISES[1], results.NOT_ATTEMPTED, 'Exercise 90.2 is not solved yet.'),
                results.without_tests(EXERCISES[2], verdicts.INVALID_SUBMISSION, 'The cell is there twice.'),
            ],
            **changes,
        }
    )


FAULT = record(first=[test('passed'), test('grader_error', True, 1, fault=SECRET)], log=[SECRET], notes=[SECRET])
LATE = record(
    late=Late('2026-11-19T10:00:00Z', '2026-11-20T10:00:00Z', 1, 10.0),
    seed='abc',
    keys={'90.1': 'k'},
    adjustments=[
        Adjustment('ada', '90.2', 8.0, None, 'right on paper'),
        Adjustment('ada', '90.1', None, -1.0, 'copied a line'),
    ],
    attempts=[Attempt('old.zip', 's' * 64, '2026-11-18T10:00:00Z', 1.0)],
)
PASSED = record(exercises=[results.scored(EXERCISES[0], [test('passed'), test('passed', True, 1)])])
RECORDS = {
    'plain': record(),
    'fault': FAULT,
    'late': LATE,
    'passed': PASSED,
    'crashed': record(
        first=[
            test('learner_crashed', details='Exercise 90.1, line 3', output='hello'),
            test('learner_crashed', True, 1, details='Exercise 90.1, line 3'),
        ]
    ),
    'visible only': record(first=[test('timeout')]),
    'incomplete': record(ungraded=['90.9']),
    'invalid': record(exercises=[results.without_tests(EXERCISES[2], verdicts.INVALID_SUBMISSION, 'Damaged.')]),
    'hostile': Record(
        HURT,
        HURT,
        HURT,
        HURT,
        [
            ExerciseResult(
                '90.1',
                HURT,
                10,
                'failed',
                0.0,
                HURT,
                [
                    TestResult(HURT, '90.1', hidden, 1, 'failed', f'{HURT}\n\n{HURT}', HURT, HURT, HURT, SECRET)
                    for hidden in (False, True)
                ],
            )
        ],
        log=[HURT],
        seed=HURT,
        sha256=HURT,
        adjustments=[Adjustment(HURT, '90.1', 1.0, None, HURT)],
        notes=[HURT],
    ),
}
each = pytest.mark.parametrize('made', RECORDS.values(), ids=RECORDS)


def validate(name: str, text: str) -> dict:
    """The JSON value, true to the schema."""
    schema = schemas.load(name)
    validator = jsonschema.validators.validator_for(schema)
    validator.check_schema(schema)
    value = json.loads(text, parse_constant=lambda word: pytest.fail(f'{word} is no JSON'))
    validator(schema).validate(value)
    return value


@each
def test_records_and_gradescope_follow_their_schemas(made):
    validate('result', made.dumps())
    for hidden in gradescope.VISIBILITIES:
        validate('gradescope', gradescope.dumps(made, hidden, ['Look out.']))


@pytest.mark.parametrize(
    'change',
    [
        {'schema': 1},
        {'status': 'good'},
        {'score': -1},
        {'extra': 1},
        {'learner': ''},
        {'exercises': [{'id': '1.1'}]},
        {'handed_in': 'yesterday'},
    ],
)
def test_the_schema_refuses(change):
    with pytest.raises(jsonschema.ValidationError):
        validate('result', json.dumps(json.loads(record().dumps()) | change))


def test_the_schema_knows_that_a_fault_is_no_zero():
    data = json.loads(FAULT.dumps())
    data['exercises'][0]['score'] = 0.0
    with pytest.raises(jsonschema.ValidationError):
        validate('result', json.dumps(data))


class Page(HTMLParser):
    """Checks the form of a page while reading it: what is open is closed, and nothing loads or runs."""

    VOID = {'meta', 'br', 'hr', 'img', 'input', 'link'}
    SVG = {'svg', 'rect', 'circle', 'path', 'text', 'line', 'title'}
    TAGS = SVG | {
        'html',
        'head',
        'meta',
        'style',
        'body',
        'a',
        'div',
        'p',
        'h1',
        'h2',
        'h3',
        'header',
        'nav',
        'main',
        'footer',
        'section',
        'article',
        'table',
        'thead',
        'tbody',
        'tr',
        'th',
        'td',
        'ul',
        'li',
        'dl',
        'dt',
        'dd',
        'span',
        'strong',
        'em',
        'code',
        'pre',
        'bdi',
        'details',
        'summary',
    }

    def __init__(self, text: str):
        super().__init__(convert_charrefs=True)
        self.open, self.ids, self.refers, self.words, self.levels, self.policy = [], [], [], [], [], ''
        self.feed(text)
        self.close()
        assert not self.open, self.open
        assert len(set(self.ids)) == len(self.ids)
        assert set(self.refers) <= set(self.ids)
        assert self.policy == "default-src 'none'; style-src 'unsafe-inline'"
        assert all(after - before <= 1 for before, after in zip(self.levels, self.levels[1:], strict=False))

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        assert tag in self.TAGS, tag
        assert len(attributes) == len(attrs) and not any(
            name.startswith('on') or name in ('src', 'style', 'srcdoc') for name in attributes
        ), (tag, attributes)
        if tag not in self.VOID:
            self.open.append(tag)
        if 'id' in attributes:
            self.ids.append(attributes['id'])
        if 'href' in attributes:
            assert attributes['href'].startswith('#'), attributes
            self.refers.append(attributes['href'][1:])
        if tag == 'meta' and attributes.get('http-equiv'):
            self.policy = attributes['content']
        if re.fullmatch('h[1-6]', tag):
            self.levels.append(int(tag[1]))
        if tag == 'svg':  # a picture has words, or is none
            assert attributes.get('aria-hidden') == 'true' or attributes.get('aria-label'), attributes
        if tag == 'th':
            assert 'scope' in attributes

    def handle_endtag(self, tag):
        assert self.open and self.open.pop() == tag, (tag, self.open)

    def handle_startendtag(self, tag, attrs):
        self.handle_starttag(tag, attrs)
        if tag not in self.VOID:
            self.open.pop()

    def handle_data(self, data):
        if self.open and self.open[-1] != 'style':
            self.words.append(data)

    @property
    def text(self) -> str:
        return ' '.join(' '.join(self.words).split())


def safe_page(text: str) -> Page:
    """The page, proved to be whole and harmless."""
    assert text.startswith('<!DOCTYPE html>\n<html lang="en">')
    assert not re.search(r'https?:|//|url\(|@import|javascript:', text)
    assert not [sign for sign in text if sign not in '\n\t' and unicodedata.category(sign) in ('Cc', 'Cs')]
    assert not re.search('[\u202a-\u202e\u2066-\u2069\ufffe]', text)
    return Page(text)


@each
def test_feedback_is_whole_and_harmless(made):
    page = safe_page(feedback.dumps(made))
    assert SECRET not in page.text


def test_hostile_feedback_shows_what_was_written():
    page = Page(feedback.dumps(RECORDS['hostile']))
    assert '<script>alert(1)</script>' in page.text and '⟨U+001B⟩[31m⟨U+202E⟩' in page.text
    assert '{{ 7 * 7 }} {% raw %}' in page.text and '&amp;' in page.text


def test_feedback_tells_what_happened_once():
    text = Page(feedback.dumps(record())).text
    assert 'Not passed: It speaks.' in text and 'It said 3 words.' in text and 'Look at the timer.' in text
    assert '2 of 3 tests passed.' in text and '6.67 of 10 points' in text and 'Go on with exercise 90.1' in text
    assert 'check · 3.33 points' in text and 'hidden · 3.33 points' in text and 'The cell is there twice.' in text
    text = Page(feedback.dumps(RECORDS['crashed'])).text
    assert 'The same happened here as above.' in text and text.count('Exercise 90.1, line 3') == 1
    assert 'Look at the timer.' not in text  # beside an error it would mislead


def test_feedback_explains_the_mark():
    text = Page(feedback.dumps(LATE)).text
    assert 'Handed in 2026-11-20 10:00:00 UTC, 1 day after the due time' in text and '10 % of the points' in text
    assert 'By the tests: 6.67 points.' in text and 'Late, less 10 %: 6 points.' in text
    assert 'By your instructor: -1 points. copied a line' in text
    assert 'By your instructor: set to 8 points. right on paper' in text and '1 submission; the latest one' in text
    assert '13 of 32 points' in feedback.dumps(LATE)
    text = Page(feedback.dumps(FAULT)).text
    assert 'fault on our side' in text and '– of 10 points' in text


def test_where_to_read_on(tmp_path):
    cells = [
        ('markdown', '# 4. Services\n'),
        ('markdown', '```\n## no heading\n```\n## 4.1 Ask\ntext\n### Wait\n'),
        ('markdown', '### Exercise 4.1: ask (10 points)'),
        ('code', '## no heading either'),
        ('markdown', '## 4.2 Answer'),
        ('markdown', '### Exercise 4.2: answer (5 points)'),
    ]
    (tmp_path / '04.ipynb').write_text(
        json.dumps({'cells': [{'cell_type': kind, 'source': [text]} for kind, text in cells]})
    )
    assert where_to_read.places('04.ipynb', tmp_path) == {
        '4.1': where_to_read.Place('04.ipynb', '4. Services', '4.1 Ask', ('Wait',)),
        '4.2': where_to_read.Place('04.ipynb', '4. Services', '4.2 Answer'),
    }
    assert where_to_read.places('05.ipynb', tmp_path) == {}
    place = where_to_read.place('3.4')
    shown = ExerciseResult('3.4', 'a latched map', 10, 'failed', 0.0, '', [test('failed')])
    text = Page(feedback.dumps(record(exercises=[shown]))).text
    assert place and place.section in text and place.notebook in text


def test_every_invisible_character_is_made_visible():
    for code in range(0x110000):
        sign = chr(code)
        if unicodedata.category(sign) in ('Cc', 'Cs', 'Zl', 'Zp') or unicodedata.bidirectional(sign) in (
            'LRE',
            'RLE',
            'LRO',
            'RLO',
            'PDF',
            'LRI',
            'RLI',
            'FSI',
            'PDI',
        ):
            assert sign in '\n\t' or safe.visible(sign) == f'⟨U+{code:04X}⟩'
    assert safe.visible('ä 漢字 👩‍💻 שלום\n\tx') == 'ä 漢字 👩‍💻 שלום\n\tx'
    assert safe.line('a\r\n  b\tc', 4) == 'a b…'


@each
def test_gradescope_adds_up(made):
    data = json.loads(gradescope.dumps(made))
    assert sum(entry['max_score'] for entry in data['tests']) == pytest.approx(made.points)
    if made.score is None:
        assert 'score' not in data
    else:
        assert data['score'] == made.score
        assert sum(entry['score'] for entry in data['tests']) == pytest.approx(made.earned)


def test_gradescope_gives_nothing_for_what_was_given():
    first = [test('passed', given=True), test('failed', number=1), test('failed', True, 2)]
    data = json.loads(gradescope.dumps(record(first=first), 'visible'))
    assert [entry['score'] for entry in data['tests']][:2] == [0, 0]
    assert results.AS_GIVEN.partition('.')[0] in data['tests'][0]['output']


def test_gradescope_keeps_what_is_hidden():
    first = [test('passed', message=''), test('failed', True, 1, expected=SECRET, message='It hides.')]
    data = json.loads(gradescope.dumps(record(first=first)))
    shown = [entry for entry in data['tests'] if entry['visibility'] == 'visible']
    (kept,) = (entry for entry in data['tests'] if entry['visibility'] != 'visible')
    assert kept['visibility'] == 'after_published' and 'It hides.' in kept['output'] and kept['status'] == 'failed'
    assert 'It hides.' not in json.dumps(shown) and SECRET not in json.dumps(shown)
    assert '5' not in data['output'] and data['stdout_visibility'] == 'hidden'
    assert 'passed; hidden tests run after submission' in data['output']
    data = json.loads(gradescope.dumps(PASSED))
    assert data['output'].startswith('All public tests passed; hidden tests run after submission.')
    data = json.loads(gradescope.dumps(record(first=first), 'visible'))
    assert data['output'] == '5 of 32 points' and {entry['visibility'] for entry in data['tests']} == {'visible'}
    with pytest.raises(ValueError, match='none of visible'):
        gradescope.dumps(record(), 'now')


@each
def test_junit(made):
    root = ElementTree.fromstring(junit.dumps(made).encode())
    (suite,) = root
    cases = suite.findall('testcase')
    kinds = Counter(kind.tag for case in cases for kind in case)
    assert root.tag == 'testsuites' and suite.get('tests') == str(len(cases)) == root.get('tests')
    assert [suite.get(name) for name in ('failures', 'errors', 'skipped')] == [
        str(kinds[name]) for name in ('failure', 'error', 'skipped')
    ]
    assert all(set(case.attrib) == {'classname', 'name', 'time'} and len(case) <= 1 for case in cases)
    assert float(suite.get('time')) == pytest.approx(sum(float(case.get('time')) for case in cases))
    assert SECRET not in junit.dumps(made)
    if made is FAULT:
        assert suite.get('errors') == '1'
    elif made is RECORDS['plain']:
        (failure,) = suite.findall('testcase/failure')[:1]
        assert (failure.get('type'), failure.get('message')) == ('failed', 'It said 3 words.')


def test_gradebook_shows_the_marks_that_count():
    text = gradebook.dumps([LATE, FAULT], EXERCISES)
    assert text == ('learner,90.1,90.2,90.3,total,status\nada,5,8,0,13,graded\nada,,0,0,,grader_error\n')
    for learner in ('=1+1', ' =1+1', '"=1+1', '＝1', '%0A=1', '|x'):
        row = list(csv.reader(io.StringIO(gradebook.dumps([record(learner)], EXERCISES))))[1]
        assert row[0] == f"'{learner}"


def test_summary():
    alike = [Pair('90.1', 'ada', HURT, 0.9, 40)]
    others = [
        record(f'l{n}', [test('failed', message=f"/robot{n} said {n} words, not 'x{n}'.\nA hint.")]) for n in range(4)
    ]
    slow = record('zoe', [test('timeout', message='It hangs.', seconds=5.0)])
    data = validate('summary', summary.dumps(summary.data([*RECORDS.values(), *others, slow], EXERCISES, alike)))
    first = data['misconceptions'][0]
    assert first['learners'] == ['l0', 'l1', 'l2', 'l3'] and first['message'] == "/robot0 said 0 words, not 'x0'."
    assert data['slowest'][0] == {'learner': 'zoe', 'exercise': '90.1', 'seconds': 5.0}
    assert data['faults'] == [{'learner': 'ada', 'exercise': '90.1', 'text': SECRET}]
    assert data['late'] == [{'learner': 'ada', 'days': 1, 'percent': 10.0}] and data['adjusted'] == 2
    exercise = data['exercises'][0]
    assert sum(exercise['verdicts'].values()) == sum(exercise['histogram']) + exercise['unknown'] == 13
    assert data['sandboxes']['none'] == 13
    assert {'learner': 'ada', 'text': SECRET} in data['notes']
    page = safe_page(summary.html(data))
    assert 'Graded without a sandbox' in page.text and 'It hangs.' in page.text and '90 %' in page.text


def test_summary_is_the_same_whatever_the_order():
    mixed = [
        record(learner, [test('failed', message=message)])
        for learner, message in (('a', 'It said 1.'), ('b', 'It said 2.'), ('c', 'Other.'), ('d', "It said 'x'."))
    ]
    assert summary.dumps(summary.data(mixed, EXERCISES)) == summary.dumps(summary.data(mixed[::-1], EXERCISES))


@pytest.mark.parametrize('few', [[], [record()], [FAULT]], ids=['none', 'one', 'fault'])
def test_summary_of_few(few):
    data = validate('summary', summary.dumps(summary.data(few, EXERCISES)))
    safe_page(summary.html(data))
    assert data['total']['known'] == sum(made.score is not None for made in few)


def test_quartiles():
    scores = [(float(score), 10.0) for score in range(11)]
    spread = summary._spread(scores)
    assert (spread['lower'], spread['median'], spread['upper'], spread['mean']) == (2.5, 5.0, 7.5, 5.0)
    assert spread['histogram'] == [1, 1, 1, 1, 1, 1, 1, 1, 1, 2]


@pytest.mark.parametrize(('folder', 'suffix', 'make'), reports.KINDS, ids=[kind[0] for kind in reports.KINDS])
def test_the_same_record_gives_the_same_report(folder, suffix, make):
    assert make(LATE) == make(LATE)


@pytest.mark.parametrize(
    ('path', 'value'),
    [
        (('exercises', 0, 'tests', 0, 'weight'), '1'),
        (('exercises', 0, 'tests', 0, 'seconds'), float('inf')),
        (('exercises', 0, 'tests', 0, 'verdict'), 'marvellous'),
        (('exercises', 0, 'tests', 0, 'rules'), [None]),
        (('exercises', 0, 'points'), 10**400),
        (('exercises', 0, 'score'), float('nan')),
        (('handed_in',), '2026-13-45T10:00:00Z'),
        (('late',), {'due': 3, 'handed_in': [], 'days': 1, 'percent': 10.0}),
        (('log',), ['a', 7]),
        (('adjustments',), [{'learner': 'ada', 'exercise': '3.1', 'points': None, 'delta': None, 'reason': 'x'}]),
        (('adjustments',), [{'learner': 'ada', 'exercise': '3.1', 'points': 1.0, 'delta': 1.0, 'reason': 'x'}]),
        (('marks',), []),
        (('more',), 1),
    ],
)
def test_a_damaged_record_is_none(tmp_path, path, value):
    """It would end the reports of everybody."""
    data = json.loads(record().dumps())
    place = data
    for part in path[:-1]:
        place = place[part]
    place[path[-1]] = value
    file = tmp_path / 'ada.json'
    file.write_text(record().dumps())
    assert Record.load(file) == record()
    file.write_text(json.dumps(data))
    assert Record.load(file) is None
