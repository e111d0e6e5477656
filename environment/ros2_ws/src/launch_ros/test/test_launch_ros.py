"""The actions and substitutions of ``launch_ros``."""

import io
import os
import threading
from array import array
from pathlib import Path

import launch.logging
import pytest
import yaml
from builtin_interfaces.msg import Time
from launch import LaunchContext, LaunchDescription, LaunchService
from launch.actions import LogInfo
from launch.frontend import Parser, parse_substitution
from launch.substitutions import LaunchConfiguration, SubstitutionFailure, TextSubstitution
from launch.utilities import perform_substitutions
from launch_ros import utilities
from launch_ros.actions import Node, PushRosNamespace, RosTimer, SetParameter, SetRemap, SetROSLogDir, SetUseSimTime
from launch_ros.parameter_descriptions import Parameter, ParameterFile, ParameterValue
from launch_ros.parameters import evaluate_parameters
from launch_ros.ros_adapters import get_ros_adapter, get_ros_node
from launch_ros.substitutions import FindPackageShare
from rclpy.exceptions import InvalidNodeNameException
from rosgraph_msgs.msg import Clock


def test_parameters_are_evaluated_as_upstream_does():
    context = LaunchContext()
    context.launch_configurations.update({'n': '5', 't': 'text', 'l': '[1, 2]', 'q': "'5'"})
    given = {
        'number': LaunchConfiguration('n'), 'text': LaunchConfiguration('t'), 'list': LaunchConfiguration('l'),
        'quoted': LaunchConfiguration('q'), 'forced': ParameterValue(LaunchConfiguration('n'), value_type=str),
        'real': ParameterValue(LaunchConfiguration('n'), value_type=float), 'plain': 1.5,
        'nested': {'a': True, 'b': {'c': 'x'}}, 'joined': [TextSubstitution(text='1'), LaunchConfiguration('n')],
        'mixed': [1, 2.5], LaunchConfiguration('t'): ['a', 'b'],
    }  # fmt: skip
    assert evaluate_parameters(context, given) == {
        'number': 5, 'text': ['a', 'b'], 'list': [1, 2], 'quoted': '5', 'forced': '5', 'real': 5.0, 'plain': 1.5,
        'nested.a': True, 'nested.b.c': 'x', 'joined': 15, 'mixed': [1.0, 2.5],
    } and evaluate_parameters(context, {'x': LaunchConfiguration('t')}) == {'x': 'text'}  # fmt: skip
    for bad in (None, object()):
        with pytest.raises(TypeError, match="parameter 'x'"):
            evaluate_parameters(context, {'x': bad})


WORD = TextSubstitution(text='word')
NO_SEQUENCE = 'Expected a non-empty sequence, with items of uniform type'


@pytest.mark.parametrize('given, value', [
    ([[WORD, 's'], WORD], ['words', 'word']),
    ([[TextSubstitution(text='1')], [TextSubstitution(text='2')]], [1, 2]),
    (['s', [WORD]], ['s', 'word']),
    ([[WORD, '/odom'], ['map']], ['word/odom', 'map']),
    ([(WORD, '_a'), ('q',)], ['word_a', 'q']),
    ([['x', 'w'], 'z'], ['xw', 'z']),
    ([], r"Expected 'value' to be one of \[<class 'float'>, .*\], but got '\(\)' of type '<class 'tuple'>'"),
    (TextSubstitution(text=''), ''),
    (ParameterValue([[TextSubstitution(text='1')], '2'], value_type=list[str]), ['1', '2']),
    (ParameterValue(TextSubstitution(text='a: b'), value_type=str), 'a: b'),
    ([1, 'a'], NO_SEQUENCE),
    ([True, 1, WORD], NO_SEQUENCE),
    (TextSubstitution(text='[1, 2.0]'), NO_SEQUENCE),
    (TextSubstitution(text='[]'), NO_SEQUENCE),
    (TextSubstitution(text='a: b: c'), 'Unable to parse the value of parameter x as yaml. If the parameter is meant to '
     r'be a string, try wrapping it in launch_ros.parameter_descriptions.ParameterValue\(value, value_type=str\)'),
    (TextSubstitution(text='{a: 1}'), "Allowed value types are bytes, .* Got <class 'dict'>"),
])  # fmt: skip
def test_values_with_substitutions_are_lists_texts_or_refused(given, value):
    if isinstance(value, str) and ' ' in value and not isinstance(given, ParameterValue):
        with pytest.raises(TypeError, match=value):
            evaluate_parameters(LaunchContext(), {'x': given})
    else:
        assert evaluate_parameters(LaunchContext(), {'x': given}) == {'x': value}


