"""Bags written and read by program, and read by the library that other tools use."""

import os
import signal
import subprocess
import sys
import textwrap
import threading
from datetime import timedelta

import pytest
import yaml
from geometry_msgs.msg import PointStamped
from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.serialization import deserialize_message, serialize_message
from rclpy.time import Time
from rosbag2_py import (
    BagError,
    CompressionMode,
    CompressionOptions,
    ConverterOptions,
    Info,
    LocalMessageDefinitionSource,
    MessageDefinition,
    MetadataIo,
    Player,
    PlayOptions,
    ReadOrder,
    ReadOrderSortBy,
    Recorder,
    RecordOptions,
    Reindexer,
    SequentialCompressionReader,
    SequentialCompressionWriter,
    SequentialReader,
    SequentialWriter,
    StorageFilter,
    StorageOptions,
    TopicMetadata,
    bag_rewrite,
    compression_mode_from_string,
    compression_mode_to_string,
    get_registered_compressors,
    running,
)
from rosbag2_py.merged import MergedReader
from rosbags.highlevel import AnyReader
from service_msgs.msg import ServiceEventInfo
from std_msgs.msg import Int32, String
from std_srvs.srv import SetBool

from environment.tests.running import PATIENCE

STORAGES = ['mcap', 'sqlite3']


