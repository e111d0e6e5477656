"""
How processes have ended.

A test that fails shows the message alone: PYTEST_DONT_REWRITE.
"""

from __future__ import annotations

from collections.abc import Sequence

from launch_testing.util import resolveProcesses

EXIT_OK = 0
EXIT_FORCED = 1
EXIT_SIGINT = 130
EXIT_SIGQUIT = 131
EXIT_SIGKILL = 137
EXIT_SIGSEGV = 139


def assertExitCodes(
    proc_info,
    allowable_exit_codes: Sequence[int] = (EXIT_OK,),
    process=None,
    cmd_args=None,
    *,
    strict_proc_matching: bool = True,
) -> None:
    """
    Check the exit codes of the processes that are meant, see ``launch_testing.util.resolveProcesses``.

    :raises AssertionError: if one has another code
    """
    wrong = [code for code in allowable_exit_codes if not isinstance(code, int)]
    assert not wrong, f'Provided exit code {wrong[0]} is not an int'
    found = resolveProcesses(proc_info, process=process, cmd_args=cmd_args, strict_proc_matching=strict_proc_matching)
    for info in (proc_info[one] for one in found):
        code = getattr(info, 'returncode', None)  # None: it still runs
        assert code in allowable_exit_codes, f'Proc {info.process_name} exited with code {code}'
