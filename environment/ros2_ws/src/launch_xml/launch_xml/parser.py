"""Reads XML launch files."""

from __future__ import annotations

import os
from typing import TextIO
from xml.etree import ElementTree

from launch import frontend

from launch_xml.entity import Entity


class Parser(frontend.Parser):
    """The parser of XML."""

    @classmethod
    def load(cls, file: str | os.PathLike | TextIO) -> tuple[Entity, Parser]:
        """
        Return the outermost element of a file, and a parser.

        :raises xml.etree.ElementTree.ParseError: if it is no XML
        :raises OSError: if it cannot be read
        """
        return Entity(ElementTree.parse(file).getroot()), cls()

    @classmethod
    def get_file_extensions(cls) -> set[str]:
        """Return what the names of XML launch files end with."""
        return {'launch.xml'}

    @classmethod
    def may_parse(cls, filename: str) -> bool:
        """Return True for any name that ends as that of an XML file."""
        return filename.endswith('.xml')
