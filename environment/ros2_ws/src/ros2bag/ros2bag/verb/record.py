"""The verb `ros2 bag record`."""

import datetime
import os
import re

from ros2bag.api import (
    NO_SERVICES,
    STORAGES,
    OpenedFile,
    check_not_negative_int,
    event_topics,
    full_names,
    print_error,
    print_warn,
    read_qos_overrides,
)
from ros2bag.verb import VerbExtension


def add_recorder_arguments(parser):
    """Add the arguments of `ros2 bag record`."""
    parser.epilog = NO_SERVICES
    add = parser.add_argument
    add('topics_positional', nargs='*', default=[], metavar='Topic', help='Topics to record (outdated: use --topics)')
    add('-o', '--output', help='Folder of the bag (default: rosbag2_ and the time, in the current folder)')
    add('-s', '--storage', choices=STORAGES, default='mcap', help='Kind of its files (default: mcap)')
    _add_selection(parser)
    add('--include-unpublished-topics', action='store_true', help='Record topics without a publisher as well')
    add('--include-hidden-topics', action='store_true', help='Record hidden topics as well')
    add('--no-discovery', action='store_true', help='Record only topics that are there at the beginning')
    add(
        '-p',
        '--polling-interval',
        type=check_not_negative_int,
        default=100,
        metavar='MS',
        help='Look for new topics every so many milliseconds (default: 100)',
    )
    add('--ignore-leaf-topics', action='store_true', help='Leave out topics that nobody subscribes to')
    add('--qos-profile-overrides-path', type=OpenedFile(), help='YAML file with the quality of service of some topics')
    add('-f', '--serialization-format', default='', choices=('', 'cdr'), help='Form of the messages: cdr')
    _add_size(parser)
    add('--disable-keyboard-controls', action='store_true', help='Do not listen to the keyboard')
    add('--start-paused', action='store_true', help='Wait for SPACE before recording')
    add('--use-sim-time', action='store_true', help='Take the time of each message from /clock')
    add('--node-name', default='rosbag2_recorder', help='Name of the recording node (default: rosbag2_recorder)')
    add('--custom-data', nargs='*', default=[], metavar='KEY=VALUE', help='Store these pairs in the metadata')
    add(
        '--storage-preset-profile',
        default='',
        choices=('', 'none', 'fastwrite', 'zstd_fast', 'zstd_small'),
        help='For mcap: compress with zstd, or not (default)',
    )
    add('--storage-config-file', help='Accepted; there is nothing to configure')
    add('--snapshot-mode', action='store_true', help='Refused: it needs a service of rosbag2_interfaces')
    _add_compression(parser)
    add('--log-level', choices=('debug', 'info', 'warn', 'error', 'fatal'), default='info', help='What to log')


def _add_size(parser):
    add = parser.add_argument
    add(
        '-b',
        '--max-bag-size',
        type=check_not_negative_int,
        default=0,
        metavar='BYTES',
        help='Begin a new file after so many bytes (default: 0, never)',
    )
    add(
        '-d',
        '--max-bag-duration',
        type=check_not_negative_int,
        default=0,
        metavar='SECONDS',
        help='Begin a new file after so many seconds (default: 0, never)',
    )
    add(
        '--max-cache-size',
        type=check_not_negative_int,
        default=100 * 1024 * 1024,
        help='Accepted; what comes goes to the file within a second',
    )


def _add_compression(parser):
    add = parser.add_argument
    add(
        '--compression-mode',
        choices=('none', 'file', 'message'),
        default='none',
        help='Compress each file when it is complete, or each message (default: none)',
    )
    add('--compression-format', choices=('zstd',), default='', help='How to compress; needed with a mode')
    add('--compression-queue-size', type=int, default=1, help='Accepted; nothing waits to be compressed')
    add('--compression-threads', type=int, default=0, help='Accepted; the recorder itself compresses')
    add('--compression-threads-priority', type=int, default=0, help='Accepted; the recorder itself compresses')


