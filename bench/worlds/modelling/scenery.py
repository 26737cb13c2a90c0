# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What several worlds have in their background."""
from modelling.materials import ON_FRONT, grey, random_colours
from modelling.shapes import ball, box, cylinder

BRICK = [(0.45, 0.2, 0.14), (0.5, 0.27, 0.18), (0.6, 0.58, 0.55)]
PAVING = [(0.3, 0.29, 0.27), (0.38, 0.36, 0.33), (0.2, 0.2, 0.2)]
GRASS = [(0.07, 0.10, 0.03), (0.14, 0.18, 0.06), (0.22, 0.22, 0.1)]


def trunk(scene, x, y, radius, height):
    bark = scene.materials.noise([(0.12, 0.08, 0.05), (0.25, 0.17, 0.1)], scale=6)
    scene.background.add(cylinder(radius, height, standing=True), bark, (x, y, 0))


def tree(scene, x, y, trunk_size, crown_radius, crown_height, seed=0):
    """A trunk of (radius, height), and a round crown with its middle at `crown_height`."""
    trunk(scene, x, y, *trunk_size)
    leaves = scene.materials.noise([(0.03, 0.08, 0.02), (0.12, 0.25, 0.06), (0.25, 0.4, 0.1)], scale=4, contrast=0.4,
                                   seed=seed)
    scene.background.add(ball(crown_radius, stretch=1.1), leaves, (x, y, crown_height))


def pole(scene, x, y, radius, height):
    metal = scene.materials.noise([grey(0.3), grey(0.45)], scale=4)
    scene.background.add(cylinder(radius, height, standing=True), metal, (x, y, 0))


def house(scene, random, x, y, ground, heights, row, seed, yaw=0, facing=ON_FRONT):
    """A house of bricks of two random colours, on a ground of (width, length), of a height between two; `row` is the
    height of a row of bricks, and `facing` the side where they look right."""
    height = random.uniform(*heights)
    colours = random_colours(random, 2, 0.2, 0.5) + [(0.55, 0.55, 0.5)]
    bricks = scene.materials.bricks(colours, (random.choice([0.6, 1.2]), row), seed=seed, turn=facing)
    scene.background.add(box(*ground, height, standing=True), bricks, (x, y, 0), (0, 0, yaw))
