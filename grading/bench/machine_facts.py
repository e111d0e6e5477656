"""The machine that figures are measured on: what it is, and how busy."""

import os
import platform
from importlib import metadata
from pathlib import Path

import psutil

# Of these the figures depend most.
PACKAGES = ('rclpy', 'ipykernel', 'jupyterlab', 'nbval', 'numpy', 'pytest')
BUSY = 0.25  # of all processors, in the last minute


def facts() -> dict[str, object]:
    """Return the machine's processor, memory (bytes), system, and the versions of what is measured."""
    return {
        'processor': _processor(),
        'processors': len(os.sched_getaffinity(0)),
        'architecture': platform.machine(),
        'memory': psutil.virtual_memory().total,
        'system': _system(),
        'kernel': platform.release(),
        'python': platform.python_version(),
        'packages': dict(_versions()),
    }


def load() -> float:
    """Return how many programs wanted to run at a time, on average over the last minute."""
    return round(os.getloadavg()[0], 2)


def busy(now: float) -> str:
    """Return a warning if a load is so high that it changes the figures, or nothing."""
    processors = len(os.sched_getaffinity(0))
    if now <= BUSY * processors:
        return ''
    return (
        f'this machine is busy (load {now:.1f} on {processors} processors): times and rates will look worse than '
        'they are; the ratios suffer less'
    )


def _processor() -> str:
    for line in Path('/proc/cpuinfo').read_text(encoding='utf-8').splitlines():
        name, _, value = line.partition(':')
        if name.strip() == 'model name':
            return value.strip()
    return platform.processor()  # not every architecture has a model's name


def _system() -> str:
    try:
        return platform.freedesktop_os_release()['PRETTY_NAME']
    except (OSError, KeyError):
        return platform.system()


def _versions():
    for name in PACKAGES:
        try:
            yield name, metadata.version(name)
        except metadata.PackageNotFoundError:  # of a ROS installation that is not a package of Python's
            pass