def test_an_action_of_ones_own_finds_the_node_and_the_executor_of_the_launch():
    context = LaunchContext()
    adapter = get_ros_adapter(context)
    try:
        assert get_ros_adapter(context) is adapter and get_ros_node(context) is adapter.node
        assert adapter.node in adapter.executor.get_nodes() and adapter.node.context is adapter.context
    finally:
        adapter.shutdown()


def test_the_parameters_of_a_node_can_be_looked_at(tmp_path):
    context = LaunchContext()
    context.launch_configurations['x'] = '5'
    file, single = tmp_path / 'p.yaml', Parameter('c', 2.0)
    given = [{'a': {'b': LaunchConfiguration('x')}, 'list': [1, 2]}, file, [str(tmp_path), '/q.yaml'], single]
    normal = utilities.normalize_parameters(given)
    first, *others = utilities.evaluate_parameters(context, normal)
    assert first == {'a.b': 5, 'list': (1, 2)}
    assert others == [file, tmp_path / 'q.yaml', single]
    assert utilities.evaluate_parameters(context, utilities.normalize_parameters(normal)) == (first, *others)
    for bad in ('text', {'a': 1}, 5):
        with pytest.raises(TypeError, match='Expecting list of parameters, got '):
            utilities.normalize_parameters(bad)
    with pytest.raises(TypeError, match='takes dictionaries and paths of files, got 5'):
        utilities.normalize_parameters([5])


def words_of(action, context):
    """The words of the command that an action would run, without a prefix."""
    action.prepare(context)
    return [perform_substitutions(context, part) for part in action.process_description.cmd]


@pytest.mark.parametrize('name, namespace, node', [
    ('n', '/ns', '/ns/n'), ('n', '', '/n'), ('n', None, '/**'), (None, '/ns', '/**'),
])  # fmt: skip
def test_parameters_name_the_node_only_if_it_is_known(name, namespace, node):
    action, context = Node(executable='x', name=name, namespace=namespace, parameters=[{'p': 1}]), LaunchContext()
    command = words_of(action, context)
    file = yaml.safe_load(Path(command[command.index('--params-file') + 1]).read_text())
    assert (list(file), action.is_node_name_fully_specified()) == ([node], node != '/**')
    assert (Node.UNSPECIFIED_NODE_NAMESPACE in action.node_name) is (namespace is None)
    context.close()


def test_a_parameter_has_its_name_with_it():
    node = Node(executable='x', parameters=[Parameter('a.b', [[WORD], 's'], value_type=list[str]), Parameter('c', 2.0)])
    command = words_of(node, LaunchContext())
    assert [word for word in command if ':=' in word] == ['a.b:=[word, s]', 'c:=2.0']


def test_the_command_of_a_node():
    context = LaunchContext()
    for action in (PushRosNamespace('a'), PushRosNamespace('b'), SetRemap('x', 'y'), SetParameter('p', 1)):
        action.visit(context)
    node = Node(
        package='turtlesim', executable='mimic', name='n', namespace='c', arguments=['--flag'],
        ros_arguments=['--log-level', 'debug'], remappings=[('input/pose', 'pose')], parameters=[{'q': '5'}],
    )  # fmt: skip
    command = words_of(node, context)
    assert command[0].endswith('/lib/turtlesim/mimic')
    file = command[command.index('--params-file') + 1]
    command[command.index(file)] = 'FILE'
    assert command[1:] == [
        '--flag', '--ros-args', '--log-level', 'debug', '-r', '__node:=n', '-r', '__ns:=/a/b/c', '-p', 'p:=1',
        '--params-file', 'FILE', '-r', 'x:=y', '-r', 'input/pose:=pose',
    ]  # fmt: skip
    assert Path(file).read_text() == "/a/b/c/n:\n  ros__parameters:\n    q: '5'\n"
    assert node.node_name == '/a/b/c/n'
    context.close()
    assert not Path(file).exists()
    absolute = words_of(Node(package='turtlesim', executable='mimic', namespace='/d'), context)
    assert '__ns:=/d' in absolute
    with pytest.raises(TypeError, match="'parameters' of Node must be a list"):
        Node(package='turtlesim', executable='mimic', parameters={'a': 1})
    pairs = Node(package='turtlesim', executable='mimic', remappings={'in': 'out', 'a': 'b'}.items())
    assert [word for word in words_of(pairs, LaunchContext()) if ':=' in word] == ['in:=out', 'a:=b']
    with pytest.raises(TypeError, match="'remappings' of Node must be pairs"):
        Node(package='turtlesim', executable='mimic', remappings={'in': 'out'})
    with pytest.raises(InvalidNodeNameException):
        words_of(Node(package='turtlesim', executable='mimic', name='a b'), context)


