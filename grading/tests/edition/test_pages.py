"""The course as web pages: readable, linked, and without any solution."""

import re
from pathlib import Path

import nbformat
import pytest
from nbformat.v4 import new_output

from grading.authoring import chapter as chapters
from grading.authoring import chapter_build, notebook_pair
from grading.edition import file_lexer, pages
from grading.tests.authoring import sources
from grading.tests.authoring.conftest import built, make_without_kernel, tree  # noqa: F401 - fixtures
from grading.tests.authoring.test_figures import illustrated  # noqa: F401 - a fixture
from helpers import paths
from helpers.show.views import recording

COURSE = chapter_build.CourseFolders(paths.ROOT)


@pytest.mark.parametrize('source', chapters.sources(COURSE.solutions), ids=lambda path: path.stem)
def test_no_solution_is_shown(source):
    chapter = chapters.read(source)
    notebook = nbformat.read(COURSE.solved(chapter), as_version=4)
    shown = {cell.id: cell for cell in pages.readable(chapter, notebook).cells}
    for cell in notebook_pair.learner(chapter).cells:
        if 'exercise' in cell.metadata:
            assert (shown[cell.id].source, shown[cell.id].outputs) == (cell.source, [])
        elif cell.cell_type == 'code' and cell.source.startswith('check('):
            assert shown[cell.id].outputs == []
    assert any(cell.get('outputs') for cell in shown.values())  # but what the lesson prints is
    links = [link for cell in shown.values() for link in re.findall(r'\]\((\d\d_[^)#]+)', cell.source)]
    assert set(links) <= {f'{path.stem}.html' for path in chapters.sources(COURSE.solutions)}
    assert links or source == chapters.sources(COURSE.solutions)[-1]  # each chapter leads to the next


def test_pages_and_contents_are_linked(built, tmp_path):  # noqa: F811
    index, page = pages.write(built, tmp_path / 'pages', say=lambda line: None)
    assert re.search(rf'<a href="{page.name}">', index.read_text())
    text = page.read_text()
    assert '<a href="index.html">All chapters</a>' in text
    assert 'prefers-color-scheme: dark' in text and '--jp-layout-color0: #111;' in text  # a theme of its own
    assert not re.search(r'<(script|link)[^>]+(src|href)="http', text)  # it can be read without a network


def test_a_hint_stays_folded(built, tmp_path):  # noqa: F811
    source = built.solutions / '07_tiny.md'
    hint = '<details><summary>Hint</summary>\n\nA **hint**.\n\n</details>\n\n'
    source.write_text(source.read_text().replace('```{code-cell}', f'{hint}```{{code-cell}}', 1))
    with pytest.raises(pages.EditionError, match='run ./course build 07 first'):
        pages.write(built, tmp_path / 'pages', say=lambda line: None)
    assert not (tmp_path / 'pages').exists()
    built.solved(chapters.read(source)).unlink()
    make_without_kernel(built)
    _, page = pages.write(built, tmp_path / 'pages', say=lambda line: None)
    assert re.search(r'<summary>Hint</summary>\s*<p>A <strong>hint</strong>.</p>\s*</details>', page.read_text())


FILES = {
    'a.py': ('def f():\n    return 1', 'k', 'def'),
    'a.yaml': ('low: 0.25', 'nt', 'low'),
    '-a src/CMakeLists.txt': ('project(a)', 'nb', 'project'),
    'a.urdf': ('<robot name="a"/>', 'nt', '&lt;robot'),
    'A.msg': ('float64 value', '', ''),
}


