"""The completers of the Tab key, with a graph that the test makes up."""

from argparse import Namespace
from contextlib import nullcontext

import pytest

# Of each package: the function that its type completer asks for the graph, the completer, and its argument.
TYPES = [
    ('ros2topic', 'get_topic_names_and_types', 'TopicTypeCompleter', 'topic_name_key'),
    ('ros2service', 'get_service_names_and_types', 'ServiceTypeCompleter', 'service_name_key'),
    ('ros2action', 'get_action_names_and_types', 'ActionTypeCompleter', 'action_name_key'),
]


@pytest.fixture
def graph(monkeypatch):
    """Return a function that puts the answers of a graph into the module `api` of a package."""

    def put(package: str, **answers):
        api = pytest.importorskip(f'{package}.api')
        monkeypatch.setattr(f'{package}.api.NodeStrategy', lambda args: nullcontext(args))
        for name, answer in answers.items():
            monkeypatch.setattr(f'{package}.api.{name}', lambda answer=answer, **_: answer)
        return api

    return put


@pytest.mark.parametrize(('package', 'function', 'completer', 'key'), TYPES)
def test_a_type_is_that_of_the_name_typed_before(graph, package, function, completer, key):
    api = graph(package, **{function: [('/one', ['pkg/One']), ('/two', ['pkg/Two'])]})
    assert getattr(api, completer)(**{key: 'name'})(prefix='', parsed_args=Namespace(name='/two')) == ['pkg/Two']


@pytest.mark.parametrize(('package', 'function', 'completer', 'key'), TYPES)
def test_of_an_unknown_name_any_type_is_possible_but_not_for_an_action(graph, package, function, completer, key):
    # A topic and a service may be made by the command itself; a goal needs an action that is there already.
    every = completer.removesuffix('TypeCompleter').lower().replace('topic', 'message') + '_type_completer'
    api = graph(package, **{function: [], every: ['pkg/Any']})
    found = getattr(api, completer)(**{key: 'name'})(prefix='', parsed_args=Namespace(name='/new'))
    assert found == ([] if package == 'ros2action' else ['pkg/Any'])
    assert getattr(api, completer)()(prefix='', parsed_args=Namespace()) == ['pkg/Any']


def test_names_come_from_the_graph(graph):
    name = graph('ros2node').NodeName('cart', '/shop', '/shop/cart')
    assert graph('ros2node', get_node_names=[name]).NodeNameCompleter()('', Namespace()) == ['/shop/cart']
    assert graph('ros2topic', get_topic_names=['/scan']).TopicNameCompleter()('', Namespace()) == ['/scan']
    assert graph('ros2service', get_service_names=['/stop']).ServiceNameCompleter()('', Namespace()) == ['/stop']
    assert graph('ros2action', get_action_names=['/dock']).action_name_completer('', Namespace()) == ['/dock']


def test_a_message_is_completed_by_its_fields(graph, monkeypatch):
    api = graph('ros2topic')
    monkeypatch.setattr('ros2topic.api.get_message', lambda name: dict if name == 'pkg/Speed' else None)
    monkeypatch.setattr('ros2topic.api.message_to_yaml', lambda message: f'{message}: fast')
    assert api.TopicMessagePrototypeCompleter(topic_type_key='kind')('', Namespace(kind='pkg/Speed')) == ["'{}: fast'"]


@pytest.mark.parametrize('package', ['ros2action', 'ros2node', 'ros2service', 'ros2topic'])
def test_what_a_module_does_not_have_is_missed_by_name(package):
    api = pytest.importorskip(f'{package}.api')
    with pytest.raises(AttributeError, match=f"module '{package}.api' has no attribute 'Nonsense'"):
        api.Nonsense  # noqa: B018
