"""The command `ros2 bag`: what is recorded is played, and what is printed is what stock prints."""

import ast
import os
import signal
import time
from argparse import ArgumentParser
from pathlib import Path

import pytest
import rclpy
import yaml
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy
from rclpy.serialization import serialize_message
from ros2bag.api import convert_yaml_to_qos_profile
from ros2bag.verb.record import add_recorder_arguments, validate_parsed_arguments
from rosbag2_py import Info, SequentialReader, SequentialWriter, StorageOptions, TopicMetadata
from rosbags.highlevel import AnyReader
from rosgraph_msgs.msg import Clock
from service_msgs.msg import ServiceEventInfo
from std_msgs.msg import Int32, String
from std_srvs.srv import SetBool

from environment.tests.running import PATIENCE, ROS2


class Listener:
    """A node that hears topics, with the times at which their messages came."""

    def __init__(self, ros2):
        self.context = rclpy.Context()
        rclpy.init(context=self.context, domain_id=int(ros2.environ['ROS_DOMAIN_ID']))
        self.node = rclpy.create_node('listener', context=self.context)
        self.executor = SingleThreadedExecutor(context=self.context)
        self.executor.add_node(self.node)

    def hear(self, kind, topic, qos=100):
        """Return a list of (time, message)."""
        heard = []
        self.node.create_subscription(kind, topic, lambda m: heard.append((time.monotonic(), m)), qos)
        return heard

    def until(self, condition, what, timeout=PATIENCE):
        """Spin until the condition holds."""
        end = time.monotonic() + timeout
        while not condition():
            assert time.monotonic() < end, f'waited {timeout} s in vain: {what}'
            self.executor.spin_once(timeout_sec=0.05)

    def close(self):
        """Leave the graph."""
        self.executor.shutdown()
        self.node.destroy_node()
        self.context.try_shutdown()


@pytest.fixture
def listener(ros2):
    """A :class:`Listener` in the domain of the command."""
    one = Listener(ros2)
    yield one
    one.close()


@pytest.fixture
def numbers(ros2):
    """A bag with the numbers 0 to 9 on /number, a tenth of a second apart, and a word after 0.55 s."""
    path = ros2.directory / 'numbers'
    if not path.exists():
        writer = SequentialWriter()
        writer.open(StorageOptions(str(path), 'mcap'))
        writer.create_topic(TopicMetadata(0, '/number', 'std_msgs/msg/Int32', 'cdr'))
        writer.create_topic(TopicMetadata(1, '/word', 'std_msgs/msg/String', 'cdr'))
        start = 1_700_000_000_000_000_000
        for n in range(10):
            writer.write('/number', serialize_message(Int32(data=n)), start + n * 100_000_000)
            if n == 5:
                writer.write('/word', serialize_message(String(data='half')), start + 550_000_000)
        writer.close()
    return str(path)


def ended(process):
    """Wait for the end of a process; its status."""
    end = time.monotonic() + PATIENCE
    while process.running:
        assert time.monotonic() < end, 'the process goes on'
        time.sleep(0.02)
    return process.returncode


def topics_of(bag):
    """The number of messages by topic."""
    reader = SequentialReader()
    reader.open_uri(str(bag))
    counts = {each.topic_metadata.name: each.message_count for each in reader.get_metadata().topics_with_message_count}
    reader.close()
    return counts


@pytest.mark.parametrize('storage', ['mcap', 'sqlite3'])
def test_record_and_info(ros2, storage):
    with ros2.start('topic', 'pub', '-r', '50', '/chatter', 'std_msgs/msg/String', '{data: hello}'):
        with ros2.start('bag', 'record', '-o', f'talk_{storage}', '-s', storage, '--topics', '/chatter') as recorder:
            recorder.wait_for_output("Subscribed to topic '/chatter'", PATIENCE)
            file = ros2.directory / f'talk_{storage}' / f'talk_{storage}_0.{"mcap" if storage == "mcap" else "db3"}'
            small = file.stat().st_size
            end = time.monotonic() + PATIENCE
            while file.stat().st_size <= small:  # a second's messages have been written
                assert time.monotonic() < end, 'nothing was written'
                time.sleep(0.05)
            assert recorder.stop(PATIENCE) == 0
            printed = [line.partition(': ')[2] for line in recorder.lines]
    assert printed[:3] == ['Press SPACE for pausing/resuming', 'Listening for topics...', 'Recording...']
    assert printed[3:] == [
        "Subscribed to topic '/chatter'",
        'All requested topics are subscribed. Stopping discovery...',
        'Recording stopped',
    ]
    lines = ros2.lines('bag', 'info', f'talk_{storage}')
    names = [
        'Files',
        'Bag size',
        'Storage id',
        'ROS Distro',
        'Duration',
        'Start',
        'End',
        'Messages',
        'Topic information',
        'Service',
        'Service information',
    ]
    assert [line.partition(':')[0] for line in lines if line] == names
    assert lines[3] == f'Storage id:        {storage}'
    count = topics_of(ros2.directory / f'talk_{storage}')['/chatter']
    assert count > 10
    assert lines[9] == (
        f'Topic information: Topic: /chatter | Type: std_msgs/msg/String | Count: {count} | Serialization Format: cdr'
    )
    more = ros2.lines('bag', 'info', '-v', '--sort', 'count', f'talk_{storage}')
    assert f'| Count: {count} | Size Contribution: ' in more[9] and more[:9] == lines[:9]


