"""The web pages on paper: nothing is cut off at the right."""

import pytest

from grading.authoring import chapter as chapters
from grading.edition import pages
from grading.tests.authoring.conftest import built, make_without_kernel, tree  # noqa: F401 - fixtures
from helpers.tests.browser import jupyterlab

pytestmark = [pytest.mark.timeout(300), *jupyterlab.NEEDED]
PAPER = 700  # px, of a sheet without its margins
LONG = f'print({", ".join(["one_name"] * 40)})'
WIDER = (
    '[...document.querySelectorAll("main pre")].filter(e => e.scrollWidth > e.clientWidth + 1).map(e => e.textContent)'
)


def test_long_lines_of_code_are_broken(built, tmp_path):  # noqa: F811
    from playwright.sync_api import sync_playwright

    source = built.solutions / '07_tiny.md'
    more = f'```{{code-cell}} ipython3\n{LONG}\n```\n\n```bash\n{LONG}\n```\n\n'
    source.write_text(source.read_text().replace('```{code-cell}', f'{more}```{{code-cell}}', 1))
    built.solved(chapters.read(source)).unlink()
    make_without_kernel(built)
    _, page_file = pages.write(built, tmp_path / 'pages', say=lambda line: None)
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=jupyterlab.CHROMIUM, args=jupyterlab.FLAGS)
        page = browser.new_page(viewport={'width': PAPER, 'height': 900})
        page.goto(page_file.as_uri())
        on_screen = page.evaluate(WIDER)  # there they can be scrolled
        page.emulate_media(media='print')
        on_paper = page.evaluate(WIDER), page.evaluate('document.documentElement.scrollWidth')
        browser.close()
    assert any('one_name' in text for text in on_screen) and on_paper == ([], PAPER)
