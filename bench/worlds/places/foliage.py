# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""A bank of a canal on a windy day, from a car that drives by: trees and reeds sway and the water moves, none of which
has a mask; five parked cars, one that drives, a boat, somebody who walks and somebody who stands."""
import math
from random import Random

from modelling import lights
from modelling.car import Car, paints
from modelling.materials import ON_FRONT, grey, move_texture
from modelling.person import Person
from modelling.scene import Thing
from modelling.scenery import GRASS, trunk
from modelling.shapes import Shape, box, plane
from recording import Recording

RECORDING = Recording(frames=40, sensor="stereo", focal_length=450, baseline=0.3, seed=727)


def build(scene):
    random = Random(1)
    lights.sky()
    lights.sun((0.5, -0.5, 0.8), 3.0)
    water = add_ground(scene)
    swaying = add_plants(scene, random)
    colours = paints(black=0.05)
    for i in range(5):
        y = 11.5 + random.uniform(-0.3, 0.3)
        yaw = random.choice([1, -1]) * math.pi / 2 + random.uniform(-0.05, 0.05)
        Car(scene, -9 + i * 5.2, y, yaw, colours[i], i)
    passing = Car(scene, 0, 0, -math.pi / 2, colours[6], 9)
    walker = Person(scene, yaw=math.pi / 2, seed=3)
    Person(scene, 1.5, 9.3, 2.4, seed=5)
    boat = make_boat(scene)

    def advance(t):
        scene.camera.place((-6 + 2 * t, 0, 1.6 + 0.01 * math.sin(8 * t)), -0.12 + 0.06 * t,
                           0.02 + 0.004 * math.sin(6 * t), 0.005 * math.sin(4 * t))
        for plant in swaying:
            plant.sway(t)
        move_texture(water, (0.8 * t, 0.5 * t + 0.1 * math.sin(3 * t), 0.6 * t))
        passing.place(-16 + 4 * t, 7.2)
        passing.roll(4 * t)
        walker.place(4 - 1.2 * t, 9.2)
        walker.walk(5 * t)
        boat.place(-12 + 2.5 * t, 27, -0.3)
        boat.turn(0.02 * math.sin(2 * t), 0.04 * math.sin(1.5 * t), -math.pi / 2)

    return advance


def add_ground(scene):
    """Road, grass, the canal and a wall behind it. Returns the water's material."""
    materials, background = scene.materials, scene.background
    grass = materials.noise(GRASS, scale=1.2, detail=9)
    background.add(plane(120, 14), materials.noise([grey(0.1), grey(0.15), grey(0.2)], scale=1.3, detail=9), (0, 7, 0))
    background.add(plane(120, 6), grass, (0, 17, 0.02))
    water = materials.noise([(0.03, 0.08, 0.12), (0.1, 0.2, 0.25), (0.35, 0.45, 0.5)], scale=0.9, detail=6,
                            contrast=0.4)
    background.add(plane(120, 22), water, (0, 31, -0.3))
    wall = materials.bricks([(0.3, 0.28, 0.25), (0.42, 0.4, 0.36), grey(0.2)], (2, 0.7), mortar=0.05, turn=ON_FRONT)
    background.add(box(120, 4, 5), wall, (0, 45, 1.5))
    return water


class Swaying:
    """A branch or a reed in the wind: it turns about its foot by up to `angle` (radians), `pace` radians a second."""

    def __init__(self, scene, foot, shape, leaves, phase, pace, angle):
        self._foot = scene.background.joint(foot)
        self._foot.add(shape, leaves)
        self._phase, self._pace, self._angle = phase, pace, angle

    def sway(self, t):
        self._foot.turn(0.5 * self._angle * math.sin(self._pace * t * 1.3 + self._phase),
                        self._angle * math.sin(self._pace * t + self._phase) + 0.05 * math.sin(1.1 * t), 0)


def add_plants(scene, random):
    """A row of trees with ten branches each, and reeds at the water. Returns what sways."""
    leaves = [scene.materials.noise([(0.03, 0.08, 0.02), (0.12, 0.25, 0.06), (0.3, 0.42, 0.1)], scale=5, contrast=0.4,
                                    seed=seed) for seed in range(3)]
    swaying = []
    for i in range(9):
        x, y = -14 + i * 4.2 + random.uniform(-0.6, 0.6), 16 + random.uniform(-1, 1)
        trunk(scene, x, y, 0.18, 2.2)
        for j in range(10):
            foot = x + random.uniform(-0.3, 0.3), y, 2.0
            shape = branch(random)
            swaying.append(Swaying(scene, foot, shape, leaves[j % 3], random.uniform(0, 6), random.uniform(1.5, 4),
                                   random.uniform(0.06, 0.14)))
    reed = Shape([(-0.25, 0, 0), (0.25, 0, 0), (0.1, 0, 1.4), (-0.1, 0.1, 1.6)], [(0, 1, 2, 3)])
    for i in range(60):
        foot = -20 + i * 0.7 + random.uniform(-0.2, 0.2), 19.5 + random.uniform(-0.4, 0.4), 0
        swaying.append(Swaying(scene, foot, reed, leaves[i % 3], random.uniform(0, 6), random.uniform(2, 5), 0.2))
    return swaying


def branch(random):
    """26 ragged leaves above the foot, each a square that is bent a little."""
    vertices, faces = [], []
    for _ in range(26):
        lean, far = random.uniform(-1.3, 1.3), random.uniform(0.4, 2.3)
        y, size, turn = random.uniform(-0.7, 0.7), random.uniform(0.15, 0.34), random.uniform(0, 3)
        first = len(vertices)
        for corner in range(4):
            angle = turn + corner * math.pi / 2
            vertices.append((far * math.sin(lean) + size * math.cos(angle), y + 0.2 * math.sin(turn * 3 + corner),
                             far * math.cos(lean) + size * math.sin(angle)))
        faces.append((first, first + 1, first + 2, first + 3))
    return Shape(vertices, faces)


def make_boat(scene):
    materials = scene.materials
    boat = Thing(scene, "boat")
    boat.add(box(1.6, 5, 0.8, standing=True, taper=1.15),
             materials.waves([grey(0.7), (0.5, 0.1, 0.1)], scale=2, distortion=2), (0, 0, -0.1))
    boat.add(box(1.2, 2, 1.1, standing=True, taper=0.85),
             materials.cells([(0.75, 0.75, 0.7), (0.3, 0.4, 0.5)], scale=3), (0, -0.4, 0.7))
    return boat
