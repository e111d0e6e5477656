"""A real Jupyter kernel for tests: run cells, interrupt, restart, exit."""

import ast
import os
import re
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

from jupyter_client.manager import KernelManager

ROOT = Path(__file__).parents[2]
TIMEOUT = 60  # s, for what takes well under a second on an idle machine


@dataclass
class Result:
    """What one cell did."""

    stdout: str = ''
    stderr: str = ''
    error: str = ''  #: exception type, '' if none
    message: str = ''
    traceback: str = ''
    values: list[str] = field(default_factory=list)


class Kernel:
    """A kernel process."""

    def __init__(self, folder: Path):
        self.log = folder / 'kernel.log'
        self._file = self.log.open('w')
        env = {name: value for name, value in os.environ.items() if name != 'PYTEST_CURRENT_TEST'}
        env['PYTHONPATH'] = os.pathsep.join([str(ROOT), env.get('PYTHONPATH', '')])
        # Not TCP: kernels that start at the same time in several processes may choose the same port.
        self._sockets = tempfile.TemporaryDirectory()  # the path of a socket must be short
        ip = f'{self._sockets.name}/kernel'
        self.manager = KernelManager(kernel_name='python3', transport='ipc', ip=ip)
        self.manager.shutdown_wait_time = TIMEOUT
        history = '--HistoryManager.hist_file=:memory:'  # no file of the user's
        self.manager.start_kernel(env=env, stderr=self._file, cwd=str(folder), extra_arguments=[history])
        self.client = self.manager.client()
        self.client.start_channels()
        self.client.wait_for_ready(timeout=TIMEOUT)

    def __enter__(self) -> 'Kernel':
        return self

    def __exit__(self, kind, error, tb) -> None:
        self.client.stop_channels()
        if self.manager.has_kernel:
            self.manager.shutdown_kernel(now=True)
        self._sockets.cleanup()
        self._file.close()

    @property
    def process(self):
        """The kernel's ``subprocess.Popen``."""
        return self.manager.provisioner.process

    def run(self, code: str, interrupt_at: str = '', store_history: bool = True) -> Result:
        """Run a cell; press the stop button once, as soon as its output contains ``interrupt_at``."""
        result = Result()
        to_interrupt = bool(interrupt_at)

        def note(message):
            nonlocal to_interrupt
            content = message['content']
            match message['msg_type']:
                case 'stream':
                    setattr(result, content['name'], getattr(result, content['name']) + content['text'])
                case 'error':
                    result.error, result.message = content['ename'], content['evalue']
                    result.traceback = re.sub(r'\x1b\[[0-9;]*m', '', '\n'.join(content['traceback']))
                case 'execute_result':
                    result.values.append(content['data']['text/plain'])
            if to_interrupt and interrupt_at in result.stdout:
                to_interrupt = False
                self.manager.interrupt_kernel()

        self.client.execute_interactive(
            code, output_hook=note, timeout=TIMEOUT, allow_stdin=False, stop_on_error=False, store_history=store_history
        )
        return result

    def ok(self, code: str) -> Result:
        """Run a cell that must not raise."""
        result = self.run(code)
        assert not result.error, result.traceback
        return result

    def value(self, expression: str):
        """Return the value of an expression, which must be a Python literal."""
        return ast.literal_eval(self.ok(expression).values[0])

    def complaints(self) -> str:
        """Return what the process wrote to the real stderr, without ipykernel's own remarks."""
        lines = self.log.read_text().splitlines()
        return '\n'.join(line for line in lines if line and '[IPKernelApp]' not in line)

    def quit(self) -> int:
        """Ask the kernel to shut down as JupyterLab does; return its exit status."""
        self.client.shutdown()
        return self.process.wait(TIMEOUT)

    def restart(self) -> None:
        """Restart as JupyterLab does."""
        self.manager.restart_kernel()
        self.client.wait_for_ready(timeout=TIMEOUT)
