# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""People who walk: they change their shape, as no rigid motion does."""
import math
import random

from modelling.materials import grey, random_colours
from modelling.scene import Thing
from modelling.shapes import ball, box, cylinder

SKIN = [(0.55, 0.36, 0.27), (0.68, 0.46, 0.36)]


class Person(Thing):
    def __init__(self, scene, x=0, y=0, yaw=0, seed=0):
        """Somebody 1.75 m tall with arms hanging down; the seed chooses the clothes."""
        super().__init__(scene, "person", x, y, yaw=yaw)
        materials, chance = scene.materials, random.Random(seed)
        colours = random_colours(chance, 3, 0.03, 0.7)
        scale = chance.choice([6, 10, 14])
        pattern = chance.choice(["waves", "noise", "cells"])
        if pattern == "waves":
            shirt = materials.waves(colours, scale, distortion=3, seed=seed)
        elif pattern == "noise":
            shirt = materials.noise(colours, scale, detail=3, seed=seed)
        else:
            shirt = materials.cells(colours, scale, seed=seed)
        trousers = materials.noise(random_colours(chance, 2, 0.02, 0.3), scale=9, seed=seed + 3)
        skin = materials.noise(SKIN, scale=10, seed=seed)
        shoe = materials.plain(grey(0.03))

        self.add(box(0.4, 0.24, 0.58, standing=True, taper=1.08), shirt, (0, 0, 0.86))
        self.add(cylinder(0.06, 0.1), skin, (0, 0, 1.47))
        self.add(ball(0.105, stretch=1.2), skin, (0, 0, 1.6))
        self.add(ball(0.108, stretch=1.05), materials.plain((0.05, 0.03, 0.02)), (0, -0.018, 1.635))
        self._limbs = [self._arm_and_leg(side, shirt, skin, trousers, shoe) for side in (-1, 1)]

    def _arm_and_leg(self, side, shirt, skin, trousers, shoe):
        shoulder = self.joint((side * 0.25, 0, 1.4))
        shoulder.add(cylinder(0.05, 0.3), shirt, (0, 0, -0.15))
        elbow = shoulder.joint((0, 0, -0.3))
        elbow.add(cylinder(0.04, 0.28), skin, (0, 0, -0.14))
        elbow.add(ball(0.05), skin, (0, 0, -0.3))
        hip = self.joint((side * 0.1, 0, 0.88))
        hip.add(cylinder(0.085, 0.44), trousers, (0, 0, -0.22))
        knee = hip.joint((0, 0, -0.44))
        knee.add(cylinder(0.065, 0.42), trousers, (0, 0, -0.2))
        knee.add(box(0.1, 0.26, 0.09), shoe, (0, 0.05, -0.4))
        return shoulder, elbow, hip, knee

    def walk(self, phase, swing=0.5):
        """Arms and legs at a phase of the stride; they swing by so many radians. Does not move the person."""
        for (shoulder, elbow, hip, knee), opposite in zip(self._limbs, (1, -1)):
            forwards = math.sin(phase) * opposite
            shoulder.turn(-swing * forwards, 0, 0)
            elbow.turn(0.3 + 0.2 * max(0, -forwards), 0, 0)
            hip.turn(swing * forwards, 0, 0)
            knee.turn(-swing * 1.1 * max(0, math.cos(phase) * opposite), 0, 0)