@pytest.mark.parametrize(
    'bad',
    [{5: 'x'}, {'a': None}, {'a': [1, 2, [3, 4]]}, {'a': {1, 2}}, {'a': object()}],
    ids=lambda bad: repr(bad)[:20],
)
def test_parameters_that_no_node_can_have_are_refused_at_once(bad):
    for parameters in ([bad], [{'outer': {'inner': bad}}]):
        with pytest.raises(TypeError, match='parameter'):
            Node(executable='mimic', parameters=parameters)


def test_parameters_that_are_neither_values_nor_files_are_refused_at_once():
    with pytest.raises(TypeError, match=r"'parameters' of Node takes dictionaries and paths of files, got 5\.0"):
        Node(executable='mimic', parameters=[5.0])


@pytest.mark.parametrize('remappings', [{'a': 'b'}, [{'a': 'b'}], ['ab', 'cd']], ids=str)
def test_remappings_that_are_no_pairs_are_refused_at_once(remappings):
    with pytest.raises(TypeError, match="'remappings' of Node must be"):
        Node(executable='mimic', remappings=remappings)


def test_parameters_are_taken_in_all_forms():
    word = LaunchConfiguration('word')
    given = ['a.yaml', Path('b.yaml'), [word, '.yaml'], word, ParameterFile('c.yaml'), {}, {
        'a': 1, word: 'x', ('b', word): word, 'c': [1, 2.5], 'd': ['x', word], 'e': {'f': [word, [word, 'y']]},
        'g': array('d', [0.5]), 'h': range(3), 'i': ParameterValue(word, value_type=str), 'j': (), 'k': '',
    }]  # fmt: skip
    Node(executable='mimic', parameters=given, remappings=[('a', word), [word, [word, 'b']]])


def test_find_package_share():
    share = FindPackageShare('turtlesim').perform(LaunchContext())
    assert os.path.isfile(os.path.join(share, 'package.xml'))
    assert (FindPackageShare('turtlesim') / 'a').perform(LaunchContext()) == os.path.join(share, 'a')


# --- what XML and YAML files say of nodes -------------------------------------------------------------------------


def node_of(text):
    """Return the command of the one node of an XML file, without the program, and the texts of its parameter files."""
    entity, parser = Parser.load(io.StringIO(f'<launch>{text}</launch>'))
    context = LaunchContext()
    context.launch_configurations.update({'x': '5', 'word': 'a b'})
    *before, node = parser.parse_description(entity).entities
    for action in before:
        action.visit(context)
    words = words_of(node, context)[1:]
    files = [
        Path(word).read_text()
        for option, word in zip(words, words[1:], strict=False)
        if option == '--params-file' and Path(word).is_file()
    ]
    context.close()
    return words, files


