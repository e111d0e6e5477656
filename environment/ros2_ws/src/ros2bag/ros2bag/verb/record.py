"""The verb `ros2 bag record`."""

import datetime
import os
import re

from ros2bag.api import STORAGES, check_not_negative_int, print_error, print_warn, read_qos_overrides
from ros2bag.verb import VerbExtension


class RecordVerb(VerbExtension):
    """Record ROS data to a bag."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add = parser.add_argument
        add('topics', nargs='*', default=[], metavar='Topic', help='Topics to record (outdated: use --topics)')
        add('-o', '--output', help='Folder of the bag (default: rosbag2_ and the time, in the current folder)')
        add('-s', '--storage', choices=STORAGES, default='mcap', help='Kind of its files (default: mcap)')
        self._add_selection(parser)
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
        add('--qos-profile-overrides-path', help='YAML file with the quality of service of some topics')
        add('-f', '--serialization-format', default='', choices=('', 'cdr'), help='Form of the messages: cdr')
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
        add('--log-level', choices=('debug', 'info', 'warn', 'error', 'fatal'), default='info', help='What to log')

    def _add_selection(self, parser):
        add = parser.add_argument
        add('--topics', nargs='+', default=[], metavar='Topic', dest='topic_names', help='Topics to record')
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

    def main(self, *, args):
        """Record until Ctrl+C."""
        if args.topics:
            print(
                print_warn('Positional "topics" argument deprecated. Please use optional "--topics" argument instead.')
            )
        args.topic_names = [*args.topics, *args.topic_names]
        try:
            _check(args)
            overrides = read_qos_overrides(args.qos_profile_overrides_path)
            custom_data = _pairs(args.custom_data)
        except ValueError as error:
            return print_error(str(error))
        output = args.output or datetime.datetime.now().strftime('rosbag2_%Y_%m_%d-%H_%M_%S')
        if os.path.exists(output):
            return print_error(f"Output folder '{output}' already exists.")
        return _record(args, output, overrides, custom_data)


def _check(args):
    chosen = (
        args.all,
        args.all_topics,
        args.all_services,
        args.services,
        args.topic_names,
        args.topic_types,
        args.regex,
    )
    if not any(chosen):
        raise ValueError(
            'Need to specify at least one option out of --all, --all-topics, --all-services, --services, '
            '--topics, --topic-types or --regex'
        )
    for option in ('regex', 'exclude_regex'):
        try:
            re.compile(getattr(args, option))
        except re.error as error:
            raise ValueError(f'--{option.replace("_", "-")} is not a valid regular expression: {error}') from None


def _pairs(texts):
    pairs = {}
    for text in texts:
        key, separator, value = text.partition('=')
        if not (key and separator):
            raise ValueError(f"Invalid key=value pair: '{text}'")
        pairs[key] = value
    return pairs


def _record(args, output, overrides, custom_data):
    from rosbag2_py import BagError, SequentialWriter, StorageOptions
    from rosbag2_py.recorder import Recorder, RecordOptions
    from rosbag2_py.running import RunningNode

    from ros2bag.api.keyboard import keys

    def full(names):
        return [name if name.startswith('/') else f'/{name}' for name in names]

    failures = []
    writer = SequentialWriter()
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
                    custom_data=custom_data,
                )
            )
            recorder = Recorder(
                running.node,
                writer,
                RecordOptions(
                    all_topics=args.all or args.all_topics,
                    all_services=args.all or args.all_services,
                    topics=full(args.topic_names),
                    topic_types=args.topic_types,
                    services=full(args.services),
                    regex=args.regex,
                    exclude_regex=args.exclude_regex,
                    exclude_topics=full(args.exclude_topics),
                    exclude_topic_types=args.exclude_topic_types,
                    exclude_services=full(args.exclude_services),
                    include_hidden_topics=args.include_hidden_topics,
                    include_unpublished_topics=args.include_unpublished_topics,
                    ignore_leaf_topics=args.ignore_leaf_topics,
                    is_discovery_disabled=args.no_discovery,
                    topic_polling_interval=args.polling_interval / 1000,
                    topic_qos_profile_overrides=overrides,
                    start_paused=args.start_paused,
                ),
                failures.append,
            )
            _run(running, recorder, pressed, failures, args)
            raise failures[0]
    except KeyboardInterrupt:  # how a recording ends
        return None
    except (BagError, OSError) as error:
        return print_error(str(error))
    finally:
        writer.close()


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
    finally:
        logger.info('Recording stopped')
