# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""A street and a car park from a drone 15 m above, which looks down steeply and turns as it flies: 16 parked cars and
five that drive, people who walk and stand."""
import math
from random import Random

from modelling import lights
from modelling.car import Car, paints
from modelling.materials import grey
from modelling.person import Person
from modelling.scenery import GRASS, tree
from modelling.shapes import box, plane
from recording import Recording

RECORDING = Recording(frames=44, sensor="stereo", focal_length=400, baseline=0.4, seed=536)

DRIVING = ((2.1, 6, 8), (2.2, 30, 7), (-2.2, 48, -8), (-2.1, 66, -8.5), (2.1, -6, 9))  # x, y, speed along y
PEOPLE = ((6.1, 20, 0, 1.3), (5.8, 36, 0, -1.3), (-6.1, 30, 0, 1.2), (-5.9, 44, 0, 0), (6.3, 45, 0, 0),
          (13, 33, 1.2, 0.1), (9.5, 26, 0, 0))  # x, y, speeds along x and y


def build(scene):
    random = Random(1)
    lights.sky()
    lights.sun((-0.5, -0.3, 0.9), 3.0)
    add_ground(scene)
    driving, people = add_traffic(scene, random)
    add_surroundings(scene, random)

    def advance(t):
        scene.camera.place((1.5 + 0.6 * math.sin(0.7 * t), 6 * t - 2, 15 + 0.25 * math.sin(1.3 * t)),
                           -0.30 + 0.16 * t + 0.01 * math.sin(6 * t), -math.pi / 4 + 0.012 * math.sin(4 * t),
                           0.02 * math.sin(2.1 * t))
        for car, (x, y, speed) in zip(driving, DRIVING):
            car.place(x, y + speed * t)
            car.roll(abs(speed) * t)
        for i, (person, (x, y, speed_x, speed_y)) in enumerate(zip(people, PEOPLE)):
            person.place(x + speed_x * t, y + speed_y * t)
            if speed_x or speed_y:
                person.walk(5 * t + i)

    return advance


def add_ground(scene):
    materials, background = scene.materials, scene.background
    grass = materials.noise(GRASS + [(0.28, 0.24, 0.14)], scale=0.5, detail=10)
    background.add(plane(300, 300), grass, (0, 30, -0.02))
    road = materials.noise([grey(0.07), grey(0.12), (0.17, 0.17, 0.165)], scale=0.9, detail=10)
    background.add(plane(9, 260), road, (0, 40, 0))
    for x, seed in ((6, 0), (-6, 3)):
        slabs = materials.bricks([(0.3, 0.29, 0.27), (0.36, 0.35, 0.33), grey(0.2)], (1, 1), mortar=0.03, seed=seed)
        background.add(plane(2.2, 260), slabs, (x, 40, 0.03))
    white = materials.noise([(0.75, 0.75, 0.73), (0.55, 0.55, 0.53)], scale=4)
    for i in range(40):
        background.add(plane(0.14, 2.4), white, (0, -10 + i * 4, 0.006))
    for side in (-1, 1):
        background.add(plane(0.12, 260), white, (side * 4.3, 40, 0.006))
    car_park = materials.noise([grey(0.1), grey(0.16), grey(0.2)], scale=0.8, detail=9)
    background.add(plane(30, 22), car_park, (24, 34, 0))


def add_traffic(scene, random):
    """Returns the cars of DRIVING and the people of PEOPLE."""
    colours = paints(black=0.03)
    count = 0
    for cars, x, step, y, shift in ((7, 14, 2.9, 38, 0), (5, 15, 3.1, 28, 4)):
        for i in range(cars):
            at = x + i * step, y + random.uniform(-0.2, 0.2)
            Car(scene, *at, random.choice([0, math.pi]), colours[(count + shift) % 10], count)
            count += 1
    for i in range(4):
        at = -8.6, 16 + i * 9 + random.uniform(-1, 1)
        Car(scene, *at, random.choice([0, math.pi]), colours[(count + 2) % 10], count)
        count += 1
    driving = []
    for x, y, speed in DRIVING:
        driving.append(Car(scene, x, y, 0 if speed > 0 else math.pi, colours[count % 10], count))
        count += 1
    people = []
    for i, (x, y, speed_x, speed_y) in enumerate(PEOPLE):
        yaw = math.atan2(-speed_x, speed_y) if speed_x or speed_y else 1.0
        people.append(Person(scene, x, y, yaw, seed=30 + i))
    return driving, people


def add_surroundings(scene, random):
    """Trees and houses along the street."""
    for i in range(14):
        x, y = random.choice([-1, 1]) * random.uniform(9.5, 11.5), 6 + i * 6 + random.uniform(-1, 1)
        tree(scene, x, y, trunk_size=(0.18, 2), crown_radius=random.uniform(1.2, 2), crown_height=3.2, seed=i)
    for i in range(6):
        height = random.uniform(4, 8)
        bricks = scene.materials.bricks([(0.4, 0.2, 0.14), (0.5, 0.3, 0.2), grey(0.3)], (0.8, 0.4), mortar=0.03, seed=i)
        scene.background.add(box(9, 11, height, standing=True), bricks, (-18 + random.uniform(-1, 1), 10 + i * 14, 0))
    for i in range(4):
        height = random.uniform(3, 6)
        blocks = scene.materials.bricks([(0.4, 0.38, 0.35), (0.5, 0.48, 0.4), grey(0.3)], (1.2, 0.6), mortar=0.04,
                                        seed=i)
        scene.background.add(box(12, 10, height, standing=True), blocks, (22, 55 + i * 13, 0))
