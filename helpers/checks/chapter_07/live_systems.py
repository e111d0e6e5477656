"""Exercise 7.8's systems: what a learner has found and changed in them, against the truth and in running copies.

The answer is data, not a function: a person is to look with the tools, and a program that does so by itself is exercise
7.7. The tests draw the same five systems from the learner's name, compare the findings with the truth, make the changes
in copies of their own, and run these. In a copy the robot measures other values, begins at another place and answers
with another word, all drawn for this run, and each machine is a place of its own: what the panel then shows has come to
it from the robot. A rate is measured from outside. Somebody else's findings do not fit: another name draws others.
"""

import os
import re
import shlex
import time
from contextlib import ExitStack
from dataclasses import dataclass

from rcl_interfaces.msg import Log
from rclpy.qos import QoSProfile, ReliabilityPolicy
from rosidl_runtime_py.utilities import get_message
from tf2_msgs.msg import TFMessage

from helpers.checks.chapter_07.findings import is_finding, no_fault, with_name
from helpers.kernel import domains
from helpers.programs.faults.fault import START, commands
from helpers.programs.faults.live import NUMBERS, Planned, changed, key
from helpers.programs.faults.machine import SETUP, SYSTEM_PATH, ros_setup
from helpers.programs.faults.mystery import MACHINES, ROOMS, Drawn, lacks, lines_of_panel
from helpers.programs.faults.rates import ENOUGH, TOO_MANY
from helpers.runner import broken, expect
from helpers.runner.elsewhere import Elsewhere
from helpers.runner.load import busy, share
from helpers.runner.verdicts import ExpectationFailed

EXAMPLE = 'my name'  # what the cell has at first
PATIENCE = 10.0  # s in which a repaired system shows that it works, after its start
SLOW = 0.6  # s from one line of the panel to the next; with its timer of 0.3 s there are half as many
QUICK = 0.5  # s for four lines of the panel; with its timer of 0.3 s they take 0.9 s
# An evidence is chosen. `ros2 topic info --verbose` prints up to forty lines, and a program of a system has more.
LONGEST, MOST_LINES = 1500, 40  # letters, lines
FEW_NUMBERS = 4  # of which one is the rate; of more, at least half
_WINDOW = 9  # so many messages before the last one tell a rate or a speed
BUSY, VERY_BUSY = 3, 6  # so many times as long on a busy machine; on one with far too much to do, at most
# What the evidence of a cause must have in it, in words.
WANTED = {
    ('no_data', 'name'): 'the topic that the panel asks for',
    ('no_data', 'type'): 'the type that the panel asks for',
    ('no_data', 'reliability'): 'what the robot offers',
    ('unseen', 'domain'): 'the room whose domain the machine has',
    ('unseen', 'range'): 'the range that the machine has',
    ('waiting', 'name'): 'the service that the panel asks for',
    ('waiting', 'type'): 'the type that the panel asks for',
    ('hang', 'call'): 'the line of the stack, or of the program, in which it waits',
    ('no_transform', 'exchanged'): 'who is whose parent, or a negative x',
    ('no_transform', 'unknown'): 'the wrong name of the frame',
    ('wrong_time', 'no clock'): 'use_sim_time of the node, or the publishers of /clock',
    ('wrong_time', 'other clock'): '`sec:` of a stamp that is no date, or the wrong clock',
    ('too_slow', 'rate'): 'the measured rate',
    ('no_parameter', 'parameter'): 'the value that the node has',
}
_KEPT = (
    'FASTDDS_BUILTIN_TRANSPORTS',
    'FASTRTPS_DEFAULT_PROFILES_FILE',
    'RMW_IMPLEMENTATION',
    'RMW_FASTRTPS_PUBLICATION_MODE',
)
# A new terminal of a machine, in a place where no shared memory is shared: UDP beyond LOCALHOST is the same loopback.
_TERMINAL = """\
cd home/{machine}
exec env -i HOME="$PWD" PATH={path} TERM=dumb LC_ALL=C.UTF-8 PYTHONUNBUFFERED=1 PYTHONDONTWRITEBYTECODE=1 \
RCUTILS_COLORIZED_OUTPUT=0 ROS_LOG_DIR="$PWD/log" {kept} bash --noprofile --norc -c {script}
"""
_SCRIPT = """\
source ~/.bashrc
[ "$ROS_AUTOMATIC_DISCOVERY_RANGE" != LOCALHOST ] || export ROS_AUTOMATIC_DISCOVERY_RANGE=SUBNET
exec {command}
"""


