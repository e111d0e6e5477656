"""Lets the linter ament_cppcheck report a skipped test where cppcheck is not installed (runs inside ament_cppcheck).

Each new package of C++, and each interface package with linter tests, asks for cppcheck. Upstream installs it with ROS;
no package index for Python has it. A test that can only fail would hide those that say something.
"""

import argparse
import functools
import shutil
import sys
from pathlib import Path
from xml.etree import ElementTree

REASON = "Could not find 'cppcheck' executable: skipped (on Debian or Ubuntu: sudo apt install cppcheck)"


def skip_without_cppcheck(main):
    """Return the linter's `main`, which does without the program what is written above."""

    @functools.wraps(main)
    def wrapper(argv=None):
        argv = sys.argv[1:] if argv is None else argv
        if shutil.which('cppcheck'):
            return main(argv)
        print(REASON, file=sys.stderr)
        parser = argparse.ArgumentParser(add_help=False)
        parser.add_argument('--xunit-file')
        file = parser.parse_known_args(argv)[0].xunit_file
        if file:
            _write(Path(file))
        return 0

    return wrapper


def _write(path):
    name = f'{path.parent.name}.{path.name.removesuffix(".xml").removesuffix(".xunit")}'
    suite = ElementTree.Element('testsuite', name=name, tests='1', errors='0', failures='0', skipped='1', time='0')
    case = ElementTree.SubElement(suite, 'testcase', name='cppcheck', classname=name)
    ElementTree.SubElement(case, 'skipped', message=REASON)
    path.parent.mkdir(parents=True, exist_ok=True)
    ElementTree.ElementTree(suite).write(path, encoding='utf-8', xml_declaration=True)
