from environment.tests.running import domain, peer  # noqa: F401
