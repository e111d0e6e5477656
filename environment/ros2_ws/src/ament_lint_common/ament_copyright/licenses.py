"""
The licences that are known: their texts, and which of them a text is under.

What tells a licence are sentences that only this one has, or its SPDX identifier.
"""

import datetime
import re
from dataclasses import dataclass
from importlib import resources

UNKNOWN = '<unknown>'
HOLDERS = {'osrf': 'Open Source Robotics Foundation, Inc.'}
_TEXTS = resources.files('ament_copyright') / 'texts'
_NOTICE_OF_TEXT = 'Copyright @year @holder'


@dataclass(frozen=True)
class License:
    """
    A licence: its name, its SPDX identifier, and for each form of its text the sentences that tell it.

    :param header: what a source file says below its copyright notice; None for the whole text
    """

    name: str
    spdx: str
    forms: tuple[tuple[str, ...], ...]
    header: str | None = None

    @property
    def license_files(self) -> list[str]:
        """The text, with ``{copyright}`` where the notice comes, as upstream's."""
        text = (_TEXTS / f'{self.spdx}.txt').read_text(encoding='utf-8')
        return [text.replace(_NOTICE_OF_TEXT, '{copyright}')]

    @property
    def file_headers(self) -> list[str]:
        """What a source file begins with, with ``{copyright}`` where the notice comes, as upstream's."""
        return self.license_files if self.header is None else [f'{{copyright}}\n\n{self.header}']

    @property
    def contributing_files(self) -> list[str]:
        """What a repository says of the licence of contributions."""
        return [
            f'Contributions to this repository are made under its own licence, the {self.name}: see LICENSE.\n\n'
            f'SPDX-License-Identifier: {self.spdx}\n'
        ]


def with_notice(template: str, holder: str) -> str:
    """Return a text of a licence with this year's copyright notice of the holder."""
    return template.format(copyright=f'Copyright {datetime.date.today().year} {holder}')


_BSD = 'Redistribution and use in source and binary forms, with or without modification, are permitted'
_NO_ENDORSEMENT = 'may be used to endorse or promote products derived from'
_MIT = 'Permission is hereby granted, free of charge, to any person obtaining a copy of this software'
_NOTICE = 'The above copyright notice and this permission notice'
_VERSION_3 = 'either version 3 of the License, or (at your option) any later version'
_APACHE_HEADER = """\
Licensed under the Apache License, Version 2.0 (the "License");
you may not use this file except in compliance with the License.
You may obtain a copy of the License at

    http://www.apache.org/licenses/LICENSE-2.0

Unless required by applicable law or agreed to in writing, software
distributed under the License is distributed on an "AS IS" BASIS,
WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
See the License for the specific language governing permissions and
limitations under the License.
"""
_BOOST_HEADER = """\
Distributed under the Boost Software License, Version 1.0.
(See accompanying file LICENSE or copy at https://www.boost.org/LICENSE_1_0.txt)
"""
_GNU_HEADER = """\
This program is free software: you can redistribute it and/or modify
it under the terms of the GNU {kind} as published by
the Free Software Foundation, either version 3 of the License, or
(at your option) any later version.

This program is distributed in the hope that it will be useful,
but WITHOUT ANY WARRANTY; without even the implied warranty of
MERCHANTABILITY or FITNESS FOR A PARTICULAR PURPOSE.  See the
GNU {kind} for more details.

You should have received a copy of the GNU {kind}
along with this program.  If not, see <https://www.gnu.org/licenses/>.
"""
# Those of more sentences come before those that have a part of them; a text is under the first one that fits.
LICENSES = {
    'apache2': License(
        'Apache License, Version 2.0',
        'Apache-2.0',
        (
            ('Licensed under the Apache License, Version 2.0',),
            ('Apache License Version 2.0, January 2004',),
            ('contributions', 'under the Apache 2 License'),
        ),
        _APACHE_HEADER,
    ),
    'boost1': License(
        'Boost Software License - Version 1.0',
        'BSL-1.0',
        (('Boost Software License - Version 1.0',), ('Distributed under the Boost Software License, Version 1.0',)),
        _BOOST_HEADER,
    ),
    'bsd2': License('BSD License 2.0', 'BSD-2.0', (('Software License Agreement (BSD License', _BSD),)),
    'bsd_3clause': License('3-Clause BSD License', 'BSD-3-Clause', ((_BSD, _NO_ENDORSEMENT),)),
    'bsd_2clause': License('2-Clause BSD License', 'BSD-2-Clause', ((_BSD,),)),
    'lgplv3': License(
        'GNU Lesser General Public License 3.0',
        'LGPL-3.0-only',
        (
            ('GNU Lesser General Public License as published by', _VERSION_3),
            ('GNU LESSER GENERAL PUBLIC LICENSE Version 3',),
        ),
        _GNU_HEADER.format(kind='Lesser General Public License'),
    ),
    'gplv3': License(
        'GNU General Public License 3.0',
        'GPL-3.0-only',
        (('GNU General Public License', _VERSION_3), ('GNU GENERAL PUBLIC LICENSE Version 3',)),
        _GNU_HEADER.format(kind='General Public License'),
    ),
    'mit': License('MIT License', 'MIT', ((_MIT, _NOTICE),)),
    'mit0': License('MIT-0 License', 'MIT-0', ((_MIT,),)),
}
COPYRIGHT = re.compile(
    r'copyright(?:\s+\(c\))?\s+(\d{4}(?:-\d{4})?(?:,\s*\d{4}(?:-\d{4})?)*),?\s+([^\n\r]+)', re.IGNORECASE
)
_COMMENT_MARK = re.compile(r'^[ \t]*(?:#+|/{2,}|\*(?!/))[ \t]?', re.MULTILINE)


def leading_comment(text: str) -> str:
    """Return the comments that a source file begins with, without their marks; '' if there is none."""
    lines = []
    in_block = False
    for line in text.lstrip('\ufeff').splitlines():
        bare = line.strip()
        if in_block:
            in_block = '*/' not in bare
        elif bare.startswith('/*'):
            in_block = '*/' not in bare
        elif bare and not bare.startswith(('#', '//')):
            break
        elif bare.startswith(('#include', '#ifndef', '#pragma', '#define')):
            break
        lines.append(line.replace('/*', '  ').replace('*/', '  '))
    return _COMMENT_MARK.sub('', '\n'.join(lines))


def find_copyrights(comment: str) -> list[str]:
    """Return the notices of a comment, each as `holder (years)`."""
    return [f'{holder.strip()} ({years})' for years, holder in COPYRIGHT.findall(comment)]


def find_license(text: str) -> str:
    """Return the identifier of the licence, or UNKNOWN."""
    flat = ' '.join(text.split()).casefold()
    stated = re.search(r'spdx-license-identifier:\s*([\w.+-]+)', flat)
    for identifier, license_ in LICENSES.items():
        if stated and stated[1] == license_.spdx.casefold():
            return identifier
        if any(all(sentence.casefold() in flat for sentence in form) for form in license_.forms):
            return identifier
    return UNKNOWN
