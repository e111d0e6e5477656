"""Text from the learner's side, made safe to show: bounded, without control characters, the same each time."""

import re

MAX_MESSAGE = 2000
MAX_OUTPUT = 20_000  # characters
LEFT_OUT = '[more was printed; the rest is left out]'

# C0 and C1 controls but newline and tab, and the marks that turn the direction of text around.
_CONTROL = re.compile(r'[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]')
_ANSI = re.compile(r'\x1b\[[0-9;?]*[ -/]*[@-~]')
_ADDRESS = re.compile(r'\b0x[0-9a-fA-F]{6,}\b')


def clean(text: str, limit: int = MAX_MESSAGE) -> str:
    """The text without escapes, control characters and memory addresses, at most `limit` characters long."""
    text = _ADDRESS.sub('0x…', _ANSI.sub('', str(text)[: 2 * limit].replace('\r\n', '\n')))
    text = _CONTROL.sub('\ufffd', text).encode('utf-8', 'replace').decode('utf-8')
    return text if len(text) <= limit else text[:limit] + ' …'