def test_record_all_but_some(ros2):
    with (
        ros2.start('topic', 'pub', '-r', '50', '/one', 'std_msgs/msg/String', '{}'),
        ros2.start('topic', 'pub', '-r', '50', '/two', 'std_msgs/msg/String', '{}'),
        ros2.start('topic', 'pub', '-r', '50', '/_hidden', 'std_msgs/msg/String', '{}'),
    ):
        for name, options in {
            'all': ['-a', '-x', 'rosout|parameter'],
            'regex': ['-e', '^/(one|two)$', '--exclude-topics', '/two'],
            'type': ['--topic-types', 'std_msgs/msg/String'],
        }.items():
            with ros2.start('bag', 'record', '-o', f'some_{name}', '--disable-keyboard-controls', *options) as recorder:
                recorder.wait_for_output("Subscribed to topic '/one'", PATIENCE)
                if name != 'regex':
                    recorder.wait_for_output("Subscribed to topic '/two'", PATIENCE)
                assert recorder.stop(PATIENCE) == 0
    assert set(topics_of(ros2.directory / 'some_all')) == {'/one', '/two'}
    assert set(topics_of(ros2.directory / 'some_regex')) == {'/one'}
    assert set(topics_of(ros2.directory / 'some_type')) == {'/one', '/two'}


@pytest.mark.parametrize('storage,ending', [('mcap', 'mcap'), ('sqlite3', 'db3')])
def test_a_killed_recording_is_reindexed(ros2, storage, ending):
    bag = ros2.directory / f'killed_{storage}'
    with ros2.start('topic', 'pub', '-r', '50', '/chatter', 'std_msgs/msg/String', '{data: hello}'):
        with ros2.start('bag', 'record', '-s', storage, '-o', bag.name, '-a') as recorder:
            recorder.wait_for_output("Subscribed to topic '/chatter'", PATIENCE)
            file = bag / f'{bag.name}_0.{ending}'
            small, end = file.stat().st_size, time.monotonic() + PATIENCE
            while file.stat().st_size < small + 1000:
                assert time.monotonic() < end, 'nothing was written'
                time.sleep(0.05)
            os.kill(recorder.pid, signal.SIGKILL)
            ended(recorder)
    assert f'run: ros2 bag reindex {bag.name}' in ros2.error('bag', 'info', bag.name)
    done = ros2.run('bag', 'reindex', bag.name)
    assert done.returncode == 0 and 'Reindexing complete.' in done.stderr
    count = topics_of(bag)['/chatter']
    assert count > 0
    assert f'Topic: /chatter | Type: std_msgs/msg/String | Count: {count} |' in ros2.output('bag', 'info', bag.name)
    with AnyReader([bag]) as reader:  # without these packages
        assert sum(connection.topic == '/chatter' for connection, *_ in reader.messages()) == count
    with ros2.start('topic', 'echo', '/chatter', 'std_msgs/msg/String') as echo:
        played = ros2.run(
            'bag', 'play', bag.name, '--topics', '/chatter', '--disable-keyboard-controls', '--delay', '2'
        )
        assert played.returncode == 0
        echo.wait_for_output('data: hello', PATIENCE)


