"""YAML launch files: entities, attributes, and what is wrong with them."""

import io
import textwrap

import launch.logging
import pytest
from launch import LaunchDescription, LaunchService
from launch.actions import IncludeLaunchDescription
from launch.frontend import Entity as BaseEntity
from launch.launch_description_sources import AnyLaunchDescriptionSource, get_launch_description_from_any_launch_file
from launch_yaml import Parser as YamlParser
from launch_yaml.launch_description_sources import YAMLLaunchDescriptionSource


@pytest.fixture(autouse=True)
def own_log(monkeypatch, tmp_path):
    monkeypatch.setenv('ROS_LOG_DIR', str(tmp_path / 'log'))
    launch.logging.reset()
    yield
    launch.logging.reset()


def parse(text):
    return YamlParser.load(io.StringIO(textwrap.dedent(text)))[0]


def test_attributes_have_types():
    entity = parse("""
        a:
          t: x
          n: 5
          f: 2
          l: [1, 2]
          s: $(var q)
          c:
            - {v: 1}
            - {v: 2}
    """)
    assert isinstance(entity, BaseEntity) and entity.type_name == 'a'
    assert entity.get_attr('t') == 'x' and entity.get_attr('n', data_type=int) == 5
    assert entity.get_attr('f', data_type=float) == 2.0 and entity.get_attr('l', data_type=None) == [1, 2]
    assert entity.get_attr('s', data_type=int) == '$(var q)' and entity.get_attr('none', optional=True) is None
    values = [child.get_attr('v', data_type=int) for child in entity.get_attr('c', data_type=list[BaseEntity])]
    assert values == [1, 2]
    with pytest.raises(AttributeError, match="Attribute 'none' of type '<class 'str'>' not found in Entity 'a'"):
        entity.get_attr('none')
    with pytest.raises(TypeError, match="Attribute 'n' of Entity 'a' expected to be of type '<class 'str'>'"):
        entity.get_attr('n')
    with pytest.raises(TypeError, match='expected to be a list of dictionaries'):
        entity.get_attr('l', data_type=list[BaseEntity])


def test_the_actions_of_launch(tmp_path, capsys):
    path = tmp_path / 'a.launch.yaml'
    path.write_text(
        textwrap.dedent("""\
        %YAML 1.2
        ---
        launch:
          - arg: {name: who, default: you}
          - arg:
              name: mode
              default: a
              choice: [{value: a}, {value: b}]
          - let: {name: x, value: $(var who)2}
          - group:
              - set_env: {name: COURSE_TEST_E, value: "1"}
              - let: {name: x, value: inner}
              - log: {message: $(var x) $(env COURSE_TEST_E)}
          - group:
              if: $(eval '"$(var mode)" == "b"')
              children:
                - log: {message: never}
          - log: {message: "$(var x) $(var mode)", unless: "false"}
          - executable:
              cmd: echo $(var x) 'b c'
              output: screen
              env: [{name: A, value: "1"}]
          - timer:
              period: 0
              children:
                - log: {message: later}
    """)
    )
    service = LaunchService()
    include = IncludeLaunchDescription(AnyLaunchDescriptionSource(str(path)), launch_arguments=[('who', 'me')])
    service.include_launch_description(LaunchDescription([include]))
    assert service.run() == 0
    lines = capsys.readouterr().out.splitlines()
    said = [line.partition('user]: ')[2] for line in lines if 'launch.user' in line]
    assert said == ['inner 1', 'me2 a', 'later']
    assert any(line.endswith('] me2 b c') for line in lines)


@pytest.mark.parametrize(
    'text, kind, message',
    [
        ('launch: [{lag: {}}]', 'RuntimeError', 'Unrecognized entity of the type: lag'),
        ('a: 1\nb: 2\n', 'InvalidFrontendLaunchFileError', 'RuntimeError: Expected only one root'),
        ('launch: [{log: {mesage: x}}]', 'AttributeError', "Attribute 'message' of type '<class 'str'>' not found"),
        ('launch: [{log: {message: x, colour: red}}]', 'ValueError', "Unexpected key(s) found in `log`: {'colour'}"),
        ('launch: [{log: {message: 5}}]', 'TypeError', "Attribute 'message' of Entity 'log' expected to be of type"),
        ('launch: [{timer: {period: 1.0}}]', 'ValueError', 'Expected entity `timer` to have children entities'),
        ('launch: {a: 1}', 'ValueError', 'Expected entity `launch` to have children entities'),
        ('launch: [{a: 1, b: 2}]', 'RuntimeError', 'a dictionary with only one key'),
        ('launch: [', 'InvalidFrontendLaunchFileError', 'ParserError: while parsing a flow node'),
    ],
)  # fmt: skip
def test_faults_are_told_with_the_format(tmp_path, text, kind, message):
    path = tmp_path / 'a_launch.yaml'
    path.write_text(text)
    with pytest.raises(Exception, match='.') as caught:
        get_launch_description_from_any_launch_file(str(path))
    told = str(caught.value)
    assert told.startswith('Caught multiple exceptions when trying to load file of format [yaml]:\n - ')
    assert f' - {kind}: ' in told and message in told


def test_a_python_file_includes_one_of_any_name(tmp_path, capsys):
    """Upstream's guide, Using XML, YAML, and Python for ROS 2 Launch Files."""
    (tmp_path / 'robot').write_text('launch: [{arg: {name: who}}, {log: {message: $(var who)}}]')
    source = YAMLLaunchDescriptionSource([str(tmp_path), '/robot'])
    assert source.method == 'interpreted YAML launch file'
    service = LaunchService()
    service.include_launch_description(
        LaunchDescription([IncludeLaunchDescription(source, launch_arguments={'who': 'a robot'}.items())])
    )
    assert service.run() == 0
    assert '[INFO] [launch.user]: a robot' in capsys.readouterr().out
