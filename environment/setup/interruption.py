"""What Ctrl+C, SIGTERM and SIGHUP do to a command: they end it at once while it loads, later they interrupt it.

While modules load there is nothing to tidy up, and a KeyboardInterrupt would print the traceback of some import. A
signal that is ignored stays so: `nohup ./course grade …` goes on when its terminal is closed.
"""

import signal

_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def ends_at_once() -> None:
    """From now on each of the three ends the process, without a word; also one that has waited."""
    _set(signal.SIG_DFL)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, _SIGNALS)


def waits() -> None:
    """From now on the three wait, also in a program that this process becomes, until `ends_at_once` lets them in.

    A Python that starts cannot say what a signal does before `site` and the .pth files have run.
    """
    signal.pthread_sigmask(signal.SIG_BLOCK, _SIGNALS)


def raises() -> None:
    """From now on each of the three raises KeyboardInterrupt in the main thread, so that the command tidies up."""
    _set(signal.default_int_handler)


def _set(handler) -> None:
    for number in _SIGNALS:
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, handler)