def test_record_compressed(ros2):
    with ros2.start('topic', 'pub', '-r', '50', '/chatter', 'std_msgs/msg/String', '{data: hello}'):
        for mode, file in (('file', 'small_file_0.mcap.zstd'), ('message', 'small_message_0.mcap')):
            bag = ros2.directory / f'small_{mode}'
            options = ('--compression-mode', mode, '--compression-format', 'zstd')
            with ros2.start('bag', 'record', '-o', bag.name, '--topics', '/chatter', *options) as recorder:
                recorder.wait_for_output("Subscribed to topic '/chatter'", PATIENCE)
                before, end = (bag / f'{bag.name}_0.mcap').stat().st_size, time.monotonic() + PATIENCE
                while (bag / f'{bag.name}_0.mcap').stat().st_size <= before:
                    assert time.monotonic() < end, 'nothing was written'
                    time.sleep(0.05)
                assert recorder.stop(PATIENCE) == 0
            assert sorted(os.listdir(bag)) == sorted([file, 'metadata.yaml'])
            assert topics_of(bag)['/chatter'] > 0


def test_convert(ros2, numbers):
    (ros2.directory / 'out.yaml').write_text('output_bags: [{uri: converted, storage_id: sqlite3, topics: [/number]}]')
    assert ros2.output('bag', 'convert', '-i', numbers, '-o', 'out.yaml') == ''
    assert topics_of(ros2.directory / 'converted') == {'/number': 10}
    assert ros2.error('bag', 'convert', '-i', 'nothing', '-o', 'out.yaml') == (
        "[ERROR] [ros2bag]: Bag path 'nothing' does not exist!"
    )
    assert "the storage 'tape' is not known" in ros2.error('bag', 'convert', '-i', numbers, 'tape', '-o', 'out.yaml')


def test_several_bags_are_played_as_one(ros2, listener, numbers):
    path = ros2.directory / 'between'
    writer = SequentialWriter()
    writer.open(StorageOptions(str(path), 'sqlite3'))
    writer.create_topic(TopicMetadata(0, '/number', 'std_msgs/msg/Int32', 'cdr'))
    begin = Info().read_metadata(str(ros2.directory / numbers)).starting_time.nanoseconds
    for number in (100, 101):
        writer.write('/number', serialize_message(Int32(data=number)), begin + (number - 100) * 10**9 + 10**8 // 2)
    writer.close()
    heard = listener.hear(Int32, '/number')
    bags = ('-i', numbers, 'mcap', '-i', 'between')
    assert (
        ros2.run(
            'bag', 'play', *bags, '-r', '5', '-d', '2', '--disable-keyboard-controls', '--disable-loan-message'
        ).returncode
        == 0
    )
    listener.until(lambda: len(heard) >= 12, 'twelve numbers')
    assert [message.data for _, message in heard] == [0, 100, *range(1, 10), 101]
    assert 'do not mix the [bag_path] positional argument and the -i' in ros2.error('bag', 'play', 'between', *bags)
    assert 'no bag is given' in ros2.error('bag', 'play')
    assert ros2.error('bag', 'play', '-i', 'nothing') == "[ERROR] [ros2bag]: Bag path 'nothing' does not exist!"
    assert "the storage 'tape' is not known" in ros2.error('bag', 'play', '-i', 'between', 'tape')


def test_play_keeps_the_pace(ros2, listener, numbers):
    heard = listener.hear(Int32, '/number')
    with ros2.start('bag', 'play', numbers, '-d', '1', '-r', '0.5') as player:
        listener.until(lambda: len(heard) == 10, 'ten numbers')
        assert ended(player) == 0
        assert [line.partition(': ')[2] for line in player.lines][:3] == [
            'Set rate to 0.5',
            'Adding keyboard callbacks.',
            'Press SPACE for Pause/Resume',
        ]
    assert [message.data for _, message in heard] == list(range(10))
    assert heard[-1][0] - heard[0][0] == pytest.approx(1.8, abs=0.7)  # 0.9 s at half the pace


def test_play_obeys_its_keys(ros2, terminal, numbers):
    player = terminal(ROS2, 'bag', 'play', str(ros2.directory / numbers), '--start-paused')
    player.read_until('Playback until')
    for key, said in (
        ('\x1b[C ', 'Resuming play.'),  # plays the next message, without a word; and two keys at one time
        ('\x1b[C', 'Called play next, but not in paused state.'),
        (' ', 'Pausing play.'),
        ('\x1b[A', 'Set rate to 1.1'),
        (' ', 'Resuming play.'),
    ):
        player.press(key)
        player.read_until(said)
        assert said == 'Called play next, but not in paused state.' or 'Called' not in player.text
        player.text = ''
    assert player.wait() == 0


def test_play_a_part_under_another_name_with_a_clock(ros2, listener, numbers):
    other, old, words = (listener.hear(*each) for each in ((Int32, '/other'), (Int32, '/number'), (String, '/word')))
    clock = listener.hear(Clock, '/clock')
    with ros2.start(
        'bag',
        'play',
        numbers,
        '-d',
        '1',
        '--start-offset',
        '0.45',
        '--remap',
        '/number:=/other',
        '--topics',
        '/number',
        '--clock',
        '50',
        '--disable-keyboard-controls',
    ) as player:
        listener.until(lambda: len(other) == 5, 'five numbers')
        assert ended(player) == 0
    assert [message.data for _, message in other] == [5, 6, 7, 8, 9]
    assert (old, words) == ([], [])
    times = [message.clock.sec * 10**9 + message.clock.nanosec - 1_700_000_000_000_000_000 for _, message in clock]
    assert len(times) > 5 and times == sorted(times)
    assert times[0] == pytest.approx(450_000_000, abs=100_000_000)


@pytest.mark.parametrize('options,triggers', [(['--clock-topics-all'], 11), (['--clock-topics', '/word'], 1)])
def test_messages_set_the_clock(ros2, listener, numbers, options, triggers):
    clock, words = listener.hear(Clock, '/clock'), listener.hear(String, '/word')
    with ros2.start('bag', 'play', numbers, '-d', '1', '-r', '10', *options) as player:
        listener.until(lambda: len(clock) >= triggers and words, 'the clock')
        assert ended(player) == 0
    times = [message.clock.nanosec for _, message in clock]
    assert len(times) == triggers and 550_000_000 in times


def test_a_burst_comes_at_once_and_the_rest_after_a_pause(ros2, listener, numbers):
    latched = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)  # heard whenever the reader is found
    (ros2.directory / 'latched.yaml').write_text('/number: {durability: transient_local, depth: 100}')
    heard = listener.hear(Int32, '/number', latched)
    options = ['--topics', '/number', '--qos-profile-overrides-path', 'latched.yaml']
    with ros2.start('bag', 'burst', numbers, '--num-messages', '3', *options) as player:
        listener.until(lambda: len(heard) == 3, 'three numbers')
        assert player.running
        assert player.stop(PATIENCE) == 0
    assert [message.data for _, message in heard] == [0, 1, 2]
    assert ros2.run('bag', 'burst', numbers).returncode == 0  # all of them, and no pause


