# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""A roundabout from a camera that turns to the right on the spot, by 25 degrees a second: a bus passes close before it,
a car goes round, somebody walks; eight cars are parked and two people stand."""
import math
from random import Random

from modelling import lights
from modelling.car import Car, paints
from modelling.materials import grey
from modelling.person import Person
from modelling.scene import Thing
from modelling.scenery import house, pole, tree
from modelling.shapes import box, cylinder, plane
from recording import Recording

RECORDING = Recording(frames=40, sensor="stereo", focal_length=400, baseline=0.3, seed=1091)

ISLAND = (-2, 17)  # its middle


def build(scene):
    random = Random(1)
    lights.sky()
    lights.sun((-0.5, -0.6, 0.85), 3.0)
    add_ground(scene)
    colours = paints(black=0.05)
    for x, y, yaw, colour, seed in ((-7, 7, 1.2, 0, 1), (5, 12, -0.9, 1, 2), (9, 7.5, -1.3, 4, 3), (-11, 13, 0.6, 5, 4),
                                    (13, 13, 0.4, 7, 8), (3.2, 7, 2.6, 6, 9)):
        Car(scene, x, y, yaw, colours[colour], seed)
    circling = Car(scene, 0, 0, 0, colours[2], 6)
    walker = Person(scene, seed=7)
    Person(scene, -1.2, 6.5, 0.4, seed=8)
    Car(scene, -13, 3, 1.4, colours[3], 12)
    Car(scene, -9, -3, 0.3, colours[1], 13)
    Person(scene, 6.5, 5.5, 1.4, seed=11)
    bus = make_bus(scene)
    add_surroundings(scene, random)

    def advance(t):
        scene.camera.place((0.02 * math.sin(3 * t), 0.03 * math.sin(2 * t), 1.5), 1.4 - math.radians(25) * t,
                           -0.03 + 0.004 * math.sin(7 * t), 0.004 * math.sin(5 * t))
        bus.place(-2.1 - 1.25, 2 - 5.5 + 6.5 * (t - 1))
        around = 1.9 - 0.45 * t
        circling.place(ISLAND[0] + 9 * math.cos(around), ISLAND[1] + 9 * math.sin(around), yaw=around - math.pi)
        circling.roll(9 * 0.45 * t)
        walker.place(2.0 + 1.2 * t, 9.5, yaw=-math.pi / 2)
        walker.walk(5 * t)

    return advance


def add_ground(scene):
    """The road, and the island with its sign posts."""
    materials, background = scene.materials, scene.background
    road = materials.noise([grey(0.07), grey(0.12), (0.18, 0.18, 0.17)], scale=1.2, detail=10)
    background.add(plane(200, 200), road)
    grass = materials.noise([(0.05, 0.12, 0.03), (0.15, 0.22, 0.06), (0.25, 0.25, 0.1)], scale=1.5)
    background.add(cylinder(5, 0.25, standing=True, sides=48), grass, (*ISLAND, 0))
    for i in range(5):
        x, y = -6 + i * 2.2, 14 + 0.9 * (i % 3)
        pole(scene, x, y, 0.1, 3.0)
        sign = materials.cells([(0.1, 0.2, 0.6), grey(0.8)], scale=6, seed=i)
        background.add(box(0.8, 0.06, 0.5), sign, (x, y - 0.1, 2.8))


def make_bus(scene):
    materials = scene.materials
    paint = materials.noise([(0.6, 0.1, 0.05), (0.7, 0.16, 0.08)], scale=1.2)
    glass = materials.noise([(0.03, 0.04, 0.05), (0.12, 0.14, 0.15)], scale=1.2, gloss=(0.03, 0.5))
    advert = materials.cells([(0.85, 0.8, 0.2), (0.1, 0.1, 0.4), grey(0.8)], scale=3, seed=4)
    gap, stripe = materials.plain((0.2, 0.03, 0.02)), materials.plain((0.8, 0.8, 0.75))
    tyre = materials.noise([grey(0.02), grey(0.06)], scale=6)
    rim = materials.cells([grey(0.5), grey(0.15)], scale=5)
    destination = materials.cells([grey(0.02), (0.9, 0.6, 0.1)], scale=9)
    bus = Thing(scene, "bus")
    bus.add(box(2.5, 11, 2.7, standing=True, taper=0.98), paint, (0, 0, 0.35))
    for side in (-1, 1):
        for i in range(6):
            bus.add(box(0.03, 1.4, 1.0), glass, (side * 1.245, -4.4 + i * 1.75, 2.1))
        bus.add(box(0.03, 3.6, 0.6), advert, (side * 1.255, -0.5, 1.05))
        bus.add(box(0.03, 0.05, 2.4, standing=True), gap, (side * 1.25, 3.2, 0.6))
        bus.add(box(0.02, 10.9, 0.08), stripe, (side * 1.25, 0, 1.5))
        for axle in (-3.3, 3.4):
            bus.add(cylinder(0.48, 0.25), tyre, (side * 1.15, axle, 0.48), (0, math.pi / 2, 0))
            bus.add(cylinder(0.25, 0.28), rim, (side * 1.15, axle, 0.48), (0, math.pi / 2, 0))
    for end in (-1, 1):
        bus.add(box(2.2, 0.03, 1.2), glass, (0, end * 5.49, 1.9))
        bus.add(box(1.6, 0.04, 0.3), destination, (0, end * 5.5, 2.8))
    return bus


def add_surroundings(scene, random):
    """Houses and trees around the place."""
    for i in range(12):
        angle = -1.6 + i * 0.3
        house(scene, random, 32 * math.sin(angle), 34 * math.cos(angle), ground=(9, 6), heights=(6, 12), row=0.4,
              seed=i, yaw=-angle)
    for i in range(8):
        angle = -1.5 + i * 0.42
        tree(scene, 19 * math.sin(angle), 20 * math.cos(angle), trunk_size=(0.25, 2.6), crown_radius=1.8,
             crown_height=3.9, seed=i)
