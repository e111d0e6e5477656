"""Where the learner's code runs while it is graded.

`bubblewrap`: a sandbox that holds off attacks. `none`: plain processes with limits, which hold off mistakes only; use
it for submissions that you trust with your machine. The name of the one that was used stands in every result.

    layout          what the sandboxes see (the arguments of bubblewrap)
    probe           whether this machine can run it
    holder          a running bubblewrap that others enter
    station         the grader's side: two servers (`helpers.runner.warm`), started once
    unprivileged    how the grader, started as root, becomes an ordinary user
    tests_side      the tests of one submission, in a sandbox with a network of their own
    learners_side   the learner's programs, in sandboxes within that network: one for cells, one for each workspace
    control_groups  the kernel's bounds on memory and processes, where they can be had
    kernel_memory   what the kernel holds for a sandbox's programs, where no control group bounds it
    namespaces, seccomp    system calls, and which of them a learner's program may use

A sandbox is a launcher, `module:function`, with the signature of `helpers.runner.start_processes.start`; its
module may have a `start_tests`, too.
"""

from functools import cache

LAUNCHERS = {'bubblewrap': 'grading.sandbox.bubblewrap:start', 'none': 'helpers.runner.start_processes:start'}
DEFAULT = 'bubblewrap'
WARNING = (
    'WARNING: --sandbox none. Submissions run as plain processes with limits, and can read and change whatever '
    'you can. Grade only what you trust.'
)


def launcher(name: str = DEFAULT) -> str:
    """The launcher of the sandbox called `name`.

    :raises KeyError: there is no such sandbox.
    """
    return LAUNCHERS[name]


@cache
def problem(name: str = DEFAULT) -> str:
    """What keeps a sandbox from working on this machine, in one line with the remedy; empty if nothing does."""
    if name != 'bubblewrap':
        return ''
    from grading.sandbox import probe

    return probe.problem()
