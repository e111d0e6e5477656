"""The learner's side of workspaces: files are written and commands run here, where only the learner's code can suffer.

Requests, beside those of `helpers.runner.worker`: value, files, run, listing. Tests use `helpers.runner.workspaces`.
"""

import os
import subprocess
import threading
from pathlib import Path

import psutil

from helpers import terminals
from helpers.runner import values

HOME = Path(os.environ.get('HOME', '/'))  # of the whole learner's side: workspaces outlive one of its processes
MAX_FILES = 2000  # names in a listing


class Commands:
    """The requests; a base of `worker.Worker`."""

    def do_value(self, name: str):
        """What the learner's program binds to a name."""
        return {'result': values.encode(self.program.find(name))}

    def do_files(self, folder: str, files: dict[str, str]):
        """Write text files below a folder of HOME, and colcon's defaults with them."""
        root = HOME / folder
        for name, text in {terminals.DEFAULTS: terminals.colcon_defaults(), **files}.items():
            path = root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return {}

    def do_listing(self, folder: str):
        """The files and links below a folder, without caches."""
        root = HOME / folder
        found = [path.relative_to(root).as_posix() for path in root.rglob('*') if not path.is_dir()]
        return {'files': sorted(name for name in found if '__pycache__' not in name)[:MAX_FILES]}

    def do_run(self, argv: list[str], folder: str, timeout: float, keep: int):
        """Run a command in a new terminal: the ROS installation is sourced, then the folder's own `install`, if any.

        Gives its exit status (None: it was ended after `timeout` seconds) and the last `keep` bytes of its output.
        """
        script = '[ ! -f install/setup.bash ] || source install/setup.bash\nexec "$@"'
        process = subprocess.Popen([*terminals.shell(script), 'bash', *argv], cwd=HOME / folder,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   env={**os.environ, 'COLCON_DEFAULTS_FILE': str(HOME / folder / terminals.DEFAULTS)})
        output = bytearray()
        reader = threading.Thread(target=_keep_last, args=(process.stdout, output, keep), daemon=True)
        reader.start()
        try:
            status = process.wait(timeout)
        except subprocess.TimeoutExpired:
            status = None
        # It stays in this process's group, so that it ends with this one however that comes; here, what it left.
        for child in psutil.Process().children(recursive=True):
            try:
                child.kill()
            except psutil.NoSuchProcess:
                pass
        process.wait()
        reader.join(2.0)
        return {'status': status, 'output': bytes(output).decode(errors='replace')}


def _keep_last(stream, kept: bytearray, limit: int) -> None:
    while chunk := stream.read1(65536):
        kept += chunk
        del kept[:-limit]
