# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""A street from a camera on a mast that does not move: a fan turns, a door opens, cars pass, one starts slowly, people
walk; five cars are parked and somebody stands."""
import math

from modelling import lights
from modelling.car import Car, paints
from modelling.materials import ON_FRONT, darker, grey
from modelling.person import Person
from modelling.scene import Thing
from modelling.scenery import BRICK, PAVING, tree
from modelling.shapes import box, cylinder, plane
from recording import Recording

RECORDING = Recording(frames=44, sensor="stereo", focal_length=430, baseline=0.3, seed=698)

WALL = 9.5  # y of the front of the house
FAN_SPEED = math.radians(200)  # a second
# Of colours that tell the blades apart: the motion of equal ones would look the same in either direction.
BLADES = [(0.7, 0.1, 0.1), (0.1, 0.3, 0.7), (0.8, 0.75, 0.2), (0.15, 0.5, 0.2), grey(0.6)]


def build(scene):
    lights.sky()
    lights.sun((0.6, -0.5, 0.8), 3.0)
    add_street(scene)
    door = make_door(scene)
    fan = make_fan(scene)
    colours = paints(black=0.03)
    for x, y, yaw, colour, seed in ((5.5, 12.5, 0.1, 0, 1), (8.3, 13.2, 0.05, 1, 2), (-8, 22, math.pi / 2, 4, 3),
                                    (3.2, 27, math.pi / 2, 5, 4), (-2.5, 27.2, -math.pi / 2, 7, 8)):
        Car(scene, x, y, yaw, colours[colour], seed)
    to_the_right = Car(scene, -18, 16, -math.pi / 2, colours[2], 5)
    to_the_left = Car(scene, 20, 19.5, math.pi / 2, colours[6], 6)
    starting = Car(scene, 2, 22.5, -math.pi / 2, colours[3], 7)
    near, crossing = Person(scene, seed=4), Person(scene, seed=6)
    Person(scene, 3.6, 8.8, 2.6, seed=15)
    add_trees_and_house(scene)

    def advance(t):
        scene.camera.look((0.6, 0, 4.2), (0.6, 13, 1.4))
        open_share = min(max(0, (t - 1.0) / 2.0), 1)
        door.turn(0, 0, -1.4 * (3 * open_share * open_share - 2 * open_share**3))
        fan.turn(0, FAN_SPEED * t, 0)
        to_the_right.place(-20 + 7.0 * t, 16)
        to_the_right.roll(7.0 * t)
        to_the_left.place(26 - 6.0 * t, 19.5)
        to_the_left.roll(6.0 * t)
        started = 0.3 * max(0, t - 2) ** 2
        starting.place(2 + started, 22.5)
        starting.roll(started)
        near.place(-4.5 + 1.3 * t, 7.4, 0.05, yaw=-math.pi / 2)
        near.walk(5.2 * t)
        crossing.place(6 - 0.9 * t, 10.5 + 0.5 * t, yaw=1.06)
        crossing.walk(4.6 * t)

    return advance


def add_street(scene):
    """Road, pavement and the front of a house with a doorway."""
    materials, background = scene.materials, scene.background
    road = materials.noise([grey(0.07), grey(0.13), (0.2, 0.2, 0.19)], scale=1.1, detail=10)
    background.add(plane(120, 120), road, (0, 25, -0.01))
    background.add(plane(60, 5), materials.bricks(PAVING, (0.6, 0.6), mortar=0.02), (0, 7.5, 0.06))
    brick = materials.bricks(BRICK, (0.5, 0.2), turn=ON_FRONT)
    background.add(box(7, 0.4, 6), brick, (-6.6, WALL + 0.2, 3))
    background.add(box(12, 0.4, 6), brick, (3.9 + 1.4, WALL + 30, 3))
    background.add(box(2.2, 0.4, 3.6), brick, (-3.1 + 1.0, WALL + 0.2, 4.3))
    background.add(box(1.2, 0.4, 6), brick, (-0.9 + 0.5, WALL + 0.2, 3))
    inside = materials.noise([(0.06, 0.05, 0.05), (0.12, 0.1, 0.1)], scale=3)
    background.add(plane(1.3, 2.6), inside, (-2.5, WALL + 0.9, 1.2), (math.pi / 2, 0, 0))


def make_door(scene):
    """It turns about its hinge, which is its origin."""
    materials = scene.materials
    wood = materials.waves([(0.25, 0.1, 0.04), (0.4, 0.2, 0.08), (0.5, 0.28, 0.12)], scale=2.2, distortion=5)
    door = Thing(scene, "door", -3.1, WALL - 0.02, 0.06)
    door.add(box(1.1, 0.06, 2.4, standing=True), wood, (0.55, 0, 0))
    door.add(box(0.35, 0.07, 0.5), materials.noise([(0.08, 0.1, 0.12), (0.3, 0.35, 0.4)], scale=5), (0.55, 0, 1.8))
    door.add(box(0.12, 0.1, 0.04), materials.plain((0.7, 0.65, 0.3)), (1.0, -0.04, 1.05))
    door.add(box(0.6, 0.065, 0.25), materials.cells([grey(0.8), (0.05, 0.05, 0.3)], scale=9), (0.55, 0, 1.2))
    return door


def make_fan(scene):
    """On the wall, to the right of the door. Returns its hub, which turns about y."""
    materials = scene.materials
    hub = Thing(scene, "fan", 0.05 - 0.4, WALL - 0.35, 3.0).joint()
    for i, colour in enumerate(BLADES):
        angle = i * 2 * math.pi / len(BLADES)
        blade = materials.noise([colour, darker(colour, 0.4)], scale=7, seed=i)
        hub.add(box(0.26, 0.03, 0.75), blade, (0.4 * math.sin(angle), 0, 0.4 * math.cos(angle)), (0, angle, 0))
    hub.add(cylinder(0.14, 0.18), materials.plain((0.3, 0.05, 0.05)), turn=(math.pi / 2, 0, 0))
    frame = materials.checks([(0.2, 0.2, 0.22), (0.3, 0.3, 0.33)], scale=4)
    scene.background.add(box(1.9, 0.06, 1.9), frame, (-0.35, WALL - 0.12, 3.0))
    return hub


def add_trees_and_house(scene):
    for x, y in ((-12, 26), (10, 30), (16, 24), (-4, 34)):
        tree(scene, x, y, trunk_size=(0.25, 3), crown_radius=2.3, crown_height=4.5, seed=x)
    blocks = scene.materials.bricks([(0.45, 0.42, 0.36), (0.52, 0.5, 0.45), grey(0.3)], (1.2, 0.5), turn=ON_FRONT)
    scene.background.add(box(50, 6, 8), blocks, (0, 44, 4))
