from environment.tests.running import domain, peer, start, terminal  # noqa: F401
