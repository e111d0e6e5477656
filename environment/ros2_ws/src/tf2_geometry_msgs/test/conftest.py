from environment.tests.tf2_domain import domain, logged  # noqa: F401
