# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Shapes that things are made of: pure geometry, metres, in the axes x right, y forward, z up."""
import math
from typing import NamedTuple


class Shape(NamedTuple):
    vertices: list  # (x, y, z)
    faces: list  # numbers of vertices, anticlockwise when seen from outside
    smooth: bool = False  # whether light runs across the edges


def box(width, length, height, standing=False, taper=1.0, taper_length=None):
    """A box about the origin, or standing on z = 0. `taper` is the share of its width, and of its length unless
    `taper_length` tells another, that is left at the top."""
    bottom, top = (0, height) if standing else (-height / 2, height / 2)
    x, y = width / 2, length / 2
    top_x, top_y = x * taper, y * (taper if taper_length is None else taper_length)
    vertices = [(-x, -y, bottom), (x, -y, bottom), (x, y, bottom), (-x, y, bottom),
                (-top_x, -top_y, top), (top_x, -top_y, top), (top_x, top_y, top), (-top_x, top_y, top)]
    faces = [(3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
    return Shape(vertices, faces)


def cylinder(radius, height, standing=False, top_radius=None, sides=20):
    """A cylinder along z about the origin, or standing on z = 0; with another radius at the top a cone."""
    bottom, top = (0, height) if standing else (-height / 2, height / 2)
    top_radius = radius if top_radius is None else top_radius
    vertices = []
    for i in range(sides):
        angle = 2 * math.pi * i / sides
        vertices.append((radius * math.cos(angle), radius * math.sin(angle), bottom))
        vertices.append((top_radius * math.cos(angle), top_radius * math.sin(angle), top))
    faces = []
    for i in range(sides):
        j = (i + 1) % sides
        faces.append((2 * i, 2 * j, 2 * j + 1, 2 * i + 1))
    faces.append(tuple(2 * i for i in reversed(range(sides))))
    faces.append(tuple(2 * i + 1 for i in range(sides)))
    return Shape(vertices, faces)


def ball(radius, stretch=1.0, sides=14):
    """A ball about the origin; its height is `stretch` times its width."""
    vertices = []
    for i in range(sides + 1):
        down = math.pi * i / sides
        for j in range(sides):
            around = 2 * math.pi * j / sides
            vertices.append((radius * math.sin(down) * math.cos(around), radius * math.sin(down) * math.sin(around),
                             radius * stretch * math.cos(down)))
    faces = []
    for i in range(sides):
        for j in range(sides):
            k = (j + 1) % sides
            faces.append((i * sides + j, (i + 1) * sides + j, (i + 1) * sides + k, i * sides + k))
    return Shape(vertices, faces, smooth=True)


def plane(width, length):
    """A rectangle in z = 0 about the origin."""
    x, y = width / 2, length / 2
    return Shape([(-x, -y, 0), (x, -y, 0), (-x, y, 0), (x, y, 0)], [(0, 1, 3, 2)])
