"""Visible tests of exercise 8.1, a linter for names."""

import pytest

from helpers.checks.chapter_08 import linting

pytestmark = pytest.mark.exercise('8.1')


@pytest.mark.rules('node', 'super')
def test_nodes(learner):
    """Names of nodes are found in create_node(…), Node(…), and super().__init__(…) of a node's class.

    Go through `calls(text)`. The names of the base classes are the last of the four values.
    """
    bad = linting.word(learner.random).capitalize()
    linting.judge(
        learner,
        f"n = create_node('{bad}A')\nm = rclpy.create_node(\n    '{bad}B')\nk = Node('{bad}C')\n"
        f"j = rclpy.node.Node('{bad}D')\n",
        [('node', f'{bad}{letter}') for letter in 'ABCD'],
        'node',
        'Its name begins with a capital letter.',
    )
    linting.judge_places(learner)
    linting.judge_super(learner)


@pytest.mark.rules('topic', 'service')
def test_topics_and_services(learner):
    """Names of topics and services are words joined by /, relative, or private with ~/.

    Take ~/ away from the front, and split the rest at each slash. An empty word is no word.
    """
    linting.judge_topics(learner, 'topic', ('create_publisher', 'create_subscription'))
    linting.judge_topics(learner, 'service', ('create_service', 'create_client'))


@pytest.mark.rules('word')
def test_words(learner):
    """A word has letters a to z, digits and single underscores, begins with a letter and ends with no underscore.

    Write the rule as one regular expression, and use fullmatch.
    """
    linting.judge_words(learner)


@pytest.mark.rules('no-text', 'keyword')
def test_arguments(learner):
    """Names are arguments, also those that are keywords; no other text is a name.

    Use calls(text): it knows what is a call, and what is no text comes as None.
    """
    linting.judge_no_text(learner)
    linting.judge_keywords(learner)


@pytest.mark.rules('package', 'files', 'once', 'sorted')
def test_files_and_list(learner):
    """The name of the package is judged, other files are not; the list is sorted, and each finding is in it once.

    A set forgets what comes twice; sorted() makes a list of it.
    """
    linting.judge_packages(learner)
    linting.judge_list(learner)
