"""The tests of exercise 6.6 let a crate fall in the simulated world, on the learner's side."""

import json
import math
from pathlib import Path
from random import Random

import numpy as np

from helpers.checks.chapter_06.frame_comparisons import apart, explain, same
from helpers.runner import expect

CLOSE = 2e-4  # of a mass or an inertia, which a small crate keeps with four digits
SCRIPT = Path(__file__).with_name('drop.py')


def small(learner, other: 'Crate') -> 'Crate':
    """A crate so small that the numbers of its inertia begin with many zeros.

    If the `other` one is longer than wide, it is wider than long, and the other way round.
    """
    draw = learner.random.uniform
    sides = [round(side, 4) for side in (draw(0.02, 0.03), draw(0.035, 0.045), draw(0.05, 0.06))]
    learner.random.shuffle(sides)
    if (sides[0] > sides[1]) is (other.size[0] > other.size[1]):
        sides[0], sides[1] = sides[1], sides[0]
    return Crate(learner, a_mass(learner.random, 0.02, 0.05), *sides)


def a_mass(random: Random, least: float, most: float) -> float:
    """A mass (kg) of more than three digits: whoever rounds it to three is wrong by more than CLOSE."""
    step = 10 ** math.floor(math.log10(least)) / 100  # what the third digit counts
    return round((random.randrange(round(least / step), round(most / step)) + random.uniform(0.3, 0.45)) * step, 6)