@dataclass(frozen=True)
class Findings:
    """What the learner's cell says, by the numbers of the systems."""

    who: str
    findings: dict[int, list[tuple]]
    changes: dict[int, list]

    def answered(self, number: int) -> bool:
        """Whether anything is said of a system."""
        return bool(self.findings.get(number) or self.changes.get(number))


def answer(learner) -> Findings:
    """Read the learner's answer, once in a session; fail with words if it has not its form."""
    cache = learner.server.workspaces
    if 'live answer' not in cache:
        cache['live answer'] = [learner.value(name) for name in ('NAME', 'FINDINGS', 'CHANGES')]
        learner.end_calls()
    who, findings, changes = cache['live answer']
    expect(
        isinstance(who, str) and key(who) not in ('', EXAMPLE) and who.encode('utf-8', 'ignore').decode() == who,
        f'NAME is {who!r}: write your own name. The systems are drawn from it, so that they are yours.',
        'name',
    )
    for name, value, rule in (('FINDINGS', findings, 'cause'), ('CHANGES', changes, 'repaired')):
        # Not by `expect`: a right form is no rule that is kept.
        if not isinstance(value, dict) or not all(one in NUMBERS and isinstance(of, list) for one, of in value.items()):
            raise broken(f'{name} must be a dictionary from the numbers of the systems, 1 to 5, to lists.', rule)
    for number, found in findings.items():
        if is_finding(found):
            raise broken(f'System {number}: one finding, {found!r}, is no list of findings: put it into [ ].', 'cause')
        for one in found:
            if not is_finding(one):
                raise broken(
                    f'System {number}: {one!r} is no finding: it has four parts, and each is a string.', 'cause'
                )
            if told := no_fault(with_name(one)[0]):
                raise broken(f'System {number}: {told}', 'cause')
    return Findings(
        key(who), {number: [with_name(one) for one in found] for number, found in findings.items()}, changes
    )


def judge_all(learner, judge) -> None:
    """Judge all five systems by `judge_findings` or `judge_repair`, and fail with what is wrong in any of them."""
    mine = answer(learner)
    wrong: list[ExpectationFailed] = []
    for number in filter(mine.answered, NUMBERS):
        try:
            judge(learner, number)
        except ExpectationFailed as error:
            wrong.append(error)
    if empty := [str(number) for number in NUMBERS if not mine.answered(number)]:
        are = 'System {} has' if len(empty) == 1 else 'Systems {} have'
        wrong.append(broken(f'{are.format(", ".join(empty))} no finding yet.', 'cause'))
    if wrong:
        raise broken('\n'.join(error.message for error in wrong), wrong[0].rule)


def judge_findings(learner, number: int) -> None:
    """Fail with words if the findings in a system are not the truth. No message tells a cause that was not found."""
    mine = answer(learner)
    found = mine.findings.get(number, [])
    expect(found, _open(number), 'cause')
    truth = Planned(mine.who, number).drawn
    there = {(fault, one.cause): one for fault, one in truth.items()}
    wrong = [one for one in found if (one[0], one[2]) not in there]
    missed = there.keys() - {(fault, cause) for fault, _, cause, _ in found}
    said = f'`{wrong[0][0]}` with the cause `{wrong[0][2]}`' if wrong else ''
    expect(
        not (wrong and missed),
        f'System {number}: {said} is no fault of this system. Which tool has told you so? Ask again from the top.',
        'cause',
    )
    expect(not wrong, f'System {number}: its faults are found, and {said} is none of them.', 'nothing-else')
    expect(
        not missed,
        f'System {number}: what you found is right, and there is one more fault. Repair the first, and look again from '
        'the top.',
        'both',
    )
    expect(
        len(found) == len(there), f'System {number}: you found the same twice. A fault is one finding.', 'nothing-else'
    )
    for fault, where, cause, evidence in found:
        one = there[fault, cause]
        files = ', '.join(Planned(mine.who, number).files)
        expect(
            where == one.where,
            f'System {number}: the fault `{fault}` is not in {where!r}. `where` is one of the files {files}: the one '
            'that does not say what the task says.',
            'where',
        )
        expect(
            len(evidence) <= LONGEST and len(evidence.splitlines()) <= MOST_LINES,
            f'System {number}: the evidence of `{cause}` has {len(evidence)} letters in '
            f'{len(evidence.splitlines())} lines. Choose the line that shows it, and leave the rest out.',
            'evidence',
        )
        expect(
            shows(one, evidence),
            f'System {number}: {evidence!r} does not show `{cause}`. Write a line that a tool has printed, with '
            f'{WANTED[fault, cause]} in it.',
            'evidence',
        )


