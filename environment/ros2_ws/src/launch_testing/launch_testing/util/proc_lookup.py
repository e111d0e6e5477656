"""Which process of a launch is meant."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from launch.actions import ExecuteProcess
from launch.substitutions import TextSubstitution

NO_CMD_ARGS = object()  # as cmd_args: the process that was started without arguments


class NoMatchingProcessException(Exception):
    """No process is meant by a name, or none of it is known."""


def resolveProcesses(
    info_obj: Any,
    *,
    process: ExecuteProcess | str | None = None,
    cmd_args: str | Sequence[str] | object | None = None,
    strict_proc_matching: bool = True,
) -> list[ExecuteProcess]:
    """
    Return the processes that are meant.

    :param info_obj: a handler of outputs or of exits, which knows the processes
    :param process: the action, or a part of the name of the process; None for all
    :param cmd_args: arguments that it was started with, if several have the name
    :param strict_proc_matching: refuse a name that several processes have
    :raises NoMatchingProcessException: if there is none
    :raises RuntimeError: if there are several
    :raises TypeError: if ``process`` is neither an action nor a text
    """
    known = list(info_obj.processes())
    if process is None:
        if not known:
            raise NoMatchingProcessException('No data recorded for any process')
        return known
    if isinstance(process, ExecuteProcess):
        if process not in known:
            raise NoMatchingProcessException(f'No data recorded for proc {_describe(process)}')
        return [process]
    if not isinstance(process, str):
        raise TypeError(f"proc argument must be 'ExecuteProcess' or 'str' not {type(process)}")
    arguments = [cmd_args] if isinstance(cmd_args, str) else cmd_args
    found = [one for one in known if process in one.process_details['name'] and _has_arguments(one, arguments)]
    listed = ', '.join(sorted(_describe(one) for one in known))
    if not found:
        raise NoMatchingProcessException(
            f"Did not find any processes matching name '{process}' and args '{arguments}'. Procs: {listed}"
        )
    if strict_proc_matching and len(found) > 1:
        raise RuntimeError(
            f"Found multiple processes matching name '{process}' and cmd_args '{arguments}'. Procs: {listed}"
        )
    return found


def _has_arguments(process: ExecuteProcess, arguments: Any) -> bool:
    given = process.process_details['cmd'][1:]
    if arguments is None:
        return True
    return not given if arguments is NO_CMD_ARGS else all(argument in given for argument in arguments)


def _describe(process: ExecuteProcess) -> str:
    if not process.process_details:
        parts = [part for word in process.cmd for part in word]
        if all(isinstance(part, TextSubstitution) for part in parts):
            return ' '.join(''.join(part.text for part in word) for word in process.cmd)
        return 'Unknown - Process not launched yet'
    return ' '.join([process.process_details['name'], *process.process_details['cmd'][1:]])