def test_a_node_of_an_xml_file():
    words, files = node_of("""
        <push-ros-namespace namespace="top"/>
        <set_use_sim_time value="true"/>
        <set_parameter name="$(var word)" value="$(var x)"/>
        <node pkg="turtlesim" exec="mimic" name="n$(var x)" namespace="low" args="--flag '$(var word)' x$(var x)"
              ros_args="--log-level debug" output="screen" respawn="$(var x)" launch-prefix="nice">
          <param name="i" value="$(var x)"/>
          <param name="none" value=""/>
          <param name="s" value="$(var x)" type="str"/>
          <param name="f" value="5" type="float"/>
          <param name="l" value="1.5, 2.5" value-sep=", "/>
          <param name="texts" value="'2', 5" value-sep=", " type="list_of_str"/>
          <param name="quoted" value="&quot;'2'&quot;, '5'" value-sep=", "/>
          <param name="group"><param name="inner" value="true"/></param>
          <param from="/no/such.yaml"/>
          <remap from="a" to="$(var x)/b"/>
        </node>
    """)
    assert words[:8] == ['--flag', 'a b', 'x5', '--ros-args', '--log-level', 'debug', '-r', '__node:=n5']
    assert words[8:14] == ['-r', '__ns:=/top/low', '-p', 'use_sim_time:=true', '-p', 'a b:=5']
    assert words[-2:] == ['-r', 'a:=5/b'] and '/no/such.yaml' not in words
    values = [yaml.safe_load(file)['/top/low/n5']['ros__parameters'] for file in files]
    assert values == [
        {'i': 5}, {'none': ''}, {'s': '5'}, {'f': 5.0}, {'l': [1.5, 2.5]}, {'texts': ["'2'", '5']},
        {'quoted': ["'2'", '5']}, {'group.inner': True},
    ]  # fmt: skip


def test_a_node_of_an_xml_file_without_a_package():
    entity, parser = Parser.load(io.StringIO('<launch><node exec="sleep" args="1"/></launch>'))
    (node,) = parser.parse_description(entity).entities
    assert words_of(node, LaunchContext())[:2] == ['sleep', '1']


@pytest.mark.parametrize(
    'text, kind, message',
    [
        ('<node pkg="p" exec="e"><param value="1"/></node>', ValueError, 'param Entity should have name or from'),
        ('<node pkg="p" exec="e"><param name="a" from="b"/></node>', RuntimeError, 'mutually exclusive'),
        ('<node pkg="p" exec="e"><param name="a"/></node>', RuntimeError, 'either a value attribute or nested params'),
        ('<node pkg="p" exec="e"><param name="a" value="1" type="int8"/></node>', ValueError, "type identifier 'int8'"),
        ('<node pkg="p" exec="e"><param name="a" type="int"><param name="b" value="1"/></param></node>', RuntimeError,
         'nested parameters and type attributes are mutually exclusive'),
        ('<node pkg="p" exec="e"><param name="a" values="1"/></node>', ValueError, "found in `param`: {'values'}"),
        ('<node pkg="p" exec="e"><remap from="a" too="b"/></node>', AttributeError, "Attribute 'to'"),
        ('<node pkg="p"/>', AttributeError, "Attribute 'exec' of type '<class 'str'>' not found in Entity 'node'"),
        ('<node pkg="p" exec="e" nmae="x"/>', ValueError, "Unexpected attribute"),
        ('<log message="$(find-pkg-share)"/>', TypeError, 'find-pkg-share substitution expects 1 argument, got 0'),
    ],
)  # fmt: skip
def test_faults_of_a_node_in_an_xml_file(text, kind, message):
    with pytest.raises(kind, match=message):
        node_of(text)


def test_a_parameter_file_that_is_missing_is_told_and_left_out(capsys):
    launch.logging.reset()
    node = Node(executable='x', parameters=['/no/such.yaml', {'p': 1}])
    context = LaunchContext()
    assert '/no/such.yaml' not in words_of(node, context)
    assert 'Parameter file path is not a file: /no/such.yaml' in capsys.readouterr().out
    context.close()


@pytest.mark.parametrize('value, kind', [('5', int), (5, float), ([1, 'a'], list[int]), ([1], int), (None, None)])
def test_values_that_can_never_have_their_type_are_refused_at_once(value, kind):
    with pytest.raises(TypeError):
        ParameterValue(value, value_type=kind)


def test_two_nodes_of_one_name_in_a_launch_are_told(capsys):
    launch.logging.reset()
    service = LaunchService()
    service.include_launch_description(LaunchDescription([
        Node(executable='true', name=name, namespace='/ns') for name in ('a', 'b', 'a')
    ]))  # fmt: skip
    assert service.run() == 0
    warned = [line for line in capsys.readouterr().out.splitlines() if 'there are now' in line]
    assert len(warned) == 1
    assert warned[0].endswith('at least 2 nodes with the name /ns/a created within this launch context')


