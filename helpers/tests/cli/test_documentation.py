"""What the guides quote is real: every command is one that the command line takes, every file that is named exists."""

import csv
import json
import re
import shlex
import shutil
import subprocess

import pytest
import typer

from helpers import paths
from helpers.cli import app
from helpers.exercises import start_page

# The learner's edition has not all of them.
GUIDES = [
    path
    for path in (
        paths.ROOT / 'README.md',
        *sorted(paths.ROOT.glob('[a-z]*/README.md')),
        paths.ROOT / 'environment' / 'containers' / 'README.md',
    )
    if path.is_file()
]
FULL = (paths.ROOT / 'grading').is_dir()
# Named in the guides, but made by what they tell: grade, build, submit, release --classroom, migrate; by JupyterLab.
MADE = {
    '.github/workflows/classroom.yml',
    'notebooks/backup-…',
    'notebooks/.ipynb_checkpoints',
    'gradescope/NAME.json',
    'build/bench.json',
}
# Placeholders of the guides. In a command one value stands for them, in a path any text.
VALUES = {'NN': '03', 'N': '2', 'N.M': '3.1'}
ANY = re.compile(r'NN|N_M|NAME|\w+-ID\b|(?<=_)name|misconception|style|…|\*')


def spans(text):
    """Code in the running text, without what stands in blocks of code."""
    text = re.sub(r'^(`{3,}).*?^\1$', '', text, flags=re.MULTILINE | re.DOTALL)
    return [' '.join(found[1].split()) for found in re.finditer(r'(?<!`)`([^`]+)`(?!`)', text)]


def commands(text):
    """Every quoted call of ./course, as the words after it."""
    quoted = [*spans(text), *(line.strip() for line in text.splitlines() if line.startswith('    '))]
    for one in quoted:
        found = re.search(r'(?:^|\s)\./course(?:\s+(.*))?$', one)
        if found:
            words = shlex.split((found[1] or '').removesuffix('…'), comments=True)
            yield [VALUES.get(word, word) for word in words]


def problem(words):
    """What the command line says against these words, '' if nothing. Nothing is run."""
    group = typer.main.get_command(app.make_app())
    if not words or words == ['--help']:
        return ''
    if words[0] not in group.commands:
        return f'there is no command {words[0]!r}'
    if '--help' in words:
        return ''
    try:
        group.commands[words[0]].make_context(words[0], words[1:])
    except Exception as error:  # typer's own errors, whose text is what the user would read
        return error.format_message() if hasattr(error, 'format_message') else repr(error)
    return ''


QUOTED = sorted(
    {
        (path.relative_to(paths.ROOT).as_posix(), shlex.join(words))
        for path in GUIDES
        for words in commands(path.read_text(encoding='utf-8'))
    }
)


@pytest.mark.parametrize(('guide', 'command'), QUOTED, ids=lambda text: text.replace('/', '.'))
def test_a_quoted_command_is_one(guide, command):
    words = shlex.split(command)
    if not FULL and words and words[0] in app.INSTRUCTOR:
        pytest.skip("the learner's edition has no commands for instructors")
    assert not problem(words), f'{guide}: ./course {command}: {problem(words)}'


# Which tests run the commands that take longer, or need a place of their own.
ELSEWHERE = {
    'lab': 'helpers/tests/browser',
    'migrate': 'helpers/tests/cli',
    'submit': 'helpers/tests/cli',
    'test': 'helpers/tests/cli/test_test.py',
    'grade': 'grading/tests/cli',
    'release': 'grading/tests/test_learners_edition.py',
    'build': 'grading/tests/authoring/test_chapter_build.py',
    'bench': 'grading/tests/cli/test_benchmarks.py',
    'dask': 'grading/tests/test_cluster.py',
    'answers': 'grading/tests/test_validity.py',
}


@pytest.mark.one_of(4)
@pytest.mark.parametrize('command', sorted({command for _, command in QUOTED}))
def test_a_quoted_command_runs(command):
    """As it is quoted, in the course's own folder; in the shell that `shell` opens, a program of ROS is there."""
    words = shlex.split(command) or ['--help']
    elsewhere = [ELSEWHERE[word] for word in words if word in ELSEWHERE and '--help' not in words]
    if elsewhere:
        assert not FULL or (paths.ROOT / elsewhere[0]).exists()
        return
    done = subprocess.run(
        [paths.ROOT / 'course', *words],
        input='command -v ros2\nexit\n',
        cwd=paths.ROOT,
        timeout=100,
        capture_output=True,
        text=True,
    )
    # 1 from a check: not all is solved
    assert done.returncode in ((0, 1) if words[0] == 'check' else (0,)), done.stdout + done.stderr
    assert words[0] != 'shell' or '/bin/ros2' in done.stdout


def test_commands_are_found():
    text = 'Run `A=b ./course check 3.1`:\n\n    ./course build NN  # proof\n    cd x\n\n```\n`./course a`\n```\n'
    assert list(commands(text)) == [['check', '3.1'], ['build', '03']]


