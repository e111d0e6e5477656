"""`unseen`: two machines that cannot see each other."""

from helpers.programs.faults import words
from helpers.programs.faults.fault import START, Fault, Verdict
from helpers.programs.faults.machine import BASHRC, SETUP
from helpers.programs.faults.topics import PUBLISHER, SUBSCRIBER

_BASHRC = f"""\
source ~/{SETUP.format(distro='jazzy')}
export ROS_DOMAIN_ID={{domain}}
export ROS_AUTOMATIC_DISCOVERY_RANGE={{range}}
"""


class Unseen(Fault):
    """The programs of two machines do not find each other. The machines are two homes on this one.

    Kinds: ``domain`` (two domain ids), ``range`` (one of them does not look for others).
    """

    name, title = 'unseen', 'two machines do not see each other'
    kinds = ('domain', 'range')

    def plan(self) -> None:
        draw = self.random
        topic, publisher, unit = draw.choice(words.SENSORS)
        robot, listener = draw.choice(words.ROBOTS), draw.choice(words.LISTENERS)
        pc = draw.choice(['laptop', 'desktop', 'tablet', 'server'])
        first, wrong = draw.randrange(10, 60), draw.choice([robot, pc])
        self.machines = (robot, pc)
        self.publisher, self.listener = publisher, listener
        common = {
            'topic': topic,
            'unit': unit,
            'type': 'Int32',
            'value': 'self.count',
            'first': first,
            'reliability': 'RELIABLE',
            'durability': 'VOLATILE',
        }
        sound = _BASHRC.format(domain='@DOMAIN@', range='LOCALHOST')
        self.files = {
            f'{robot}/{publisher}.py': PUBLISHER.format(node=publisher, **common),
            f'{pc}/{listener}.py': SUBSCRIBER.format(node=listener, **common),
            f'{robot}/{BASHRC}': sound,
            f'{pc}/{BASHRC}': sound,
            START: f'{robot}: python3 {publisher}.py\n{pc}: python3 {listener}.py\n',
        }
        where = f'{wrong}/{BASHRC}'
        self.repaired = {where: sound}
        self.files[where] = _BASHRC.format(
            domain='@OTHER@' if self.kind == 'domain' else '@DOMAIN@',
            range='LOCALHOST' if self.kind == 'domain' else 'OFF',
        )
        self.task = (
            f'The machine {robot} measures, the machine {pc} should print it. (Both are folders here, with '
            'a .bashrc of their own.)'
        )
        variable = {'domain': 'ROS_DOMAIN_ID', 'range': 'ROS_AUTOMATIC_DISCOVERY_RANGE'}[self.kind]
        line = next(line for line in self.files[where].splitlines() if variable in line)
        self.diagnose(where, self.kind, line)
        self.facts = {'variable': variable}

    def prepare(self) -> None:
        for machine in self.machines:
            self.home(machine).install()

    def show_symptom(self) -> None:
        self.watch(lambda: len(self.lines(self.publisher)) >= 2 and self.lines(self.listener), self.patience)
        self.show_programs()

    def works(self, timeout: float) -> Verdict:
        heard = self.watch(lambda: any('heard' in line for line in self.lines(self.listener)), timeout)
        robot, pc = self.machines
        return Verdict(heard, f'{pc} {"hears" if heard else "does not hear"} {robot}')
