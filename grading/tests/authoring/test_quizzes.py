"""Questions with options that are clicked."""

import pytest

from grading.authoring import chapter_build, quizzes
from grading.authoring.chapter_errors import CellError, ChapterErrors
from grading.tests.authoring.conftest import write
from grading.tests.authoring.sources import TINY, line_of

QUIZ = """```{quiz}
What does `a < b` show?
Say it.

- (a) nothing
  It shows
  *something*.
- (b, right) a `bool` & *more*
  See {chapter}`7`.
```"""


def shown(tree, text):
    write(tree, TINY.replace('Some prose.', text))
    (chapter,) = chapter_build.read_all(tree)
    return chapter.cells[2].split.solved


def test_each_option_is_folded_by_itself(tree):
    assert shown(tree, f'Before.\n\n{QUIZ}\n\n{QUIZ}').startswith(
        """Before.

**1.** What does `a < b` show? Say it.

<div style="margin-bottom: 1.2em">
<details><summary>(a) nothing</summary>

✗ **No.** It shows *something*.

</details>
<details><summary>(b) a <code>bool</code> &amp; <em>more</em></summary>

✓ **Right.** See [chapter 7](07_tiny.ipynb).

</details>
</div>

**2.** What does"""
    )


@pytest.mark.parametrize(
    ('old', 'new', 'line', 'problem', 'remedy'),
    [
        ('(b, right)', '(b)', '{quiz}', 'needs one right option', '(b, right)'),
        ('(a)', '(a, right)', '{quiz}', 'needs one right option', '(b, right)'),
        ('(b, right)', '(c, right)', '{quiz}', 'are not (a), (b)', '- (a) an option'),
        ('  See {chapter}`7`.\n', '', '(b, right)', 'option (b) has no reason', 'write it below'),
        ('- (a)', '- a)', '- a)', 'neither an option nor a reason', '- (a) an option'),
        ('  See', 'See', 'See', 'neither an option nor a reason', '- (a) an option'),
        ('What does `a < b` show?\nSay it.\n', '', '{quiz}', 'without a question', 'above the options'),
        ('{quiz}', '{quiz} 1', '{quiz}', "'1' in its first line", 'write the question below'),
    ],
)
def test_a_quiz_that_is_not_complete_is_named(tree, old, new, line, problem, remedy):
    assert QUIZ.count(old) == 1
    text = f'Before.\n\n{QUIZ.replace(old, new)}\n'
    with pytest.raises(ChapterErrors) as caught:
        shown(tree, text)
    (error,) = caught.value.errors
    assert problem in error.problem and remedy in error.remedy
    assert error.line == line_of(line, TINY.replace('Some prose.', text))


def test_the_numbers_go_on_in_the_next_cell():
    assert quizzes.render(f'{QUIZ}\n\n{QUIZ}', 1)[1] == 2
    assert quizzes.render(QUIZ, 3)[0].startswith('**3.** ')
    assert quizzes.render('No quiz.', 3) == ('No quiz.', 2)


def test_a_quiz_without_an_end_is_named():
    with pytest.raises(CellError, match='a quiz has no end; close it with ```'):
        quizzes.render(QUIZ.removesuffix('```'), 1)
