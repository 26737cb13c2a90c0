# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""A table from a hand-held RGB-D camera that circles it, .75 m away: a box is pushed at .15 m/s, a toy turns on the
spot, six more things stand."""
import math
from random import Random

from modelling import lights
from modelling.materials import grey, random_colours
from modelling.scene import Thing
from modelling.shapes import ball, box, cylinder, plane
from recording import Recording

RECORDING = Recording(frames=50, rate=30, sensor="rgbd", height=480, focal_length=525, baseline=0.075, max_depth=6,
                      slowest=0.03, seed=859)

FLOOR = -0.75  # z; that of the table is 0


def build(scene):
    random = Random(1)
    scene.materials.set_ambient(0.4, 0.14)
    lights.sky((0.3, 0.3, 0.32), (0.4, 0.4, 0.42))
    lights.sun((0.5, -0.35, 1), 1.7, 0.04)
    add_room(scene, random)
    pushed, turning = add_things(scene, random)

    def advance(t):
        around = -1.9 + 0.55 * t + 0.02 * math.sin(5 * t)
        scene.camera.look((0.75 * math.cos(around), 0.75 * math.sin(around), 0.5 + 0.02 * math.sin(3 * t)),
                          (0.02, 0.02, 0.05), 0.03 * math.sin(2.3 * t))
        way = pushed_way(t)
        pushed.place(-0.05 + way * 0.8, -0.12 - way * 0.6)
        turning.turn(0, 0, math.radians(45) * max(0, t - 0.3))

    return advance


def pushed_way(t):
    """Metres that the box has been pushed: from .5 s on, .2 s to reach its speed, 1.2 s in all."""
    t = min(max(0, t - 0.5), 1.2)
    return 0.15 * (t - 0.1) if t > 0.2 else 0.15 * t * t / 0.4


def add_room(scene, random):
    """The table, and a room with boxes along its walls."""
    materials, background = scene.materials, scene.background
    wood = materials.waves([(0.35, 0.2, 0.09), (0.5, 0.32, 0.17), (0.58, 0.4, 0.24), (0.42, 0.27, 0.13)], scale=3,
                           distortion=9, stretch=(1, 4, 1))
    background.add(box(1.6, 1.2, 0.04), wood, (0, 0, -0.02))
    leg = materials.plain(grey(0.2))
    for x in (-0.7, 0.7):
        for y in (-0.5, 0.5):
            background.add(box(0.05, 0.05, 0.7), leg, (x, y, -0.4))
    tiles = materials.bricks([(0.3, 0.3, 0.32), (0.45, 0.45, 0.46), (0.38, 0.36, 0.35)], (0.5, 0.5), mortar=0.01)
    background.add(plane(10, 10), tiles, (0, 0, FLOOR))
    for i, (x, y, yaw) in enumerate(((0, 3.2, 0), (3.4, 0, math.pi / 2), (-3.4, 0, math.pi / 2), (0, -3.4, 0))):
        plaster = materials.noise([(0.45, 0.47, 0.43), (0.58, 0.58, 0.55), grey(0.5)], scale=1.3, detail=9, seed=i)
        background.add(box(7, 0.1, 3.4), plaster, (x, y, 0.7), (0, 0, yaw))
    for i in range(9):
        angle = i * 0.7
        height = random.uniform(0.5, 1.4)
        colours, scale = random_colours(random, 3, 0.1, 0.7), random.choice([3, 6])
        pattern = random.choice([materials.cells, materials.noise, materials.checks])
        background.add(box(0.5, 0.5, height, standing=True), pattern(colours, scale, seed=i),
                       (2.8 * math.cos(angle), 2.7 * math.sin(angle), FLOOR))
    paper = materials.cells([(0.85, 0.84, 0.8), (0.1, 0.1, 0.12), (0.7, 0.2, 0.2)], scale=25)
    background.add(box(0.5, 0.35, 0.002), paper, (-0.1, 0.1, 0.001), (0, 0, 0.3))
    cloth = materials.checks([(0.1, 0.2, 0.5), (0.5, 0.6, 0.8)], scale=30)
    background.add(box(0.3, 0.2, 0.003), cloth, (0.4, -0.3, 0.001), (0, 0, -0.4))


def add_things(scene, random):
    """What stands on the table. Returns the box that is pushed and the toy that turns."""
    materials = scene.materials

    def colours(count=3):
        return random_colours(random, count, 0.05, 0.75)

    pushed = Thing(scene, "box", -0.05, -0.12, yaw=0.3)
    pushed.add(box(0.16, 0.08, 0.12, standing=True), materials.cells(colours(), scale=20))
    can = Thing(scene, "can", 0.22, 0.05)
    can.add(cylinder(0.035, 0.12, standing=True, sides=32), materials.cells(colours(), scale=22, seed=2))
    can.add(cylinder(0.033, 0.004), materials.plain(grey(0.7)), (0, 0, 0.122))
    cereal = Thing(scene, "cereal", -0.28, 0.18, yaw=0.5)
    cereal.add(box(0.2, 0.06, 0.28, standing=True), materials.cells(colours(4), scale=13, seed=4))
    mug = Thing(scene, "mug", 0.05, 0.25)
    mug.add(cylinder(0.042, 0.1, standing=True, sides=32), materials.noise(colours(2), scale=18, seed=5))
    mug.add(box(0.015, 0.05, 0.06), materials.noise(colours(2), scale=18, seed=5), (0, 0.06, 0.05))
    toy = Thing(scene, "toy", 0.3, -0.2)
    toy.add(box(0.14, 0.1, 0.1, standing=True), materials.checks(colours(), scale=18, seed=6))
    toy.add(box(0.06, 0.06, 0.06, standing=True), materials.cells(colours(), scale=30, seed=7), (0.02, 0, 0.1))
    sphere = Thing(scene, "ball", -0.32, -0.2)
    sphere.add(ball(0.055, sides=28), materials.cells(colours(), scale=20, seed=8), (0, 0, 0.055))
    book = Thing(scene, "book", 0.45, 0.25, yaw=0.7)
    book.add(box(0.2, 0.27, 0.03, standing=True), materials.noise(colours(), scale=12, seed=9))
    bottle = Thing(scene, "bottle", -0.1, 0.02)
    glass = materials.waves(colours(), scale=24, distortion=3, seed=10)
    bottle.add(cylinder(0.035, 0.16, standing=True, sides=28), glass)
    bottle.add(cylinder(0.035, 0.05, standing=True, top_radius=0.014, sides=28), materials.plain((0.2, 0.4, 0.2)),
               (0, 0, 0.16))
    bottle.add(cylinder(0.014, 0.04, standing=True), materials.plain((0.6, 0.1, 0.1)), (0, 0, 0.21))
    return pushed, toy
