"""Hidden tests of exercise 8.1, a linter for names."""

import pytest

from helpers import paths
from helpers.checks.chapter_08 import linting
from helpers.checks.chapter_08.linting import bad_names, compare, word

pytestmark = pytest.mark.exercise('8.1')


@pytest.mark.rules('topic')
def test_topics(learner):
    """Each word of a topic is judged; the name is relative, or private with ~/.

    Take ~/ away from the front, and split the rest at each slash. An empty word is no word.
    """
    linting.judge_topics(learner, 'topic', ('create_subscription', 'create_publisher'))


@pytest.mark.rules('word')
@pytest.mark.weight(2)
def test_words(learner):
    """A word has letters a to z, digits and single underscores, begins with a letter and ends with no underscore.

    Write the rule as one regular expression, and use fullmatch.
    """
    linting.judge_words(learner)


@pytest.mark.rules('service')
def test_services(learner):
    """Services are judged as topics are, of servers and of clients, and are reported as services.

    create_service and create_client: the second argument.
    """
    linting.judge_topics(learner, 'service', ('create_client', 'create_service'))


@pytest.mark.rules('no-text', 'keyword')
@pytest.mark.weight(2)
def test_where_names_are(learner):
    """Only names are judged: no comment, no other text, no variable; and keywords are arguments, too.

    Use calls(text): it knows what is a call. A text in the file is no name.
    """
    linting.judge_keywords(learner)
    linting.judge_no_text(learner)


@pytest.mark.rules('node', 'super')
def test_nodes(learner):
    """super().__init__ names a node only in a class with the base Node or LifecycleNode; Node(…) names one, too.

    `bases` holds the names of the base classes. An exception has a super().__init__ as well.
    """
    bad = word(learner.random).capitalize()
    text = f"def make():\n    return Node('{bad}D'), rclpy.node.Node('{bad}E', use=[create_node('{bad}F')])"
    linting.judge(learner, text, [('node', f'{bad}{letter}') for letter in 'DEF'], 'node')
    linting.judge_places(learner)
    linting.judge_super(learner)


@pytest.mark.rules('package', 'files')
def test_packages(learner):
    """The name of the package is read from package.xml, wherever that is; it has at least two characters.

    Judge the element <name>, and no other file.
    """
    linting.judge_packages(learner)


@pytest.mark.rules('once', 'sorted')
def test_order(learner):
    """The list is sorted, and each finding is in it once.

    A set forgets what comes twice; sorted() makes a list of it.
    """
    linting.judge_list(learner)


@pytest.mark.rules('topic', 'service')
def test_real_package(learner):
    """In a real package, the turtle simulation, exactly the names that were made wrong are found.

    Try your function with the packages of the course, as the notebook does.
    """
    folder = paths.ROOT / 'environment' / 'ros2_ws' / 'src' / 'turtlesim'
    files = {
        path.relative_to(folder).as_posix(): path.read_text()
        for path in [*folder.rglob('*.py'), folder / 'package.xml']
    }
    bad = word(learner.random).capitalize()
    planted = {"'turtle1/cmd_vel'": ('topic', f'{bad}/cmd_vel'), "'reset'": ('service', f'/{bad.lower()}/reset')}
    expected = []
    for path, text in files.items():
        for old, (kind, new) in planted.items():
            if f', {old},' in text or f', {old})' in text:
                text = text.replace(f', {old}', f', {new!r}')
                expected.append((path, kind, new))
        files[path] = text
    assert len(expected) >= 3
    found = bad_names(learner, files, 'topic')
    for kind in ('topic', 'service'):
        compare([one for one in found if one[1] == kind], [one for one in expected if one[1] == kind], kind)