def test_plugins_are_listed(ros2):
    assert ros2.lines('bag', 'list', 'storage') == ['mcap', 'sqlite3']
    assert ros2.lines('bag', 'list', 'compression') == ros2.lines('bag', 'list', 'decompression') == ['zstd']
    assert ros2.lines('bag', 'list', 'converter') == []
    verbose = ros2.lines('bag', 'list', 'storage', '--verbose')
    assert verbose[:2] == ['available storage plugins are:', 'name: mcap'] and len(verbose) == 9
    assert 'the following arguments are required: plugin_type' in ros2.error('bag', 'list', status=2)


def test_play_in_a_loop_until_interrupted(ros2, listener, numbers):
    heard = listener.hear(Int32, '/number')
    with ros2.start('bag', 'play', numbers, '-l', '-r', '10', '--playback-duration', '0.25') as player:
        listener.until(lambda: len(heard) >= 9, 'three rounds')
        assert player.stop(PATIENCE) == 0
    data = [message.data for _, message in heard]
    assert set(data) == {0, 1, 2} and data.count(0) >= 2


def test_requests_of_a_service_are_recorded_and_sent_again(ros2, node, listener):
    """Managing service data, of the tutorial on recording."""
    node('introspected')
    with ros2.start('bag', 'record', '-o', 'services', '--service', '/watched') as recorder:
        recorder.wait_for_output("Subscribed to topic '/watched/_service_event'", PATIENCE)
        ros2.output('service', 'call', '/watched', 'std_srvs/srv/SetBool', '{data: true}')
        assert recorder.stop(PATIENCE) == 0
    told = ros2.output('bag', 'info', 'services')
    assert 'Service: /watched | Type: std_srvs/srv/SetBool | Event Count: 2 | Serialization Format: cdr' in told
    assert 'Request Count: 1 | Response Count: 1 | Size Contribution: ' in ros2.output('bag', 'info', '-v', 'services')
    assert not ros2.output('bag', 'info', '-t', 'services')
    events = listener.hear(SetBool.Event, '/watched/_service_event')
    play = ('bag', 'play', 'services', '--disable-keyboard-controls', '--publish-service-requests')
    assert ros2.run(*play, '--service-requests-source', 'client_introspection').returncode == 0  # it was not recorded
    assert ros2.run(*play, '--exclude-services', '/watched').returncode == 0
    assert ros2.run(*play, '--services', '/watched').returncode == 0
    listener.until(lambda: len(events) >= 2, 'a request and its answer')
    (request, answer) = (event for _, event in events)
    assert (request.info.event_type, request.request[0].data) == (ServiceEventInfo.REQUEST_RECEIVED, True)
    assert (answer.info.event_type, answer.response[0].success) == (ServiceEventInfo.RESPONSE_SENT, True)


