"""From a source to its notebooks, with a real kernel."""

import json
import re

import nbformat
import pytest

from grading.authoring import chapter_build, execution, in_step, notebook_pair, outputs
from grading.authoring.chapter_errors import ChapterErrors
from grading.tests.authoring.conftest import write
from grading.tests.authoring.sources import TINY, line_of
from helpers import paths
from helpers.exercises import manifest


def read(path):
    return nbformat.read(path, as_version=4)


def only(tree):
    """The one chapter of ``tree``."""
    (chapter,) = chapter_build.read_all(tree)
    return chapter


def quiet(line):
    """Take no notice of progress."""


def test_a_chapter_is_built_and_in_step(tree):
    chapter_build.build(tree, say=quiet)
    solved, learner = read(tree.solved(only(tree))), read(tree.learner(only(tree)))
    code = [cell for cell in solved.cells if cell.cell_type == 'code']
    assert [cell.execution_count for cell in code] == [1, 2, 3, 4]
    assert code[2].outputs[0].text == 'checked 7.1\n'
    assert [output.output_type for output in code[3].outputs] == ['stream', 'error']
    assert 'SOLUTION' not in code[1].source and 'return 2 * number' in code[1].source
    stubs = [cell for cell in learner.cells if cell.cell_type == 'code']
    assert all(cell.execution_count is None and cell.outputs == [] for cell in stubs)
    assert learner.cells[3].source.splitlines()[-2:] == ['    # Your code here.', '    return None']
    assert learner.cells[3].metadata == {
        'deletable': False,
        'exercise': {'id': '7.1', 'points': 10, 'names': ['double']},
    }
    assert [cell.id for cell in learner.cells] == [cell.id for cell in solved.cells]
    assert learner.cells[3].id == 'ex-7-1'
    assert in_step.drift(tree) == []


def test_nothing_in_the_metadata_changes_from_build_to_build(tree):
    chapter_build.build(tree, say=quiet)
    before = {path: path.read_bytes() for path in tree.root.rglob('*') if path.is_file()}
    chapter_build.build(tree, force=True, say=quiet)
    assert {path: path.read_bytes() for path in tree.root.rglob('*') if path.is_file()} == before
    text = tree.solved(only(tree)).read_text()
    assert 'timestamp' not in text and 'iopub' not in text and '"version": "3.' not in text


def test_a_chapter_is_executed_again_only_if_its_code_has_changed(built, monkeypatch):
    executed = []
    monkeypatch.setattr(execution, 'execute', lambda *args: executed.append(1))
    lines = []
    chapter_build.build(built, say=lines.append)
    assert executed == [] and lines == ['07_tiny: unchanged']
    before = read(built.solved(only(built)))
    write(built, TINY.replace('Some prose.', 'Other prose.'))
    chapter_build.build(built, say=lines.append)
    assert executed == [] and lines[1:] == ['07_tiny: only its prose has changed']
    assert in_step.drift(built) == []
    after = read(built.solved(only(built)))
    assert [cell.get('outputs') for cell in after.cells] == [cell.get('outputs') for cell in before.cells]
    write(built, TINY.replace("print('before')", "print('now')"))
    chapter_build.build(built, say=lines.append)
    assert executed == [1]
    chapter_build.build(built, force=True, say=lines.append)
    assert executed == [1, 1]


def test_a_chapter_is_executed_again_if_a_card_has_more_rules(built, monkeypatch):
    check = next(cell for cell in read(built.solved(only(built))).cells if cell.source == 'check("7.1")')
    edit_output(built, check.id, '  Solved: 1 of 1 rules are kept. When your work is graded, …')
    assert 'counts 1 rules; its card has 0' in ''.join(in_step.drift(built))
    card = ':names: double\n```\n'
    write(built, TINY.replace(card, card + '\n- {rule}`twice` It returns twice the number.\n'))
    executed = []
    monkeypatch.setattr(execution, 'execute', lambda *args: executed.append(1))
    chapter_build.build(built, say=quiet)
    assert executed == [], 'its output counts the one rule of its card'
    two = '\n- {rule}`twice` It returns twice the number.\n- {rule}`same` It keeps the kind of number.\n'
    write(built, TINY.replace(card, card + two))
    chapter_build.build(built, say=quiet)
    assert executed == [1]


