"""Where the learner's code runs while it is graded.

A sandbox is a launcher, `module:function`, with the signature of `helpers.runner.launch.start`: it starts the learner's
fork server and returns a `Started`. The name of the one that was used stands in every result.

There is one so far: `none`, a plain child process with limits on memory, computing time, files and output. It keeps a
learner's mistakes away from the grader, but not a learner's malice: grade only submissions that you trust with it.
"""

LAUNCHERS = {'none': 'helpers.runner.launch:start'}
DEFAULT = 'none'


def launcher(name: str = DEFAULT) -> str:
    """The launcher of the sandbox called `name`.

    :raises KeyError: there is no such sandbox.
    """
    return LAUNCHERS[name]
