from environment.tests.running import domain, start  # noqa: F401
