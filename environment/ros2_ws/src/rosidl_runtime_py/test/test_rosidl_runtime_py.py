"""rosidl_runtime_py: messages from and to dictionaries, YAML and CSV."""

import pytest
from builtin_interfaces.msg import Time
from geometry_msgs.msg import Pose, PoseArray, TwistStamped
from rosidl_runtime_py import (
    get_interfaces,
    get_message_interfaces,
    message_to_csv,
    message_to_ordereddict,
    message_to_yaml,
    set_message_fields,
)
from rosidl_runtime_py.utilities import (
    get_action,
    get_action_namespaced_type,
    get_interface,
    get_message,
    get_message_namespaced_type,
    get_service,
    get_service_namespaced_type,
)
from sensor_msgs.msg import Imu, JointState
from std_msgs.msg import Byte, Int32, String


def test_fields_are_set_however_deep():
    message = PoseArray()
    assert set_message_fields(message, {'header': {'frame_id': 'map'}, 'poses': [{'position': {'x': 2}}, {}]}) == []
    assert message.header.frame_id == 'map'
    assert [pose.position.x for pose in message.poses] == [2.0, 0.0]
    joints = JointState()
    set_message_fields(joints, {'name': ['a'], 'position': [1, 2.5]})
    assert list(joints.position) == [1.0, 2.5]
    imu = Imu()
    set_message_fields(imu, {'orientation_covariance': range(9)})
    assert list(imu.orientation_covariance) == list(range(9))
    byte = Byte()
    set_message_fields(byte, {'data': 65})
    assert byte.data == b'A'


def test_now_and_auto_give_setters_of_exactly_those_stamps():
    message = TwistStamped()
    setters = set_message_fields(message, {'header': 'auto'}, expand_header_auto=True, expand_time_now=True)
    assert len(setters) == 1
    setters[0](Time(sec=5))
    assert message.header.stamp.sec == 5
    poses = PoseArray()
    (setter,) = set_message_fields(poses, {'header': {'stamp': 'now', 'frame_id': 'a'}}, expand_time_now=True)
    setter(Time(sec=6))
    assert (poses.header.stamp.sec, poses.header.frame_id) == (6, 'a')
    with pytest.raises(TypeError):
        set_message_fields(TwistStamped(), {'header': 'auto'})


@pytest.mark.parametrize(
    'values,error,text',
    [
        ({'date': 1}, AttributeError, "'Int32' object has no attribute 'date'"),
        ({'data': 'x'}, ValueError, 'invalid literal'),
        ({'data': [1]}, TypeError, "not 'list'"),
        (None, TypeError, "Value 'None' is expected to be a dictionary but is a NoneType"),
        ({False: 1}, TypeError, "Field name 'False' is expected to be a string"),
    ],
)
def test_what_does_not_fit_is_refused(values, error, text):
    with pytest.raises(error, match=text):
        set_message_fields(Int32(), values)


def test_yaml_keeps_the_order_of_the_fields_and_reads_back():
    message = TwistStamped()
    message.twist.angular.z = float('nan')
    text = message_to_yaml(message)
    assert text.index('header:') < text.index('twist:') < text.index('angular:')
    assert '    z: .nan\n' in text
    assert message_to_yaml(String(data='on')) == "data: 'on'\n"
    assert message_to_yaml(String(data='Grüße: 1')) == "data: 'Grüße: 1'\n"
    assert message_to_yaml(String(data='x' * 500)).count('\n') == 1


def test_long_values_are_cut():
    joints = JointState(name=['a', 'b'], position=[1.0, 2.0])
    assert message_to_ordereddict(joints, truncate_length=1)['name'] == ['a', '...']
    assert message_to_csv(joints, truncate_length=1) == '0,0,,a,...,1.0,...,,'
    assert message_to_csv(joints, no_arr=True).endswith(
        '<sequence type: string, length: 2>,<sequence type: double, length: 2>,<sequence type: double, length: 0>,'
        '<sequence type: double, length: 0>'
    )
    assert message_to_ordereddict(Imu(), no_arr=True)['orientation_covariance'] == '<array type: double[9]>'
    assert message_to_yaml(Byte(data=b'\xff')) == 'data: ÿ\n'


def test_interfaces_by_name():
    assert get_message('std_msgs/String') is get_message('std_msgs/msg/String') is String
    assert get_service('std_srvs/Empty') is get_interface('std_srvs/srv/Empty')
    with pytest.raises(ValueError, match="Expected the full name of a message, got 'std_srvs/srv/Empty'"):
        get_message('std_srvs/srv/Empty')
    with pytest.raises(ValueError, match='Expected the full name of an action'):
        get_action('std_msgs/msg/String')
    with pytest.raises(ValueError):
        get_message('String')
    with pytest.raises(ModuleNotFoundError):
        get_message('no_such/msg/String')


def test_a_value_may_be_a_message():
    stamped = TwistStamped()
    twist = TwistStamped().twist
    twist.linear.x = 2.5
    set_message_fields(stamped, {'twist': twist})
    assert stamped.twist.linear.x == 2.5
    poses = PoseArray()
    pose = Pose()
    pose.position.y = 1.0
    set_message_fields(poses, {'poses': [pose, {'position': {'y': 3.0}}]})
    assert [each.position.y for each in poses.poses] == [1.0, 3.0]


def test_names_of_each_kind_of_interface():
    for name, function in (
        ('msg', get_message_namespaced_type),
        ('srv', get_service_namespaced_type),
        ('action', get_action_namespaced_type),
    ):
        assert function('package/Name') == function(f'package/{name}/Name')
        assert function('package/Name').namespaces == ['package', name]


def test_interfaces_of_packages():
    assert get_interfaces(['rclpy']) == {'rclpy': []}
    assert get_message_interfaces(['rclpy']) == {}
    with pytest.raises(LookupError, match="Unknown package 'no_such'"):
        get_interfaces(['no_such'])
