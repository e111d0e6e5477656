"""Runs a program that is described apart."""

from __future__ import annotations

import asyncio
import os
import signal
from typing import Any

import launch.logging
from launch.action import Action
from launch.child_process import STDERR, STDOUT, ChildProcess
from launch.descriptions.executable import Executable
from launch.event_handlers import OnProcessExit
from launch.events.process import ProcessExited, ProcessStarted, ProcessStderr, ProcessStdout
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitutions import LaunchConfiguration
from launch.utilities import normalize_to_list_of_substitutions, to_entities, to_text
from launch.utilities.type_utils import to_bool, to_number

_SIGTERM_TIMEOUT = LaunchConfiguration('sigterm_timeout', default=5)
_SIGKILL_TIMEOUT = LaunchConfiguration('sigkill_timeout', default=5)


class ExecuteLocal(Action):
    """
    Runs a program until it ends, or until the system shuts down.

    Each process is the leader of a process group of its own, so that a signal reaches its children too. On
    shutdown it gets SIGINT, after ``sigterm_timeout`` seconds SIGTERM, after ``sigkill_timeout`` more SIGKILL.

    :param process_description: the program
    :param shell: let a shell read the command as one text
    :param emulate_tty: give the program a terminal to write to, so that it does not hold its output back
    :param output: screen, log or both, see ``launch.logging.get_output_loggers``
    :param output_format: how a line is shown; ``{line}`` and ``{this}`` are filled in
    :param cached_output: keep the output for ``get_stdout`` and ``get_stderr``
    :param log_cmd: log the command before it runs
    :param on_exit: actions, or a function of (event, context) that returns some, for when the process has ended
    :param respawn: start the program again whenever it ends
    :param respawn_delay: seconds to wait before that
    :param respawn_max_retries: how often; a negative number means for ever
    """

    def __init__(
        self,
        *,
        process_description: Executable,
        shell: bool = False,
        sigterm_timeout: SomeSubstitutionsType = _SIGTERM_TIMEOUT,
        sigkill_timeout: SomeSubstitutionsType = _SIGKILL_TIMEOUT,
        emulate_tty: bool = False,
        output: SomeSubstitutionsType | dict = 'log',
        output_format: str = '[{this.process_description.final_name}] {line}',
        cached_output: bool = False,
        log_cmd: bool = False,
        on_exit=None,
        respawn: bool | SomeSubstitutionsType = False,
        respawn_delay: float | None = None,
        respawn_max_retries: int = -1,
        **kwargs,
    ):
        super().__init__(**kwargs)
        self._description = process_description
        self._shell, self._emulate_tty = shell, emulate_tty
        self._timeouts = (sigterm_timeout, sigkill_timeout)
        self._output, self._output_format, self._log_cmd = output, output_format, log_cmd
        self._cached: list[bytearray] | None = [bytearray(), bytearray()] if cached_output else None
        self._unfinished = [b'', b'']
        self._on_exit = on_exit
        self._respawn, self._respawn_delay, self._respawn_retries = respawn, respawn_delay, respawn_max_retries
        self._details: dict[str, Any] = {}
        self._executed = False
        self._child: ChildProcess | None = None
        self._task: asyncio.Task | None = None
        self._shutdown_requested: asyncio.Event | None = None
        self._shutdown_quiet = False
        self.return_code: int | None = None

    @property
    def process_description(self) -> Executable:
        """The program."""
        return self._description

    @property
    def shell(self) -> bool:
        """True if a shell reads the command."""
        return self._shell

    @property
    def emulate_tty(self) -> bool:
        """True if the program gets a terminal to write to."""
        return self._emulate_tty

    @property
    def output(self):
        """Where the output goes."""
        return self._output

    @property
    def sigterm_timeout(self):
        """Seconds from SIGINT to SIGTERM, as substitutions."""
        return normalize_to_list_of_substitutions(self._timeouts[0])

    @property
    def sigkill_timeout(self):
        """Seconds from SIGTERM to SIGKILL, as substitutions."""
        return normalize_to_list_of_substitutions(self._timeouts[1])

    def get_stdout(self) -> str:
        """
        Return what the process has written to its standard output.

        :raises RuntimeError: if the output is not kept
        """
        return self._kept(STDOUT)

    def get_stderr(self) -> str:
        """
        Return what the process has written to its standard error.

        :raises RuntimeError: if the output is not kept
        """
        return self._kept(STDERR)

    def _kept(self, source: int) -> str:
        if self._cached is None:
            raise RuntimeError("the output of this process is not kept: give the action 'cached_output=True'")
        return self._cached[source].decode(errors='replace')

    @property
    def process_name(self) -> str:
        """What the log calls the process, e.g. ``talker-1``; known once it is executed."""
        return self._details['name']

    @property
    def process_details(self) -> dict[str, Any] | None:
        """Name, command, directory, environment and pid; None before the action is executed."""
        return self._details or None

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        return [] if callable(self._on_exit) else to_entities(self._on_exit)

    def get_asyncio_future(self) -> asyncio.Future | None:
        return self._task

    # --- what the launch service asks for ---------------------------------------------------------------------

    def prepare(self, context: LaunchContext) -> None:
        """Find the texts of name, command, directory and environment, as ``execute`` does; start nothing."""
        program = self._description
        program.prepare(context, self)
        self._details = {
            'action': self,
            'name': program.final_name,
            'cmd': program.final_cmd,
            'cwd': program.final_cwd,
            'env': program.final_env,
        }

    def execute(self, context: LaunchContext) -> None:
        if self._executed:
            raise RuntimeError(f"ExecuteLocal action '{self.process_name}': executed more than once: {self.describe()}")
        self._executed = True
        if not self._details:
            self.prepare(context)
        if context.is_shutdown:
            return
        self._logger = launch.logging.get_logger(self.process_name)
        output = os.environ.get('OVERRIDE_LAUNCH_PROCESS_OUTPUT', self._output)
        output = output if isinstance(output, dict) else to_text(context, output)
        self._outputs = launch.logging.get_output_loggers(self.process_name, output)
        self._respawn = to_bool(context, self._respawn)
        self._emulate_tty = to_bool(context, LaunchConfiguration('emulate_tty', default=str(self._emulate_tty)))
        self._timeout_values = [to_number(context, timeout) for timeout in self._timeouts]
        self._timeout_texts = [to_text(context, timeout) for timeout in self._timeouts]
        self._shutdown_requested = asyncio.Event()
        context.running_processes.append(self)
        self._task = context.asyncio_loop.create_task(self._live(context))

    def request_shutdown(self, context: LaunchContext, *, quiet: bool = False) -> None:
        """
        End the process, and do not start it again.

        :param quiet: do not log the SIGINT: the user at the terminal knows that they pressed Ctrl+C
        """
        self._shutdown_quiet = quiet
        self._shutdown_requested.set()

    def send_signal(self, number: signal.Signals) -> None:
        """Send a signal to the process and its children; harmless if they have ended."""
        if self._child is not None and self._child.running:
            self._logger.info(f"sending signal '{number.name}' to process[{self.process_name}]")
            self._child.signal(number)

    # --- the life of the process ------------------------------------------------------------------------------

    async def _live(self, context: LaunchContext) -> None:
        stopper: asyncio.Task | None = None
        try:
            while not self._shutdown_requested.is_set():
                if not await self._start(context):
                    return
                stopper = asyncio.create_task(self._stop_when_asked())
                self.return_code = await self._child.wait()
                self._log_unfinished_lines()
                self._report_end(context)
                if self._shutdown_requested.is_set():
                    await stopper
                stopper.cancel()
                if not self._respawn or context.is_shutdown or self._respawn_retries == 0:
                    return
                self._respawn_retries -= 1
                await self._pause(self._respawn_delay or 0.0)
        finally:
            if stopper is not None:
                stopper.cancel()
            context.running_processes.remove(self)

    async def _start(self, context: LaunchContext) -> bool:
        cmd = self._details['cmd']
        if self._log_cmd:
            self._logger.info(f"process details: cmd='{' '.join(cmd)}', cwd='{self._details['cwd']}', custom_env?=True")
        try:
            self._child = await ChildProcess.start(
                ' '.join(cmd) if self._shell else cmd,
                cwd=self._details['cwd'],
                env=self._details['env'],
                tty=self._emulate_tty,
                on_output=lambda source, data: self._on_output(context, source, data),
            )
        except OSError as error:
            self._logger.error(f'exception occurred while executing process: {error}')
            return False
        self._details['pid'] = self._child.pid
        self._logger.info(f'process started with pid [{self._child.pid}]')
        context.emit_event_sync(ProcessStarted(**self._details))
        return True

    def _on_output(self, context: LaunchContext, source: int, data: bytes) -> None:
        """Log the lines that are complete now, keep the rest, and tell the handlers what was read."""
        *lines, self._unfinished[source] = (self._unfinished[source] + data).split(b'\n')
        for line in lines:
            self._log_line(source, line)
        if self._cached is not None:
            self._cached[source] += data
        event = (ProcessStdout, ProcessStderr)[source](text=data, **self._details)
        if context.would_handle_event(event):  # or else a talkative process would fill the queue for nothing
            context.emit_event_sync(event)

    def _log_unfinished_lines(self) -> None:
        for source, line in enumerate(self._unfinished):
            if line:
                self._log_line(source, line)
        self._unfinished = [b'', b'']

    def _log_line(self, source: int, line: bytes) -> None:
        text = line.decode(errors='replace').rstrip('\r')
        self._outputs[source].info(self._output_format.format(line=text, this=self))

    def _report_end(self, context: LaunchContext) -> None:
        pid, code = self._child.pid, self.return_code
        if code == 0:
            self._logger.info(f'process has finished cleanly [pid {pid}]')
        else:
            command = ' '.join(part for part in self._details['cmd'] if part.strip())
            self._logger.error(f"process has died [pid {pid}, exit code {code}, cmd '{command}'].")
        event = ProcessExited(returncode=code, **self._details)
        context.emit_event_sync(event)
        if self._on_exit is not None:
            self._register_on_exit(context)

    def _register_on_exit(self, context: LaunchContext) -> None:
        # Registered only now, it is still in time for the event just queued.
        context.register_event_handler(OnProcessExit(target_action=self, on_exit=self._on_exit, handle_once=True))

    async def _stop_when_asked(self) -> None:
        await self._shutdown_requested.wait()
        if self._shutdown_quiet:
            self._child.signal(signal.SIGINT)
        else:
            self.send_signal(signal.SIGINT)
        waited = 0.0
        steps = [(signal.SIGINT, signal.SIGTERM), (signal.SIGTERM, signal.SIGKILL)]
        for (before, after), timeout, text in zip(steps, self._timeout_values, self._timeout_texts, strict=True):
            if await self._child.gone(timeout):
                return
            waited += timeout
            shown = text if before is signal.SIGINT else waited
            self._logger.error(
                f"process[{self.process_name}] failed to terminate '{shown}' seconds after receiving "
                f"'{before.name}', escalating to '{after.name}'"
            )
            self._logger.info(f"sending signal '{after.name}' to process[{self.process_name}]")
            self._child.signal(after)
        await self._child.gone(5.0)

    async def _pause(self, seconds: float) -> None:
        """Wait, but not longer than until the shutdown."""
        try:
            await asyncio.wait_for(self._shutdown_requested.wait(), seconds)
        except asyncio.TimeoutError:
            pass
