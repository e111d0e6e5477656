"""`python -IS client.py SOCKET PYTHON ARGUMENTS...`: let the server run what `PYTHON ARGUMENTS...` would run.

Any other command, and every command without a server, is run as it stands. Standard library only, and as few modules as
can be: the point of it is to start quickly.
"""

import os
import socket
import sys


def ask(path: str, command: list[str]) -> int | None:
    """The exit status of the command, run by the server at `path`; None if the server is gone or does not run such."""
    import json

    request = json.dumps({'command': command, 'cwd': os.getcwd(), 'environ': dict(os.environ)}).encode()
    with socket.socket(socket.AF_UNIX) as connection:
        try:
            connection.connect(path)
            socket.send_fds(connection, [len(request).to_bytes(4, 'big')], [1, 2])
            connection.sendall(request)
            answer = connection.recv(1)
        except OSError:
            return None
    return answer[0] if answer and answer[0] != 255 else None


def main() -> None:
    path, command = sys.argv[1], sys.argv[2:]
    # CMake's own commands (cmake -E copy ...) come through here as well.
    if os.path.basename(command[0]).startswith('python'):
        status = ask(path, command)
        if status is not None:
            sys.exit(status)
    os.execvp(command[0], command)


if __name__ == '__main__':
    main()