def shows(truth: Drawn, evidence: str) -> bool:
    """Whether a text is evidence of a fault, in whatever words the rest of it is."""
    if truth.cause == 'rate':
        rate = float(truth.evidence)
        told = re.sub(r'\b(min|max|std dev|window): \S+', '', evidence)  # `ros2 topic hz` says more than the rate
        numbers = [float(number) for number in re.findall(r'\d+\.\d+|\d+', told)]
        fit = [number for number in numbers if 0.6 * rate < number < 1.6 * rate]
        if fit and (len(numbers) <= FEW_NUMBERS or 2 * len(fit) >= len(numbers)):
            return True
    return any(re.search(pattern, evidence) for pattern in truth.shows)


def judge_repair(learner, number: int, panel_first: bool = False) -> None:
    """Fail with words if the system does not work after the learner's changes, or if they are in other files.

    All systems that are answered run side by side, once in a session.

    :param panel_first: the robot is started only when the panel runs.
    """
    mine = answer(learner)
    expect(mine.answered(number), _open(number), 'repaired')
    named = {where for _, where, _, _ in mine.findings.get(number, [])}
    changes = mine.changes.get(number, [])
    # What is no change is told where it is made.
    files_of = [one[0] for one in changes if isinstance(one, list) and one and isinstance(one[0], str)]
    others = [name for name in files_of if name not in named]
    files = list(Planned(mine.who, number).files)
    absent = [name for name in others if name not in files]
    expect(
        not absent,
        f'System {number}: there is no file {absent and absent[0]!r} to change. There are {", ".join(files)}.',
        'only-there',
    )
    expect(
        not others,
        f'System {number}: you changed {others and others[0]!r}, and none of your findings is there. Change only what '
        'a finding names.',
        'only-there',
    )
    cache, name = learner.server.workspaces, ('live outcomes', panel_first)
    if name not in cache:
        wanted = {one: mine.changes.get(one, []) for one in NUMBERS if mine.answered(one)}
        cache[name] = run(learner, mine.who, wanted, panel_first)
    expect(not cache[name][number], f'System {number}: {cache[name][number]}', 'repaired')


def run(learner, who: str, answers: dict[int, list], panel_first: bool = False) -> dict[int, str]:
    """Run copies of some systems after these changes, side by side; for each, what is wrong with it, '' if it works."""
    outcomes: dict[int, str] = {}
    with ExitStack() as held:
        other = str(held.enter_context(domains.claim()))
        running: dict[int, _Copy] = {}
        for number, changes in answers.items():
            system = Planned(who, number)
            try:
                texts = changed(system.files, changes)
            except ValueError as error:
                outcomes[number] = f'your change does not fit: {error}.'
                continue
            if any(re.search(r'ROS_DOMAIN_ID=\W?\d', text) for text in texts.values()):
                outcomes[number] = (
                    'write the domain as the room in rooms.sh, as in `$KITCHEN`: its number is another one wherever '
                    'the system runs.'
                )
                continue
            programs = {machine for machine, _ in commands(texts[START])}
            if missing := [machine for machine in MACHINES if machine not in programs]:
                outcomes[number] = f'after your changes start.txt starts no program on {missing[0]}.'
                continue
            running[number] = held.enter_context(_Copy(learner, system, texts, other, panel_first))
        begin = time.monotonic()
        while running:
            late = time.monotonic() - begin > PATIENCE * _times_as_long()
            for number, copy in list(running.items()):
                outcomes[number] = copy.lacks()
                if not outcomes[number] or late or copy.ended():
                    copy.end()
                    del running[number]
            time.sleep(0.05)
    return outcomes


