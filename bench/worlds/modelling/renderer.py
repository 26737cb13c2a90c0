# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Renders frames with Blender's Cycles: an image, and for each pixel the depth and the part that it shows."""
import bpy

SAMPLES = 4  # a pixel of the image: the light needs few, since none is reflected twice


class Renderer:
    """Writes image0000.png, depth0000.exr (metres along the optical axis) and part0000.exr (number of the part, from 1
    on, 0 = background) into a folder."""

    def __init__(self, recording, folder, threads):
        self._scene = bpy.context.scene
        self._folder = folder
        self._set_up(recording, threads)
        self._add_truth_output()

    def render(self, frame):
        self._scene.frame_current = frame  # part of the file names
        self._scene.cycles.seed = frame
        self._render_image(frame)
        self._render_truth()

    def _set_up(self, recording, threads):
        render, cycles = self._scene.render, self._scene.cycles
        render.engine = "CYCLES"
        render.resolution_x, render.resolution_y = recording.width, recording.height
        render.resolution_percentage = 100
        render.use_persistent_data = True
        render.threads_mode = "FIXED"
        render.threads = threads
        render.image_settings.file_format = "PNG"
        render.image_settings.color_mode = "RGB"
        cycles.device = "CPU"
        cycles.use_denoising = False
        cycles.use_adaptive_sampling = False
        cycles.max_bounces = 1
        cycles.diffuse_bounces = 0
        cycles.glossy_bounces = 1
        cycles.transmission_bounces = 0
        cycles.transparent_max_bounces = 4
        cycles.caustics_reflective = False
        cycles.sample_clamp_indirect = 3
        self._scene.view_settings.view_transform = "Standard"

    def _add_truth_output(self):
        """What writes depth and parts, when the scene's nodes are in use."""
        layer = bpy.context.view_layer
        layer.use_pass_z = True
        layer.use_pass_object_index = True
        self._scene.use_nodes = True
        tree = self._scene.node_tree
        tree.nodes.clear()
        layers = tree.nodes.new("CompositorNodeRLayers")
        output = tree.nodes.new("CompositorNodeOutputFile")
        output.base_path = self._folder
        output.format.file_format = "OPEN_EXR"
        output.format.color_depth = "32"
        output.format.color_mode = "RGB"
        output.file_slots.clear()
        for name, source in (("depth", "Depth"), ("part", "IndexOB")):
            output.file_slots.new(name)
            tree.links.new(layers.outputs[source], output.inputs[name])

    def _render_image(self, frame):
        """With a soft pixel filter, as a lens has."""
        self._scene.use_nodes = False
        self._scene.cycles.samples = SAMPLES
        self._scene.cycles.pixel_filter_type = "GAUSSIAN"
        self._scene.cycles.filter_width = 1.3
        self._scene.render.filepath = f"{self._folder}/image{frame:04d}.png"
        bpy.ops.render.render(write_still=True)

    def _render_truth(self):
        """At the pixels' centres."""
        self._scene.use_nodes = True
        self._scene.cycles.samples = 1
        self._scene.cycles.pixel_filter_type = "BOX"
        self._scene.cycles.filter_width = 0.01
        bpy.ops.render.render(write_still=False)
