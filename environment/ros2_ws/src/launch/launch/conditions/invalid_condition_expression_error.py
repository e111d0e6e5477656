"""The error of a condition."""


class InvalidConditionExpressionError(Exception):
    """The text of a condition is neither true nor false."""
