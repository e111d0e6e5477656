"""The table of README.md, made from the headers of the corpus: `python -m grading.tests.attacks.readme` writes it."""

import re
from pathlib import Path

from grading.tests.attacks import arena

README = Path(__file__).with_name('README.md')
_TABLE = re.compile(r'(?<=<!-- corpus -->\n).*?(?=<!-- end -->)', re.DOTALL)


def table() -> str:
    """One row per attack, by family."""
    rows = ['| attack | what it does | what stops it |', '|---|---|---|']
    rows += [
        f'| `{attack.family}/{attack.name}` | {attack.header["attack"]} | {attack.header["stopped by"]} |'
        for attack in arena.attacks()
    ]
    return '\n'.join(rows) + '\n'


def updated() -> str:
    """README.md with the table of today."""
    return _TABLE.sub(lambda found: table(), README.read_text(encoding='utf-8'))


if __name__ == '__main__':
    README.write_text(updated(), encoding='utf-8')