@pytest.mark.parametrize('command', ['chekc 3.1', 'check', 'lab --prot 1', 'lab --port x', 'check 3.1 3.2'])
def test_a_wrong_command_is_noticed(command):
    assert problem(command.split())


@pytest.mark.skipif(not FULL, reason="the learner's edition has not all commands")
@pytest.mark.parametrize('guide', GUIDES, ids=lambda path: path.parent.name)
def test_quoted_options_exist(guide):
    group = typer.main.get_command(app.make_app())
    known = {option for command in group.commands.values() for parameter in command.params for option in parameter.opts}
    quoted = {
        found
        for span in spans(guide.read_text(encoding='utf-8'))
        if span.startswith('--')
        for found in re.findall(r'^--[a-z-]+', span)
    }
    assert quoted - known <= {'--security-opt'}  # docker's


@pytest.mark.parametrize('guide', GUIDES, ids=lambda path: path.parent.name)
def test_named_files_exist(guide):
    text = guide.read_text(encoding='utf-8')
    links = [target for target in re.findall(r'\]\(([^)#]+)[^)]*\)', text) if not re.match(r'https?:', target)]
    missing = []
    for name in [*links, *spans(text)]:
        first = name.partition('/')[0]
        if ' ' in name or '/' not in name or name.startswith('/') or name in MADE:
            continue
        if not (first == '..' or (guide.parent / first).exists() or (paths.ROOT / first).exists()):
            if FULL and name in links:
                missing.append(name)
            continue  # a name of something else, such as a folder of results
        pattern = ANY.sub('*', name).rstrip('/')
        base = (guide.parent, paths.ROOT)
        if first in ('.venv', '.home') or any(True for folder in base if _exists(folder, pattern)):
            continue
        if not FULL and re.match(r'(\.github|grading|solutions)\b', name):
            continue
        missing.append(name)
    assert missing == []


def _exists(folder, pattern):
    while pattern.startswith('../'):
        folder, pattern = folder.parent, pattern[3:]
    return any(folder.glob(pattern))


def test_the_readme_lists_every_chapter():
    rows = re.findall(r'^\| (\d) \| `(\w+)` \|', (paths.ROOT / 'README.md').read_text(), re.MULTILINE)
    found = sorted(paths.NOTEBOOKS.glob('[0-9][0-9]_*.ipynb'))
    assert rows == [(path.name[1], path.stem) for path in found]


def test_every_chapter_says_how_long_it_takes():
    for path in sorted(paths.NOTEBOOKS.glob('[0-9][0-9]_*.ipynb')):
        assert re.fullmatch(r'[a-z]+ hours', start_page.introduction(path).time), path.name


@pytest.mark.skipif(not FULL, reason="the learner's edition has no commands for instructors")
@pytest.mark.one_of(3)
def test_the_way_from_a_release_to_the_grade_book(tmp_path, monkeypatch, capsys):
    """The commands of the guide, in their order: release, an old answer taken over, submit, grade."""
    from grading import sandbox

    monkeypatch.chdir(tmp_path)

    def course(command):
        status = app.main(shlex.split(command))
        return status, capsys.readouterr().out

    assert course('release -o ros2-course')[0] == 0
    notebooks = tmp_path / 'ros2-course' / 'notebooks'
    (chapter,) = notebooks.glob('03_*.ipynb')
    old = tmp_path / 'old'
    old.mkdir()
    solution = json.loads((paths.ROOT / 'solutions' / chapter.name).read_text())
    answer = next(cell['source'] for cell in solution['cells'] if cell['id'] == 'ex-3-1')
    work = json.loads(chapter.read_text())
    next(cell for cell in work['cells'] if cell['id'] == 'ex-3-1')['source'] = answer
    (old / chapter.name).write_text(json.dumps(work))
    assert course('migrate old --notebooks ros2-course/notebooks')[0] == 0
    handed_in = tmp_path / 'submissions'
    handed_in.mkdir()
    for path in notebooks.glob('*.ipynb'):
        if path != chapter:
            path.unlink()  # one chapter is enough
    status, shown = course('submit --id ada --notebooks ros2-course/notebooks -o submissions/ada.zip')
    assert status == 0 and '1 of ' in shown
    protected = '' if not sandbox.problem() else ' --sandbox none'
    assert course(f'grade submissions -o results{protected}')[0] == 0
    with open('results/gradebook.csv', newline='', encoding='utf-8') as file:
        (row,) = csv.DictReader(file)
    assert row['learner'] == 'ada' and float(row['3.1']) == 10
    assert (tmp_path / 'results' / 'feedback' / 'ada.html').is_file()
    assert course(f'grade submissions -o results --only ada/3.2 --regrade{protected}')[0] == 0
    assert course(f'grade submissions -o results-3 --chapter 3{protected}')[0] == 0
    shutil.rmtree(notebooks.parent)
