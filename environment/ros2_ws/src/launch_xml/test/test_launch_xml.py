"""XML launch files: elements, attributes, and what is wrong with them."""

import io
import textwrap

import launch.logging
import pytest
from launch import LaunchDescription, LaunchService
from launch.actions import IncludeLaunchDescription
from launch.frontend import Entity as BaseEntity
from launch.frontend import InvalidFrontendLaunchFileError, Parser
from launch.launch_description_sources import (
    FrontendLaunchDescriptionSource,
    get_launch_description_from_any_launch_file,
)
from launch_xml import Parser as XmlParser
from launch_xml.launch_description_sources import XMLLaunchDescriptionSource


@pytest.fixture(autouse=True)
def own_log(monkeypatch, tmp_path):
    monkeypatch.setenv('ROS_LOG_DIR', str(tmp_path / 'log'))
    launch.logging.reset()
    yield
    launch.logging.reset()


@pytest.fixture
def go(tmp_path, capsys):
    """Launch a file; return (status, what the user and the processes said)."""

    def go_on(body, **arguments):
        path = tmp_path / 'a.launch.xml'
        path.write_text(f'<launch>{textwrap.dedent(body)}</launch>')
        service = LaunchService()
        source = FrontendLaunchDescriptionSource(str(path))
        include = IncludeLaunchDescription(source, launch_arguments=arguments.items())
        service.include_launch_description(LaunchDescription([include]))
        status = service.run()
        lines = capsys.readouterr().out.splitlines()[2:]
        wanted = [line for line in lines if not line.startswith('[INFO]') or 'launch.user' in line]
        return status, [line.partition('user]: ' if 'launch.user' in line else '] ')[2] for line in wanted]

    return go_on


def parse(text):
    return XmlParser.load(io.StringIO(text))[0]


def test_attributes_have_types():
    entity = parse('<a t="x" n="5" b="true" l="1, 2" l-sep=", " s="$(var q)"><c v="1"/><c v="2"/></a>')
    assert isinstance(entity, BaseEntity) and entity.type_name == 'a' and entity.parent is None
    assert entity.get_attr('t') == 'x' and entity.get_attr('n') == '5' and entity.get_attr('n', data_type=int) == 5
    assert entity.get_attr('b', data_type=bool) is True and entity.get_attr('n', data_type=None) == 5
    assert entity.get_attr('l', data_type=list[int]) == [1, 2] and entity.get_attr('s', data_type=int) == '$(var q)'
    assert [child.get_attr('v') for child in entity.get_attr('c', data_type=list[BaseEntity])] == ['1', '2']
    assert entity.children[0].parent is entity
    assert entity.get_attr('none', optional=True) is None
    assert entity.get_attr('none', data_type=list[BaseEntity], optional=True) is None
    with pytest.raises(AttributeError, match="Attribute 'none' of type '<class 'str'>' not found in Entity 'a'"):
        entity.get_attr('none')
    with pytest.raises(TypeError, match="Attribute 't' of Entity 'a' expected to be of type '<class 'int'>'"):
        entity.get_attr('t', data_type=int, can_be_str=False)


def test_the_actions_of_launch(go):
    status, said = go("""
        <arg name="who" default="you" description="whom to greet"/>
        <arg name="mode" default="a"><choice value="a"/><choice value="b"/></arg>
        <let name="x" value="$(var who)2"/>
        <log message="hello $(var x) $(var mode)"/>
        <group>
          <let name="x" value="inner"/><set_env name="COURSE_TEST_E" value="1"/>
          <append_env name="COURSE_TEST_E" value="0" prepend="true" separator=","/>
          <log message="$(var x) $(env COURSE_TEST_E)"/>
          <unset_env name="COURSE_TEST_E"/><log message="$(env COURSE_TEST_E unset)"/>
        </group>
        <group scoped="false"><let name="y" value="1"/></group>
        <log message="$(var x) $(env COURSE_TEST_E unset) $(var y)"/>
        <group forwarding="false"><keep name="z" value="$(var x)"/><log message="$(var x none) $(var z)"/></group>
        <unset name="y"/><log message="$(var y gone)"/>
        <reset><keep name="w" value="$(var x)"/></reset><log message="$(var x gone) $(var w)"/>
        <log message="no" if="false"/><log message="yes" unless="$(eval '1 == 2')"/>
        <timer period="0.1"><log message="later"/><shutdown reason="enough" if="true"/></timer>
    """, who='me')  # fmt: skip
    assert status == 0
    assert said == ['hello me2 a', 'inner 0,1', 'unset', 'me2 unset 1', 'none me2', 'gone', 'gone me2', 'yes', 'later']


