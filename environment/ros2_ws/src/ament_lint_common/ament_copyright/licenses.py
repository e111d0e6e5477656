"""Which licence a text is under, by sentences that only this licence has, or by its SPDX identifier."""

import re
from dataclasses import dataclass

UNKNOWN = '<unknown>'
HOLDERS = {'osrf': 'Open Source Robotics Foundation, Inc.'}


@dataclass(frozen=True)
class License:
    """A licence: its name, its SPDX identifier, and for each form of its text the sentences that tell it."""

    name: str
    spdx: str
    forms: tuple[tuple[str, ...], ...]


_BSD = 'Redistribution and use in source and binary forms, with or without modification, are permitted'
_NO_ENDORSEMENT = 'may be used to endorse or promote products derived from'
_MIT = 'Permission is hereby granted, free of charge, to any person obtaining a copy of this software'
_NOTICE = 'The above copyright notice and this permission notice'
_VERSION_3 = 'either version 3 of the License, or (at your option) any later version'
# Those of more sentences come before those that have a part of them.
LICENSES = {
    'apache2': License(
        'Apache License, Version 2.0',
        'Apache-2.0',
        (
            ('Licensed under the Apache License, Version 2.0',),
            ('Apache License Version 2.0, January 2004',),
            ('contributions', 'under the Apache 2 License'),
        ),
    ),
    'boost1': License(
        'Boost Software License - Version 1.0',
        'BSL-1.0',
        (('Boost Software License - Version 1.0',), ('Distributed under the Boost Software License, Version 1.0',)),
    ),
    'bsd': License('BSD License 2.0', 'BSD-3-Clause', ((_BSD, _NO_ENDORSEMENT),)),
    'bsd_2clause': License('BSD 2-Clause License', 'BSD-2-Clause', ((_BSD,),)),
    'lgplv3': License(
        'GNU Lesser General Public License 3.0',
        'LGPL-3.0-only',
        (('GNU Lesser General Public License', _VERSION_3), ('GNU LESSER GENERAL PUBLIC LICENSE Version 3',)),
    ),
    'gplv3': License(
        'GNU General Public License 3.0',
        'GPL-3.0-only',
        (('GNU General Public License', _VERSION_3), ('GNU GENERAL PUBLIC LICENSE Version 3',)),
    ),
    'mit': License('MIT License', 'MIT', ((_MIT, _NOTICE),)),
    'mit0': License('MIT-0 License', 'MIT-0', ((_MIT,),)),
}
_COPYRIGHT = re.compile(
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
    return [f'{holder.strip()} ({years})' for years, holder in _COPYRIGHT.findall(comment)]


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
