"""Play a bag at a terminal, as `play` and `burst` do: its log lines, its keys, and Ctrl+C."""

from argparse import ArgumentTypeError, Namespace
from collections.abc import Callable
from typing import Any

from ros2bag.api import (
    NO_SERVICES,
    STORAGES,
    OpenedFile,
    check_not_negative,
    check_path_exists,
    event_topics,
    full_names,
    input_bag,
    print_error,
    read_qos_overrides,
)
from ros2bag.api.keyboard import keys

_KEYS = (
    'Press SPACE for Pause/Resume',
    'Press CURSOR_RIGHT for Play Next Message',
    'Press CURSOR_UP for Increase Rate 10%',
    'Press CURSOR_DOWN for Decrease Rate 10%',
)


def add_bag_arguments(parser: Any, several: bool = False) -> None:
    """
    Add the arguments that both verbs have.

    :param several: the verb takes several bags, too, with -i.
    """
    parser.epilog = NO_SERVICES
    add = parser.add_argument
    number = {'nargs': '?'} if several else {}
    add('bag_path', type=check_path_exists, help='Bag: a folder, or a .mcap or .db3 file', **number)
    if several:
        add(
            '-i',
            '--input',
            action='append',
            nargs='+',
            default=[],
            metavar=('uri', 'storage_id'),
            help='Bag, and the kind of its files if it shall be checked; several bags with several -i',
        )
    add('-s', '--storage', choices=STORAGES, default='', help='Accepted; the bag says it itself')
    add('--read-ahead-queue-size', type=int, default=1000, help='Accepted; messages are read as they are due')
    add('--topics', nargs='+', default=[], metavar='TOPIC', help='Play only these topics')
    add('--services', nargs='+', default=[], metavar='SERVICE', help='Play the events of these services only')
    add('--qos-profile-overrides-path', type=OpenedFile(), help='YAML file with the quality of service of some topics')
    add('--remap', '-m', nargs='+', default=[], metavar='OLD:=NEW', help='Publish topics under other names')
    add('--storage-config-file', help='Accepted; there is nothing to configure')
    add('--start-offset', type=check_not_negative, default=0.0, help='Begin so many seconds into the bag')


def play_bag(args: Namespace, act: Callable[[Any], Any], log_level: str = 'info', **options: Any) -> str | None:
    """
    Open the bag and let `act` play it.

    :param act: called with a `rosbag2_py.player.Playback`; it returns when everything is played.
    :param options: fields of `rosbag2_py.PlayOptions` that only one of the verbs has arguments for.
    :returns: an error to print, or None.
    """
    from rosbag2_py import BagError, PlayOptions, StorageOptions
    from rosbag2_py.merged import MergedReader
    from rosbag2_py.running import RunningNode

    several = getattr(args, 'input', [])
    if several and args.bag_path:
        return print_error(
            'do not mix the [bag_path] positional argument and the -i,--input option; for multiple input bags, use '
            '-i,--input multiple times'
        )
    reader = None
    try:
        bags = [input_bag(*each) for each in several] or [(args.bag_path, '')]
        if bags[0][0] is None:
            return print_error('no bag is given: ros2 bag play BAG, or -i BAG -i BAG for several')
        reader = MergedReader([StorageOptions(*each) for each in bags])
        play_options = PlayOptions(
            topics_to_filter=full_names(args.topics),
            services_to_filter=event_topics(args.services),
            topic_qos_profile_overrides=read_qos_overrides(args.qos_profile_overrides_path),
            topic_remapping_options=args.remap,
            start_offset=args.start_offset,
            **options,
        )
        with RunningNode('rosbag2_player') as running:
            _act(running, reader, play_options, log_level, act)
    except (BagError, ValueError, ArgumentTypeError) as error:
        return print_error(str(error))
    except KeyboardInterrupt:  # how a loop ends
        return None
    finally:
        if reader is not None:
            reader.close()
    return None


def _act(running: Any, reader: Any, options: Any, log_level: str, act: Callable[[Any], Any]) -> None:
    from rclpy.logging import LoggingSeverity
    from rosbag2_py.player import RATE_STEP, Playback

    logger = running.node.get_logger()
    logger.set_level(LoggingSeverity[log_level.upper()])
    keyboard = not options.disable_keyboard_controls

    def wait(seconds: float) -> None:
        running.spin(timeout=seconds)
        key = pressed()
        if key == ' ':
            player.pause(not player.paused)
            logger.info('Pausing play.' if player.paused else 'Resuming play.')
        elif key == 'right':
            player.skip = player.paused
            if not player.paused:
                logger.warning('Called play next, but not in paused state.')
        elif key in ('up', 'down'):
            player.set_rate(player.rate * (1 + RATE_STEP if key == 'up' else 1 - RATE_STEP))
            logger.info(f'Set rate to {player.rate:g}')

    with keys(keyboard) as pressed:
        player = Playback(running.node, reader, options, wait)
        logger.info(f'Set rate to {options.rate:g}')
        if keyboard:
            logger.info('Adding keyboard callbacks.')
            for line in _KEYS:
                logger.info(line)
        logger.info(f'Playback until timestamp: {options.playback_until_timestamp}')
        act(player)
