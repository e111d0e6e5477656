"""The verb `ros2 bag play`."""

from ros2bag.api import (
    STORAGES,
    check_not_negative,
    check_path_exists,
    check_positive_float,
    event_topics,
    full_names,
    print_error,
    read_qos_overrides,
)
from ros2bag.verb import VerbExtension

_KEYS = (
    'Press SPACE for Pause/Resume',
    'Press CURSOR_RIGHT for Play Next Message',
    'Press CURSOR_UP for Increase Rate 10%',
    'Press CURSOR_DOWN for Decrease Rate 10%',
)


class PlayVerb(VerbExtension):
    """Play back ROS data from a bag."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add = parser.add_argument
        add('bag_path', type=check_path_exists, help='Bag: a folder, or a .mcap or .db3 file')
        add('-s', '--storage', choices=STORAGES, default='', help='Accepted; the bag says it itself')
        add('--read-ahead-queue-size', type=int, default=1000, help='Accepted; messages are read as they are due')
        add('-r', '--rate', type=check_positive_float, default=1.0, help='How fast to play (default: 1, as recorded)')
        add('--topics', nargs='+', default=[], metavar='TOPIC', help='Play only these topics')
        add('--services', nargs='+', default=[], metavar='SERVICE', help='Play the events of these services only')
        add('-e', '--regex', default='', help='Play only topics that this regular expression matches')
        add('-x', '--exclude-regex', default='', help='Leave out topics that this regular expression matches')
        add('--exclude-topics', nargs='+', default=[], metavar='TOPIC', help='Leave out these topics')
        add('--exclude-services', nargs='+', default=[], metavar='SERVICE', help='Leave out these services')
        add('--qos-profile-overrides-path', help='YAML file with the quality of service of some topics')
        add('-l', '--loop', action='store_true', help='Begin again at the end, until Ctrl+C')
        add('--remap', '-m', nargs='+', default=[], metavar='OLD:=NEW', help='Publish topics under other names')
        add('--storage-config-file', help='Accepted; there is nothing to configure')
        clock = parser.add_mutually_exclusive_group()
        clock.add_argument(
            '--clock',
            type=check_positive_float,
            nargs='?',
            const=40.0,
            default=0.0,
            metavar='HZ',
            help="Publish the bag's time on /clock, so often (default with the option: 40 Hz)",
        )
        add('-d', '--delay', type=check_positive_float, default=0.0, help='Wait so many seconds before each playback')
        add('--playback-duration', type=float, default=-1.0, help='Play so many seconds of the bag only')
        until = parser.add_mutually_exclusive_group()
        until.add_argument(
            '--playback-until-sec', type=float, default=-1.0, help='Play up to this time, in seconds since 1970'
        )
        until.add_argument(
            '--playback-until-nsec', type=int, default=-1, help='Play up to this time, in nanoseconds since 1970'
        )
        add('--disable-keyboard-controls', action='store_true', help='Do not listen to the keyboard')
        add('-p', '--start-paused', action='store_true', help='Wait for SPACE before the first message')
        add('--start-offset', type=check_not_negative, default=0.0, help='Begin so many seconds into the bag')
        add(
            '--wait-for-all-acked',
            type=int,
            default=-1,
            metavar='TIMEOUT',
            help='Wait at the end for slow reliable readers, at most so many milliseconds; 0: for ever',
        )
        add(
            '--publish-service-requests',
            action='store_true',
            help='Send the recorded requests to their services, instead of publishing the recorded events',
        )
        add(
            '--service-requests-source',
            choices=('service_introspection', 'client_introspection'),
            default='service_introspection',
            help='Send the requests as services received them (default), or as clients sent them',
        )
        add('--log-level', choices=('debug', 'info', 'warn', 'error', 'fatal'), default='info', help='What to log')

    def main(self, *, args):
        """Play the bag until its end or Ctrl+C."""
        from rosbag2_py import BagError, SequentialReader
        from rosbag2_py.running import RunningNode

        reader = SequentialReader()
        try:
            reader.open_uri(args.bag_path)
            overrides = read_qos_overrides(args.qos_profile_overrides_path)
            with RunningNode('rosbag2_player') as running:
                _play(running, reader, overrides, args)
        except (BagError, ValueError) as error:
            return print_error(str(error))
        except KeyboardInterrupt:  # how a loop ends
            return None
        finally:
            reader.close()


def _play(running, reader, overrides, args):
    from rclpy.logging import LoggingSeverity
    from rosbag2_py import PlayOptions
    from rosbag2_py.player import RATE_STEP, Playback

    from ros2bag.api.keyboard import keys

    logger = running.node.get_logger()
    logger.set_level(LoggingSeverity[args.log_level.upper()])
    until = args.playback_until_nsec if args.playback_until_sec < 0 else round(args.playback_until_sec * 1e9)

    def wait(seconds):
        running.spin(timeout=seconds)
        key = pressed()
        if key == ' ':
            player.pause(not player.paused)
            logger.info('Pausing play.' if player.paused else 'Resuming play.')
        elif key == 'right':
            player.skip = player.paused
        elif key in ('up', 'down'):
            player.set_rate(player.rate * (1 + RATE_STEP if key == 'up' else 1 - RATE_STEP))
            logger.info(f'Set rate to {player.rate:g}')

    with keys(not args.disable_keyboard_controls) as pressed:
        player = Playback(
            running.node,
            reader,
            PlayOptions(
                rate=args.rate,
                topics_to_filter=full_names(args.topics),
                exclude_topics_to_filter=full_names(args.exclude_topics),
                services_to_filter=event_topics(args.services),
                exclude_service_events_to_filter=event_topics(args.exclude_services),
                publish_service_requests=args.publish_service_requests,
                service_requests_source=args.service_requests_source,
                regex_to_filter=args.regex,
                exclude_regex_to_filter=args.exclude_regex,
                topic_qos_profile_overrides=overrides,
                loop=args.loop,
                topic_remapping_options=args.remap,
                clock_publish_frequency=args.clock,
                delay=args.delay,
                start_paused=args.start_paused,
                start_offset=args.start_offset,
                playback_duration=args.playback_duration,
                playback_until_timestamp=until,
                wait_acked_timeout=args.wait_for_all_acked,
            ),
            wait,
        )
        logger.info(f'Set rate to {args.rate:g}')
        if not args.disable_keyboard_controls:
            logger.info('Adding keyboard callbacks.')
            for line in _KEYS:
                logger.info(line)
        logger.info(f'Playback until timestamp: {until}')
        player.play()
