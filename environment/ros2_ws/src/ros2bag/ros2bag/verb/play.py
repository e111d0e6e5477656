"""The verb `ros2 bag play`."""

from ros2bag.api import check_positive_float, event_topics, full_names
from ros2bag.api.playing import add_bag_arguments, play_bag
from ros2bag.verb import VerbExtension


class PlayVerb(VerbExtension):
    """Play back ROS data from a bag."""

    def add_arguments(self, parser, cli_name):
        """Add the arguments."""
        add_bag_arguments(parser, several=True)
        add = parser.add_argument
        add('-r', '--rate', type=check_positive_float, default=1.0, help='How fast to play (default: 1, as recorded)')
        add('-e', '--regex', default='', help='Play only topics that this regular expression matches')
        add('-x', '--exclude-regex', default='', help='Leave out topics that this regular expression matches')
        add('--exclude-topics', nargs='+', default=[], metavar='TOPIC', help='Leave out these topics')
        add('--exclude-services', nargs='+', default=[], metavar='SERVICE', help='Leave out these services')
        add('-l', '--loop', action='store_true', help='Begin again at the end, until Ctrl+C')
        self._add_clock(parser)
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
        add('--disable-loan-message', action='store_true', help='Borrow no messages (this player never does)')
        add('-p', '--start-paused', action='store_true', help='Wait for SPACE before the first message')
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

    def _add_clock(self, parser):
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
        clock.add_argument(
            '--clock-topics',
            nargs='+',
            default=[],
            metavar='TOPIC',
            help="Publish a message's time on /clock before each message of these topics",
        )
        clock.add_argument(
            '--clock-topics-all', action='store_true', help="Publish a message's time on /clock before each message"
        )

    def main(self, *, args):
        """Play the bag until its end or Ctrl+C."""
        until = args.playback_until_nsec if args.playback_until_sec < 0 else round(args.playback_until_sec * 1e9)
        return play_bag(
            args,
            lambda player: player.play(),
            args.log_level,
            rate=args.rate,
            exclude_topics_to_filter=full_names(args.exclude_topics),
            exclude_service_events_to_filter=event_topics(args.exclude_services),
            publish_service_requests=args.publish_service_requests,
            service_requests_source=args.service_requests_source,
            regex_to_filter=args.regex,
            exclude_regex_to_filter=args.exclude_regex,
            loop=args.loop,
            clock_publish_frequency=args.clock,
            clock_publish_on_topic_publish=args.clock_topics_all or bool(args.clock_topics),
            clock_topics=full_names(args.clock_topics),
            delay=args.delay,
            start_paused=args.start_paused,
            playback_duration=args.playback_duration,
            playback_until_timestamp=until,
            wait_acked_timeout=args.wait_for_all_acked,
            disable_keyboard_controls=args.disable_keyboard_controls,
        )