def _times_as_long() -> float:
    """How much more time a system has, as this machine is now."""
    return min(VERY_BUSY, max(BUSY, 1 / share())) if busy() else 1


class _Copy:
    """A system that runs in places where no cell has run; use it in a `with` block."""

    def __init__(self, learner, system: Planned, texts: dict[str, str], other: str, panel_first: bool):
        random = learner.random
        self.system, self._panel_first = system, panel_first
        self._word = f'done-{random.getrandbits(32):x}'
        self._begin, self._first = float(random.randrange(20, 90)), random.randrange(1000, 9000)
        self._held = ExitStack()
        domain = self._held.enter_context(domains.claim())
        self._outside: _Outside | None = _Outside(domain, system)
        given = {f'home/robot/{name}': text for name, text in self._given().items()}
        setup = f'source {shlex.quote(str(ros_setup()))}\n'
        self._places = {}
        for machine in MACHINES:
            files = {f'home/{name}': text for name, text in texts.items() if name.startswith(f'{machine}/')}
            files[f'home/{machine}/{SETUP.format(distro="jazzy")}'] = setup
            files[f'home/{machine}/{ROOMS}'] = system.rooms_text(str(domain), other)
            files |= given if machine == 'robot' else {}
            self._places[machine] = learner.workspace(files, alone=True)
        self._waiting = [one for one in commands(texts[START]) if one[0] in MACHINES]
        self._tasks: list[tuple[str, str, object]] = []
        self._start()

    def lacks(self) -> str:
        """What the system lacks, in words; '' if it works. Starts what waits for another program."""
        self._start()
        lines = [line for machine, _, task in self._tasks if machine == 'panel' for line in task.output.splitlines()]
        for machine, command, task in self._tasks:
            if (status := task.wait(0)) is not None:
                last = (task.output.strip().splitlines() or ['it printed nothing'])[-1]
                return f'after your changes `{command}` on {machine} ends with status {status}: {last[:200]}'
        missing = lacks(lines, self._word, self._begin, self._first)
        if not missing and self._outside is not None:
            missing = self._outside.lacks()
        if not missing:
            return ''
        shown = lines_of_panel(lines)
        told = [line.partition(']: ')[2] for line in lines if shown and 'base_link: ' in line]
        return (
            f'after your changes {missing}. The panel shows {told[-1]!r}.' if told else f'after your changes {missing}.'
        )

    def ended(self) -> bool:
        """Whether a program has ended by itself."""
        return any(task.wait(0) is not None for _, _, task in self._tasks)

    def end(self) -> None:
        """End the programs, and remove what they have left; idempotent."""
        for place in self._places.values():
            place.forget()
        self._places = {}
        if self._outside is not None:
            self._outside.close()
            self._outside = None
        self._held.close()

    def _given(self) -> dict[str, str]:
        return self.system.given(self._word, self._begin, self._first)

    def _start(self) -> None:
        """Start the programs; the robot only when the panel has printed something, if it is to be the first."""
        for one in list(self._waiting):
            machine, command = one
            up = any(where == 'panel' and task.output for where, _, task in self._tasks)
            if self._panel_first and machine == 'robot' and not up:
                continue
            self._waiting.remove(one)
            kept = ' '.join(f'{name}={shlex.quote(os.environ[name])}' for name in _KEPT if name in os.environ)
            script = _TERMINAL.format(
                machine=machine, path=SYSTEM_PATH, kept=kept, script=shlex.quote(_SCRIPT.format(command=command))
            )
            self._tasks.append((machine, command, self._places[machine].start('bash', '-c', script)))

    def __enter__(self) -> '_Copy':
        return self

    def __exit__(self, kind, error, tb) -> None:
        self.end()


