# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Cars."""
import math
import random

from modelling.materials import darker, grey, lighter
from modelling.scene import Thing
from modelling.shapes import Shape, box, cylinder

RED, SILVER, NAVY, WHITE = (0.5, 0.03, 0.03), (0.6, 0.6, 0.62), (0.03, 0.05, 0.25), (0.75, 0.75, 0.72)
GREEN, BEIGE, BLUE = (0.1, 0.25, 0.1), (0.45, 0.4, 0.3), (0.1, 0.3, 0.5)
YELLOW, GREY = (0.7, 0.5, 0.05), (0.25, 0.25, 0.27)


def paints(black):
    """The usual colours of cars, to take by turns; `black` is how light the black one is."""
    return [RED, SILVER, NAVY, grey(black), WHITE, GREEN, BEIGE, BLUE, YELLOW, GREY]


class Car(Thing):
    WHEEL_RADIUS = 0.31

    def __init__(self, scene, x, y, yaw, colour, seed=0, length=4.3, width=1.75, height=1.45):
        """A car on the ground; the seed chooses the texture of its paint and the length of its cabin."""
        super().__init__(scene, "car", x, y, yaw=yaw)
        self.length, self.width, self.height = length, width, height
        self.waist = height * 0.52  # where the cabin begins
        materials = scene.materials
        self._add_body(materials, colour, seed)
        self._add_lamps(materials, seed)
        self._add_wheels(materials, seed)

    def roll(self, distance):
        """Turns the wheels as after a way forwards, metres."""
        for wheel in self.wheels:
            wheel.turn(-distance / self.WHEEL_RADIUS, 0, 0)

    def _add_body(self, materials, colour, seed):
        length, width, waist = self.length, self.width, self.waist
        paint = materials.noise([colour, lighter(colour, 1.15, 0.02)], scale=2.5, gloss=(0.25, 0.35), seed=seed)
        glass = materials.noise([(0.03, 0.04, 0.05), (0.10, 0.11, 0.12)], scale=1.5, gloss=(0.02, 0.6), seed=seed)
        gap = materials.plain(darker(colour, 0.55))
        handle, sill = materials.plain(grey(0.6)), materials.plain(grey(0.04))

        self.add(box(width, length, waist - 0.22, standing=True, taper=0.97, taper_length=0.985), paint, (0, 0, 0.22))
        cabin = length * random.Random(seed).uniform(0.5, 0.58)
        middle = -length * 0.05
        self.add(box(width * 0.94, cabin, self.height - waist, standing=True, taper=0.8, taper_length=0.62), paint,
                 (0, middle, waist))
        for side in (-1, 1):
            for pane in self._panes(side, cabin, middle):
                self.add(pane, glass)
            for y in (-0.9, 0.05, 1.0):
                self.add(box(0.008, 0.015, waist - 0.32, standing=True), gap, (side * width * 0.4935, y, 0.27))
            for y in (-0.55, 0.4):
                self.add(box(0.03, 0.18, 0.03), handle, (side * width * 0.488, y, waist - 0.13))
            self.add(box(0.02, length * 0.6, 0.07), sill, (side * width * 0.497, 0, 0.3))

    def _panes(self, side, cabin, middle):
        """Two panes at one side of the cabin, and that at its rear (side -1) or front (1), just outside its walls."""
        low, high = self.waist + 0.06, self.height - 0.08

        def half_size(z):
            up = (z - self.waist) / (self.height - self.waist)
            return (self.width * 0.94 / 2) * (1 - up * 0.2), (cabin / 2) * (1 - up * 0.38)

        (x0, y0), (x1, y1), outside = half_size(low), half_size(high), 0.006
        corners = []
        for begin, end in ((-0.92, -0.04), (0.04, 0.92)):
            corners.append([(side * (x0 + outside), middle + y0 * begin * 0.93, low),
                            (side * (x0 + outside), middle + y0 * end * 0.93, low),
                            (side * (x1 + outside), middle + y1 * end * 0.88, high),
                            (side * (x1 + outside), middle + y1 * begin * 0.88, high)])
        corners.append([(-x0 * 0.86, middle + side * (y0 + outside), low),
                        (x0 * 0.86, middle + side * (y0 + outside), low),
                        (x1 * 0.84, middle + side * (y1 + outside), high),
                        (-x1 * 0.84, middle + side * (y1 + outside), high)])
        return [Shape(four, [(0, 1, 2, 3)]) for four in corners]

    def _add_lamps(self, materials, seed):
        length, width = self.length, self.width
        headlamp = materials.cells([(0.8, 0.8, 0.75), (0.3, 0.3, 0.3)], scale=14, seed=seed)
        tail_lamp = materials.cells([(0.6, 0.02, 0.02), (0.25, 0.0, 0.0)], scale=14, seed=seed)
        bumper = materials.plain((0.05, 0.05, 0.055))
        for side in (-1, 1):
            self.add(box(0.36, 0.03, 0.14), headlamp, (side * width * 0.34, length / 2 - 0.005, 0.6))
            self.add(box(0.3, 0.03, 0.16), tail_lamp, (side * width * 0.35, -length / 2 + 0.005, 0.62))
        for end in (-1, 1):
            plate = materials.cells([(0.8, 0.8, 0.78), grey(0.05)], scale=16, seed=seed + end)
            self.add(box(0.5, 0.02, 0.11), plate, (0, end * (length / 2), 0.42))
            self.add(box(width * 0.98, 0.05, 0.13), bumper, (0, end * (length / 2 - 0.005), 0.26))
        self.add(box(0.7, 0.02, 0.12), materials.checks([grey(0.02), grey(0.2)], scale=12), (0, length / 2, 0.58))

    def _add_wheels(self, materials, seed):
        tyre = materials.noise([grey(0.015), grey(0.05)], scale=9, seed=seed)
        rim = materials.cells([(0.55, 0.55, 0.57), grey(0.1)], scale=6, seed=seed)
        spoke = materials.plain(grey(0.12))
        self.wheels = []
        for side in (-1, 1):
            for end in (-1, 1):
                wheel = self.joint((side * (self.width / 2 - 0.1), end * self.length * 0.31, self.WHEEL_RADIUS))
                wheel.add(cylinder(self.WHEEL_RADIUS, 0.2), tyre, turn=(0, math.pi / 2, 0))
                wheel.add(cylinder(0.2, 0.215), rim, turn=(0, math.pi / 2, 0))
                for i in range(3):
                    wheel.add(box(0.22, 0.05, 0.38), spoke, turn=(i * math.pi / 3, 0, 0))
                self.wheels.append(wheel)
