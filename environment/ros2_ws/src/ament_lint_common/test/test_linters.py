"""The linters of this package: what they find, what they print, and their JUnit files."""

import datetime
from xml.etree import ElementTree

import pytest
from ament_copyright import get_licenses
from ament_copyright.licenses import UNKNOWN, find_license, leading_comment
from ament_copyright.main import main as ament_copyright
from ament_lint_cmake.main import main as ament_lint_cmake
from ament_xmllint.main import main as ament_xmllint

APACHE = '# Copyright 2024 Ada\n#\n# Licensed under the Apache License, Version 2.0 (the "License");\n\nx = 1\n'


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """The folder in which the linters run."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def failures(file):
    """(the suite's name, the messages of its failed cases)."""
    suite = ElementTree.parse(file).getroot()
    assert int(suite.get('failures')) == len(suite.findall('.//failure'))
    return suite.get('name'), [failure.get('message') for failure in suite.iter('failure')]


def test_copyright_names_the_files_without_a_notice(folder, capsys):
    (folder / 'good.py').write_text(APACHE)
    (folder / 'empty.py').touch()
    (folder / 'bad.py').write_text('x = 1\n')
    (folder / 'odd.cpp').write_text('// Copyright 2024 Ada\n// All rights reserved.\n#include <a>\n')
    (folder / '.hidden').mkdir()
    (folder / '.hidden' / 'no.py').write_text('x = 1\n')
    assert ament_copyright(['--xunit-file', 'results/pkg/copyright.xunit.xml']) == 1
    printed = capsys.readouterr()
    assert printed.err.splitlines() == [
        'bad.py: could not find copyright notice',
        'odd.cpp: copyright=Ada (2024), license=<unknown>',
        '2 errors, checked 4 files',
    ]
    assert failures('results/pkg/copyright.xunit.xml') == (
        'pkg.copyright',
        ['could not find copyright notice', 'copyright=Ada (2024), license=<unknown>'],
    )
    assert ament_copyright(['--exclude', 'bad.py', 'odd.cpp', '--', '.']) == 0
    assert capsys.readouterr().out == 'No problems found, checked 2 files\n'


def test_copyright_of_a_package_and_of_a_repository(folder, capsys):
    (folder / 'setup.py').write_text('x = 1\n')
    (folder / 'package.xml').touch()
    assert ament_copyright([]) == 0
    assert capsys.readouterr().err == 'No repository roots and files found\n'
    (folder / '.git').mkdir()
    (folder / 'LICENSE').write_text(
        'Permission is hereby granted, free of charge, to any person obtaining a copy of '
        'this software\n The above copyright notice and this permission notice'
    )
    assert ament_copyright([]) == 1
    assert capsys.readouterr().err.splitlines()[0] == 'CONTRIBUTING.md: file not found'


@pytest.mark.parametrize('identifier', sorted(get_licenses()))
def test_missing_notices_are_written_below_the_first_lines(folder, capsys, identifier):
    (folder / '.git').mkdir()
    (folder / 'program.py').write_text('#!/usr/bin/env python3\n# coding: utf-8\n\n\nx = 1\n')
    (folder / 'a.hpp').write_text('\n#include <b>\n')
    (folder / 'good.py').write_text(APACHE)
    (folder / 'empty.py').touch()
    assert ament_copyright(['--add-missing', 'Ada', identifier]) == 0
    assert capsys.readouterr().out.splitlines() == ['+ CONTRIBUTING.md', '+ LICENSE', '* a.hpp', '* program.py']
    year = datetime.date.today().year
    assert (folder / 'a.hpp').read_text().endswith('\n\n#include <b>\n')
    text = (folder / 'program.py').read_text()
    assert text.startswith('#!/usr/bin/env python3\n# coding: utf-8\n\n# ') and text.endswith('\n\nx = 1\n')
    assert f'# Copyright {year} Ada\n#\n' in text and 'LICENSE' in (folder / 'CONTRIBUTING.md').read_text()
    assert (folder / 'good.py').read_text() == APACHE and (folder / 'empty.py').read_text() == ''

    assert ament_copyright(['--add-missing', 'Ada', identifier, '--verbose']) == 0  # there is nothing left to do
    assert f'+ Copyright {year} Ada' in (printed := capsys.readouterr().out) and '  program.py' in printed
    assert (folder / 'program.py').read_text() == text
    assert ament_copyright(['--verbose']) == 0  # and all of it is understood
    printed = capsys.readouterr().out.splitlines()
    assert printed[:3] == [f'CONTRIBUTING.md: {identifier}', f'LICENSE: {identifier}', (
        f'a.hpp: copyright=Ada ({year}), license={identifier}'
    )]  # fmt: skip
    with pytest.raises(SystemExit, match='2'):
        ament_copyright(['--add-missing', 'Ada', 'nobody'])
    assert "'--list-licenses' lists them" in capsys.readouterr().err


def test_years_are_added_to_the_notices(folder, capsys):
    before = {'a.py': '2019', 'b.cpp': '2019-2021, 2024', 'c.py': '2022-2023'}
    for name, years in before.items():
        mark = '#' if name.endswith('.py') else '//'
        (folder / name).write_text(f'{mark} Copyright {years} Ada\n{mark} Copyright 2001 Bob\n')
    (folder / 'none.py').write_text('x = "Copyright 2001 Eve"\n')
    assert ament_copyright(['--add-copyright-year', '2022', '2023', '--verbose']) == 0
    assert [line for line in capsys.readouterr().out.splitlines() if line] == ['* a.py', '* b.cpp', '  c.py']
    assert [(folder / name).read_text().split(' Copyright ')[1:] for name in before] == [
        ['2019, 2022-2023 Ada\n#', '2001 Bob\n'],
        ['2019-2024 Ada\n//', '2001 Bob\n'],
        ['2022-2023 Ada\n#', '2001 Bob\n'],
    ]
    assert ament_copyright(['--add-copyright-year']) == 0
    assert f'{datetime.date.today().year} Ada' in (folder / 'a.py').read_text()
    assert (folder / 'none.py').read_text() == 'x = "Copyright 2001 Eve"\n'


def test_which_licence():
    assert find_license(leading_comment(APACHE)) == 'apache2'
    assert find_license('SPDX-License-Identifier: BSD-3-Clause') == 'bsd_3clause'
    assert find_license('/* nothing */') == UNKNOWN
    block = '/*\n * Copyright 2020 Ada\n * Distributed under the Boost Software\n * License, Version 1.0.\n */\n'
    assert find_license(leading_comment(block)) == 'boost1'


def test_xmllint(folder, capsys):
    (folder / 'good.xml').write_text('<a><b/></a>')
    assert ament_xmllint([]) == 0
    assert capsys.readouterr().out == "File 'good.xml' is valid\n\nNo problems found\n"
    (folder / 'bad.xml').write_text('<a><b></a>')
    (folder / 'package.xml').write_text('<package format="3"><name>x</name></package>')
    assert ament_xmllint(['--xunit-file', 'results/pkg/xmllint.xunit.xml']) == 1
    assert '2 files are invalid' in capsys.readouterr().err
    name, messages = failures('results/pkg/xmllint.xunit.xml')
    assert (name, len(messages)) == ('pkg.xmllint', 2)
    assert 'mismatch' in messages[0]
    assert ament_xmllint(['--extensions', 'sdf']) == 1
    assert capsys.readouterr().err == 'No files found\n'


def test_lint_cmake(folder, capsys):
    (folder / 'CMakeLists.txt').write_text('cmake_minimum_required(VERSION 3.8)\nproject( x )\n' + '#' * 141 + '\n')
    assert ament_lint_cmake(['--xunit-file', 'results/pkg/lint_cmake.xunit.xml']) == 1
    printed = capsys.readouterr()
    assert 'CMakeLists.txt:3: Lines should be <= 140 characters long [linelength]' in printed.err.splitlines()
    assert printed.out.splitlines()[-1] == f'{len(printed.err.splitlines())} errors'
    assert failures('results/pkg/lint_cmake.xunit.xml')[0] == 'pkg.lint_cmake'
    assert ament_lint_cmake(['--linelength', '200', '--filters=-whitespace']) == 0
    assert capsys.readouterr().out.splitlines()[-1] == 'No problems found'