def edit_output(tree, cell_id, text):
    """Keep `text` as what the cell has shown."""
    path = tree.solved(only(tree))
    notebook = read(path)
    cell = next(cell for cell in notebook.cells if cell.id == cell_id)
    cell.outputs = [nbformat.v4.new_output('display_data', {'text/plain': text})]
    nbformat.write(notebook, path)


def test_only_the_selected_chapters_are_built(tree):
    write(tree, TINY.replace('7.1', '8.1'), '08_other.md')
    chapter_build.build(tree, {8}, say=quiet)
    assert {path.name for path in tree.notebooks.iterdir()} == {'08_other.ipynb'}
    assert list(manifest.load(tree.manifest)) == ['7.1', '8.1']


def test_an_edit_changes_the_id_of_its_own_cell_only(tree):
    before = [cell.id for cell in notebook_pair.solved(only(tree)).cells]
    write(tree, TINY.replace('Some prose.', 'Other prose.'))
    after = [cell.id for cell in notebook_pair.solved(only(tree)).cells]
    assert [one == other for one, other in zip(before, after, strict=True)] == [True, True, False, True, True, True]


def test_equal_cells_have_different_ids(tree):
    write(tree, TINY + '\n```{code-cell} ipython3\nprint(1)\n```\n\n```{code-cell} ipython3\nprint(1)\n```\n')
    ids = [cell.id for cell in notebook_pair.solved(only(tree)).cells]
    assert len(set(ids)) == len(ids)


def test_the_list_of_exercises_recognises_the_stub(built):
    exercise = manifest.load(built.manifest)['7.1']
    assert (exercise.chapter, exercise.notebook, exercise.title) == (7, '07_tiny.ipynb', 'twice as much')
    assert (exercise.points, exercise.names, exercise.cell_id) == (10, ('double',), 'ex-7-1')
    stub = read(built.learner(only(built))).cells[3].source
    assert manifest.stub_digest(stub) == exercise.stub
    assert manifest.stub_digest(stub + '\n# a comment\n') == exercise.stub
    assert manifest.stub_digest(stub.replace('None', '0')) != exercise.stub


def test_the_learners_notebook_keeps_only_the_tags_that_matter_there(tree):
    write(tree, TINY.replace(':tags: [raises-exception]', ':tags: [raises-exception, nbval-ignore-output]'))
    learner = notebook_pair.learner(only(tree))
    assert learner.cells[5].metadata == {'tags': ['raises-exception']}


def test_a_failing_cell_names_its_line_and_error(tree):
    end = 'return 2 * number\n    # END SOLUTION'
    text = TINY.replace(end, f'{end}\n\n\ndouble(undefined)')
    path = write(tree, text)
    with pytest.raises(ChapterErrors) as caught:
        chapter_build.build(tree, say=quiet)
    place = f'solutions/{path.name}:{line_of("double(undefined)", text)}: cell 4 (ex-7-1) failed'
    assert str(caught.value).startswith(f"{place} with NameError: name 'undefined' is not defined; correct it")
    assert not tree.solved(only(tree)).exists()
    assert tree.learner(only(tree)).exists()  # check needs it, and the author sees it


def test_a_cell_that_hangs_is_ended(tree):
    path = write(tree, TINY.replace("print('before')", 'import time; time.sleep(60)'))
    with pytest.raises(ChapterErrors, match=r'cell 6 \(\w+\) took more than 1 s; bound its waits') as caught:
        chapter_build.build(tree, timeout=1, say=quiet)
    assert f':{line_of("time.sleep", path.read_text())}: ' in str(caught.value)


def test_a_cell_that_ends_the_kernel_is_named(tree):
    write(tree, TINY.replace("print('before')", 'import os; os._exit(3)'))
    with pytest.raises(ChapterErrors, match=r'cell 6 \(\w+\) ended the kernel'):
        chapter_build.build(tree, say=quiet)


