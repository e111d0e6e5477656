"""What a machine can lack, said in one line together with what mends it."""


class Lack(Exception):
    """The machine lacks something; the set-up cannot go on without it.

    `what` names the lack, `remedy` is the exact command (or act) that mends it.
    """

    def __init__(self, what: str, remedy: str):
        super().__init__(f'{what}; {remedy}')
        self.what = what
        self.remedy = remedy


class BuildFailed(Exception):
    """A step failed for a reason that is no known lack; `tail` holds its last lines of output."""

    def __init__(self, what: str, tail: str, log: str):
        super().__init__(what)
        self.what = what
        self.tail = tail
        self.log = log
