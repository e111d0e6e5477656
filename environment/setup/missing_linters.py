"""Lets linters report a skipped test where the program that they run is not installed (runs inside these linters).

Each new package of C++, and each interface package with linter tests, asks for cppcheck and uncrustify. Upstream
installs them with ROS; no package index for Python has cppcheck, and the wheel of uncrustify is empty for Python 3.13.
A test that can only fail would hide those that say something.
"""

import argparse
import functools
import shutil
import sys
from pathlib import Path
from xml.etree import ElementTree


def skip_without(program, main):
    """Return the linter's `main`, which does without the program what is written above."""
    reason = f"Could not find '{program}' executable: skipped (on Debian or Ubuntu: sudo apt install {program})"

    @functools.wraps(main)
    def wrapper(argv=None):
        argv = sys.argv[1:] if argv is None else argv
        if shutil.which(program):
            return main(argv)
        print(reason, file=sys.stderr)
        parser = argparse.ArgumentParser(add_help=False)
        parser.add_argument('--xunit-file')
        file = parser.parse_known_args(argv)[0].xunit_file
        if file:
            _write(Path(file), program, reason)
        return 0

    return wrapper


def _write(path, program, reason):
    name = f'{path.parent.name}.{path.name.removesuffix(".xml").removesuffix(".xunit")}'
    suite = ElementTree.Element('testsuite', name=name, tests='1', errors='0', failures='0', skipped='1', time='0')
    case = ElementTree.SubElement(suite, 'testcase', name=program, classname=name)
    ElementTree.SubElement(case, 'skipped', message=reason)
    path.parent.mkdir(parents=True, exist_ok=True)
    ElementTree.ElementTree(suite).write(path, encoding='utf-8', xml_declaration=True)
