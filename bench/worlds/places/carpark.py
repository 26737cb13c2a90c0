# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""A car park, seen from a car that turns left through it: 20 parked cars, one that backs out of its place, somebody who
walks and a trolley that rolls and turns."""
import math
from random import Random

from modelling import lights
from modelling.car import Car, paints
from modelling.materials import ON_FRONT, ON_SIDE, grey
from modelling.person import Person
from modelling.scene import Thing
from modelling.scenery import BRICK, pole, tree
from modelling.shapes import box, cylinder, plane
from recording import Recording

RECORDING = Recording(frames=44, sensor="stereo", focal_length=480, baseline=0.4, max_depth=80, seed=740)

SPEED = 5.0
STRAIGHT, RADIUS = 5.0, 14.0  # of the camera's way
ROW_AHEAD = 29  # y of the cars ahead
LEAVING = 3  # that one of them leaves


def build(scene):
    random = Random(1)
    lights.sky()
    lights.sun((0.5, -0.4, 0.9), 3.0)
    asphalt = scene.materials.noise([(0.05, 0.05, 0.052), grey(0.13), (0.2, 0.2, 0.19)], scale=1.3, detail=9,
                                    contrast=0.45)
    scene.background.add(plane(160, 160), asphalt)
    leaving = park_cars(scene, random)
    walker = Person(scene, seed=5)
    trolley = make_trolley(scene)
    add_surroundings(scene)

    def advance(t):
        x, y, yaw = way(SPEED * t)
        scene.camera.place((x, y, 1.55 + 0.012 * math.sin(9 * t)), yaw, -0.05 + 0.004 * math.sin(7 * t),
                           0.004 * math.sin(5 * t))
        backwards = speeding_up(t - 1.2)
        leaving.place(place_ahead(LEAVING), ROW_AHEAD - backwards)
        leaving.roll(-backwards)
        walker.place(-10.5 + 1.4 * t, 20.5, 0.02 * abs(math.sin(5 * t)), yaw=-math.pi / 2)
        walker.walk(5.2 * t)
        trolley.place(3.5 - 0.9 * t, 17 + 0.35 * t, yaw=1.2 + 0.25 * t)

    return advance


def way(s):
    """The camera's (x, y, yaw) after s metres: straight on, then around to the left."""
    if s < STRAIGHT:
        return 0, s, 0
    yaw = (s - STRAIGHT) / RADIUS
    return -RADIUS + RADIUS * math.cos(yaw), STRAIGHT + RADIUS * math.sin(yaw), yaw


def speeding_up(t):
    """Metres after t seconds of a start that takes .4 s to reach 1.5 m/s."""
    t = max(0, t)
    return 1.5 * (t - 0.4) + 0.3 if t > 0.4 else 0.5 * 1.5 / 0.4 * t * t


def place_ahead(i):
    """x of the i-th place ahead."""
    return 5 - i * 2.8


def park_cars(scene, random):
    """Rows to the right of the way, ahead, to the left and far left. Returns the car that will leave."""
    colours = paints(black=0.02)
    line = scene.materials.noise([(0.6, 0.6, 0.58), (0.4, 0.4, 0.38)], scale=5)
    leaving = None
    count = 0
    for i in range(6):
        y = 4 + i * 2.75
        scene.background.add(plane(4.8, 0.1), line, (6.5 + 2.2, y - 1.37, 0.004))
        if i == 2:
            continue
        x = 6.7 + 2.2 + random.uniform(-0.2, 0.2)
        yaw = math.pi / 2 + random.uniform(-0.03, 0.03) + (math.pi if i % 2 else 0)
        Car(scene, x, y, yaw, colours[count % 10], count)
        count += 1
    for i in range(8):
        x = place_ahead(i)
        scene.background.add(plane(0.1, 4.8), line, (x + 1.4, ROW_AHEAD, 0.004))
        if i == LEAVING:
            leaving = Car(scene, x, ROW_AHEAD, 0, colours[count % 10], count)
        else:
            x, y = x + random.uniform(-0.1, 0.1), ROW_AHEAD + random.uniform(-0.3, 0.3)
            yaw = (0 if i % 3 else math.pi) + random.uniform(-0.03, 0.03)
            Car(scene, x, y, yaw, colours[count % 10], count)
        count += 1
    for i in range(4):
        yaw = -math.pi / 2 + random.uniform(-0.03, 0.03)
        Car(scene, -8.5, 6 + i * 2.8, yaw, colours[(count + 3) % 10], count)
        count += 1
    for i in range(4):
        yaw = -math.pi / 2 + random.uniform(-0.04, 0.04)
        Car(scene, -26, 15 + i * 3.2, yaw, colours[(count + 5 + i) % 10], 40 + i)
    return leaving


def make_trolley(scene):
    materials = scene.materials
    basket = materials.checks([grey(0.75), grey(0.12)], scale=16)
    red, handle = materials.plain((0.5, 0.1, 0.1)), materials.plain((0.7, 0.1, 0.1))
    castor, metal = materials.plain(grey(0.05)), materials.plain(grey(0.6))
    trolley = Thing(scene, "trolley")
    trolley.add(box(0.55, 0.9, 0.5, standing=True, taper=1.15), basket, (0, 0, 0.5))
    trolley.add(box(0.5, 0.8, 0.06), red, (0, 0, 0.25))
    trolley.add(box(0.6, 0.05, 0.05), handle, (0, -0.5, 1.05))
    for side in (-1, 1):
        for end in (-1, 1):
            trolley.add(cylinder(0.07, 0.05), castor, (side * 0.22, end * 0.35, 0.07), (0, math.pi / 2, 0))
            trolley.add(box(0.03, 0.03, 0.5, standing=True), metal, (side * 0.23, end * 0.38, 0.12))
    return trolley


def add_surroundings(scene):
    """Buildings on three sides, lamp posts and trees."""
    materials, background = scene.materials, scene.background
    background.add(box(60, 6, 9), materials.bricks(BRICK, (0.5, 0.2), turn=ON_FRONT), (-5, 42, 4.5))
    for i in range(10):
        for floor, seed in ((3.2, i), (6.6, i + 20)):
            glass = materials.noise([(0.05, 0.07, 0.1), (0.2, 0.25, 0.3)], scale=1, seed=seed, gloss=(0.02, 0.5))
            background.add(box(1.6, 0.1, 1.6), glass, (-28 + i * 5, 38.97, floor))
    blocks = materials.bricks([(0.5, 0.5, 0.45), (0.35, 0.36, 0.33), (0.6, 0.6, 0.58)], (1.2, 0.6), turn=ON_SIDE)
    background.add(box(6, 50, 7), blocks, (24, 15, 3.5))
    blocks = materials.bricks([(0.3, 0.35, 0.4), (0.4, 0.42, 0.45), grey(0.2)], (2, 0.5), turn=ON_SIDE)
    background.add(box(6, 70, 5), blocks, (-45, 15, 2.5))
    lamp = materials.plain(grey(0.3))
    for x, y in ((2.5, 22), (-6, 24.5), (4.2, 24), (-14, 24.5)):
        pole(scene, x, y, 0.09, 6)
        background.add(box(0.8, 0.3, 0.15), lamp, (x, y - 0.3, 6))
    for x, y in ((-16, 12), (-20, 20), (-13, 16)):
        tree(scene, x, y, trunk_size=(0.2, 2.4), crown_radius=1.7, crown_height=3.6)
