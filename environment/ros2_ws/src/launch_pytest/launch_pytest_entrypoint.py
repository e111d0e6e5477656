"""
Tests with the mark ``launch`` under pytest: while the launch of their fixture runs, or after its end.

Every pytest run of the installation imports this module. So it stands outside of the package, and imports that, and
``launch`` with it, only when there is a launch test.
"""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from launch_pytest.fixture import Options
    from launch_pytest.running import Running


def pytest_configure(config) -> None:
    """Make the mark known."""
    config.addinivalue_line(
        'markers', 'launch: mark the test as a launch test, it will be run using the specified launch_pad.'
    )


# --- what a test can ask for --------------------------------------------------------------------------------------


@pytest.fixture
def launch_service(request):
    """The LaunchService of the test's launch."""
    return _running(request).service


@pytest.fixture
def launch_context(request):
    """The LaunchContext of the test's launch."""
    return _running(request).service.context


@pytest.fixture
def event_loop(request):
    """The loop of the test's launch."""
    return _running(request).loop


def _running(request) -> Running:
    from launch_pytest.fixture import run_of

    options = _options(request.node.iter_markers('launch'))
    if options is None:
        pytest.fail(f"'{request.node.name}' asks for a launch, but it has no @pytest.mark.launch(fixture=…)")
    return run_of(request.getfixturevalue(options.name))


def _options(marks) -> Options | None:
    """Return what the launch fixture is like that the mark of a test names."""
    for mark in marks:
        from launch_pytest.fixture import options_of

        return options_of(mark.kwargs.get('fixture'))
    return None


# --- collecting ---------------------------------------------------------------------------------------------------


@pytest.hookimpl(tryfirst=True)
def pytest_pycollect_makeitem(collector, name: str, obj: Any):
    """Collect launch tests, those that are generators too, which pytest itself refuses."""
    if not inspect.isfunction(obj) or not collector.funcnamefilter(name):
        return None
    marks = [*getattr(obj, 'pytestmark', []), *collector.iter_markers()]
    marks = [mark for mark in marks if mark.name == 'launch']
    if not marks:
        return None
    options = _options(marks)
    if options is None:
        reason = (
            f'{name}(): "fixture" keyword argument is required in a pytest.mark.launch() decorator; it takes a '
            'launch_pytest.fixture'
        )
        collector.warn(pytest.PytestCollectionWarning(reason))
        pytest.mark.skip(reason)(obj)
        return list(collector._genfunctions(name, obj))
    pytest.mark.usefixtures(options.name)(obj)
    items = list(collector._genfunctions(name, obj))
    if not _has_second_part(obj) or options.scope == 'function':
        return items
    # The launch goes on for other tests, so that what comes after its end has to wait for them.
    return items + [_second_item(collector, item) for item in items]


def _second_item(collector, item: pytest.Function) -> pytest.Function:
    second = pytest.Function.from_parent(
        collector,
        name=f'{item.name}[shutdown_test]',
        callobj=item.obj,
        callspec=getattr(item, 'callspec', None),
        fixtureinfo=item._fixtureinfo,
    )
    second._launch_pytest_first_part = item
    return second


def _has_second_part(function: Any) -> bool:
    return inspect.isgeneratorfunction(function) or inspect.isasyncgenfunction(function)


def _is_after_end(item: pytest.Item) -> bool:
    if hasattr(item, '_launch_pytest_first_part'):
        return True
    mark = item.get_closest_marker('launch')
    return mark is not None and bool(mark.kwargs.get('shutdown', False))


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Put the tests that run after the end of a launch behind the last one that needs it running."""
    if not any(item.get_closest_marker('launch') for item in items):
        return
    last: dict[Any, int] = {}
    for position, item in enumerate(items):
        key = _launch_key(item)
        if key is not None and not _is_after_end(item):
            last[key] = position
    order = {
        item: (
            max(position, last.get(_launch_key(item), position)) if _is_after_end(item) else position,
            _is_after_end(item),
        )
        for position, item in enumerate(items)
    }
    items.sort(key=lambda item: order[item])


def _launch_key(item: pytest.Item) -> Any:
    """Return what the tests that share a launch have in common; None for all others."""
    options = _options(item.iter_markers('launch'))
    if options is None or options.scope == 'function':
        return None
    parameters = getattr(getattr(item, 'callspec', None), 'params', {})
    scope = item.cls if options.scope == 'class' else getattr(item, 'module', None)
    return options.name, id(scope), repr(parameters.get(options.name))


# --- running ------------------------------------------------------------------------------------------------------


@pytest.hookimpl(tryfirst=True)
def pytest_pyfunc_call(pyfuncitem):
    """Run a launch test: at once, or after the end of the launch, or its two parts before and after it."""
    options = _options(pyfuncitem.iter_markers('launch'))
    if options is None:
        return None
    running = _running(pyfuncitem._request)
    function = pyfuncitem.obj
    if hasattr(pyfuncitem, '_launch_pytest_first_part'):
        _second_part(pyfuncitem._launch_pytest_first_part, running)
        return True
    mark = pyfuncitem.get_closest_marker('launch')
    arguments = {name: pyfuncitem.funcargs[name] for name in pyfuncitem._fixtureinfo.argnames}
    if _has_second_part(function):
        if mark.kwargs.get('shutdown', False):
            pytest.fail('generator or async generator based launch test items cannot be marked with shutdown=True')
        pyfuncitem._launch_pytest_generator = function(**arguments)
        _advance(pyfuncitem, running)
        if options.scope == 'function':
            _second_part(pyfuncitem, running)
        return True
    if mark.kwargs.get('shutdown', False):
        running.finish()
    result = function(**arguments)
    if inspect.iscoroutine(result):
        running.do(result)
    return True


def _second_part(item: pytest.Item, running: Running) -> None:
    if getattr(item, '_launch_pytest_generator', None) is None:
        pytest.skip('the part of the test before the end of the launch has not passed')
    running.finish()
    if _advance(item, running):
        pytest.fail('launch tests using a generator function must stop iteration after yielding once')


def _advance(item: pytest.Item, running: Running) -> bool:
    """Go on to the next yield; return False if there is none."""
    generator = item._launch_pytest_generator
    try:
        if inspect.isgenerator(generator):
            next(generator)
        else:
            running.do(_next(generator))
    except (StopIteration, StopAsyncIteration):
        item._launch_pytest_generator = None
        return False
    except BaseException:
        item._launch_pytest_generator = None
        raise
    return True


async def _next(generator) -> None:
    await generator.__anext__()
