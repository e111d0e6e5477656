"""Roles that become links, and links that lead nowhere."""

import re

import pytest

from grading.authoring import chapter_build
from grading.authoring.chapter_errors import ChapterErrors
from grading.edition import pages
from grading.tests.authoring.conftest import make_without_kernel, write
from grading.tests.authoring.sources import FRONT, TINY, line_of

OTHER = (
    FRONT
    + '# 8 Other\n\n## 8.10 Record and *replay*\n\n```text\n## 8.11 no heading\n```\n\n### A8.2 `cmd: not found`\n'
)


def cell(tree, text):
    """The text of the tiny chapter's Markdown cell, with `text` in it."""
    write(tree, OTHER, '08_other.md')
    write(tree, TINY.replace('Some prose.', text))
    return chapter_build.read_all(tree)[0].cells[2].split.solved


@pytest.mark.parametrize(
    ('role', 'link'),
    [
        ('{section}`8.10`', '[section 8.10](08_other.ipynb#heading=8.10-Record-and-replay)'),
        ('{section}`the recording <8.10>`', '[the recording](08_other.ipynb#heading=8.10-Record-and-replay)'),
        ('{section}`A8.2`', '[section A8.2](08_other.ipynb#heading=A8.2-cmd:-not-found)'),
        ('{exercise-ref}`7.1`', '[exercise 7.1](07_tiny.ipynb#heading=Exercise-7.1:-twice-as-much-(10-points))'),
        ('{chapter}`8`', '[chapter 8](08_other.ipynb)'),
        ('({chapter}`8`) of [a](08_other.ipynb)', '([chapter 8](08_other.ipynb)) of [a](08_other.ipynb)'),
        ('`ws/{section}` and `{term}`', '`ws/{section}` and `{term}`'),
    ],
)
def test_a_role_becomes_a_link(tree, role, link):
    assert f'See {link}, and go on.' in cell(tree, f'See {role}, and go on.')


@pytest.mark.parametrize(
    ('text', 'problem', 'remedy'),
    [
        ('{section}`8.11`', "there is no section '8.11'", 'there are: 8.10'),
        ('{exercise-ref}`7.2`', "there is no exercise '7.2'", 'there are: 7.1'),
        ('{chapter}`9`', "there is no chapter '9'", 'one that exists'),
        ('{secton}`8.10`', "unknown role 'secton'", 'use one of section'),
        ('[{section}`8.10`](https://example.org)', "role 'section' is in the text of a link", 'one after the other'),
        ('[the {chapter}`8` of it](https://example.org)', 'Markdown has no link in a link', 'one after the other'),
        ('[a](08_other.ipynb#8.10-Record)', 'has no such heading', '{section}'),
        ('[a](09_gone.ipynb)', "link to '09_gone.ipynb', which does not exist", 'mend its path'),
        ('[a](#nowhere)', '07_tiny.ipynb has no such heading', '{section}'),
    ],
)
def test_what_leads_nowhere_is_named_with_its_line(tree, text, problem, remedy):
    with pytest.raises(ChapterErrors) as caught:
        cell(tree, f'A line.\nSee {text}.')
    (error,) = caught.value.errors
    assert problem in error.problem and remedy in error.remedy
    assert error.line == line_of('Some prose.') + 1


def test_a_heading_that_jupyterlab_would_not_find_cannot_be_linked(tree):
    write(tree, OTHER + '\n## 8.12 "Quoted"\n', '08_other.md')
    write(tree, TINY.replace('Some prose.', '{section}`8.12`'))
    with pytest.raises(ChapterErrors, match='a link in JupyterLab fails; write it .* without quotes'):
        chapter_build.read_all(tree)


def test_links_that_lead_somewhere_are_let_alone(tree):
    (tree.notebooks / 'picture.svg').touch()
    text = (
        '[a](08_other.ipynb#8.10-Record-and-replay) [b](#7-Tiny) [c](https://docs.ros.org) ![d](picture.svg) `[e](f)`'
    )
    assert text in cell(tree, text)


def test_links_lead_to_headings_of_the_web_edition(tree, tmp_path):
    cell(tree, 'See {section}`8.10` and {exercise-ref}`7.1`.')
    make_without_kernel(tree)
    _, tiny, other = pages.write(tree, tmp_path / 'pages', say=lambda line: None)
    found = re.findall(r'<a href="((?:07|08)_[^"#]+)#([^"]+)">', tiny.read_text())
    assert [name for name, _ in found] == [other.name, tiny.name]
    for name, anchor in found:
        assert f'id="{anchor}"' in (tmp_path / 'pages' / name).read_text()
