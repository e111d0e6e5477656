"""The shared front end: texts with substitutions, typed values, tags."""

import pytest
from launch import LaunchContext
from launch.action import Action
from launch.frontend import Parser, expose_action, expose_substitution, parse_if_substitutions, parse_substitution
from launch.frontend.expose import action_parse_methods, instantiate_substitution, substitution_parse_methods
from launch.substitutions import TextSubstitution
from launch.utilities import perform_substitutions
from launch.utilities.type_utils import (
    coerce_to_type,
    get_typed_value,
    is_instance_of,
    normalize_typed_substitution,
    perform_typed_substitution,
)


def perform(text, **configurations):
    context = LaunchContext()
    context.launch_configurations.update({'x': '5', 'name': 'x', 'file': 'a b', 'no': 'off', **configurations})
    context.push_locals({'current_launch_file_path': '/dir/a.launch.xml', 'current_launch_file_directory': '/dir'})
    return perform_substitutions(context, parse_substitution(text))


@pytest.mark.parametrize(
    'text, result',
    [
        ('', ''),
        ('plain "text" and \'quotes\' $x $', 'plain "text" and \'quotes\' $x $'),
        ('$(var x)', '5'),
        ('a $(var x)b$(var $(var name))', 'a 5b5'),
        ('$(var none default)', 'default'),
        ("$(var none 'two words')", 'two words'),
        (r'\$(var x) \\ \'', r'$(var x) \ ' + "'"),
        ("$(eval '$(var x) == 5 and True')", 'True'),
        ('$(eval "\'a b\' + \\"c\\"")', 'a bc'),
        ('$(eval \'os.path.basename("/a/$(var x)")\' os)', '5'),
        ("$(eval 'math.floor(2.5)')", '2'),
        ('$(dirname)/$(filename)', '/dir//dir/a.launch.xml'),
        ('$(env COURSE_TEST_NO_SUCH none)', 'none'),
        ('$(command "echo $(var file)")', 'a b\n'),
        ('$(not true) $(and true false) $(or true false) $(any 0 1 0) $(all 1 1)', 'false false true true true'),
        ('$(equals $(var x) 5.0) $(not-equals a b) $(if $(var no) a b)', 'true true b'),
        ('$(if true yes)', 'yes'),
        ('$(var   x  )', '5'),
        ("$(var none '')", ''),
    ],
)
def test_texts_with_substitutions(text, result):
    assert perform(text) == result


@pytest.mark.parametrize(
    'text, kind, message',
    [
        ('$(var x', ValueError, "this '\\$\\(' has no '\\)'"),
        ('a $( x)', ValueError, "expected the name of a substitution behind '\\$\\('"),
        ("$(eval a=='b')", ValueError, "expected a space or '\\)'"),
        ("$(var 'x)", ValueError, "a quote ' is not closed"),
        ('$(no-such x)', RuntimeError, 'Unknown substitution: no-such'),
        ('$(var)', TypeError, 'var substitution expects 1 to 2 arguments, got 0'),
        ('$(dirname x)', TypeError, 'dirname substitution expects 0 arguments, got 1'),
    ],
)
def test_faults_of_a_text_are_told(text, kind, message):
    with pytest.raises(kind, match=message):
        parse_substitution(text)


def test_values_with_substitutions():
    assert parse_if_substitutions(5) == 5 and parse_if_substitutions('a') == 'a'
    assert parse_if_substitutions([1, 2]) == [1, 2]
    assert [part.describe() for part in parse_if_substitutions('$(var a)b')] == ["LaunchConfig('a')", "'b'"]
    assert parse_if_substitutions([1, '$(var a)'])[0] == 1
    with pytest.raises(ValueError, match='non-uniform list'):
        parse_if_substitutions([1, 'a'])


@pytest.mark.parametrize(
    'text, kind, value',
    [('5', int, 5), ('5', float, 5.0), ('5', str, '5'), ('5', None, 5), ('on', bool, True), ('x', None, 'x'),
     ('[1, 2]', list[int], [1, 2]), ('1.5', None, 1.5), (['1', '2'], list[int], [1, 2]),
     (['a', 'b'], None, ['a', 'b'])],
)  # fmt: skip
def test_typed_values(text, kind, value):
    assert get_typed_value(text, kind) == value and is_instance_of(value, kind)


def test_values_of_another_type_are_refused():
    for text, kind in (('a', int), ('2', bool), ('[1, a]', list[int]), ('5', list[int]), ('{a: 1}', None)):
        with pytest.raises(ValueError, match='.'):
            coerce_to_type(text, kind)
    assert coerce_to_type('$(var a)', int, can_be_str=True) == '$(var a)'
    context = LaunchContext()
    context.launch_configurations['x'] = '5'
    text = parse_substitution('$(var x)')
    assert perform_typed_substitution(context, normalize_typed_substitution(text, int), int) == 5
    mixed = normalize_typed_substitution([1, text], list[int])
    assert perform_typed_substitution(context, mixed, list[int]) == [1, 5]
    with pytest.raises(TypeError, match='is not an instance of'):
        normalize_typed_substitution('5', int)
    with pytest.raises(TypeError, match='a list of types'):
        normalize_typed_substitution([1, 'a'], list[int])


def test_a_package_gives_its_actions_and_substitutions_names(monkeypatch):
    for known in (action_parse_methods, substitution_parse_methods):
        for name in ('test-word', 'test_tag'):
            monkeypatch.delitem(known, name, raising=False)

    @expose_substitution('test-word')
    def word(data):
        return TextSubstitution, {'text': f'{len(data)}'}

    assert instantiate_substitution('test-word', [['a'], ['b']]).text == '2'
    with pytest.raises(RuntimeError, match=r'Two substitution parsing methods exposed with the same name: \[test-w'):
        expose_substitution('test-word')(lambda data: None)
    with pytest.raises(RuntimeError, match="Did not find a class method called 'parse'"):
        expose_substitution('other')(TextSubstitution)
    with pytest.raises(RuntimeError, match='is not a callable or a class'):
        expose_action('other')(5)

    @expose_action('test_tag')
    class Tagged(Action):
        pass

    assert 'test_tag' in action_parse_methods
    substitution_parse_methods.pop('test-word')
    action_parse_methods.pop('test_tag')


def test_parsers_are_found_by_the_names_of_files():
    assert Parser.get_available_extensions() == ['xml', 'yaml']
    assert Parser.get_file_extensions_from_parsers() == {'launch.xml', 'launch.yaml', 'launch.yml'}
    assert Parser.is_filename_valid('a_launch.xml') and not Parser.is_filename_valid('a.launch.py')