def test_requests_that_nobody_serves_are_told(ros2, tmp_path):
    bag = tmp_path / 'bag'
    event = SetBool.Event(
        info=ServiceEventInfo(event_type=ServiceEventInfo.REQUEST_RECEIVED), request=[SetBool.Request(data=True)]
    )
    writer = SequentialWriter()
    writer.open(StorageOptions(str(bag), 'mcap'))
    writer.create_topic(TopicMetadata(0, '/nobody/_service_event', 'std_srvs/srv/SetBool_Event', 'cdr'))
    writer.write('/nobody/_service_event', serialize_message(event), 10**9)
    writer.close()
    played = ros2.run('bag', 'play', str(bag), '--disable-keyboard-controls', '--publish-service-requests')
    assert played.returncode == 0
    assert "Service request hasn't been sent. The '/nobody' service isn't ready !" in played.stderr


def test_a_latched_topic_is_played_latched(ros2, listener, tmp_path):
    overrides = tmp_path / 'qos.yaml'
    overrides.write_text(yaml.safe_dump({'/latched': {'durability': 'transient_local', 'depth': 1}}))
    with ros2.start(
        'topic',
        'pub',
        '--qos-durability',
        'transient_local',
        '-r',
        '20',
        '/latched',
        'std_msgs/msg/String',
        '{data: kept}',
    ):
        with ros2.start(
            'bag', 'record', '-o', 'latched', '--topics', '/latched', '--qos-profile-overrides-path', str(overrides)
        ) as recorder:
            recorder.wait_for_output("Subscribed to topic '/latched'", PATIENCE)
            assert recorder.stop(PATIENCE) == 0
    content = yaml.safe_load((ros2.directory / 'latched' / 'metadata.yaml').read_text())
    topic = content['rosbag2_bagfile_information']['topics_with_message_count'][0]['topic_metadata']
    assert topic['offered_qos_profiles'][0]['durability'] == 'transient_local'


def test_wrong_usage_is_said(ros2, numbers, tmp_path):
    assert ros2.error('bag', 'record').startswith('[ERROR] [ros2bag]: Need to specify at least one option out of')
    assert ros2.error('bag', 'record', '-a', '-o', numbers) == (
        f"[ERROR] [ros2bag]: Output folder '{numbers}' already exists."
    )
    for options, said in (
        (
            ['--topics', '/a', '--exclude-topics', '/b'],
            '--exclude-topics argument requires either --all, --all-topics,',
        ),
        (['--topics', '/a', '-x', 'b'], '--exclude-regex argument requires either --all, --all-topics, --topic-types,'),
        (['--all', '--compression-format', 'zstd'], 'Invalid choice: Cannot specify compression format without a'),
        (['--all', '--compression-mode', 'file'], "the compression format '' is not known; there is 'zstd'"),
        (['--all', '--snapshot-mode'], 'Snapshot mode is not available: the service that takes a snapshot is one of'),
        (['--all', '--use-sim-time', '--no-discovery'], '--use-sim-time and --no-discovery both set, but are'),
    ):
        assert ros2.error('bag', 'record', *options).splitlines()[-1].startswith(f'[ERROR] [ros2bag]: {said}')
    for verb in ('record', 'play', 'burst'):
        assert 'offers no services such as ~/pause' in ' '.join(ros2.output('bag', verb, '-h').split())
    assert 'not a valid regular expression' in ros2.error('bag', 'record', '-e', '[')
    for verb in ('info', 'play', 'reindex'):
        assert "Bag path 'nothing' does not exist!" in ros2.error('bag', verb, 'nothing', status=2)
    assert 'no remapping' in ros2.error('bag', 'play', numbers, '--remap', 'x')
    assert ros2.error('bag', 'play', numbers, '-r', '0', status=2).endswith('0 is not in the valid range (> 0.0)')
    (ros2.directory / 'empty').mkdir(exist_ok=True)
    assert 'has no .mcap or .db3 file' in ros2.run('bag', 'reindex', 'empty').stderr


