"""Reads YAML launch files."""

from __future__ import annotations

import os
from typing import TextIO

import yaml
from launch import frontend

from launch_yaml.entity import Entity


class Parser(frontend.Parser):
    """The parser of YAML."""

    @classmethod
    def load(cls, file: str | os.PathLike | TextIO) -> tuple[Entity, Parser]:
        """
        Return the outermost entity of a file, and a parser.

        :raises yaml.YAMLError: if it is no YAML
        :raises RuntimeError: if it is not one mapping with one key
        :raises OSError: if it cannot be read
        """
        if isinstance(file, (str, os.PathLike)):
            with open(file, encoding='utf-8') as opened:
                return cls.load(opened)
        tree = yaml.safe_load(file)
        if not isinstance(tree, dict) or len(tree) != 1:
            raise RuntimeError('Expected only one root')
        (name,) = tree
        return Entity(tree[name], name), cls()

    @classmethod
    def get_file_extensions(cls) -> set[str]:
        """Return what the names of YAML launch files end with."""
        return {'launch.yaml', 'launch.yml'}

    @classmethod
    def may_parse(cls, filename: str) -> bool:
        """Return True for any name that ends as that of a YAML file."""
        return filename.endswith(('.yaml', '.yml'))
