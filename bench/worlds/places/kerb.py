# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""A kerb, from a car that creeps along the street and looks across it: lorries pass 3.5 m before the camera and hide
six parked cars, somebody who walks and somebody who stands."""
import math
from random import Random

from modelling import lights
from modelling.car import Car, paints
from modelling.materials import grey, lighter
from modelling.person import Person
from modelling.scene import Thing
from modelling.scenery import PAVING, house
from modelling.shapes import box, cylinder, plane
from recording import Recording

RECORDING = Recording(frames=50, sensor="stereo", focal_length=400, baseline=0.3, seed=420)

TRUCKS = (((0.7, 0.7, 0.68), 5.2, 2.3, -11, 3.6, 8.0), ((0.1, 0.25, 0.5), 6.5, 2.6, 26, 4.0, -7.0),
          ((0.6, 0.1, 0.05), 9, 2.9, -38, 3.5, 10.0))  # colour, length, height, x, y, speed along x


def build(scene):
    random = Random(1)
    lights.sky()
    lights.sun((0.5, -0.6, 0.85), 3.0)
    road = scene.materials.noise([grey(0.07), grey(0.12), (0.18, 0.18, 0.17)], scale=1.2, detail=10)
    scene.background.add(plane(200, 60), road, (0, 20, 0))
    scene.background.add(plane(200, 4), scene.materials.bricks(PAVING, (0.6, 0.6), mortar=0.02), (0, 12.5, 0.05))
    colours = paints(black=0.05)
    for i in range(6):
        y = 8.6 + random.uniform(-0.2, 0.2)
        yaw = (math.pi / 2 if i % 2 else -math.pi / 2) + random.uniform(-0.04, 0.04)
        Car(scene, -12 + i * 5.4, y, yaw, colours[i], i)
    Person(scene, 1.2, 11.2, 2.4, seed=5)
    walker = Person(scene, yaw=-math.pi / 2, seed=8)
    trucks = [make_truck(scene, colour, length, height, seed)
              for seed, (colour, length, height, *_) in enumerate(TRUCKS, start=1)]
    for i in range(14):
        house(scene, random, -60 + i * 9, 18, ground=(9, 5), heights=(6, 11), row=0.3, seed=i)

    def advance(t):
        scene.camera.place((-4 + 1.0 * t, 0, 1.5 + 0.01 * math.sin(9 * t)), 0.03 * math.sin(1.2 * t),
                           -0.03 + 0.004 * math.sin(7 * t), 0.004 * math.sin(5 * t))
        for truck, (_, _, _, x, y, speed) in zip(trucks, TRUCKS):
            truck.place(x + speed * t, y, yaw=-math.pi / 2 if speed > 0 else math.pi / 2)
        walker.place(-6 + 1.3 * t, 11.9, 0.05)
        walker.walk(5 * t)

    return advance


def make_truck(scene, colour, length, height, seed):
    materials = scene.materials
    paint = materials.noise([colour, lighter(colour, 1.25, 0.03)], scale=2.0, seed=seed)
    glass = materials.noise([(0.03, 0.04, 0.05), (0.12, 0.14, 0.15)], scale=1.2, gloss=(0.03, 0.5))
    advert = materials.cells([(0.85, 0.8, 0.2), (0.1, 0.1, 0.4), grey(0.8)], scale=4, seed=seed)
    tyre = materials.noise([grey(0.02), grey(0.06)], scale=6)
    rim = materials.cells([grey(0.5), grey(0.15)], scale=5)
    stripe, plate = materials.plain(grey(0.1)), materials.plain((0.8, 0.8, 0.78))
    truck = Thing(scene, "truck")
    truck.add(box(2.0, length, height - 0.35, standing=True, taper=0.95, taper_length=0.96), paint, (0, 0, 0.35))
    for side in (-1, 1):
        truck.add(box(0.03, length * 0.45, 0.7), advert, (side * 0.985, -length * 0.15, 1.2))
        truck.add(box(0.03, 1.0, 0.6), glass, (side * 0.965, length * 0.32, 1.7))
        truck.add(box(0.02, length * 0.98, 0.06), stripe, (side * 0.995, 0, 0.75))
        for axle in (-0.32, 0.34):
            truck.add(cylinder(0.36, 0.22), tyre, (side * 0.92, axle * length, 0.36), (0, math.pi / 2, 0))
            truck.add(cylinder(0.2, 0.25), rim, (side * 0.92, axle * length, 0.36), (0, math.pi / 2, 0))
    for end in (-1, 1):
        truck.add(box(1.6, 0.03, 0.7), glass, (0, end * length * 0.495, 1.6))
        truck.add(box(0.5, 0.03, 0.11), plate, (0, end * length * 0.5, 0.5))
    return truck
