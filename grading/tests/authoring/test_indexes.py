"""The glossary with its marks in the chapters, and the index of symptoms."""

import pytest

from grading.authoring import chapter_build, in_step
from grading.authoring.chapter_errors import ChapterErrors
from grading.edition import pages
from grading.tests.authoring.conftest import make_without_kernel, write
from grading.tests.authoring.sources import FRONT, TINY, line_of

GLOSSARY = """- term: node
  says: A member of the
    graph.
  link: https://docs.ros.org/nodes
- term: callback group
  says: A set of callbacks.
"""
SEVEN = f"""{TINY}
## 7.1 A start

One {{term}}`node`. Two {{term}}`callback groups <callback group>`.

## 7.2 When it goes wrong

| symptom | how | usual cause |
|---|---|---|
| `a \\| b` hangs | look | see {{section}}`7.1` |
| no data | look | QoS |

### Check yourself
"""
EIGHT = FRONT + '# 8 Other\n\n## 8.1 More\n\nA {term}`node`.\n'


@pytest.fixture
def marked(tree):
    write(tree, GLOSSARY, 'glossary.yml')
    write(tree, SEVEN)
    write(tree, EIGHT, '08_other.md')
    return tree


def last(tree, number):
    """The last Markdown cell of a chapter."""
    return chapter_build.read_all(tree)[number - 7].cells[-1].split.solved


def test_marks_lead_to_entries_and_new_words_stand_before_the_questions(marked):
    text = last(marked, 7)
    assert 'One [*node*](GLOSSARY.md#node). Two [*callback groups*](GLOSSARY.md#callback-group).' in text
    words = '[callback group](GLOSSARY.md#callback-group) · [node](GLOSSARY.md#node)'
    assert text.endswith(f'### New words\n\n{words}\n\n### Check yourself')
    assert 'New words' not in last(marked, 8)


def test_the_pages_are_built_and_kept_in_step(marked):
    make_without_kernel(marked)
    start = '[section 7.1](07_tiny.ipynb#heading=7.1-A-start)'
    words, symptoms = marked.notebooks / 'GLOSSARY.md', marked.notebooks / 'SYMPTOMS.md'
    assert words.read_text().endswith(
        f'## callback group\n\nA set of callbacks. First in {start}.\n\n'
        f'## node\n\nA member of the graph. First in {start}.'
        ' More: [docs.ros.org](https://docs.ros.org/nodes).\n'
    )
    wrong = '[7.2](07_tiny.ipynb#heading=7.2-When-it-goes-wrong)'
    assert symptoms.read_text().endswith(
        f'## 7 Tiny\n\n| symptom | cause | section |\n|---|---|---|\n'
        f'| `a \\| b` hangs | see {start} | {wrong} |\n| no data | QoS | {wrong} |\n'
    )
    assert in_step.drift(marked) == []
    words.unlink()
    symptoms.write_text('')
    assert in_step.drift(marked) == [
        'notebooks/GLOSSARY.md is missing',
        'notebooks/SYMPTOMS.md is not what its source gives',
    ]


def test_the_pages_are_part_of_the_web_edition(marked, tmp_path):
    make_without_kernel(marked)
    index, tiny, _ = pages.write(marked, tmp_path / 'pages', say=lambda line: None)
    assert '<a href="GLOSSARY.html">Glossary</a>' in index.read_text()
    assert '<a href="GLOSSARY.html#callback-group">' in tiny.read_text()
    words = (tmp_path / 'pages' / 'GLOSSARY.html').read_text()
    assert 'id="callback-group"' in words and 'href="07_tiny.html#7.1-A-start"' in words
    assert 'href="07_tiny.html#7.2-When-it-goes-wrong"' in (tmp_path / 'pages' / 'SYMPTOMS.html').read_text()


@pytest.mark.parametrize(
    ('name', 'old', 'new', 'line', 'problem'),
    [
        ('07_tiny.md', 'One {term}`node`', 'One {term}`nod`', 'One', "the glossary has no term 'nod'"),
        ('07_tiny.md', 'One', '{term}`node`\nOne', 'One', "'node' is marked twice in this chapter (first in line"),
        ('07_tiny.md', '### Check yourself', '### Questions', None, 'no place for the new words'),
        (
            '07_tiny.md',
            ' Two {term}`callback groups <callback group>`',
            '',
            'term: callback',
            'no chapter uses the term',
        ),
        ('glossary.yml', '  says: A set of callbacks.\n', '', 'term: callback', 'needs term and says'),
        ('glossary.yml', 'callback group', 'node', 'A set', "'node' is there twice"),
        ('glossary.yml', '- term: callback', '-- term: callback', None, 'no YAML'),
    ],
)
def test_mistakes_are_named_with_their_line(marked, name, old, new, line, problem):
    source = {'07_tiny.md': SEVEN, 'glossary.yml': GLOSSARY}[name]
    assert source.count(old) == 1
    text = source.replace(old, new)
    write(marked, text, name)
    with pytest.raises(ChapterErrors) as caught:
        chapter_build.read_all(marked)
    (error,) = (error for error in caught.value.errors if problem in error.problem)
    if line:
        where = text if error.path.name == name else GLOSSARY
        assert error.line == line_of(line, where) - (line == 'A set')
