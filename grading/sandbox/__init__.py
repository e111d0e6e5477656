"""Where the learner's code runs while it is graded.

`bubblewrap`: a sandbox that holds off attacks. `none`: plain processes with limits, which hold off mistakes only; use
it for submissions that you trust with your machine. The name of the one that was used stands in every result.

    layout          what the sandboxes see (the arguments of bubblewrap)
    holder          a running bubblewrap that others enter
    station         the grader's side: two warm servers, started once
    unprivileged    how root gives up being root first
    warm            the servers: fork for each submission
    tests_side      the tests of one submission, in a sandbox with a network of their own
    learners_side   the learner's programs, in a sandbox within that network
    namespaces, seccomp    system calls, and which of them a learner's program may use

A sandbox is a launcher, `module:function`, with the signature of `helpers.runner.launch.start`; its module may have a
`start_tests`, too.
"""

LAUNCHERS = {'bubblewrap': 'grading.sandbox.bubblewrap:start', 'none': 'helpers.runner.launch:start'}
DEFAULT = 'bubblewrap'


def launcher(name: str = DEFAULT) -> str:
    """The launcher of the sandbox called `name`.

    :raises KeyError: there is no such sandbox.
    """
    return LAUNCHERS[name]