class Crate:
    """The learner's crate of this mass (kg) and size (length, width, height; metres), and what `drop.py` found."""

    def __init__(self, learner, mass: float, *size: float):
        self.mass, self.size = mass, size
        self.name = f'crate({", ".join(map(str, (mass, *size)))})'
        # Another one comes first, in the same program: what a call leaves must not be seen in the next one.
        self.before = [round(1.37 * number, 4) for number in (mass, *size)]
        others = learner.call('crate', *self.before)
        text = learner.call('crate', mass, *size)
        self.first = f'crate({", ".join(map(str, self.before))})'
        expect(
            text != others or not text,
            f'{self.first} and then {self.name} gave the same text. Each call uses the numbers that it gets, and keeps '
            'nothing of an earlier call.',
            'mass',
        )
        expect(isinstance(text, str), f'{self.name} gave {text}, expected the text of a URDF.', 'urdf')
        expect(len(text) < 20_000, f'{self.name} gave {len(text)} characters.', 'urdf')
        workspace = learner.workspace({'crate.urdf': text, 'drop.py': SCRIPT.read_text()})
        done = workspace.run('python3', 'drop.py', 'crate.urdf')
        expect(done.status == 0 and done.lines, f'{self.name} cannot be simulated: {done.last_line}', 'urdf')
        try:
            self.found = json.loads(done.lines[-1])
        except ValueError:
            expect(False, f'{self.name} cannot be simulated: {done.last_line}', 'urdf')
        expect('refused' not in self.found, f'{self.name} cannot be simulated: {self.found.get("refused")}', 'urdf')

        links = self.found['links']
        expect(
            links == ['crate'],
            f'{self.name} has the links {", ".join(links)}; expected one link with the name crate.',
            'urdf',
        )

    def check_fall(self) -> None:
        """It stands on the floor in the end, and touches where it is seen."""
        found, (length, width, height) = self.found, self.size
        last = found['height']
        expect(
            found['touches'],
            f'{self.name} fell through the floor: after 1.5 s it is at z = {last:.1f} m. It has no <collision>.',
            'collision',
        )
        kinds = ' and '.join(f'a {kind}' for kind in found['kinds'])
        expect(
            found['kinds'] == ['box'],
            f'{self.name}: what touches is {kinds}, expected one <collision>, a box like that of the <visual>.',
            'collision',
        )
        expect(found['looks'], f'{self.name} cannot be seen: its <visual> is gone.', 'visual')
        low, high = np.array(found['low']), np.array(found['high'])
        wanted = np.array([-length / 2, -width / 2, 0.0]), np.array([length / 2, width / 2, height])
        expect(
            same(found['seen'], wanted),
            f'{self.name}: its <visual> is not the one that was given, a box on top of the frame. It stays as it is.',
            'visual',
        )
        (from_, from_wanted), (to, to_wanted) = apart(low, wanted[0]), apart(high, wanted[1])
        told = f'{self.name}: its <collision> reaches from {from_} to {to}, expected from {from_wanted} to {to_wanted}.'
        explain(
            same((low, high), wanted),
            told,
            (
                same((low, high), (wanted[0] - (0, 0, height / 2), wanted[1] - (0, 0, height / 2))),
                'The middle of the box is at the frame: the <collision> needs an <origin>, too.',
            ),
            (same(high - low, np.array(self.size) / 2), 'A <box> has whole sides, not half ones.'),
            (
                same((high - low)[[1, 0, 2]], self.size),
                'Length and width are exchanged: is it turned by an rpy that the <visual> does not have?',
            ),
            rule='place' if same(high - low, self.size) else 'collision',
        )
        expect(
            same(last, 0.0, 5e-3),
            f'{self.name}, dropped from half a metre, is at z = {last:.3f} m after 1.5 s, expected 0.',
            'collision',
        )

    def check_weight(self) -> None:
        """Its mass, where the middle of it is, and its inertia."""
        found, c = self.found, self.size[2]
        mass, centre = found['mass'], found['centre']
        expect(mass > 0.002, f'{self.name} weighs next to nothing: it has no <inertial>, or no mass in it.', 'mass')
        explain(
            abs(mass - self.mass) < CLOSE * self.mass,
            f'{self.name} has the mass {mass:g} kg, expected {self.mass:g} kg.',
            (abs(mass - self.mass) < 0.01 * self.mass, 'Do not round the mass in the text.'),
            (
                abs(mass - self.before[0]) < CLOSE * mass,
                f'That is the mass of {self.first}, which was called before: keep nothing of an earlier call.',
            ),
            rule='mass',
        )
        is_at, must = apart(centre, (0, 0, c / 2))
        explain(
            same(centre, (0, 0, c / 2)),
            f'{self.name}: the centre of its mass is at {is_at}, expected {must}.',
            (same(centre, (0, 0, 0)), 'That is its bottom. The <inertial> needs an <origin>, too.'),
            rule='centre',
        )
        self._check_inertia()

    def _check_inertia(self) -> None:
        found, (a, b, c) = self.found, self.size
        squares = np.array([b * b + c * c, a * a + c * c, a * a + b * b])
        inertia, wanted = np.array(found['inertia']), self.mass / 12 * squares
        numbers = [[f'{value:.6g}' for value in values] for values in (np.diag(inertia), wanted)]
        told = (
            f'{self.name}: the inertia about x, y and z is {", ".join(numbers[0])} kg m², expected '
            f'{", ".join(numbers[1])}.'
        )

        def is_about(values):
            return np.allclose(np.diag(inertia), values, rtol=CLOSE, atol=1e-12) and upright

        # A crate that is turned by half a turn, with a pi of six digits, is the same one: its products are nearly 0.
        products = inertia - np.diag(np.diag(inertia))
        upright = np.abs(products).max() <= CLOSE * np.diag(inertia).min()
        own = self.mass / 12 * np.array([a * a, b * b, c * c])
        explain(
            is_about(wanted),
            told,
            (is_about(12 * wanted), 'Divide by 12.'),
            (is_about(wanted / 4), 'The formula takes whole sides, not half ones.'),
            (
                is_about(wanted + self.mass * np.array([c * c, c * c, 0.0]) / 4),
                'This is the inertia about its bottom. It is to be that about the centre of its mass.',
            ),
            (
                not upright,
                'But these are not all: the products ixy, ixz and iyz of a box about its own axes are 0, and its '
                '<inertial> is not turned by an rpy.',
            ),
            (
                is_about(wanted[[1, 0, 2]]),
                'Those about x and y are exchanged, in the formulas or by an rpy of the <inertial>.',
            ),
            (
                np.allclose(inertia, np.diag(wanted), rtol=1e-2, atol=6e-4),
                'Do not round the numbers in the text: the inertia of a small crate has many zeros.',
            ),
            # No body has two moments that are together less than the third: MuJoCo takes the mean of all three.
            (
                is_about(own) or is_about([own.mean()] * 3),
                'The side along an axis does not count for it: take the two others.',
            ),
            (is_about([1.0, 1.0, 1.0]), '1 kg m² is the inertia of a large table.'),
            (
                is_about([inertia[0, 0]] * 3),
                'These are three equal numbers. If there are others in the text, two of them are together less than '
                'the third, which no body has, and the simulator takes their mean: look at each of the three formulas.',
            ),
            rule='inertia',
        )
