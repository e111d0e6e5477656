"""Marks in long names of tables: they change no text, and leave no piece that a narrow column cannot hold."""

import re
from html import unescape

import pytest
from markdown_it import MarkdownIt

from grading.authoring import chapter, chapter_build, table_names
from helpers import paths

ROOM = 15  # letters of code in a column of a table with four of them, in a window of 700 px
COURSE = chapter_build.CourseFolders(paths.ROOT)


def text_of(markdown):
    """What a reader sees and copies."""
    shown = MarkdownIt('commonmark', {'html': True}).enable('table').render(markdown)
    return unescape(re.sub(r'<[^>]*>', '', shown))


def row(code):
    return f'| a | b | c |\n|---|---|---|\n| {code} | x | y |\n'


@pytest.mark.parametrize(
    'code',
    [
        '`StaticTransformBroadcaster`',
        '`/robot_state_publisher/get_type`',
        '`config/*_long_name/*.yaml`',
        '`$ROS_DISTRO $AMENT_PREFIX_PATH`',
        '`[see](this)_is_no_link`',
        '`<collision>_and_<inertial>&amp;`',
        '`_begins_with_a_sign_`',
    ],
)
def test_a_mark_changes_no_text(code):
    marked = table_names.marked(row(code))
    assert '<wbr>' in marked and text_of(marked) == text_of(row(code))
    assert '$' not in marked  # JupyterLab takes what stands between two of them for a formula


@pytest.mark.parametrize(
    'text',
    [
        row('`short_name`'),
        row('`one | two_more_words_here`'),
        row('StaticTransformBroadcaster'),
        '| a | b |\n|---|---|\n| `StaticTransformBroadcaster` | x |\n',
        'The `StaticTransformBroadcaster`.\n',
        f'```\n{row("`StaticTransformBroadcaster`")}```\n',
    ],
)
def test_only_long_names_of_code_in_wide_tables_get_one(text):
    assert table_names.marked(text) == text


@pytest.mark.parametrize('path', chapter.sources(COURSE.solutions), ids=lambda path: path.stem)
def test_the_pieces_of_the_courses_names_fit_into_a_narrow_column(path):
    found = [
        piece
        for cell in chapter.read(path).cells
        if cell.kind == 'markdown'
        for line in cell.split.solved.splitlines()
        if line.startswith('|') and line.count('|') > 4
        for code in re.findall(r'<code>(.*?)</code>|(?<!`)`([^`]+)`(?!`)', line)
        for piece in re.split(r'<wbr>|[ -]', unescape(''.join(code)))
    ]
    assert [piece for piece in found if len(piece) > ROOM] == []
