from environment.tests.running import domain, peer, start  # noqa: F401
