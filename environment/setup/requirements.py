"""The virtual environment and what is installed into it from PyPI."""

import re
from collections.abc import Iterable, Mapping
from importlib.metadata import distributions
from pathlib import Path

LINE = re.compile(r'^([A-Za-z0-9][A-Za-z0-9._-]*)==', re.MULTILINE)


def entry(lock: str, name: str) -> str:
    """The lines of one package in the lock: its pin with its hashes."""
    found = re.search(rf'^{re.escape(name)}==.*?(?=^\S|\Z)', lock, re.MULTILINE | re.DOTALL)
    if not found:
        raise KeyError(f'{name} is not in the lock')
    return found.group()


def entries(lock: str, pattern: str) -> str:
    """The lines of all packages whose name matches `pattern` from its start."""
    blocks = re.findall(r'^[A-Za-z0-9].*?(?=^\S|\Z)', lock, re.MULTILINE | re.DOTALL)
    return ''.join(block for block in blocks if re.match(pattern, block))


def names(lock: str) -> set[str]:
    return set(LINE.findall(lock))


def sharing(site_packages: Path, removed: Iterable[str]) -> list[str]:
    """The installed packages that have files in common with those of `removed`, whose removal takes the files away."""
    files = {
        re.sub('[-_.]+', '-', found.metadata['Name']).lower(): {str(file) for file in found.files or ()}
        for found in distributions(path=[str(site_packages)])
    }
    lost = set().union(*(files.get(name, ()) for name in removed))
    return sorted(name for name in files.keys() - set(removed) if files[name] & lost)


def for_uv(environ: Mapping[str, str], pip_config: str) -> dict[str, str]:
    """Settings for uv that say what pip's configuration says: index, find-links, certificates.

    uv reads neither pip's variables nor its files, yet a machine behind a mirror has just those.
    `pip_config` is the output of `pip config list`. What uv's own variables say already stays.
    """
    found: dict[str, str] = {}
    for line in pip_config.splitlines():
        name, _, value = line.partition('=')
        # `:env:` lines come last and win, as they do in pip.
        found[name.rpartition('.')[2].replace('_', '-')] = value.strip().strip('\'"').replace('\\n', ' ')
    settings = {}
    if not {'UV_DEFAULT_INDEX', 'UV_INDEX_URL'} & set(environ) and found.get('index-url'):
        settings['UV_DEFAULT_INDEX'] = found['index-url']
    if not {'UV_INDEX', 'UV_EXTRA_INDEX_URL'} & set(environ) and found.get('extra-index-url'):
        settings['UV_INDEX'] = ' '.join(found['extra-index-url'].split())
    if 'UV_FIND_LINKS' not in environ and found.get('find-links'):
        settings['UV_FIND_LINKS'] = ','.join(found['find-links'].split())
    if 'SSL_CERT_FILE' not in environ and found.get('cert'):
        settings['SSL_CERT_FILE'] = found['cert']
    return settings
