"""What may happen to a reader (`grading.reader`) that reads something hostile."""

import os
import resource


def run(way: str):
    """Spin, crash, use up the memory, raise, or answer with what is no JSON."""
    resource.setrlimit(resource.RLIMIT_CPU, (1, 1))
    match way:
        case 'spin':
            while True:
                pass
        case 'crash':
            os.abort()
        case 'memory':
            return [bytes(2**30) for _ in range(100)], ()
        case 'raise':
            raise ValueError('FORGED\x1b[2J')
        case 'answer':
            return {1, 2}, ()