def _add_selection(parser):
    add = parser.add_argument
    add('--topics', nargs='+', default=[], metavar='Topic', help='Topics to record')
    add('--services', nargs='+', default=[], metavar='ServiceName', help='Services whose events to record')
    add('--topic-types', nargs='+', default=[], metavar='TopicType', help='Record all topics of these types')
    add('-a', '--all', action='store_true', help='Record all topics and services, without hidden topics')
    add('--all-topics', action='store_true', help='Record all topics, without hidden ones')
    add('--all-services', action='store_true', help='Record the events of all services')
    add('-e', '--regex', default='', help='Record topics and services that this regular expression is found in')
    add('--exclude-regex', '-x', default='', help='Leave out those that this regular expression is found in')
    add('--exclude-topics', nargs='+', default=[], metavar='Topic', help='Leave out these topics')
    add('--exclude-topic-types', nargs='+', default=[], metavar='TopicType', help='Leave out these types')
    add('--exclude-services', nargs='+', default=[], metavar='ServiceName', help='Leave out these services')


class RecordVerb(VerbExtension):
    """Record ROS data to a bag."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_recorder_arguments(parser)

    def main(self, *, args):
        """Record until Ctrl+C."""
        output = args.output or datetime.datetime.now().strftime('rosbag2_%Y_%m_%d-%H_%M_%S')
        wrong = validate_parsed_arguments(args, output)
        if wrong:
            return wrong
        try:
            overrides = read_qos_overrides(args.qos_profile_overrides_path)
            custom_data = _pairs(args.custom_data)
        except ValueError as error:
            return print_error(str(error))
        return _record(args, output, overrides, custom_data)


def validate_parsed_arguments(args, uri):
    """
    Return what is wrong with the arguments, to be printed, or None; put positional topics with the others.

    :param uri: the folder of the bag
    """
    if args.topics_positional:
        print(print_warn('Positional "topics" argument deprecated. Please use optional "--topics" argument instead.'))
        args.topics = [*args.topics_positional, *args.topics]
    try:
        _check(args)
    except ValueError as error:
        return print_error(str(error))
    _warn(args)
    return print_error(f"Output folder '{uri}' already exists.") if os.path.exists(uri) else None


def _check(args):
    """Refuse what contradicts itself; ValueError."""
    named = args.services or args.topics or args.topic_types
    if not (args.all or args.all_topics or args.all_services or args.regex or named):
        raise ValueError(
            'Need to specify at least one option out of --all, --all-topics, --all-services, --services, '
            '--topics, --topic-types or --regex'
        )
    for option in ('regex', 'exclude_regex'):
        try:
            re.compile(getattr(args, option))
        except re.error as error:
            raise ValueError(f'--{option.replace("_", "-")} is not a valid regular expression: {error}') from None
    everything = args.all or args.regex
    topics = everything or args.all_topics or args.topic_types
    for option, needed, text in (
        ('exclude_regex', topics or args.all_services, '--all, --all-topics, --topic-types, --all-services or --regex'),
        ('exclude_topics', topics, '--all, --all-topics, --topic-types or --regex'),
        ('exclude_topic_types', topics, '--all, --all-topics or --regex'),
        ('exclude_services', everything or args.all_services, '--all, --all-services or --regex'),
    ):
        if getattr(args, option) and not needed:
            raise ValueError(f'--{option.replace("_", "-")} argument requires either {text}')
    if args.use_sim_time and args.no_discovery:
        raise ValueError(
            '--use-sim-time and --no-discovery both set, but are incompatible settings. '
            'The /clock topic needs to be discovered to record with sim time.'
        )
    if args.compression_format and args.compression_mode == 'none':
        raise ValueError('Invalid choice: Cannot specify compression format without a compression mode.')
    if args.compression_queue_size < 0:
        raise ValueError('Compression queue size must be at least 0.')


def _warn(args):
    """Tell which options count for nothing."""
    for some, options, overridden in (
        (args.all or args.all_services, '--all or --all-services', 'services'),
        (args.all or args.all_topics, '--all or --all-topics', 'topics'),
        (args.all or args.all_topics or args.all_services, '--all, --all-topics or --all-services', 'regex'),
    ):
        if some and getattr(args, overridden):
            print(print_warn(f'{options} will override --{overridden}'))


def _pairs(texts):
    pairs = {}
    for text in texts:
        key, separator, value = text.partition('=')
        if not (key and separator):
            raise ValueError(f"Invalid key=value pair: '{text}'")
        pairs[key] = value
    return pairs


def _record(args, output, overrides, custom_data):
    from rosbag2_py import BagError, StorageOptions
    from rosbag2_py.recorder import Recording
    from rosbag2_py.running import RunningNode

    from ros2bag.api.keyboard import keys

    failures = []
    try:
        writer = _writer(args)
    except BagError as error:
        return print_error(str(error))
    try:
        with (
            RunningNode(args.node_name, args.use_sim_time) as running,
            keys(not args.disable_keyboard_controls) as pressed,
        ):
            writer.open(
                StorageOptions(
                    output,
                    args.storage,
                    args.max_bag_size,
                    args.max_bag_duration,
                    args.max_cache_size,
                    args.storage_preset_profile,
                    snapshot_mode=args.snapshot_mode,
                    custom_data=custom_data,
                )
            )
            recorder = Recording(running.node, writer, _options(args, overrides), failures.append)
            _run(running, recorder, pressed, failures, args)
            raise failures[0]
    except KeyboardInterrupt:  # how a recording ends
        return None
    except (BagError, OSError) as error:
        return print_error(str(error))
    finally:
        writer.close()


def _writer(args):
    """Return what writes the bag, compressed or not; BagError for a format that there is not."""
    from rosbag2_py import CompressionOptions, SequentialCompressionWriter, compression_mode_from_string

    return SequentialCompressionWriter(
        CompressionOptions(args.compression_format, compression_mode_from_string(args.compression_mode))
    )


def _options(args, overrides):
    """Return what to record."""
    from rosbag2_py import RecordOptions

    return RecordOptions(
        all_topics=args.all or args.all_topics,
        all_services=args.all or args.all_services,
        topics=full_names(args.topics),
        topic_types=args.topic_types,
        services=event_topics(args.services),
        regex=args.regex,
        exclude_regex=args.exclude_regex,
        exclude_topics=full_names(args.exclude_topics),
        exclude_topic_types=args.exclude_topic_types,
        exclude_service_events=event_topics(args.exclude_services),
        include_hidden_topics=args.include_hidden_topics,
        include_unpublished_topics=args.include_unpublished_topics,
        ignore_leaf_topics=args.ignore_leaf_topics,
        is_discovery_disabled=args.no_discovery,
        topic_polling_interval=datetime.timedelta(milliseconds=args.polling_interval),
        topic_qos_profile_overrides=overrides,
        start_paused=args.start_paused,
    )


def _run(running, recorder, pressed, failures, args):
    """Record until a failure of the writer; Ctrl+C comes as KeyboardInterrupt."""
    from rclpy.logging import LoggingSeverity

    logger = running.node.get_logger()
    logger.set_level(LoggingSeverity[args.log_level.upper()])

    def step():
        recorder.look()
        if pressed() == ' ':
            recorder.paused = not recorder.paused
            logger.info('Pausing recording.' if recorder.paused else 'Resuming recording.')
        return failures

    if not args.disable_keyboard_controls:
        logger.info('Press SPACE for pausing/resuming')
    logger.info('Listening for topics...')
    logger.info('Waiting for recording: Press SPACE to start.' if recorder.paused else 'Recording...')
    try:
        running.spin(until=step)
    except KeyboardInterrupt:
        running.spin_ready(lambda: recorder.written)  # on a busy machine the queue may hold messages
        raise
    finally:
        logger.info('Recording stopped')
