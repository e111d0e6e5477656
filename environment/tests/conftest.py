"""Made-up machines for the set-up's tests."""

import os
import stat
from pathlib import Path

import pytest

from environment.setup.layout import Layout


@pytest.fixture
def tool(tmp_path):
    """Make a fake program: `tool('cc', 'exit 1')` returns its directory, fit for PATH."""
    directory = tmp_path / 'tools'
    directory.mkdir()

    def make(name: str, script: str) -> Path:
        path = directory / name
        path.write_text(f'#!/bin/sh\n{script}\n')
        path.chmod(path.stat().st_mode | stat.S_IXUSR)
        return directory

    return make


@pytest.fixture
def stock(tmp_path):
    """Make a made-up stock ROS: `stock('jazzy', 'rclpy')` returns its prefix."""

    def make(name: str, *packages: str, python: str = 'python3.12') -> Path:
        prefix = tmp_path / name
        index = prefix / 'share' / 'ament_index' / 'resource_index' / 'packages'
        index.mkdir(parents=True)
        for package in packages:
            (index / package).touch()
            (prefix / 'share' / package).mkdir()
            (prefix / 'lib' / python / 'site-packages' / package).mkdir(parents=True)
        return prefix

    return make


@pytest.fixture
def checkout(tmp_path) -> Layout:
    """An empty checkout with a lock and two packages, of which `upper` needs `lower`."""
    layout = Layout(tmp_path / 'course')
    layout.sources.mkdir(parents=True)
    layout.cmake_include.parent.mkdir()
    layout.cmake_include.touch()
    layout.requirements.write_text('ros-jazzy-rclpy==1\nnumpy==2\nrich==3\n')
    add_package(layout, 'lower')
    add_package(layout, 'upper', 'lower')
    return layout


def add_package(layout: Layout, name: str, *needs: str) -> Path:
    directory = layout.sources / name
    directory.mkdir()
    depends = ''.join(f'<depend>{n}</depend>' for n in needs)
    (directory / 'package.xml').write_text(f'<package format="3"><name>{name}</name>{depends}</package>')
    (directory / 'code.py').write_text(f'# {name}\n')
    return directory


@pytest.fixture
def clean_environ():
    """This process's variables without any ROS or virtual environment."""
    drop = ('ROS_', 'AMENT_', 'COLCON_', 'CMAKE_', 'PYTHON', 'VIRTUAL', 'CONDA', 'COURSE_', 'LD_', '_ROS', 'RCUTILS')
    return {name: value for name, value in os.environ.items() if not name.startswith(drop)}
