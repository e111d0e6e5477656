# ruff: noqa: F401 - imports for the attacks
"""What the attacks of the corpus share. Its text stands in a cell of every hostile notebook, before the attack."""

import ctypes
import os
import re
import signal
import socket
import subprocess
import sys
import threading
import time

COOKIE = 'cookie'  # each batch of attacks has its own: by it, what an attack has left behind is recognised
# In two parts: so this text is not what it describes.
SHAPE = 'CANARY-[0-9a-f]{16}'


def tell(*words):
    """Print at once: what an attack has found must not be lost with its process."""
    print(*words, flush=True)


def search(text, where):
    """Tell each canary in a text or in bytes."""
    if isinstance(text, bytes):
        text = text.decode('latin-1')
    for canary in sorted(set(re.findall(SHAPE, text))):
        tell('FOUND', canary, 'in', where)


def search_file(path, limit=2**22):
    """Search a file that may be anything."""
    try:
        with open(path, 'rb') as file:
            search(file.read(limit), path)
    except (OSError, ValueError):
        pass


def walk(*roots, seconds=1.0):
    """Search all files below the roots, for a while."""
    end = time.monotonic() + seconds
    for root in roots:
        for folder, _, names in os.walk(root):
            for name in names:
                if time.monotonic() > end:
                    return
                path = os.path.join(folder, name)
                if os.path.isfile(path):
                    search_file(path)


def touch(path):
    """Tell if a file could be written. It is opened for writing, and not written."""
    try:
        os.close(os.open(path, os.O_WRONLY | os.O_APPEND))
    except OSError:
        return
    tell('TOUCHED', path)


def plant(folder):
    """Leave a file with the cookie's name in a folder, if that is possible."""
    try:
        with open(os.path.join(folder, COOKIE), 'w') as file:
            file.write('was here')
    except OSError:
        pass


def disguise():
    """Name the process after the cookie."""
    ctypes.CDLL(None).prctl(15, COOKIE.encode())


def linger(seconds=30):
    """Be a process that the cookie names, for a while: also if nobody ends it."""
    for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGALRM):
        signal.signal(number, signal.SIG_IGN)
    disguise()
    time.sleep(seconds)
    os._exit(0)
