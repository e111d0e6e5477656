"""A program plays and records bags, and controls it while it goes on."""

import time
from datetime import timedelta
from itertools import pairwise
from pathlib import Path

import pytest
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.serialization import serialize_message
from rosbag2_py import (
    BagError,
    ConverterOptions,
    MetadataIo,
    Player,
    PlayOptions,
    Recorder,
    RecordOptions,
    SequentialReader,
    SequentialWriter,
    ServiceRequestsSource,
    StorageOptions,
    TopicMetadata,
)
from rosbag2_py.recorder import Recording
from std_msgs.msg import String

from environment.tests.running import PATIENCE

SECOND = 1_000_000_000
LATCHED = QoSProfile(depth=20, durability=DurabilityPolicy.TRANSIENT_LOCAL)  # no word is lost before all is connected


@pytest.fixture
def bag(tmp_path):
    """The words 0 to 4 at the seconds 1 to 5."""
    writer = SequentialWriter()
    writer.open(StorageOptions(str(tmp_path / 'bag')), ConverterOptions())
    writer.create_topic(TopicMetadata(0, '/words', 'std_msgs/msg/String', 'cdr', [LATCHED]))
    for number in range(5):
        writer.write('/words', serialize_message(String(data=str(number))), (1 + number) * SECOND)
    writer.close()
    return StorageOptions(str(tmp_path / 'bag'))


@pytest.fixture
def listen(peer):
    """A function that waits until the words so far are those given."""
    heard = []
    peer.node.create_subscription(String, '/words', lambda message: heard.append(message.data), LATCHED)

    def check(*words):
        peer.until(lambda: len(heard) >= len(words), f'the words {words}')
        assert heard == list(words)

    return check


def test_a_paused_player_plays_what_it_is_told(bag, listen):
    player = Player(bag, PlayOptions(start_paused=True), node_name='jukebox')
    assert (player.get_starting_time(), player.get_playback_duration()) == (SECOND, 4 * SECOND)
    player.start_spin()
    player.play()
    assert player.wait_for_playback_to_start(timeout=PATIENCE) and player.is_paused()
    assert not player.wait_for_playback_to_finish(timeout=0.0)
    assert player.play_next() is True
    listen('0')
    assert player.burst(2) == 2
    listen('0', '1', '2')
    player.seek(5 * SECOND)
    assert player.play_next()
    listen('0', '1', '2', '4')
    assert not player.play_next() and player.burst(num_messages=3) == 0
    assert player.wait_for_playback_to_finish(timeout=PATIENCE)
    player.play()  # again from the beginning
    player.seek(2 * SECOND)
    assert player.burst(0) == 4
    listen('0', '1', '2', '4', '1', '2', '3', '4')
    player.stop_spin()


def test_a_player_is_paused_resumed_and_stopped(bag, listen):
    player = Player([bag], PlayOptions(rate=0.001))
    player.play()
    listen('0')
    player.play()  # it is being played: nothing happens
    assert player.play_next() is False and player.burst(1) == 0  # only while it is paused
    player.pause()
    assert player.is_paused()
    player.seek(4 * SECOND)
    player.resume()
    assert not player.is_paused()
    listen('0', '3')
    player.stop()
    assert player.wait_for_playback_to_finish(timeout=0.0)
    player.seek(0)
    player.play()
    listen('0', '3', '0')
    player.stop()


def test_a_recorder_is_paused_and_stopped(tmp_path, peer):
    publisher, bag = peer.node.create_publisher(String, '/words', 10), tmp_path / 'new'
    options = RecordOptions(topics=['/words'], topic_polling_interval=timedelta(milliseconds=10), start_paused=True)
    recorder = Recorder(StorageOptions(str(bag)), options, 'warn', 'scribe')
    assert recorder.is_paused() and not bag.exists()
    recorder.start_spin()
    recorder.record()
    peer.until(publisher.get_subscription_count, 'the recorder')
    peer.until(lambda: ('scribe', '/') in peer.node.get_node_names_and_namespaces(), 'its node')
    publisher.publish(String(data='left out'))
    assert publisher.wait_for_all_acked()
    recorder.resume()
    assert not recorder.is_paused()
    recorder.record()  # it is being recorded: nothing happens
    file = Path(bag, 'new_0.mcap')
    before = file.stat().st_size
    timer = peer.node.create_timer(0.02, lambda: publisher.publish(String(data='word')))
    peer.until(lambda: file.stat().st_size > before + 100, 'words in the file')
    recorder.pause()
    timer.cancel()
    recorder.stop()
    recorder.stop_spin()
    assert MetadataIo().read_metadata(str(bag)).message_count > 0
    with pytest.raises(BagError, match='exists already'):
        recorder.record()


def test_the_stamp_is_when_a_message_came(tmp_path, peer):
    """A recorder that has other things to do meanwhile tells the same distances: rosbag2's pull request 1531."""
    node, publisher = peer.node, peer.node.create_publisher(String, '/words', LATCHED)
    writer, failures = SequentialWriter(), []
    writer.open(StorageOptions(str(tmp_path / 'bag')), ConverterOptions())
    recording = Recording(node, writer, RecordOptions(topics=['/words']), failures.append)
    peer.until(lambda: node.count_publishers('/words'), 'the publisher in the graph')
    recording.look()
    begin = time.time_ns()
    peer.until(publisher.get_subscription_count, 'the recorder')
    for word in ('first', 'second', 'third'):
        publisher.publish(String(data=word))
        assert publisher.wait_for_all_acked()  # it has come, and nobody spins
        time.sleep(0.2)  # no wait for anything: the distance that is to be recorded
    end = time.time_ns()
    peer.until(lambda: recording.written == 3, 'three messages')
    writer.close()
    reader = SequentialReader()
    reader.open(StorageOptions(str(tmp_path / 'bag')), ConverterOptions())
    stamps = [reader.read_next()[2] for _ in range(3)]
    assert not failures and begin <= stamps[0] and stamps[2] <= end
    assert all(later - earlier > 0.15 * SECOND for earlier, later in pairwise(stamps))


@pytest.mark.parametrize(
    'act',
    ['play', 'stop', 'pause', 'resume', 'is_paused', 'play_next', 'get_starting_time', 'wait_for_playback_to_start'],
)
def test_a_player_without_a_bag_says_so(act):
    with pytest.raises(RuntimeError, match='Player is not initialized. Please use constructor with storage and play'):
        getattr(Player(), act)()


@pytest.mark.parametrize('act', ['record', 'stop', 'pause', 'resume', 'is_paused'])
def test_a_recorder_without_a_bag_says_so(act):
    with pytest.raises(RuntimeError, match='Recorder is not initialized. Please use constructor with storage and rec'):
        getattr(Recorder('warn'), act)()


def test_what_a_player_cannot_do_is_said_at_once(bag, tmp_path):
    with pytest.raises(BagError):
        Player(StorageOptions(str(tmp_path / 'none')), PlayOptions())
    with pytest.raises(ValueError, match="'x' is no remapping"):
        Player(bag, PlayOptions(topic_remapping_options=['x']))


def test_the_source_of_requests_is_a_value_with_a_name():
    assert PlayOptions().service_requests_source is ServiceRequestsSource.SERVICE_INTROSPECTION
    assert ServiceRequestsSource(1) is ServiceRequestsSource.CLIENT_INTROSPECTION
