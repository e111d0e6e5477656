"""A name stands for one thing: each file and each class of the course has a name that no other one has."""

import ast
from collections import defaultdict
from pathlib import PurePosixPath

from grading import learners_edition
from helpers import paths

# What is named by its place: the parts of an exercise, and what pytest and Python themselves look for.
BY_PLACE = {'__init__.py', '__main__.py', 'conftest.py', 'hidden.py', 'mutants.py', 'alternatives.py'}
# ROS packages; and notebooks' sources, whose figures are called as their pictures.
ELSEWHERE = ('environment/ros2_ws', 'solutions', 'notebooks')


def modules() -> list[PurePosixPath]:
    """The course's own ones: not what learners are given as files of theirs."""
    found = map(PurePosixPath, learners_edition.files(paths.ROOT, ELSEWHERE))
    return [path for path in found if path.suffix == '.py' and 'given' not in path.parts]


def several(places: dict[str, list[str]]) -> dict[str, list[str]]:
    return {name: found for name, found in places.items() if len(found) > 1}


def test_files():
    places = defaultdict(list)
    for path in modules():
        if path.name not in BY_PLACE:
            places[path.name].append(str(path))
    assert len(places) > 500
    assert not several(places)


def test_classes():
    places = defaultdict(list)
    for path in modules():
        if 'tests' in path.parts:
            continue
        for node in ast.walk(ast.parse((paths.ROOT / path).read_text(encoding='utf-8'))):
            if isinstance(node, ast.ClassDef) and not node.name.startswith('_'):
                places[node.name].append(str(path))
    assert len(places) > 200
    assert not several(places)