class _Outside:
    """What somebody else than the panel sees of a copy: is it as its task says?

    Where two faults are in two files, a learner may change both: then the panel alone cannot tell on which side
    a name, a type or a frame is wrong. How often the panel prints is seen on /rosout, where its lines have a time.
    """

    def __init__(self, domain: int, system: Planned):
        self._values = system._values
        self._node = Elsewhere(domain)
        self._sent: list[tuple[float, int]] = []  # when the robot has sent its last messages, in s, and their numbers
        self._places: list[tuple[float, float]] = []  # when base_link was where in odom: s, m
        self._topic, kind = f'/{self._values["topic"]}', self._values['type']
        self._kind = f'std_msgs/msg/{kind}'
        qos = QoSProfile(depth=50, reliability=ReliabilityPolicy.BEST_EFFORT)
        self._node.node.create_subscription(get_message(self._kind), self._topic, self._on_message, qos)
        self._node.node.create_subscription(TFMessage, '/tf', self._on_transforms, qos)
        self._printed: list[float] = []  # when the panel has printed its lines, in s
        self._node.node.create_subscription(Log, '/rosout', self._on_line, qos)

    def lacks(self) -> str:
        """In what the system is not as its task says, in words; '' if it is. Waits for four seconds at most."""
        self._node.wait_until(lambda: not self._missing(), 4.0)
        return self._missing()

    def close(self) -> None:
        self._node.__exit__(None, None, None)

    def _on_message(self, message, info) -> None:
        # Numbered where they are published: a busy machine that hears one of many is not to take that for a low rate.
        sent = info['source_timestamp'] / 1e9, info['publication_sequence_number']
        self._sent = [*self._sent[-_WINDOW:], sent]

    def _on_line(self, message) -> None:
        if message.name.endswith('panel') and 'base_link: ' in message.msg:
            self._printed.append(message.stamp.sec + message.stamp.nanosec / 1e9)

    def _on_transforms(self, message) -> None:
        for one in message.transforms:
            if (one.header.frame_id, one.child_frame_id) == ('odom', 'base_link'):
                stamp = one.header.stamp
                place = stamp.sec + stamp.nanosec / 1e9, one.transform.translation.x
                self._places = [*self._places[-_WINDOW:], place]

    def _missing(self) -> str:
        if not self._sent:
            return f'the robot does not publish {self._topic[1:]} ({self._kind})'
        offers = self._node.node.get_publishers_info_by_topic(self._topic)
        if any(one.qos_profile.reliability != ReliabilityPolicy.RELIABLE for one in offers):
            return f'the robot does not publish {self._topic[1:]} as RELIABLE'
        rate = _slope(*zip(*self._sent, strict=True)) if len(self._sent) > 5 else 0.0
        if rate <= ENOUGH:
            return 'the robot publishes less than ten times a second'
        if rate > TOO_MANY:
            return f'the robot publishes more than ten times a second: {rate:.0f} times'
        service, kind = self._values['service'], f'{self._values["package"]}/srv/Trigger'
        if kind not in dict(self._node.node.get_service_names_and_types()).get(f'/{service}', []):
            return f'the robot does not serve {service} ({kind})'
        if not self._places:
            return 'the robot does not say where base_link is in odom'
        speed = _slope(*zip(*self._places, strict=True)) if len(self._places) > 5 else 0.0
        wanted = float(self._values['speed'])
        if abs(speed - wanted) > 0.2 * wanted:
            return f'the robot drives with {speed:.2f} m/s, and not with {wanted:g} m/s'
        # A busy machine delays some lines, but not all: four in time are enough. What no logger prints is not seen.
        spans = [later - earlier for earlier, later in zip(self._printed, self._printed[3:], strict=False)]
        if self._printed and not any(span < 3 * SLOW for span in spans):
            return 'the panel prints less than three times a second'
        # A late line is near to the next one, but a timer makes up for none: half of the lines take their time.
        if spans and sorted(spans)[len(spans) // 2] < QUICK:
            return 'the panel prints more than three times a second'
        return ''


def _slope(times, values) -> float:
    """By how much the values rise in a second, from the first to the last; 0 if no time has passed."""
    passed = times[-1] - times[0]
    return (values[-1] - values[0]) / passed if passed > 0 else 0.0


def _open(number: int) -> str:
    return f'System {number} has no finding yet.'
