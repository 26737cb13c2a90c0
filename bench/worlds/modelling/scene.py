# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""A world under construction: things, the axes that their parts hang on, and the camera that sees them."""
import bpy

from modelling.camera import Camera
from modelling.materials import Materials

BACKGROUND = 0


class Scene:
    """Empties what Blender holds and starts a world: x right, y forward, z up, metres."""

    def __init__(self, recording):
        for item in list(bpy.data.objects):
            bpy.data.objects.remove(item, do_unlink=True)
        self.kinds = {}  # of each thing, by its id
        self.roots = []  # the Thing of each id, from 1 on
        self.parts = []  # (Blender's object, id of the thing) of each part of a thing
        self.materials = Materials(recording.focal_length)
        self.camera = Camera(recording.focal_length, recording.width)
        self.background = Axes(self, BACKGROUND)

    def new_id(self, thing, kind):
        self.roots.append(thing)
        self.kinds[len(self.roots)] = kind
        return len(self.roots)


class Axes:
    """Axes (x right, y forward, z up, metres) that parts hang on and move with. Themselves they hang on their parent,
    or stand in the world. `item` is Blender's object."""

    def __init__(self, scene, thing_id, parent=None, at=(0, 0, 0)):
        self.scene = scene
        self.thing_id = thing_id
        self.item = bpy.data.objects.new("axes", None)
        bpy.context.scene.collection.objects.link(self.item)
        self.item.parent = parent.item if parent else None
        self.item.location = at

    def joint(self, at=(0, 0, 0)):
        """Axes of the same thing that turn about `at` by themselves."""
        return Axes(self.scene, self.thing_id, self, at)

    def add(self, shape, material, at=(0, 0, 0), turn=(0, 0, 0), casts_shadow=True):
        """Hangs a part on these axes, turned about x, then y, then z (radians), then moved to `at`."""
        mesh = bpy.data.meshes.new("part")
        mesh.from_pydata(shape.vertices, [], shape.faces)
        mesh.update()
        mesh.materials.append(material)
        for polygon in mesh.polygons:
            polygon.use_smooth = shape.smooth
        part = bpy.data.objects.new("part", mesh)
        bpy.context.scene.collection.objects.link(part)
        part.parent = self.item
        part.location = at
        part.rotation_euler = turn
        part.visible_shadow = casts_shadow
        if self.thing_id != BACKGROUND:
            self.scene.parts.append((part, self.thing_id))
            part.pass_index = len(self.scene.parts)

    def place(self, x, y, z=0, yaw=None):
        """Moves the axes. `yaw` turns them to the left, in radians; without it they stay as they are turned."""
        self.item.location = (x, y, z)
        if yaw is not None:
            self.turn(0, 0, yaw)

    def turn(self, about_x, about_y, about_z):
        self.item.rotation_euler = (about_x, about_y, about_z)


class Thing(Axes):
    """Something that a segmentation network shows as one instance. Its axes mostly lie on the ground below it, y to its
    front."""

    def __init__(self, scene, kind, x=0, y=0, z=0, yaw=0):
        super().__init__(scene, scene.new_id(self, kind))
        self.place(x, y, z, yaw)
