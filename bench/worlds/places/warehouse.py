# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""An aisle of a warehouse from an RGB-D camera in a hand, which is carried along and sways: a fork-lift crosses,
somebody walks ahead; pallets, boxes and somebody else stand."""
import math
from random import Random

from modelling import lights
from modelling.materials import ON_FRONT, grey
from modelling.person import SKIN, Person
from modelling.scene import Thing
from modelling.shapes import ball, box, cylinder, plane
from recording import Recording

RECORDING = Recording(frames=50, rate=30, sensor="rgbd", height=480, focal_length=520, baseline=0.075, max_depth=9,
                      seed=979)


def build(scene):
    random = Random(1)
    scene.materials.set_ambient(0.42, 0.12)
    lights.sky((0.3, 0.3, 0.32), (0.4, 0.4, 0.42))
    lights.sun((0.35, 0.25, 1), 1.6, 0.05)
    goods = Goods(scene)
    add_hall(scene)
    add_racks(scene, random, goods)
    goods.add_pallet(1.2, 3.6, 0.1, 1, layers=2)
    goods.add_pallet(-1.25, 5.2, -0.2, 4, layers=1)
    goods.add_pallet(1.3, 7.6, math.pi / 2, 7, layers=3)
    goods.add_box(-1.0, 2.9, 0.4, (0.5, 0.4, 0.45), 2)
    goods.add_box(0.55, 6.3, -0.3, (0.45, 0.45, 0.6), 5)
    goods.add_box(-0.9, 7.2, 0.1, (0.6, 0.5, 0.5), 8)
    forklift = make_forklift(scene, goods)
    walker = Person(scene, seed=9)
    Person(scene, 0.9, 9.3, 0.5, seed=12).walk(0.3, 0.03)

    def advance(t):
        scene.camera.place((0.05 * math.sin(2.3 * t) + 0.02 * math.sin(11 * t), 1.0 * t - 1.2,
                            1.45 + 0.02 * math.sin(11.5 * t)),
                           0.035 * math.sin(2.1 * t) + 0.006 * math.sin(17 * t),
                           -0.06 + 0.012 * math.sin(5.3 * t) + 0.004 * math.sin(19 * t),
                           0.012 * math.sin(3.7 * t))
        forklift.place(4.2 - 1.5 * t, 5.3, yaw=math.pi / 2)
        walker.place(-0.45 + 0.05 * t, 2.3 + 1.25 * t, 0.02 * abs(math.sin(5.5 * t)), yaw=-0.08)
        walker.walk(5.5 * t)

    return advance


def add_hall(scene):
    materials, background = scene.materials, scene.background
    floor = materials.noise([(0.2, 0.2, 0.19), (0.33, 0.32, 0.3), (0.42, 0.41, 0.39)], scale=2.2, detail=9)
    background.add(plane(60, 60), floor, (0, 10, 0))
    roof = materials.bricks([(0.35, 0.36, 0.38), (0.5, 0.5, 0.52), grey(0.2)], (3, 0.4))
    background.add(plane(40, 60), roof, (0, 10, 6.5), (math.pi, 0, 0), casts_shadow=False)
    line = materials.noise([(0.7, 0.55, 0.05), (0.55, 0.42, 0.05)], scale=5)
    for side in (-1, 1):
        background.add(plane(0.12, 40), line, (side * 1.75, 10, 0.004))
    wall = materials.bricks([(0.4, 0.42, 0.45), (0.5, 0.52, 0.55), grey(0.3)], (1, 0.5), turn=ON_FRONT)
    background.add(box(14, 0.3, 7), wall, (0, 15, 3.5))


def add_racks(scene, random, goods):
    """Racks with boxes along both sides; the fork-lift comes through a gap."""
    background = scene.background
    steel = scene.materials.noise([(0.05, 0.12, 0.4), (0.1, 0.18, 0.5)], scale=5)
    beam = scene.materials.noise([(0.8, 0.3, 0.03), (0.65, 0.22, 0.02)], scale=6)
    for side in (-1, 1):
        for i in range(7):
            y = -2 + i * 2.8
            if side == 1 and i == 2:
                continue
            for inwards in (0, 1.1):
                background.add(box(0.1, 0.1, 5, standing=True), steel, (side * (2.3 + inwards), y, 0))
            for shelf in (1.6, 3.2, 4.8):
                background.add(box(0.06, 2.7, 0.14), beam, (side * 2.3, y + 1.4, shelf))
                for place in range(3):
                    if random.random() < 0.8:
                        height = random.uniform(0.5, 1.1)
                        background.add(box(0.8, 0.75, height, standing=True), goods.cartons[random.randrange(9)],
                                       (side * 2.75, y + 0.5 + place * 0.9, shelf + 0.08))
                        background.add(box(0.006, 0.2, 0.15), goods.label,
                                       (side * 2.345, y + 0.5 + place * 0.9, shelf + 0.3))
            for place in range(2):
                if random.random() < 0.7:
                    height = random.uniform(0.6, 1.2)
                    background.add(box(0.9, 1.0, height, standing=True), goods.cartons[random.randrange(9)],
                                   (side * 2.8, y + 0.75 + place * 1.3, 0))


class Goods:
    """Pallets, boxes and what they are made of."""

    def __init__(self, scene):
        materials = scene.materials
        self.scene = scene
        self.label = materials.cells([(0.85, 0.85, 0.82), grey(0.05)], scale=18)
        self.wood = materials.waves([(0.35, 0.22, 0.1), (0.5, 0.34, 0.18), (0.6, 0.45, 0.27)], scale=5, distortion=4)
        self.strap = materials.plain((0.5, 0.4, 0.25))
        self.band = materials.plain((0.6, 0.5, 0.3))
        self.cartons = []
        for kind in range(10):
            brown = (0.33 + 0.03 * (kind % 4), 0.22 + 0.02 * (kind % 3), 0.12)
            self.cartons.append(materials.noise([brown, (0.48, 0.34, 0.2), (0.58, 0.44, 0.29)], scale=2.5, seed=kind,
                                                contrast=0.6))

    def add_pallet(self, x, y, yaw, kind, layers):
        """With so many layers of two cartons."""
        pallet = Thing(self.scene, "pallet", x, y, yaw=yaw)
        for across in (-0.5, 0, 0.5):
            pallet.add(box(0.1, 0.8, 0.1, standing=True), self.wood, (across, 0, 0.02))
        for along in (-0.34, -0.17, 0, 0.17, 0.34):
            pallet.add(box(1.2, 0.1, 0.02, standing=True), self.wood, (0, along, 0.12))
        for layer in range(layers):
            for across in (-0.28, 0.28):
                z = 0.141 + layer * 0.405
                pallet.add(box(0.53, 0.7, 0.4, standing=True), self.cartons[kind + layer], (across, 0, z))
                pallet.add(box(0.16, 0.006, 0.12), self.label, (across + 0.08, -0.353, z + 0.219))
                pallet.add(box(0.54, 0.05, 0.003), self.strap, (across, 0, z + 0.402))

    def add_box(self, x, y, yaw, size, kind):
        """A single box of (width, length, height)."""
        width, length, height = size
        single = Thing(self.scene, "box", x, y, yaw=yaw)
        single.add(box(width, length, height, standing=True), self.cartons[kind])
        single.add(box(width * 0.4, 0.006, height * 0.35), self.label, (0.02, -length / 2 - 0.002, height * 0.55))
        single.add(box(width + 0.002, 0.06, height + 0.002, standing=True), self.band)


def make_forklift(scene, goods):
    """With a box on its forks, and a driver, who is a part of it."""
    materials = scene.materials
    yellow = materials.noise([(0.75, 0.5, 0.02), (0.85, 0.6, 0.05)], scale=3)
    dark = materials.noise([grey(0.04), grey(0.12)], scale=6)
    stripes = materials.checks([grey(0.02), (0.8, 0.6, 0.0)], scale=8)
    forklift = Thing(scene, "forklift")
    forklift.add(box(1.0, 1.7, 0.75, standing=True, taper=0.95), yellow, (0, -0.3, 0.25))
    forklift.add(box(0.9, 0.5, 0.55, standing=True, taper=0.85), dark, (0, -0.85, 1.0))
    for side in (-1, 1):
        forklift.add(box(0.07, 0.07, 1.1, standing=True), dark, (side * 0.42, -0.7, 1.0))
        forklift.add(box(0.07, 0.07, 1.1, standing=True), dark, (side * 0.42, 0.3, 1.0))
        forklift.add(box(0.1, 0.12, 2.1, standing=True), dark, (side * 0.3, 0.65, 0.1))
        forklift.add(box(0.12, 1.0, 0.05), dark, (side * 0.25, 1.2, 0.15))
    forklift.add(box(1.0, 1.15, 0.06), dark, (0, -0.2, 2.12))
    forklift.add(box(0.3, 0.02, 0.2), goods.label, (0.505, -0.3, 0.6), (0, 0, math.pi / 2))
    for side in (1, -1):
        forklift.add(box(0.02, 0.9, 0.12), stripes, (side * 0.5, -0.3, 0.85))
    forklift.add(box(0.9, 1.0, 0.8, standing=True), goods.cartons[3], (0, 1.25, 0.2))
    for side in (-1, 1):
        for end in (-1, 1):
            forklift.add(cylinder(0.24, 0.16), dark, (side * 0.46, -0.3 + end * 0.65, 0.24), (0, math.pi / 2, 0))
    vest = materials.waves([(0.8, 0.3, 0.02), (0.9, 0.8, 0.1)], scale=5, distortion=2)
    forklift.add(box(0.4, 0.25, 0.55, standing=True), vest, (0, -0.45, 1.05))
    forklift.add(ball(0.11), materials.noise(SKIN, scale=10), (0, -0.42, 1.75))
    return forklift
