# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""A pedestrian street in which all that moves comes straight towards the camera or goes away from it, and hardly shifts
in the image: five people, two cars at walking pace. Three people stand, a car is parked. The camera is carried."""
import math
from random import Random

from modelling import lights
from modelling.car import NAVY, RED, SILVER, Car
from modelling.materials import ON_FRONT, ON_SIDE, grey
from modelling.person import Person
from modelling.scenery import house
from modelling.shapes import box, plane
from recording import Recording

RECORDING = Recording(frames=45, sensor="stereo", focal_length=450, baseline=0.3, seed=621)

PEOPLE = ((-1.6, 13, -1.3), (1.2, 10, 1.3), (2.9, 22, -1.3), (-3.2, 19, 1.2), (0.1, 17, 0), (4.3, 15, 0), (-4.6, 12, 0),
          (-0.6, 27, -1.5))  # x, y, speed along y


def build(scene):
    random = Random(1)
    lights.sky()
    lights.sun((0.5, -0.4, 0.85), 3.0)
    slabs = scene.materials.bricks([(0.3, 0.29, 0.27), (0.38, 0.36, 0.33), grey(0.2)], (1, 1), mortar=0.03)
    scene.background.add(plane(120, 160), slabs, (0, 50, 0))
    for side in (-1, 1):
        for i in range(9):
            house(scene, random, side * 9, 2 + i * 8, ground=(5, 7.6), heights=(5, 9), row=0.3, seed=i + side,
                  facing=ON_SIDE)
    blocks = scene.materials.bricks([(0.45, 0.42, 0.36), (0.52, 0.5, 0.45), grey(0.3)], (1.2, 0.5), turn=ON_FRONT)
    scene.background.add(box(40, 5, 12), blocks, (0, 70, 4))
    people = [Person(scene, yaw=0 if speed > 0 else math.pi, seed=50 + i) for i, (_, _, speed) in enumerate(PEOPLE)]
    coming = Car(scene, -2.2, 40, math.pi, SILVER, 3)
    leaving = Car(scene, 3.2, 34, 0, RED, 4)
    Car(scene, 5.2, 24, 0, NAVY, 5)

    def advance(t):
        scene.camera.place((0.04 * math.sin(2 * t), 1.2 * t, 1.5 + 0.012 * math.sin(9 * t)), 0.01 * math.sin(1.5 * t),
                           -0.04 + 0.004 * math.sin(7 * t), 0.004 * math.sin(5 * t))
        for i, (person, (x, y, speed)) in enumerate(zip(people, PEOPLE)):
            person.place(x, y + speed * t)
            if speed:
                person.walk(5.2 * t + i)
        coming.place(-2.2, 40 - 2.0 * t)
        coming.roll(2 * t)
        leaving.place(3.2, 34 + 0.8 * t)
        leaving.roll(0.8 * t)

    return advance