@pytest.mark.parametrize(
    'policies, said',
    [
        ('{reliability: perhaps}', '`perhaps` is no value of `reliability`; possible are system_default, reliable,'),
        ('{deadline: {sec: 1}}', 'Time overrides must include both seconds (sec) and nanoseconds (nsec).'),
        ('{depth: 1, lifespan: {sec: -1, nsec: 0}}', 'Time duration may not be a negative value.'),
        ('{depth: -1}', '`depth` may not be a negative value.'),
        ('{foo: bar}', 'Unexpected key `foo` for QoS profile.'),
        ('{durability: volatile}', 'History and/or depth settings are required.'),
        ('[]', 'a file of QoS overrides is a mapping from each topic to its policies'),
        ('{', 'is not valid YAML: '),
    ],
)
def test_overrides_that_are_no_profiles_are_refused(ros2, tmp_path, policies, said):
    wrong = tmp_path / 'qos.yaml'
    wrong.write_text(f'/chatter: {policies}')
    error = ros2.error('bag', 'record', '-a', '--qos-profile-overrides-path', str(wrong))
    assert error.startswith('[ERROR] [ros2bag]: ') and said in error


@pytest.mark.parametrize('verb', ['record', 'play'])
def test_overrides_that_cannot_be_opened_are_a_wrong_argument(ros2, verb):
    words = ['-a'] if verb == 'record' else ['.']
    error = ros2.error('bag', verb, '--qos-profile-overrides-path', 'nowhere.yaml', *words, status=2)
    refused = f"ros2 bag {verb}: error: argument --qos-profile-overrides-path: can't open 'nowhere.yaml'"
    assert error.splitlines()[-1].startswith(refused)


def test_overrides_become_profiles_by_upstreams_names():
    profiles = convert_yaml_to_qos_profile(
        {
            '/a': {'history': 'keep_all', 'reliability': 'best_effort', 'deadline': {'sec': 1, 'nsec': 2}},
            '/b': {'depth': 3, 'avoid_ros_namespace_conventions': True, 'lifespan': None},
        }
    )
    assert profiles['/a'].history == HistoryPolicy.KEEP_ALL
    assert profiles['/a'].reliability == ReliabilityPolicy.BEST_EFFORT
    assert profiles['/a'].deadline.nanoseconds == 1_000_000_002
    assert (profiles['/b'].depth, profiles['/b'].avoid_ros_namespace_conventions) == (3, True)
    assert profiles['/b'].lifespan.nanoseconds == 0


def test_arguments_are_parsed_and_validated_by_upstreams_functions(tmp_path, capsys):
    parser = ArgumentParser()
    add_recorder_arguments(parser)
    args = parser.parse_args(['--services', 's1', 's2', '--topics', '/a', '/b', '--output', 'out'])
    assert (args.services, args.topics, args.output) == (['s1', 's2'], ['/a', '/b'], 'out')
    assert validate_parsed_arguments(args, tmp_path / 'new') is None and capsys.readouterr().out == ''
    args = parser.parse_args(['/a', '/b'])
    assert validate_parsed_arguments(args, tmp_path / 'new') is None and args.topics == ['/a', '/b']
    assert 'Positional "topics" argument deprecated.' in capsys.readouterr().out
    said = validate_parsed_arguments(args, tmp_path)
    assert said == f"[ERROR] [ros2bag]: Output folder '{tmp_path}' already exists."
    args = parser.parse_args(['--exclude-services', 's1', '--services', 's1', '--all-topics'])
    said = '--exclude-services argument requires either --all, --all-services or --regex'
    assert validate_parsed_arguments(args, tmp_path / 'new') == f'[ERROR] [ros2bag]: {said}'


def test_it_needs_of_ros2cli_only_what_upstreams_has():
    """Upstream's ros2cli may be overlaid from a workspace, without ros2bag."""
    import ros2bag

    names = {
        (node.module, name.name)
        for file in Path(ros2bag.__file__).parent.rglob('*.py')
        for node in ast.walk(ast.parse(file.read_text()))
        if isinstance(node, ast.ImportFrom)
        for name in node.names
        if node.module.startswith('ros2cli')
    }
    assert names == {('ros2cli.command', 'CommandExtension'), ('ros2cli.command', 'add_subparsers_on_demand')}