def test_substitutions_of_packages_and_parameters():
    context = LaunchContext()
    for action in (SetParameter('speed', 2), SetROSLogDir('/logs')):
        action.visit(context)
    try:
        assert context.environment['ROS_LOG_DIR'] == '/logs'
    finally:
        context.environment.pop('ROS_LOG_DIR')
    Parser.load_launch_extensions()

    def perform(text):
        return perform_substitutions(context, parse_substitution(text))

    assert perform('$(param speed) $(param none 5)') == '2 5'
    assert perform('$(find-pkg-share turtlesim)') == f'{perform("$(find-pkg-prefix turtlesim)")}/share/turtlesim'
    assert perform('$(exec-in-pkg mimic turtlesim)').endswith('/lib/turtlesim/mimic')
    with pytest.raises(SubstitutionFailure, match="parameter 'nope' not found"):
        perform('$(param nope)')


def test_a_parameter_file_with_substitutions(tmp_path):
    (tmp_path / 'p.yaml').write_text('/**:\n  ros__parameters:\n    a: $(var x)\n    b: "$(var word)"\n')
    context = LaunchContext()
    context.launch_configurations.update({'x': '5', 'word': 'a b'})
    path = ParameterFile([str(tmp_path), '/p.yaml'], allow_substs=True).evaluate(context)
    assert yaml.safe_load(path.read_text()) == {'/**': {'ros__parameters': {'a': 5, 'b': 'a b'}}}
    assert ParameterFile(str(tmp_path / 'p.yaml')).evaluate(context) == tmp_path / 'p.yaml'
    context.close()
    assert not path.exists()
    context.launch_configurations['x'] = '['
    with pytest.raises(SubstitutionFailure, match='The substituted parameter file is not a valid yaml file'):
        ParameterFile(tmp_path / 'p.yaml', allow_substs=TextSubstitution(text='true')).evaluate(context)
    words, files = node_of(
        f'<node pkg="turtlesim" exec="mimic"><param from="{tmp_path}/p.yaml" allow_substs="true"/></node>'
    )
    assert 'a: 5' in files[0] and '$(var' not in files[0]


def test_a_ros_timer_waits_in_the_time_of_the_clock(peer, capsys):
    launch.logging.reset()
    service = LaunchService()
    service.include_launch_description(LaunchDescription([
        SetUseSimTime(True),
        RosTimer(period=10.0, actions=[LogInfo(msg='ten seconds later')]),
    ]))  # fmt: skip
    thread = threading.Thread(target=service.run)
    thread.start()
    clock = peer.publisher(Clock, '/clock')
    now = 0

    def done():
        nonlocal now
        now += 1
        clock.publish(Clock(clock=Time(sec=now)))
        return not thread.is_alive()

    peer.until(done, 'the end of the launch')
    thread.join()
    assert 'ten seconds later' in capsys.readouterr().out and now >= 10
    launch.logging.reset()


@pytest.mark.parametrize(
    ('base', 'namespace', 'absolute', 'relative'),
    [
        (None, None, None, None),
        (None, 'arm', '/arm', 'arm'),
        (None, '/', '/', '/'),
        ('', None, '/', ''),
        ('robot', None, '/robot', 'robot'),
        ('robot', 'arm', '/robot/arm', 'robot/arm'),
        ('robot', '/arm', '/arm', '/arm'),
        ('/robot', 'arm/', '/robot/arm', '/robot/arm'),
        ('/', 'arm', '/arm', '/arm'),
        ('', 'arm', '/arm', 'arm'),
        ('robot', '', '/robot', 'robot'),
    ],
)
def test_a_namespace_is_put_below_another(base, namespace, absolute, relative):
    assert utilities.prefix_namespace(base, namespace) == absolute
    assert utilities.prefix_namespace(base, namespace, return_absolute_ns=False) == relative


def test_a_namespace_begins_at_the_root_or_is_made_to():
    assert utilities.is_root_namespace('/') and not utilities.is_root_namespace('/arm')
    assert utilities.is_namespace_absolute('/arm') and not utilities.is_namespace_absolute('arm')
    assert [utilities.make_namespace_absolute(each) for each in ('', 'arm', '/arm')] == ['/', '/arm', '/arm']
