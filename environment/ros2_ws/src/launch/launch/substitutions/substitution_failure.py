"""The error of a substitution."""


class SubstitutionFailure(RuntimeError):
    """A substitution has no text to give; the message says why."""
