"""GitHub Classroom's workflow: what it runs, and that it is given only if asked for."""

import re

import yaml

from grading import classroom, learners_edition
from helpers.exercises import manifest
from helpers.tests import small

EXERCISES = [
    small.exercise(1, chapter=4, points=10),
    small.exercise(2, chapter=3, points=2.5),
    small.exercise(3, chapter=4, points=5),
]


def test_one_check_for_each_chapter():
    workflow = yaml.safe_load(classroom.workflow(EXERCISES))
    (job,) = workflow['jobs'].values()
    steps = {step['id']: step['with'] for step in job['steps'] if 'id' in step}
    assert {name: (step['command'], step['max-score']) for name, step in steps.items()} == {
        'chapter3': ('./course check 3', 2),
        'chapter4': ('./course check 4', 15),
    }
    (report,) = (step for step in job['steps'] if 'reporter' in step.get('uses', ''))
    assert report['with']['runners'] == 'chapter3,chapter4' and report['if'] == 'always()'
    assert report['env'] == {
        f'CHAPTER{number}_RESULTS': f'${{{{ steps.chapter{number}.outputs.result }}}}' for number in (3, 4)
    }


def test_it_may_do_little_and_knows_no_secret():
    text = classroom.workflow(manifest.load().values())
    workflow = yaml.safe_load(text)
    assert workflow['permissions'] == {'checks': 'write', 'actions': 'read', 'contents': 'read'}
    assert set(workflow[True]) == {'push', 'workflow_dispatch', 'repository_dispatch'}  # YAML reads `on` as true
    assert 'secrets.' not in text and 'pull_request_target' not in text and 'hidden' not in text
    (job,) = workflow['jobs'].values()
    assert job['timeout-minutes'] and all(
        re.fullmatch(r'[\w-]+/[\w-]+@v\d+', step['uses']) for step in job['steps'] if 'uses' in step
    )
    # What GitHub fills in stands in no shell command, where a name could become code.
    assert not [step for step in job['steps'] if '${{' in step.get('run', '')]


def test_only_when_asked_for(tmp_path):
    files = learners_edition.release(tmp_path / 'a', classroom=True)
    assert classroom.PATH in files
    text = (tmp_path / 'a' / classroom.PATH).read_text()
    assert text == classroom.workflow(manifest.load().values())
    assert classroom.PATH not in learners_edition.files(learners_edition.paths.ROOT)
