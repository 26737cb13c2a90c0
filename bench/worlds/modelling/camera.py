# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""The camera: where it is and where it looks."""
import math

import bpy
from mathutils import Matrix, Vector

SENSOR_WIDTH = 36  # mm; only its ratio to the focal length matters


class Camera:
    def __init__(self, focal_length, width):
        """Focal length and width of the image in pixels."""
        lens = bpy.data.cameras.new("camera")
        lens.clip_start, lens.clip_end = 0.02, 2000
        lens.sensor_fit = "HORIZONTAL"
        lens.sensor_width = SENSOR_WIDTH
        lens.lens = focal_length * SENSOR_WIDTH / width
        self.item = bpy.data.objects.new("camera", lens)
        bpy.context.scene.collection.objects.link(self.item)
        bpy.context.scene.camera = self.item

    def place(self, position, yaw, pitch, roll=0):
        """At a position, metres. Radians: yaw from +y to the left, pitch upwards, roll about the optical axis."""
        self.item.matrix_world = (Matrix.Translation(position) @ Matrix.Rotation(yaw, 4, "Z")
                                  @ Matrix.Rotation(math.pi / 2 + pitch, 4, "X") @ Matrix.Rotation(roll, 4, "Z"))

    def look(self, position, target, roll=0):
        """From a position at a point."""
        towards = (Vector(target) - Vector(position)).to_track_quat("-Z", "Y")
        self.item.matrix_world = (Matrix.Translation(position) @ towards.to_matrix().to_4x4()
                                  @ Matrix.Rotation(roll, 4, "Z"))