def test_ctrl_c_is_no_error_of_the_notebook(tree):
    write(tree, TINY.replace('1 / 0', 'import os, signal, time; os.kill(os.getppid(), signal.SIGINT); time.sleep(60)'))
    with pytest.raises(KeyboardInterrupt):
        chapter_build.build(tree, say=quiet)
    assert not tree.solved(only(tree)).exists()


def test_a_notebook_over_one_megabyte_is_refused(tree):
    write(tree, TINY.replace("print('before')", "print('x' * 1_000_001)"))
    with pytest.raises(ChapterErrors, match='has 1.0 MB with outputs, 1 MB is allowed'):
        chapter_build.build(tree, say=quiet)
    assert not tree.solved(only(tree)).exists()


def test_streams_are_joined_and_ordered(tree):
    code = """import sys
for number in range(3):
    print(number, file=sys.stderr, flush=True)
    print(number, flush=True)"""
    write(tree, TINY.replace("print('before')", code))
    chapter_build.build(tree, say=quiet)
    shown = [(output.get('name'), output.get('text')) for output in read(tree.solved(only(tree))).cells[5].outputs]
    assert shown == [('stdout', '0\n1\n2\n'), ('stderr', '0\n1\n2\n'), (None, None)]


def test_the_kernel_has_a_ros_domain_of_its_own_and_runs_in_notebooks(tree, domain):
    write(tree, TINY.replace("print('before')", "import os; print(os.environ['ROS_DOMAIN_ID'], os.getcwd())"))
    chapter_build.build(tree, say=quiet)
    number, folder = read(tree.solved(only(tree))).cells[5].outputs[0].text.split()
    assert int(number) not in (0, domain)
    assert folder == '/course/notebooks'  # the path of this machine is not kept


def test_what_differs_between_machines_is_not_kept(tree):
    text = 'import os; print(f"<f at {id(os):#x}> http://127.0.0.1:41234/a pid {os.getpid()} process 77")'
    write(tree, TINY.replace("print('before')", text))
    chapter_build.build(tree, say=quiet)
    kept = read(tree.solved(only(tree))).cells[5].outputs[0].text
    assert kept == '<f at 0x0> http://127.0.0.1:0/a pid 0 process 0\n'


def test_sanitizers_leave_alone_what_they_made(tmp_path):
    for name, regex, replace in outputs.sanitizers(tmp_path):
        example = {
            'folder': f'{tmp_path}/solutions/ros2_ws',
            'checkout': f'{tmp_path}/a',
            'duration': 'Finished <<< a [1min 1.28s]',
            'email': 'by <root@todo.todo>',
            'ipykernel_file': '/tmp/ipykernel_71/8.py',
            'address': '0x7f0011aabb',
            'temporary': '/tmp/tmpc3i2_xnc/a',
            'port': 'localhost:4242',
            'pid': 'pid=12',
            'kept': 'What you made or changed in a_ws is kept: b, now in /course/notebooks/a_ws_kept/3\n$ cd src\n',
            'ros_log': 'below /home/ada/.ros/log/2026-11-21-09-59-04-704598-lab-23551',
        }[name]
        once = re.sub(regex, replace, example)
        assert once != example
        assert re.sub(regex, replace, once) == once


def test_exercises_are_sorted_by_number(tree):
    rows = [manifest.Exercise(f'7.{number}', 7, 'a.ipynb', 't', 1, ('a',), 'ex', '') for number in (10, 2, 1)]
    assert [row['id'] for row in json.loads(manifest.dumps(rows))['exercises']] == ['7.1', '7.2', '7.10']


@pytest.mark.parametrize('path', sorted((paths.ROOT / 'solutions').glob('*.ipynb')), ids=lambda path: path.stem)
def test_what_the_real_checks_have_printed_is_read(path):
    """The words of a check stand in another module: if they change, the counts of rules would be found nowhere."""
    checks = [cell for cell in read(path).cells if re.fullmatch(r'check\("\d\.\d+"\)', cell.source.strip())]
    counted = [cell for cell in checks if chapter_build.RULES_KEPT.search(json.dumps(cell.outputs))]
    assert len(counted) >= len(checks) / 2 > 0
