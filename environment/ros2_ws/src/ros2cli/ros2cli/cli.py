"""The `ros2` command: parses the command line and runs the command that it names."""

import argparse
import os
import signal
import sys
from pathlib import Path
from typing import Any

from ros2cli.command import CommandExtension, LazyParser, add_subparsers_on_demand

# What a shell reports for a program that SIGPIPE ended.
_BROKEN_PIPE_STATUS = 128 + signal.SIGPIPE


def main(
    *,
    script_name: str = 'ros2',
    argv: list[str] | None = None,
    description: str | None = None,
    extension: CommandExtension | None = None,
) -> Any:
    """Run the command line; return what sys.exit takes: a status, or a text for stderr, which means 1."""
    try:
        status = _main(script_name, argv, description, extension)
        sys.stdout.flush()
        return status
    except BrokenPipeError:
        # The reader has had enough, as in `ros2 topic list | head -1`. Python flushes once more when it ends.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return _BROKEN_PIPE_STATUS
    except KeyboardInterrupt:
        return int(signal.SIGINT)
    except RuntimeError as e:
        return str(e)


def _main(script_name: str, argv: list[str] | None, description: str | None, extension: CommandExtension | None) -> Any:
    _find_own_prefix()
    parser = LazyParser(
        prog=None if extension else script_name,
        description=description or f'{script_name} is an extensible command-line tool for ROS 2.',
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        '--use-python-default-buffering',
        action='store_true',
        help='Do not write each line at once, but buffer standard output as Python does by default, '
        'which depends on PYTHONUNBUFFERED and on whether it is a terminal',
    )
    if extension is None:
        add_subparsers_on_demand(
            parser,
            script_name,
            '_command',
            'ros2cli.command',
            hide_extensions=('extension_points', 'extensions'),
            required=False,
        )
    else:
        extension.add_arguments(parser, script_name)

    if '_ARGCOMPLETE' in os.environ:
        from ros2cli.yaml_completion import CompletionFinder

        CompletionFinder()(parser, exclude=['-h', '--help'])

    args = parser.parse_args(argv)
    if not args.use_python_default_buffering and hasattr(sys.stdout, 'reconfigure'):
        sys.stdout.reconfigure(line_buffering=True)
    if extension is None:
        extension = getattr(args, '_command', None)
    if extension is None:
        parser.print_help()
        return 0
    return extension.main(parser=parser, args=args)


def _find_own_prefix() -> None:
    """Let an unsourced shell find the packages beside this Python, as a sourced one would."""
    if not os.environ.get('AMENT_PREFIX_PATH') and Path(sys.prefix, 'share', 'ament_index').is_dir():
        os.environ['AMENT_PREFIX_PATH'] = sys.prefix
