"""The doctor's probes, on made-up machines."""

import os
from pathlib import Path

import pytest

from environment.setup import facts
from environment.setup.layout import Layout
from environment.setup.main import ROOT


@pytest.mark.parametrize(
    ('variable', 'ok', 'required'),
    [('', True, True), ('7', True, True), ('101', True, True), ('150', False, False), ('233', False, True),
     ('x', False, True), ('-1', False, True)],
)  # fmt: skip
def test_domain(variable, ok, required):
    fact = facts.domain({'ROS_DOMAIN_ID': variable})
    assert (fact.ok, fact.required) == (ok, required)
    assert fact.ok or 'export ROS_DOMAIN_ID' in fact.remedy


@pytest.mark.parametrize(('value', 'ok'), [('LOCALHOST', True), ('SUBNET', True), ('OFF', False), ('local', False)])
def test_discovery_range(value, ok):
    assert facts.discovery({'ROS_AUTOMATIC_DISCOVERY_RANGE': value}).ok is ok


def test_a_private_home_is_found(tmp_path):
    inner = tmp_path / 'home' / 'bin'
    inner.mkdir(parents=True)
    python = inner / 'python'
    python.touch()
    for path in (tmp_path / 'home', inner, python):
        path.chmod(0o755)
    outside = facts.closed_to_others(tmp_path)
    assert facts.closed_to_others(python) == outside
    (tmp_path / 'home').chmod(0o700)
    assert facts.closed_to_others(python) == (outside or tmp_path / 'home')
    assert facts.closed_to_others(python, tmp_path / 'home') == tmp_path / 'home'
    assert facts.closed_to_others(python, inner) is None


def test_system_files_are_open():
    assert facts.closed_to_others(Path('/usr/bin/env')) is None


def test_sandbox_missing():
    fact = facts.sandbox(which=lambda name: None)
    assert not fact.ok
    assert not fact.required
    assert fact.remedy == 'run: sudo apt install bubblewrap'


def test_sandbox_works():
    assert facts.sandbox(which=lambda name: '/usr/bin/bwrap', attempt=lambda: '').ok


@pytest.mark.parametrize(
    ('setting', 'value', 'remedy'),
    [
        ('kernel/apparmor_restrict_unprivileged_userns', '1', 'apparmor_parser'),
        ('kernel/unprivileged_userns_clone', '0', 'unprivileged_userns_clone=1'),
        ('user/max_user_namespaces', '0', 'max_user_namespaces='),
        ('kernel/apparmor_restrict_unprivileged_userns', '0', 'Docker'),
    ],
)
def test_sandbox_forbidden_by_the_kernel(tmp_path, setting, value, remedy):
    (tmp_path / setting).parent.mkdir(parents=True)
    (tmp_path / setting).write_text(value + '\n')
    fact = facts.sandbox(lambda name: '/usr/bin/bwrap', lambda: 'bwrap: No permissions', tmp_path)
    assert not fact.ok
    assert 'No permissions' in fact.text
    assert remedy in fact.remedy


def test_a_probe_that_fails_does_not_end_the_report(monkeypatch):
    def broken(*_):
        raise RuntimeError('boom')

    monkeypatch.setattr(facts, 'disk', broken)
    monkeypatch.setattr(facts, 'wire', lambda *_: facts.Fact('wire', True, ''))
    found = list(facts.facts(ROOT))
    assert len(found) > 10
    assert any('boom' in fact.text for fact in found)


@pytest.mark.parametrize('foreign', [True, False])
def test_an_import_that_fails_is_not_the_firewalls_fault(tmp_path, foreign):
    (tmp_path / 'yaml.py').write_text('raise ImportError("another yaml")\n')
    environ = {**os.environ, 'AMENT_PREFIX_PATH': '/opt/ros/jazzy', 'PYTHONPATH': f':/opt/ros/jazzy/lib:{tmp_path}'}
    fact = facts.wire(Layout(ROOT) if foreign else _WithPython(tmp_path), environ)
    assert not fact.ok and 'ImportError: another yaml' in fact.text and 'firewall' not in fact.remedy
    assert fact.remedy == ('run: unset PYTHONPATH' if foreign else 'run: rm -rf .venv, then ./course')
    assert fact.text.endswith(f'; PYTHONPATH is {tmp_path}') is foreign


class _WithPython(Layout):
    """A checkout that has this one's Python."""

    python = ROOT / '.venv' / 'bin' / 'python'


def test_this_machine_runs_the_course():
    missing = [fact for fact in facts.facts(ROOT) if not fact.ok]
    assert not [fact for fact in missing if fact.required]
    assert all(fact.remedy for fact in missing)
