"""Faults to find: every fault of chapter 7 as a small system that is broken, live, and can be repaired.

    fault = faults.stage('no_data', seed=3)
    fault                                   # what the system should do, and its files
    fault.symptom()                         # what its user sees
    fault.run('ros2 topic list')            # look at it with the real tools
    fault.edit('display.py', 'RELIABLE', 'BEST_EFFORT')
    fault.verify()                          # does it work now?
    fault.diagnosis                         # the truth, as a list of findings
    fault.stop()                            # nothing stays

Another seed gives other names, values and causes; the same seed the same ones, on every machine. ``kind=`` asks for one
cause. A system lives in a folder of its own (``faults_ws/…`` beside the notebook) and in child processes.
"""

from helpers.programs.faults.catalogue import FAULTS, plan, stage, stop
from helpers.programs.faults.fault import Fault, Verdict
from helpers.programs.faults.finding import Finding
from helpers.programs.faults.live import live

__all__ = ['FAULTS', 'Fault', 'Finding', 'Verdict', 'live', 'plan', 'stage', 'stop']