@pytest.mark.parametrize('file', FILES)
def test_a_file_has_the_colours_of_its_language(built, tmp_path, file):  # noqa: F811
    source = built.solutions / '07_tiny.md'
    text, kind, word = FILES[file]
    cell = f'```{{code-cell}} ipython3\n%%writefile {file}\n{text}\n```\n\n'
    source.write_text(source.read_text().replace('```{code-cell}', f'{cell}```{{code-cell}}', 1))
    built.solved(chapters.read(source)).unlink()
    make_without_kernel(built)
    _, page = pages.write(built, tmp_path / 'pages', say=lambda line: None)
    shown = page.read_text().partition('writefile')[2].partition('</pre>')[0]
    assert (f'<span class="{kind}">{word}</span>' in shown if kind else word in shown) and 'class="err"' not in shown
    assert not kind or f'.highlight .{kind} {{' in page.read_text(), 'no rule gives it a colour'


def test_the_parts_of_a_cell_with_files_have_their_own_colours():
    text = 'x = 1\n%%answer NODE src/a.py\ndef f(): pass\n%%answer ROBOT a.xml\n<robot/>\n%%answer NOTE a.msg\nint8 a\n'
    found = list(file_lexer.FilesLexer().get_tokens_unprocessed(text))
    assert ''.join(value for _, _, value in found) == text
    assert all(text[place:].startswith(value) for place, _, value in found)
    kinds = {value.strip(): str(kind) for _, kind, value in found}
    assert (kinds['def'], kinds['<robot'], kinds['%%answer NOTE a.msg'], kinds['int8 a']) == (
        'Token.Keyword',
        'Token.Name.Tag',
        'Token.Comment.Preproc',
        'Token.Text',
    )
    assert file_lexer.has_files(text) and not file_lexer.has_files('%%bash\nls')


def test_a_page_brings_its_figures(illustrated, tmp_path):  # noqa: F811
    _, page = pages.write(illustrated, tmp_path / 'pages', say=lambda line: None)
    (address,) = re.findall(r'<img[^>]* src="([^"]+)"', page.read_text())
    assert (page.parent / address).read_bytes() == (illustrated.pictures / 'a_box.svg').read_bytes()
    assert 'alt="A box with a word."' in page.read_text()


def test_a_folder_that_is_not_empty_is_refused(built, tmp_path):  # noqa: F811
    (tmp_path / 'mine').mkdir()
    (tmp_path / 'mine' / 'file').touch()
    with pytest.raises(pages.EditionError, match='is not empty'):
        pages.write(built, tmp_path / 'mine')


def test_views_are_recorded_and_opened_from_the_page(built, tmp_path, monkeypatch):  # noqa: F811
    source = built.solutions / '07_tiny.md'
    view = '```{code-cell} ipython3\nTfView()\n```\n\n'
    solution = sources.EXERCISE.replace('    return 2', '    TfView()\n    return 2')
    source.write_text(sources.TINY.replace(sources.EXERCISE, view + solution))
    built.solved(chapters.read(source)).unlink()
    make_without_kernel(built)

    def execute(notebook, chapter, folder, timeout, environment):
        """Each cell with a view, also in a solution, leaves a scene and a picture."""
        scenes = Path(environment[recording.VARIABLE])
        for name in recording.SHARED:
            (scenes / name).touch()
        for number, cell in enumerate(cell for cell in notebook.cells if 'TfView()' in cell.source):
            (scenes / f'{number}.html').touch()
            forms = {'image/svg+xml': '<svg/>', 'text/html': '<img/>'}
            picture = new_output('display_data', forms, metadata={'scene': f'{number}.html'})
            cell.outputs = [picture]

    monkeypatch.setattr(pages.execution, 'execute', execute)
    _, page = pages.write(built, tmp_path / 'pages', say=lambda line: None)
    assert re.findall(r'<a href="(scenes/[^"]+)"', page.read_text()) == ['scenes/0.html']
    assert {path.name for path in (tmp_path / 'pages' / 'scenes').iterdir()} == {'0.html', *recording.SHARED}
    _, page = pages.write(built, tmp_path / 'still', say=lambda line: None, scenes=False)
    assert 'scenes/' not in page.read_text() and not (tmp_path / 'still' / 'scenes').exists()
