"""The command `ros2 interface`, which needs no node."""

import sys

import pytest


def test_interface_show_indents_nested_fields(ros2):
    assert ros2.output('interface', 'show', 'geometry_msgs/msg/TwistStamped') == (
        '# A twist with reference coordinate frame and timestamp\n'
        '\n'
        'std_msgs/Header header\n'
        '\tbuiltin_interfaces/Time stamp\n'
        '\t\tint32 sec\n'
        '\t\tuint32 nanosec\n'
        '\tstring frame_id\n'
        'Twist twist\n'
        '\tVector3  linear\n'
        '\t\tfloat64 x\n'
        '\t\tfloat64 y\n'
        '\t\tfloat64 z\n'
        '\tVector3  angular\n'
        '\t\tfloat64 x\n'
        '\t\tfloat64 y\n'
        '\t\tfloat64 z\n'
    )
    expected = 'bool data\n---\nbool success\nstring message\n'
    assert ros2.output('interface', 'show', 'std_srvs/srv/SetBool', '--no-comments') == expected
    assert ros2.output('interface', 'show', '-', '--no-comments', stdin='std_srvs/srv/SetBool\n') == expected
    assert '\t# ' not in ros2.output('interface', 'show', 'std_msgs/msg/Header')
    assert '\t# ' in ros2.output('interface', 'show', 'std_msgs/msg/Header', '--all-comments')
    assert '#\n' in ros2.output('interface', 'show', 'sensor_msgs/msg/Imu')
    assert '#' not in ros2.output('interface', 'show', 'sensor_msgs/msg/Imu', '--no-comments')


def test_interface_names_what_is_wrong(ros2):
    assert ros2.error('interface', 'show', 'std_msgs/String') == (
        "Invalid name 'std_msgs/String'. Expected three parts separated by '/'"
    )
    assert ros2.error('interface', 'show', 'no_such/msg/String') == "Unknown package 'no_such'"
    assert ros2.error('interface', 'show', 'std_msgs/msg/Nothing').startswith('Could not find the interface ')
    assert ros2.error('interface', 'package', 'no_such') == "Unknown package 'no_such'"
    assert ros2.error('interface', 'proto', 'std_msgs/msg/Nothing') == (
        "Could not find the interface 'std_msgs/msg/Nothing'"
    )


def test_interface_lists(ros2):
    everything = ros2.lines('interface', 'list')
    assert everything[0] == 'Messages:'
    assert everything.index('Services:') < everything.index('Actions:')
    assert '    std_msgs/msg/String' in everything
    assert ros2.lines('interface', 'list', '--only-srvs')[0] == 'Services:'
    assert ros2.lines('interface', 'package', 'std_srvs') == [
        'std_srvs/srv/Empty',
        'std_srvs/srv/SetBool',
        'std_srvs/srv/Trigger',
    ]
    assert ros2.lines('interface', 'package', 'std_srvs', '-m') == []
    assert 'std_srvs' in ros2.lines('interface', 'packages', '-s')
    assert 'std_srvs' not in ros2.lines('interface', 'packages', '-m')
    assert ros2.output('interface', 'proto', 'std_srvs/srv/SetBool') == '"data: false\n"\n'
    assert ros2.output('interface', 'proto', 'geometry_msgs/msg/Point', '--no-quotes') == 'x: 0.0\ny: 0.0\nz: 0.0\n\n'


def test_a_lone_hash_is_a_comment(overlay_of_messages):
    assert (
        overlay_of_messages('# a comment\n#\nint32 x  # trailing\n').output(
            'interface', 'show', '--no-comments', 'made_up/msg/Thing'
        )
        == 'int32 x\n'
    )


@pytest.fixture
def overlay_of_messages(ros2, tmp_path):
    """A function that writes a file of the package made_up, and returns the command that sees it."""

    def make(definition, file='Thing.msg', folder='msg'):
        path, index = tmp_path / 'share/made_up' / folder / file, tmp_path / 'share/ament_index/resource_index'
        for each in (index / 'packages', index / 'rosidl_interfaces', path.parent):
            each.mkdir(parents=True)
        (index / 'packages/made_up').touch()
        (index / 'rosidl_interfaces/made_up').write_text(f'{folder}/{path.stem}.idl\n{folder}/{file}\n')
        path.write_text(definition)
        prefixes = f'{tmp_path}:{ros2.environ.get("AMENT_PREFIX_PATH", sys.prefix)}'
        return type(ros2)({**ros2.environ, 'AMENT_PREFIX_PATH': prefixes}, tmp_path)

    return make


def test_what_is_defined_in_idl_only_is_shown_as_it_is(overlay_of_messages):
    text = 'module made_up {\n  module msg {\n    struct Other {\n      uint32 value;  // a number\n    };\n  };\n};\n'
    assert overlay_of_messages(text, 'Other.idl').output('interface', 'show', 'made_up/msg/Other') == text


@pytest.mark.parametrize('folder', ['msg-common', 'msg/common'])
def test_a_definition_may_be_in_a_folder_of_any_name(overlay_of_messages, folder):
    shown = overlay_of_messages('int32 x\n', folder=folder)
    assert shown.output('interface', 'show', 'made_up/msg/Thing') == 'int32 x\n'
    assert shown.error('interface', 'show', 'made_up/msg/Other').startswith('Could not find the interface ')
    assert shown.error('interface', 'show', 'made_up/srv/Thing').startswith('Could not find the interface ')


def test_lines_know_their_comments():
    from ros2interface.verb.show import InterfaceTextLine

    for text in ('#', '  # text'):
        assert InterfaceTextLine('made_up', 'Thing', text).is_comment()
    line = InterfaceTextLine('made_up', 'Thing', "string s 'a#b'  # text\n")
    assert not line.is_comment() and line.is_trailing_comment()
    assert (line.text_without_comment, str(line)) == ("string s 'a#b'", "string s 'a#b'  # text")
    assert not InterfaceTextLine('made_up', 'Thing', "string s 'a#b'").is_trailing_comment()
    assert InterfaceTextLine('made_up', 'Thing', 'Other[] others').nested_type == 'made_up/msg/Other'