def test_executables(go, tmp_path):
    status, said = go("""
        <let name="word" value="a  b"/>
        <executable cmd="printf '%s|' $(var word) 'c d' $(var word)e f$(var word)" output="screen"/>
        <executable cmd="echo $GREETING; pwd" shell="true" output="screen" cwd="$(dirname)" name="shell">
          <env name="GREETING" value="hi $(var word)"/>
        </executable>
        <executable cmd="sleep 100" on_exit="shutdown" sigterm_timeout="20.5" if="false"/>
    """)
    assert status == 0
    assert sorted(said) == sorted(['a  b|c d|a  be|fa  b|', 'hi a b', str(tmp_path)])


def test_an_executable_may_end_the_launch_and_respawn(go):
    status, said = go("""
        <executable cmd="sleep 100"/>
        <executable cmd="sh -c 'echo up; exit 3'" output="screen" respawn="true" respawn_delay="0.01"
                    respawn_max_retries="1" name="again"/>
        <executable cmd="sleep 0.5" on_exit="shutdown"/>
    """)
    assert status == 0 and said.count('up') == 2


def test_files_include_each_other(go, tmp_path):
    (tmp_path / 'b.launch.xml').write_text(
        '<launch deprecated="use a"><arg name="n"/><log message="$(var n) in $(filename)"/></launch>'
    )
    (tmp_path / 'c.launch.py').write_text(
        'from launch import LaunchDescription\nfrom launch.actions import LogInfo\n'
        "def generate_launch_description():\n    return LaunchDescription([LogInfo(msg='python')])\n"
    )
    status, said = go("""
        <include file="$(dirname)/b.launch.xml"><let name="n" value="one"/></include>
        <include file="$(dirname)/b.launch.xml"><arg name="n" value="two"/></include>
        <include file="$(dirname)/c.launch.py"/>
    """)
    path = tmp_path / 'b.launch.xml'
    warning = f'[launch]: launch file [{path}] is deprecated: use a'
    assert (status, said) == (0, [warning, f'one in {path}', warning, f'two in {path}', 'python'])


@pytest.mark.parametrize(
    'text, kind, message',
    [
        ('<launch><lag/></launch>', 'RuntimeError', 'Unrecognized entity of the type: lag'),
        ('<robot/>', 'RuntimeError', "Expected 'launch' as root tag"),
        ('<launch><log mesage="x"/></launch>', 'AttributeError',
         "Attribute 'message' of type '<class 'str'>' not found"),
        ('<launch><log message="x" colour="red"/></launch>', 'ValueError',
         "Unexpected attribute(s) found in `log`: {'colour'}"),
        ('<launch><let name="a" value="b"><c/></let></launch>', 'ValueError',
         "Unexpected nested tag(s) found in `let`: {'c'}"),
        ('<launch><log message="x" if="1" unless="0"/></launch>', 'RuntimeError',
         "if and unless conditions can't be used simultaneously"),
        ('<launch><log message="$(vra x)"/></launch>', 'RuntimeError', 'Unknown substitution: vra'),
        ('<launch><executable cmd="a" respawn_delay="-1"/></launch>', 'ValueError', 'non-negative value'),
        ('<launch><executable cmd="a" on_exit="x"/></launch>', 'ValueError', 'expected to be shutdown but got `x`'),
        ('<launch', 'InvalidFrontendLaunchFileError', 'ParseError: unclosed token: line 1, column 0'),
    ],
)  # fmt: skip
def test_faults_are_told_with_the_format(tmp_path, text, kind, message):
    path = tmp_path / 'a_launch.xml'
    path.write_text(text)
    with pytest.raises(Exception, match='.') as caught:
        get_launch_description_from_any_launch_file(str(path))
    told = str(caught.value)
    assert told.startswith('Caught multiple exceptions when trying to load file of format [xml]:\n - ')
    assert f' - {kind}: ' in told and message in told


def test_a_file_of_no_format_is_refused(tmp_path):
    (tmp_path / 'a.txt').write_text('<launch')
    with pytest.raises(InvalidFrontendLaunchFileError, match='its format is unknown'):
        Parser.load(str(tmp_path / 'a.txt'))
    (tmp_path / 'b.txt').write_text('<launch/>')
    assert Parser.load(str(tmp_path / 'b.txt'))[0].type_name == 'launch'


def test_a_python_file_includes_one_of_any_name(tmp_path, capsys):
    """Upstream's guide, Using XML, YAML, and Python for ROS 2 Launch Files."""
    (tmp_path / 'robot').write_text('<launch><arg name="who"/><log message="$(var who)"/></launch>')
    source = XMLLaunchDescriptionSource([str(tmp_path), '/robot'])
    assert source.method == 'interpreted XML launch file'
    service = LaunchService()
    service.include_launch_description(
        LaunchDescription([IncludeLaunchDescription(source, launch_arguments={'who': 'a robot'}.items())])
    )
    assert service.run() == 0
    assert '[INFO] [launch.user]: a robot' in capsys.readouterr().out
