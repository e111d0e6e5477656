"""A headless Chromium for the tests here; what a failed test saw is kept and its place is told."""

import pytest

from helpers.tests.browser import failure_traces, jupyterlab

NO_WEBGL = """
const getContext = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
  return kind.includes('webgl') ? null : getContext.call(this, kind, ...more);
};
"""


@pytest.fixture(scope='module')
def browser():
    """A Playwright browser: Debian's Chromium, without a window.

    Not for longer than a module: while Playwright runs, its thread has an event loop, and other tests start their own.
    """
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(
            executable_path=jupyterlab.CHROMIUM, args=jupyterlab.FLAGS, timeout=jupyterlab.PATIENCE
        )
        yield chromium
        chromium.close()


@pytest.fixture
def page_without_webgl(browser):
    """A page of a browser that cannot draw in 3-D, as in many virtual machines."""
    page = failure_traces.watch(browser.new_page(viewport={'width': 700, 'height': 420}))
    page.set_default_timeout(jupyterlab.PATIENCE)
    page.add_init_script(NO_WEBGL)
    yield page
    page.close()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item, call):
    report = yield
    # After pytest's own time limit Playwright is interrupted at an unknown place, and would not answer.
    if report.failed and call.when != 'teardown' and not str(call.excinfo.value).startswith('Timeout (>'):
        report.sections.append(('what the browser showed', '\n'.join(failure_traces.keep(item.name))))
    return report
