"""What stops the set-up, said in one line together with what to do about it."""


class PreflightError(Exception):
    """Something that the set-up needs is missing, or does not work.

    `what` says what it is, `remedy` is the command to run, or what else to do.
    """

    def __init__(self, what: str, remedy: str):
        super().__init__(f'{what}; {remedy}')
        self.what = what
        self.remedy = remedy


class StepError(Exception):
    """A step failed for a reason that is not a known one; `tail` holds its last lines of output."""

    def __init__(self, what: str, tail: str, log: str):
        super().__init__(what)
        self.what = what
        self.tail = tail
        self.log = log
