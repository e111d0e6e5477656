"""A small course for tests: exercises, notebooks and test files made on the spot."""

import json
from dataclasses import dataclass, replace
from pathlib import Path

from helpers.exercises.manifest import Exercise, stub_digest
from helpers.exercises.notebooks import NotebookCell

NOTEBOOK = '90_small.ipynb'
STUB = 'class Talker(Node):\n    pass\n'
IMPORTS = """\
import time
import rclpy
from rclpy.node import Node
from rclpy.qos import *
from std_msgs.msg import *
"""
TALKER = """\
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.count = 0
        self.create_timer(0.5, self.tick)

    def tick(self):
        self.publisher.publish(String(data=str(self.count)))
        self.count += 1
"""
VISIBLE = '''
def test_rate(learner):
    """The talker speaks twice a second.

    Look at the period.
    """
    heard = learner.listen('/chatter', String)
    learner.start('Talker')
    learner.run(2.0)
    expect(len(heard) == 4, f'{len(heard)} messages came in 2 s.')
'''
HIDDEN = '''
@pytest.mark.weight(3)
def test_text(learner):
    """The texts count from 0.

    Look at the counter.
    """
    heard = learner.listen('/chatter', String)
    learner.start('Talker')
    learner.run(2.0)
    expect(heard.data == ['0', '1', '2', '3'], f'The texts are {heard.data}.', hint=True)
'''
HEAD = """\
import os
import time
import pytest
from rclpy.qos import *
from std_msgs.msg import *
from helpers.runner import expect
pytestmark = pytest.mark.exercise('{id}')
"""


@dataclass
class Case:
    """One program, its test, and what the result must be."""

    program: str
    test: str
    verdict: str = 'passed'
    messages: tuple = ()  # fragments of the message
    details: str = ''  # fragment of the details
    output: str = ''  # fragment of the output


def exercise(number: int = 1, names=('Talker',), points: float = 10, **changes) -> Exercise:
    """An exercise of chapter 90."""
    made = Exercise(
        id=f'90.{number}',
        chapter=90,
        notebook=NOTEBOOK,
        title='a talker',
        points=points,
        names=tuple(names),
        cell_id=f'ex-90-{number}',
        stub=stub_digest(STUB),
    )
    return replace(made, **changes)


def cell(source: str, number: int = 1) -> NotebookCell:
    """The cell of an exercise of chapter 90."""
    return NotebookCell(f'# Exercise 90.{number}: a talker\n{source}', number + 1, f'ex-90-{number}')


def cells(source: str, number: int = 1) -> list[NotebookCell]:
    """A notebook's cells: imports and one exercise."""
    return [NotebookCell(IMPORTS, 1, 'imports'), cell(source, number)]


def notebook(*sources: str) -> bytes:
    """A notebook of these code cells."""
    return json.dumps(
        {
            'nbformat': 4,
            'nbformat_minor': 5,
            'metadata': {},
            'cells': [
                {
                    'cell_type': 'code',
                    'id': f'c{number}',
                    'metadata': {},
                    'execution_count': None,
                    'outputs': [],
                    'source': source,
                }
                for number, source in enumerate(sources)
            ],
        }
    ).encode()


def write_tests(folder: Path, text: str, number: int = 1, kind: str = 'checks') -> Path:
    """Write a test file for exercise 90.number; returns the folder of the chapters' or exercises' folders.

    `kind` is 'checks', or 'exercises' for hidden tests.
    """
    path = folder / kind / ('chapter_90' if kind == 'checks' else f'90_{number}')
    path /= f'test_90_{number}.py' if kind == 'checks' else 'hidden.py'
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(HEAD.format(id=f'90.{number}') + text)
    return folder / kind


def solved(source: str = TALKER) -> bytes:
    """A notebook with one exercise, 90.1."""
    return notebook(IMPORTS, f'# Exercise 90.1: a talker\n{source}')
