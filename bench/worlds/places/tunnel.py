# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""A tunnel whose lamps flicker, from a car: a bicycle ahead at about the same speed, two parked cars, three barriers
and somebody who walks."""
import math
from random import Random

from modelling import lights
from modelling.car import Car
from modelling.materials import ON_SIDE, grey
from modelling.person import SKIN, Person
from modelling.scene import Thing
from modelling.shapes import ball, box, cylinder, plane
from recording import Recording

RECORDING = Recording(frames=40, sensor="stereo", focal_length=420, baseline=0.3, seed=662)
AMBIENT = (0.55, 0.1)
SUN = 0.9

RIDING = 5.25  # m/s
WHEEL_RADIUS = 0.34


def build(scene):
    scene.materials.set_ambient(*AMBIENT)
    lights.sky(grey(0.1), grey(0.2))
    sun = lights.sun((0.15, -0.5, 1), SUN, 0.05)
    add_tunnel(scene)
    bicycle = Bicycle(scene)
    Car(scene, -1.9, 17, 0, (0.7, 0.7, 0.68), 5, length=4.8, width=1.8, height=1.9)
    Car(scene, 2.0, 30, math.pi, (0.1, 0.2, 0.5), 7)
    add_barriers(scene)
    walker = Person(scene, yaw=math.pi, seed=22)

    def advance(t):
        scene.camera.place((0.06 * math.sin(2 * t), 5 * t, 1.4 + 0.012 * math.sin(9 * t)), 0.015 * math.sin(1.5 * t),
                           -0.04 + 0.004 * math.sin(7 * t), 0.006 * math.sin(4 * t))
        flicker(scene.materials, sun, frame=round(t * RECORDING.rate))
        bicycle.ride(t)
        walker.place(-2.4, 33 - 1.2 * t, 0.18)
        walker.walk(5 * t)

    return advance


def flicker(materials, sun, frame):
    """From frame to frame the lamps change by up to a quarter, and what comes from outside by up to a tenth."""
    random = Random(100 + frame)
    lamps = 1 + 0.25 * random.uniform(-1, 1)
    materials.set_ambient(*(lamps * strength for strength in AMBIENT))
    sun.energy = SUN * (1 + 0.1 * random.uniform(-1, 1))


def add_tunnel(scene):
    materials, background = scene.materials, scene.background
    tiles = materials.bricks([(0.5, 0.5, 0.46), (0.5, 0.5, 0.46), (0.2, 0.2, 0.19)], (0.6, 0.3), mortar=0.02,
                             turn=ON_SIDE)
    road = materials.noise([grey(0.1), grey(0.15), grey(0.2)], scale=1.5, detail=9)
    pillar, lamp = materials.plain((0.3, 0.3, 0.31)), materials.plain((0.9, 0.9, 0.85))
    line = materials.noise([(0.75, 0.75, 0.7), (0.6, 0.6, 0.55)], scale=3)
    kerb = materials.noise([grey(0.4), grey(0.5)], scale=1.2)
    background.add(plane(8, 160), road, (0, 60, 0))
    for side in (-1, 1):
        background.add(box(0.3, 160, 4.2), tiles, (side * 3.4, 60, 2.1), casts_shadow=False)
        for i in range(40):
            background.add(box(0.12, 0.25, 4.2), pillar, (side * 3.2, -10 + i * 3, 2.1))
        for i in range(40):
            background.add(box(0.1, 1.0, 0.12), lamp, (side * 3.15, -8.5 + i * 3, 3.1))
        background.add(plane(0.15, 160), line, (side * 2.2, 60, 0.004))
        background.add(box(0.25, 160, 0.18, standing=True), kerb, (side * 3.0, 60, 0))
    roof = materials.bricks([grey(0.3), grey(0.4), grey(0.2)], (3, 3), mortar=0.04)
    background.add(plane(7.5, 160), roof, (0, 60, 4.2), (math.pi, 0, 0), casts_shadow=False)
    background.add(box(7, 0.3, 4.5), materials.cells([(0.5, 0.52, 0.5), (0.3, 0.3, 0.35)], scale=1.0), (0, 60, 2.2))


def add_barriers(scene):
    yellow = scene.materials.plain((0.8, 0.6, 0.05))
    for i, (x, y) in enumerate(((1.7, 9), (1.9, 13.5), (-1.2, 24))):
        barrier = Thing(scene, "barrier", x, y, yaw=0.1 * i)
        checks = scene.materials.checks([(0.8, 0.15, 0.05), (0.85, 0.85, 0.8)], scale=3, seed=i)
        barrier.add(box(1.0, 0.35, 0.8, standing=True, taper_length=0.6), checks)
        barrier.add(box(0.1, 0.1, 0.3, standing=True), yellow, (0, 0, 0.8))


class Bicycle(Thing):
    """With its rider, whose legs turn the pedals."""

    def __init__(self, scene):
        super().__init__(scene, "bicycle")
        self._add_bicycle(scene.materials)
        self._add_rider(scene.materials)

    def _add_bicycle(self, materials):
        frame = materials.plain((0.6, 0.05, 0.05))
        tyre = materials.noise([grey(0.02), grey(0.07)], scale=9)
        spokes = materials.cells([grey(0.6), grey(0.25)], scale=7)
        self._wheels = []
        for y in (-0.52, 0.52):
            wheel = self.joint((0, y, WHEEL_RADIUS))
            wheel.add(cylinder(WHEEL_RADIUS, 0.04, sides=28), tyre, turn=(0, math.pi / 2, 0))
            wheel.add(cylinder(0.29, 0.046, sides=28), spokes, turn=(0, math.pi / 2, 0))
            self._wheels.append(wheel)
        self.add(box(0.04, 0.6, 0.05), frame, (0, 0, 0.75))
        self.add(box(0.04, 0.05, 0.5), frame, (0, -0.2, 0.55))
        self.add(box(0.5, 0.04, 0.04), materials.plain(grey(0.1)), (0, 0.45, 1.0))
        self.add(box(0.16, 0.25, 0.06), materials.plain(grey(0.05)), (0, -0.22, 0.9))

    def _add_rider(self, materials):
        shirt = materials.cells([(0.05, 0.3, 0.6), (0.8, 0.8, 0.1), grey(0.1)], scale=7, seed=3)
        rucksack = materials.cells([(0.5, 0.1, 0.1), (0.2, 0.05, 0.05), (0.7, 0.6, 0.5)], scale=9)
        skin = materials.noise(SKIN, scale=10)
        trousers = materials.noise([(0.04, 0.04, 0.06), (0.12, 0.12, 0.15)], scale=9)
        shoe = materials.plain(grey(0.03))
        self.add(box(0.4, 0.26, 0.55, standing=True, taper=1.05), shirt, (0, -0.12, 0.98), (-0.5, 0, 0))
        self.add(box(0.3, 0.18, 0.4, standing=True), rucksack, (0, -0.18, 1.12), (-0.5, 0, 0))
        self.add(ball(0.12), materials.plain((0.85, 0.85, 0.8)), (0, 0.25, 1.62))
        self._legs = []  # hip, knee, and the phase of the pedal
        for side, phase in ((-1, math.pi), (1, 0)):
            self.add(box(0.07, 0.5, 0.08), skin, (side * 0.22, 0.2, 1.2), (-0.6, 0, 0))
            hip = self.joint((side * 0.12, -0.18, 0.95))
            hip.add(cylinder(0.08, 0.45), trousers, (0, 0, -0.22))
            knee = hip.joint((0, 0, -0.45))
            knee.add(cylinder(0.055, 0.42), trousers, (0, 0, -0.2))
            knee.add(box(0.1, 0.25, 0.08), shoe, (0, 0.05, -0.42))
            self._legs.append((hip, knee, phase))

    def ride(self, t):
        """Where it is, and how it leans, after t seconds: in gentle bends."""
        self.place(0.3 + 0.15 * math.sin(1.2 * t), 6.5 + RIDING * t)
        self.turn(0, 0.03 * math.sin(5 * t), -0.03 * math.cos(1.2 * t))
        for wheel in self._wheels:
            wheel.turn(-RIDING * t / WHEEL_RADIUS, 0, 0)
        for hip, knee, phase in self._legs:
            pedal = math.sin(6 * t + phase)
            hip.turn(0.75 + 0.35 * pedal, 0, 0)
            knee.turn(-1.0 - 0.35 * pedal, 0, 0)
