"""All faults by name."""

from helpers.programs.faults.apt import NoSource
from helpers.programs.faults.clocks import WrongTime
from helpers.programs.faults.discovery_range import Unseen
from helpers.programs.faults.distros import MixedDistros
from helpers.programs.faults.fault import Fault, stop_all
from helpers.programs.faults.finding import name_of
from helpers.programs.faults.hang import Hang
from helpers.programs.faults.models import Falls, NoModel
from helpers.programs.faults.mystery import Mystery
from helpers.programs.faults.packages import NoProgram
from helpers.programs.faults.parameters import NoParameter
from helpers.programs.faults.rates import TooSlow
from helpers.programs.faults.services import Waiting
from helpers.programs.faults.shells import CommandNotFound, NoColcon
from helpers.programs.faults.topics import NoData
from helpers.programs.faults.transforms import NoTransform

#: The faults in the order of the chapter; the mystery, which has two of them, is the last one.
FAULTS: tuple[type[Fault], ...] = (
    CommandNotFound,
    NoColcon,
    NoSource,
    MixedDistros,
    Unseen,
    NoProgram,
    NoData,
    Waiting,
    NoModel,
    TooSlow,
    NoParameter,
    Hang,
    Falls,
    NoTransform,
    WrongTime,
    Mystery,
)


def plan(what: str, seed: int | str = 0, kind: str | None = None, folder=None, domain: int | None = None) -> Fault:
    """A fault that is drawn but not staged: nothing is written, nothing runs. For its ``files`` and ``diagnosis``.

    :param what: its name, such as ``'no_data'``, or the number that it had in earlier versions.
    :param kind: one of the fault's ``kinds``; drawn from the seed if not given.
    :param folder: where to stage it; by default ``faults_ws/NAME`` in the current folder.
    :param domain: its ROS domain; by default that of the environment.
    :raises ValueError: there is no such fault or kind.
    """
    for fault in FAULTS:
        if name_of(what) == fault.name:
            return fault(seed, kind, folder, domain)
    raise ValueError(f'there is no fault {what!r}: there are {", ".join(f.name for f in FAULTS)}')


def stage(what: str, seed: int | str = 0, kind: str | None = None, folder=None, domain: int | None = None) -> Fault:
    """Write a broken system into its folder and return its handle; arguments as in `plan`.

    One at a time: without a folder, the fault that was staged before is stopped and removed; with one, that which is
    staged in the same folder.

    :raises FileExistsError: the folder is somebody else's.
    """
    fault = plan(what, seed, kind, folder, domain)
    if folder is None:
        stop()
    return fault.stage()


def stop() -> None:
    """Stop all faults that are staged, and remove their folders."""
    stop_all()
