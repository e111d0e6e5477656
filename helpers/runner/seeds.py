"""From one seed to the random inputs of every test: HMAC-SHA256, the same on every machine.

A grader's run has one seed. Each submission's seed comes from it, and each test's from that one: so inputs that a test
draws differ between learners, and are the same when the same work is graded again with the same seed.
"""

import hashlib
import hmac
import random
import secrets


def fresh() -> str:
    """A new seed: 32 hexadecimal digits."""
    return secrets.token_hex(16)


def derive(seed: str, *names: str) -> str:
    """The seed of something that has `names`, below `seed`. Without `seed` it cannot be guessed."""
    return hmac.new(seed.encode(), '\0'.join(names).encode(), hashlib.sha256).hexdigest()[:32]


def generator(seed: str, test: str) -> random.Random:
    """What the test called `test` draws from in a session with this seed."""
    return random.Random(int(derive(seed, test), 16))