def write(path, storage, count=5, writer=None, **options):
    """Write a bag with `count` words and one point; returns its folder."""
    writer = writer or SequentialWriter()
    writer.open(StorageOptions(str(path), storage, **options), ConverterOptions('cdr', 'cdr'))
    latched = QoSProfile(depth=3, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    writer.create_topic(TopicMetadata(0, '/words', 'std_msgs/msg/String', 'cdr', [latched]))
    writer.create_topic(TopicMetadata(id=1, name='/point', type='geometry_msgs/msg/PointStamped'))
    point = PointStamped()
    point.point.x = 1.5
    writer.write('/point', serialize_message(point), 1_000_000_000)
    for number in range(count):
        writer.write('/words', serialize_message(String(data=str(number))), (2 + number) * 1_000_000_000)
    writer.close()
    return path


def read(path):
    """(topic, time in seconds, text) of each message."""
    reader = SequentialReader()
    reader.open_uri(str(path))
    found = []
    while reader.has_next():
        topic, data, timestamp = reader.read_next()
        found.append((topic, timestamp / 1e9, deserialize_message(data, String).data if topic == '/words' else ''))
    reader.close()
    return found


@pytest.mark.parametrize('storage', STORAGES)
def test_what_was_written_is_read(tmp_path, storage):
    bag = write(tmp_path / 'bag', storage)
    suffix = {'mcap': 'mcap', 'sqlite3': 'db3'}[storage]
    assert sorted(os.listdir(bag)) == [f'bag_0.{suffix}', 'metadata.yaml']
    expected = [('/point', 1.0, ''), *(('/words', 2.0 + n, str(n)) for n in range(5))]
    assert read(bag) == expected
    assert read(bag / f'bag_0.{suffix}') == expected
    reader = SequentialReader()
    reader.open(StorageOptions(str(bag), storage), ConverterOptions('', ''))
    topics = {each.name: each for each in reader.get_all_topics_and_types()}
    assert topics['/words'].type == 'std_msgs/msg/String'
    (profile,) = topics['/words'].offered_qos_profiles
    assert (profile.durability, profile.reliability, profile.depth) == (
        DurabilityPolicy.TRANSIENT_LOCAL,
        ReliabilityPolicy.RELIABLE,
        3,
    )
    assert topics['/point'].type_description_hash.startswith('RIHS01_')
    reader.set_filter(StorageFilter(topics=['/words']))
    reader.seek(5 * 10**9)
    assert [reader.read_next()[2] for _ in range(2)] == [5 * 10**9, 6 * 10**9]
    assert not reader.has_next()
    with pytest.raises(BagError, match='at end'):
        reader.read_next()


def test_what_is_known_of_a_bag_is_printed_in_an_order_and_with_sizes_as_asked(tmp_path, capsys):
    bag, info = tmp_path / 'bag', Info()
    events = ('/b/_service_event', '/a/_service_event')
    writer = SequentialWriter()
    writer.open(StorageOptions(str(bag), 'mcap'))
    for index, name in enumerate(('/z', '/y', *events)):
        kind = 'std_srvs/srv/SetBool_Event' if name in events else 'std_msgs/msg/String'
        writer.create_topic(TopicMetadata(index, name, kind, 'cdr'))
    for second, name in enumerate('zzy'):
        writer.write(f'/{name}', serialize_message(String(data='a' * 1000)), second)
    for second, kind in enumerate((0, 1, 2, 3, 0)):  # as client and service tell them, the last without an answer
        event = ServiceEventInfo(event_type=kind, sequence_number=second // 4)
        writer.write(events[0], serialize_message(SetBool.Event(info=event)), second)
    writer.close()
    metadata = info.read_metadata(str(bag), '')

    def printed(method, *args):
        method(*args)
        return capsys.readouterr().out

    assert info.get_sorting_methods() == {'name', 'type', 'count'}
    assert printed(info.print_output_topic_name_only, metadata, 'name') == '/y\n/z\n'
    assert printed(info.print_output, metadata, 'Count').split('\n')[8:] == [
        'Messages:          3',
        'Topic information: Topic: /y | Type: std_msgs/msg/String | Count: 1 | Serialization Format: cdr',
        '                   Topic: /z | Type: std_msgs/msg/String | Count: 2 | Serialization Format: cdr',
        'Service:           2',
        'Service information: Service: /a | Type: std_srvs/srv/SetBool | Event Count: 0 | Serialization Format: cdr',
        '                     Service: /b | Type: std_srvs/srv/SetBool | Event Count: 5 | Serialization Format: cdr',
        '',
        '',
    ]
    told = printed(info.print_output_verbose, str(bag), metadata, 'name')
    for counts in ('Count: 1 | Size Contribution: 1009 B', 'Count: 2 | Size Contribution: 2.0 KiB'):
        assert f'std_msgs/msg/String | {counts} | Serialization Format: cdr' in told
    assert 'SetBool | Request Count: 2 | Response Count: 1 | Size Contribution: ' in told
    with pytest.raises(RuntimeError, match='Enum value match for "size" string is not found.'):
        info.print_output(metadata, 'size')


def test_several_bags_are_read_as_one(tmp_path):
    for name, count in (('a', 3), ('b', 5)):
        write(tmp_path / name, 'mcap', count)
    bags = [StorageOptions(str(tmp_path / name)) for name in 'ab']
    reader, (first, second) = MergedReader(bags), (Info().read_metadata(bag.uri) for bag in bags)

    def rest():
        return [reader.read_next()[::2] for _ in iter(reader.has_next, False)]

    together, metadata = first.message_count + second.message_count, reader.get_metadata()
    assert metadata.message_count == together == len(rest())
    assert (metadata.starting_time, metadata.duration) == (first.starting_time, second.duration)
    assert sorted(each.name for each in reader.get_all_topics_and_types()) == ['/point', '/words']
    reader.set_filter(StorageFilter(topics=['/words']))
    assert reader.passes('/words') and not reader.passes('/point')
    reader.seek(3 * 10**9)
    times = [time for _, time in rest()]
    assert times == sorted(times) and len(times) == 2 + 4
    with pytest.raises(BagError, match='at end'):
        reader.read_next()
    reader.close()
    with pytest.raises(BagError, match='does not exist'):
        MergedReader([bags[0], StorageOptions(str(tmp_path / 'none'))])


@pytest.mark.parametrize('storage', STORAGES)
def test_a_filter_counts_from_the_message_read_last(tmp_path, storage):
    writer = SequentialWriter()
    writer.open(StorageOptions(str(tmp_path / 'bag'), storage))
    for index, name in enumerate('abc'):
        writer.create_topic(TopicMetadata(index, name, 'std_msgs/msg/String', 'cdr'))
    moments = [('a', 1), ('b', 1), ('a', 1), ('c', 1), ('a', 1), ('b', 2), ('a', 3)]
    for topic, time in moments:
        writer.write(topic, b'', time)
    writer.close()
    reader = SequentialReader()
    reader.open_uri(str(tmp_path / 'bag'))

    def rest(count):
        return [reader.read_next()[::2] for _ in range(count)]

    reader.set_filter(StorageFilter(topics=['a']))
    assert rest(2) == [('a', 1)] * 2
    reader.reset_filter()
    assert rest(2) == moments[3:5]
    reader.set_filter(StorageFilter(regex_to_exclude='b'))
    reader.set_filter(StorageFilter(exclude_topics=['b']))
    assert rest(1) == [('a', 3)] and not reader.has_next()
    reader.reset_filter()
    assert not reader.has_next()
    reader.seek(2)
    assert rest(2) == moments[5:]


def test_metadata_has_times_and_can_be_written(tmp_path):
    folder, files = str(write(tmp_path / 'bag', 'mcap')), MetadataIo()
    metadata = files.read_metadata(folder)
    assert (metadata.starting_time, metadata.duration) == (Time(seconds=1), Duration(seconds=5))
    assert (metadata.files[0].starting_time, metadata.files[0].duration) == (Time(seconds=1), Duration(seconds=5))
    metadata.custom_data = {'who': 'me'}
    files.write_metadata(folder, metadata)
    assert files.read_metadata(folder) == metadata
    assert not files.metadata_file_exists(str(tmp_path)) and files.metadata_file_exists(folder)


@pytest.mark.parametrize('storage', STORAGES)
def test_other_tools_read_it_without_the_packages(tmp_path, storage):
    with AnyReader([write(tmp_path / 'bag', storage)]) as reader:
        (connection,) = (each for each in reader.connections if each.topic == '/point')
        assert 'std_msgs/Header' in connection.msgdef.data and 'MSG: builtin_interfaces/Time' in connection.msgdef.data
        points = [reader.deserialize(raw, each.msgtype).point for each, _, raw in reader.messages([connection])]
        assert [point.x for point in points] == [1.5]


@pytest.mark.parametrize('storage', STORAGES)
def test_a_topic_of_a_type_that_is_not_installed_has_the_definition_given(tmp_path, storage):
    writer = SequentialWriter()
    writer.open(StorageOptions(str(tmp_path / 'bag'), storage), ConverterOptions('cdr', 'cdr'))
    given = MessageDefinition('far_msgs/msg/Depth', 'ros2msg', 'int32 metres')
    type_hash = 'RIHS01_be868934e60442a8b7dcb1dbba4b69b8ca92bf0f081274f8f4d682d20ad1ca8a'
    writer.create_topic(TopicMetadata(0, '/depth', 'far_msgs/msg/Depth', 'cdr', [], type_hash), given)
    writer.create_topic(TopicMetadata(1, '/words', 'std_msgs/msg/String'), MessageDefinition())
    writer.write('/depth', serialize_message(Int32(data=7)), 1)
    writer.write('/words', serialize_message(String(data='one')), 2)
    writer.close()
    with AnyReader([tmp_path / 'bag']) as reader:
        texts = {each.topic: each.msgdef.data for each in reader.connections}
        assert texts['/depth'] == 'int32 metres' and 'string data' in texts['/words']
        (metres,) = (reader.deserialize(raw, each.msgtype).metres for each, at, raw in reader.messages() if at == 1)
    assert metres == 7


def test_the_names_of_the_tutorials_need_no_import_of_their_own():
    code = """
        import rosbag2_py

        storage_options = rosbag2_py._storage.StorageOptions(uri='my_bag', storage_id='mcap')
        converter_options = rosbag2_py._storage.ConverterOptions('', '')
        rosbag2_py._storage.TopicMetadata(id=0, name='a', type='std_msgs/msg/String', serialization_format='cdr')
    """
    subprocess.run([sys.executable, '-c', textwrap.dedent(code)], check=True)


LINE = '=' * 80 + '\n'


@pytest.fixture
def sonar_msgs(tmp_path, monkeypatch):
    """A package of definitions that is installed, as far as the texts of its files go."""
    share = tmp_path / 'share' / 'sonar_msgs'
    files = {
        'msg/Ping.msg': 'Echo[<=4] echoes\nbuiltin_interfaces/Time stamp\nAngle angle\n',
        'msg/Echo.msg': 'Angle angle\nfloat32 range\n',
        'msg/Angle.msg': 'float32 radians\n',
        'msg/Depth.idl': 'module sonar_msgs { module msg { struct Depth { float metres; }; }; };\n',
        'msg/Dive.idl': '#include "sonar_msgs/msg/Depth.idl"\nmodule sonar_msgs {};\n',
        'srv/Aim.srv': 'Angle angle\n---\nEcho echo\n',
        'srv/Sink.srv': 'Depth depth\n---\n',
    }
    for name, text in files.items():
        (share / name).parent.mkdir(parents=True, exist_ok=True)
        (share / name).write_text(text)
    index = tmp_path / 'share' / 'ament_index' / 'resource_index' / 'rosidl_interfaces'
    index.mkdir(parents=True)
    (index / 'sonar_msgs').write_text('\n'.join(files))
    monkeypatch.setenv('AMENT_PREFIX_PATH', str(tmp_path), prepend=os.pathsep)
    return files


def test_a_message_definition_has_those_that_it_holds_each_once(sonar_msgs):
    found = LocalMessageDefinitionSource().get_full_text('sonar_msgs/msg/Ping')
    assert (found.topic_type, found.encoding) == ('sonar_msgs/msg/Ping', 'ros2msg')
    time = '# This message communicates ROS Time'
    begin, _, rest = found.encoded_message_definition.partition(time)
    assert begin.startswith(f'{sonar_msgs["msg/Ping.msg"]}\n{LINE}MSG: builtin_interfaces/Time\n')
    echo = f'{LINE}MSG: sonar_msgs/Echo\n{sonar_msgs["msg/Echo.msg"]}'
    angle = f'{LINE}MSG: sonar_msgs/Angle\n{sonar_msgs["msg/Angle.msg"]}'
    assert rest.endswith(f'\n{angle}\n{echo}')
    assert (
        LocalMessageDefinitionSource().get_full_text('sonar_msgs/Angle').encoded_message_definition
        == (sonar_msgs['msg/Angle.msg'])
    )


def test_definitions_in_idl_and_of_services_are_found(sonar_msgs):
    source = LocalMessageDefinitionSource()
    dive = source.get_full_text('sonar_msgs/msg/Dive')
    depth = f'IDL: sonar_msgs/msg/Depth\n{sonar_msgs["msg/Depth.idl"]}'
    assert (dive.encoding, dive.encoded_message_definition) == (
        'ros2idl',
        f'{LINE}IDL: sonar_msgs/msg/Dive\n{sonar_msgs["msg/Dive.idl"]}\n{LINE}{depth}',
    )
    aim = source.get_full_text('sonar_msgs/srv/Aim_Event')
    assert aim.encoding == 'ros2msg'
    assert aim.encoded_message_definition.startswith(f'{LINE}SRV: sonar_msgs/srv/Aim\n{sonar_msgs["srv/Aim.srv"]}\n')
    assert aim.encoded_message_definition.count('MSG: sonar_msgs/Angle\n') == 1
    sink = source.get_full_text('sonar_msgs/srv/Sink')
    assert sink.encoding == 'ros2idl'
    assert sink.encoded_message_definition.endswith(f'IDL: sonar_msgs/Depth\n{sonar_msgs["msg/Depth.idl"]}')


def test_what_has_no_definition_is_unknown_or_an_error():
    source = LocalMessageDefinitionSource()
    for name in ('std_msgs', 'example_interfaces/action/Fibonacci_FeedbackMessage', 'action_msgs/msg/GoalStatusArray'):
        found = source.get_full_text(name)
        assert (found.topic_type, found.encoding, found.encoded_message_definition) == (name, 'unknown', '')
    for name in ('std_msgs/msg/Nothing', 'no_such_package/msg/Nothing', 'std_msgs/srv/Nothing'):
        with pytest.raises(RuntimeError, match=name):
            source.get_full_text(name)


def test_metadata_is_that_of_jazzy(tmp_path):
    content = yaml.safe_load((write(tmp_path / 'bag', 'mcap') / 'metadata.yaml').read_text())
    inner = content['rosbag2_bagfile_information']
    assert (inner['version'], inner['storage_identifier'], inner['ros_distro']) == (9, 'mcap', 'jazzy')
    assert inner['duration'] == {'nanoseconds': 5_000_000_000}
    assert inner['relative_file_paths'] == ['bag_0.mcap'] == [each['path'] for each in inner['files']]
    assert [each['message_count'] for each in inner['topics_with_message_count']] == [5, 1]
    lines = str(Info().read_metadata(str(tmp_path / 'bag'), '')).splitlines()
    assert lines[1] == 'Files:             bag_0.mcap'
    assert lines[5] == 'Duration:          5.000000000s'
    assert lines[9].startswith('Topic information: Topic: /point')  # sorted by name
    assert lines[10].startswith('                   Topic: /words | Type: std_msgs/msg/String | Count: 5 | Serial')


@pytest.mark.parametrize('storage', STORAGES)
def test_a_bag_is_split(tmp_path, storage):
    bag = write(tmp_path / 'bag', storage, count=6, max_bagfile_duration=3)
    metadata = Info().read_metadata(str(bag), storage)
    assert [each.message_count for each in metadata.files] == [3, 3, 1]
    assert [text for topic, _, text in read(bag) if topic == '/words'] == list('012345')


def test_a_bag_is_compressed(tmp_path):
    plain = write(tmp_path / 'plain', 'mcap', count=2000)
    small = write(tmp_path / 'small', 'mcap', count=2000, storage_preset_profile='zstd_fast')
    assert (small / 'small_0.mcap').stat().st_size < (plain / 'plain_0.mcap').stat().st_size
    assert read(small) == read(plain)


@pytest.mark.parametrize('storage', STORAGES)
@pytest.mark.parametrize('mode', [CompressionMode.FILE, CompressionMode.MESSAGE])
def test_files_and_messages_are_compressed(tmp_path, storage, mode):
    writer = SequentialCompressionWriter(CompressionOptions('zstd', mode))
    bag = write(tmp_path / 'small', storage, count=6, writer=writer, max_bagfile_duration=3)
    names = [f'small_{n}.{ {"mcap": "mcap", "sqlite3": "db3"}[storage] }' for n in range(3)]
    names = [f'{name}.zstd' for name in names] if mode == CompressionMode.FILE else names
    assert sorted(os.listdir(bag)) == ['metadata.yaml', *names]
    metadata = Info().read_metadata(str(bag), storage)
    assert (metadata.compression_format, metadata.compression_mode) == ('zstd', mode.name)
    assert metadata.relative_file_paths == names == [each.path for each in metadata.files]
    expected = read(write(tmp_path / 'plain', storage, count=6))
    assert read(bag) == expected
    with AnyReader([bag]) as reader:  # without these packages
        assert [raw[:2] for *_, raw in reader.messages()] == [b'\0\1'] * 7
    reader = SequentialCompressionReader()
    reader.open(StorageOptions(str(bag), storage), ConverterOptions('', ''))
    assert deserialize_message(reader.read_next()[1], PointStamped).point.x == 1.5
    if mode == CompressionMode.MESSAGE:
        (bag / 'metadata.yaml').unlink()
        assert Reindexer().reindex(StorageOptions(str(bag))).compression_mode == 'MESSAGE'
        assert read(bag) == expected
        assert read(bag / names[0]) == expected[:3]


def test_modes_of_compression_have_names():
    assert get_registered_compressors() == {'zstd'}
    for name in ('NONE', 'FILE', 'MESSAGE'):
        assert compression_mode_from_string(name.lower()) == CompressionMode[name]
        assert compression_mode_to_string(CompressionMode[name]) == name
    with pytest.raises(BagError, match="the compression format 'zip' is not known; there is 'zstd'"):
        SequentialCompressionWriter(CompressionOptions('zip', CompressionMode.FILE))


@pytest.mark.parametrize('storage', STORAGES)
def test_a_bag_is_read_backwards(tmp_path, storage):
    bag = write(tmp_path / 'bag', storage, count=5, max_bagfile_duration=3)
    reader = SequentialReader()
    reader.open_uri(str(bag))
    assert reader.set_read_order(ReadOrder(reverse=True))

    def times():
        found = []
        while reader.has_next():
            found.append(reader.read_next()[2] // 10**9)
        return found

    assert times() == [6, 5, 4, 3, 2, 1]
    reader.seek(4 * 10**9)
    reader.set_filter(StorageFilter(topics=['/words']))
    assert reader.read_next()[2] == 4 * 10**9
    reader.reset_filter()
    assert times() == [3, 2, 1]
    reader.seek(3 * 10**9)
    reader.read_next()
    assert reader.set_read_order(ReadOrder(reverse=False))
    assert times() == [4, 5, 6]
    assert not reader.set_read_order(ReadOrder(ReadOrderSortBy.PublishedTimestamp))


def test_a_pause_of_years_is_read_backwards_at_once(tmp_path):
    writer = SequentialWriter()
    writer.open(StorageOptions(str(tmp_path / 'bag')))
    writer.create_topic(TopicMetadata(0, '/words', 'std_msgs/msg/String', 'cdr'))
    for moment in (0, 1, 10**18):
        writer.write('/words', serialize_message(String()), moment)
    writer.close()
    reader = SequentialReader()
    reader.open_uri(str(tmp_path / 'bag'))
    reader.set_read_order(ReadOrder(reverse=True))
    assert [reader.read_next()[2] for _ in range(3)] == [10**18, 1, 0]


# Writes without end, as a recorder does, and says when the first messages have been flushed.
ENDLESS = """
    import sys, time
    from rclpy.serialization import serialize_message
    from rosbag2_py import SequentialWriter, StorageOptions, TopicMetadata
    from std_msgs.msg import String
    writer = SequentialWriter()
    writer.open(StorageOptions(sys.argv[1], sys.argv[2]))
    writer.create_topic(TopicMetadata(0, '/words', 'std_msgs/msg/String', 'cdr'))
    for number in range(1_000_000):
        writer.write('/words', serialize_message(String(data=str(number))), number)
        if number == 99:
            writer.flush()
            print('flushed', flush=True)
        if number >= int(sys.argv[3]):
            sys.exit()
"""


@pytest.mark.parametrize('storage', STORAGES)
@pytest.mark.parametrize('number', [signal.SIGKILL, signal.SIGTERM])
def test_a_killed_recording_can_be_reindexed(tmp_path, storage, number):
    bag = tmp_path / 'bag'
    process = subprocess.Popen(
        [sys.executable, '-c', textwrap.dedent(ENDLESS), bag, storage, '10000000'], stdout=subprocess.PIPE, text=True
    )
    assert process.stdout.readline() == 'flushed\n'
    process.send_signal(number)
    process.wait(30)
    with pytest.raises(BagError, match='ros2 bag reindex'):
        SequentialReader().open_uri(str(bag))
    metadata = Reindexer().reindex(StorageOptions(str(bag)))
    assert metadata.message_count >= 100
    assert [text for _, _, text in read(bag)] == [str(n) for n in range(metadata.message_count)]
    with AnyReader([bag]) as reader:
        assert reader.message_count == metadata.message_count
    assert Reindexer().reindex(StorageOptions(str(bag))).message_count == metadata.message_count  # again: the same


# Two topics, each in the order of its times, as a recorder on a busy machine may get their messages.
MIXED = """
    import os, sys
    from rclpy.serialization import serialize_message
    from rosbag2_py import CompressionOptions, SequentialCompressionWriter, StorageOptions, TopicMetadata
    from std_msgs.msg import String
    writer = SequentialCompressionWriter(CompressionOptions())
    writer.open(StorageOptions(sys.argv[1], 'mcap', storage_preset_profile=sys.argv[2]))
    for number, topic in enumerate(('/late', '/early')):
        writer.create_topic(TopicMetadata(number, topic, 'std_msgs/msg/String', 'cdr'))
    for moment in range(0, 200, 10):
        writer.write('/late', serialize_message(String(data=f'late {moment}' + 1000 * '-')), moment + 25)
        writer.write('/early', serialize_message(String(data=f'early {moment}')), moment)
        writer.flush()
    os._exit(1)
"""


@pytest.mark.parametrize('profile', ['', 'zstd_fast'])
def test_messages_of_a_killed_recording_may_be_in_any_order(tmp_path, profile):
    bag = tmp_path / 'bag'
    subprocess.run([sys.executable, '-c', textwrap.dedent(MIXED), bag, profile], timeout=60)
    before = (bag / 'bag_0.mcap').stat().st_size
    assert Reindexer().reindex(StorageOptions(str(bag))).message_count == 40
    assert (bag / 'bag_0.mcap').stat().st_size < 1.5 * before and (before < 20_000) == bool(profile)
    assert {path.name for path in bag.iterdir()} == {'bag_0.mcap', 'metadata.yaml'}
    with AnyReader([bag]) as reader:
        moments = [moment for _, moment, _ in reader.messages()]
    assert len(moments) == 40 and moments == sorted(moments)
    assert [round(seconds * 1e9) for _, seconds, _ in read(bag)] == moments


@pytest.mark.parametrize('cut', [1, 9, 40, 400])
def test_a_file_that_was_cut_off_keeps_what_is_whole(tmp_path, cut):
    bag = write(tmp_path / 'bag', 'mcap', count=50)
    file = bag / 'bag_0.mcap'
    os.truncate(file, file.stat().st_size - cut)
    with pytest.raises(BagError, match='reindex'):
        SequentialReader().open_uri(str(file))
    assert Reindexer().reindex(StorageOptions(str(bag))).message_count == 51
    assert len(read(bag)) == 51


def test_a_program_that_ends_without_close_leaves_a_whole_bag(tmp_path):
    subprocess.run(
        [sys.executable, '-c', textwrap.dedent(ENDLESS), tmp_path / 'bag', 'mcap', '200'],
        check=True,
        capture_output=True,
    )
    assert len(read(tmp_path / 'bag')) == 201


def test_what_cannot_be_is_said(tmp_path):
    writer = SequentialWriter()
    with pytest.raises(BagError, match='not open'):
        writer.write('/words', b'', 0)
    with pytest.raises(BagError, match="the storage 'tape' is not known; there are mcap, sqlite3"):
        writer.open(StorageOptions(str(tmp_path / 'bag'), 'tape'))
    with pytest.raises(BagError, match='Snapshot mode is not available: .* is one of rosbag2_interfaces'):
        writer.open(StorageOptions(str(tmp_path / 'bag'), snapshot_mode=True))
    writer.open(StorageOptions(str(tmp_path / 'bag')))
    with pytest.raises(BagError, match='create_topic'):
        writer.write('/words', b'', 0)
    for storage, size in (('mcap', 1023), ('sqlite3', 50_000)):
        with pytest.raises(BagError, match=rf'Please provide a value greater than \d+\. Specified value of {size}'):
            SequentialWriter().open(StorageOptions(str(tmp_path / 'small'), storage, max_bagfile_size=size))
    assert not (tmp_path / 'small').exists()
    for method in ('has_next', 'read_next'):
        with pytest.raises(BagError, match='not open'):
            getattr(SequentialReader(), method)()
    with pytest.raises(BagError, match='exists already'):
        SequentialWriter().open(StorageOptions(str(tmp_path / 'bag')))
    with pytest.raises(BagError, match='does not exist'):
        SequentialReader().open_uri(str(tmp_path / 'nothing'))
    (tmp_path / 'text.txt').touch()
    with pytest.raises(BagError, match='is no bag'):
        SequentialReader().open_uri(str(tmp_path / 'text.txt'))
    with pytest.raises(BagError, match='has no .mcap or .db3 file'):
        Reindexer().reindex(StorageOptions(str(tmp_path)))


def test_a_program_records_and_plays_until_it_is_cancelled(tmp_path, peer):
    """Player and Recorder in threads of a program, as upstream's programs use them."""
    publisher, heard, bag = peer.node.create_publisher(String, '/words', 10), [], str(tmp_path / 'bag')
    options = RecordOptions(topics=['/words'], topic_polling_interval=timedelta(milliseconds=10))
    recorder = Recorder()
    recording = threading.Thread(target=recorder.record, args=(StorageOptions(bag), options), daemon=True)
    recording.start()
    peer.until(publisher.get_subscription_count, 'the recorder')
    file = tmp_path / 'bag' / 'bag_0.mcap'
    before = file.stat().st_size
    timer = peer.node.create_timer(0.02, lambda: publisher.publish(String(data='word')))
    peer.until(lambda: file.stat().st_size > before + 100, 'words in the file')
    timer.cancel()
    recorder.cancel()
    recording.join(PATIENCE)
    assert not recording.is_alive()
    assert MetadataIo().read_metadata(bag).message_count > 0
    options = PlayOptions(loop=True, topic_remapping_options=['--ros-args', '--remap', '/words:=/again'])
    peer.node.create_subscription(String, '/again', heard.append, 10)
    player = Player()
    playing = threading.Thread(target=player.play, args=(StorageOptions(bag), options), daemon=True)
    playing.start()
    peer.until(lambda: heard, 'a word')
    player.cancel()
    playing.join(PATIENCE)
    assert not playing.is_alive()
    for number in (1, 0):  # one message, and all of them
        Player().burst(StorageOptions(bag), PlayOptions(), number)
    with pytest.raises(RuntimeError, match="the log level 'xxx' is not known"):
        Player('xxx')


def test_bags_are_written_anew(tmp_path):
    """Two bags become one that is compressed, and one with a part."""
    first, second = write(tmp_path / 'first', 'mcap'), write(tmp_path / 'second', 'sqlite3', count=2)
    whole, part, options = tmp_path / 'whole', tmp_path / 'part', tmp_path / 'options.yaml'
    bags = [
        {'uri': str(whole), 'storage_id': 'sqlite3', 'all_topics': True, 'compression_mode': 'file'},
        {'uri': str(part), 'all_topics': True, 'exclude': 'point', 'max_bagfile_duration': 3},
    ]
    bags[0]['compression_format'] = 'zstd'
    options.write_text(yaml.safe_dump({'output_bags': bags}))
    bag_rewrite([StorageOptions(str(first)), StorageOptions(str(second), 'sqlite3')], str(options))
    assert read(whole) == sorted(read(first) + read(second), key=lambda message: message[1])
    assert sorted(os.listdir(whole)) == ['metadata.yaml', 'whole_0.db3.zstd']
    assert {topic for topic, *_ in read(part)} == {'/words'} and len(read(part)) == 7
    assert sorted(os.listdir(part)) == ['metadata.yaml', 'part_0.mcap', 'part_1.mcap']


@pytest.mark.parametrize(
    'text,said',
    [
        ('- key: value', "must have the key 'output_bags'"),
        ('output_bags: {key: value}', "must have the key 'output_bags'"),
        ('output_bags: [', 'is not valid YAML'),
        ('output_bags: [{topics: [a]}]', "needs a 'uri'"),
        ('output_bags: [{uri: x, colour: red}]', "'colour' is no option of a bag"),
        ('output_bags: [{uri: x, topics: a}]', "'topics' must be a list, not 'a'"),
    ],
)
def test_what_shall_be_written_is_checked(tmp_path, text, said):
    (tmp_path / 'options.yaml').write_text(text)
    with pytest.raises(RuntimeError, match=said):
        bag_rewrite([], str(tmp_path / 'options.yaml'))


def test_what_has_come_is_handled_at_the_end_though_nobody_has_spun():
    heard = []
    with running.RunningNode('keeper') as keeper:
        publisher = keeper.node.create_publisher(String, 'words', 50)
        keeper.node.create_subscription(String, 'words', heard.append, 50)
        keeper.spin(until=publisher.get_subscription_count, timeout=10)
        for number in range(30):
            publisher.publish(String(data=str(number)))
        assert publisher.wait_for_all_acked(Duration(seconds=10))
        keeper.spin_ready(lambda: len(heard), timeout=10)
    assert [message.data for message in heard] == [str(number) for number in range(30)]
