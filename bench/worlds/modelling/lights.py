# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Lights. Surfaces also have some light by themselves, see materials.py."""
import bpy
from mathutils import Vector


def sun(towards, strength, angle=0.009):
    """A sun in the direction `towards` that seems `angle` radians wide: 0.009 outdoors, more for the soft shadows of a
    hall. Returns Blender's light, whose `energy` is the strength."""
    light = bpy.data.lights.new("sun", "SUN")
    light.energy = strength
    light.angle = angle
    light.color = (1, 0.96, 0.88)
    item = bpy.data.objects.new("sun", light)
    bpy.context.scene.collection.objects.link(item)
    item.rotation_euler = Vector(towards).to_track_quat("Z", "Y").to_euler()
    return light


def sky(clear=(0.35, 0.5, 0.8), cloud=(0.8, 0.82, 0.85)):
    """What is behind everything: clouds of one colour before another. It sheds no light."""
    world = bpy.data.worlds.new("sky")
    bpy.context.scene.world = world
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    noise = nodes.new("ShaderNodeTexNoise")
    noise.inputs["Scale"].default_value = 3
    noise.inputs["Detail"].default_value = 6
    ramp = nodes.new("ShaderNodeValToRGB")
    for element, position, colour in zip(ramp.color_ramp.elements, (0.4, 0.65), (clear, cloud)):
        element.position = position
        element.color = (*colour, 1)
    links.new(nodes.new("ShaderNodeTexCoord").outputs["Generated"], noise.inputs["Vector"])
    links.new(noise.outputs["Fac"], ramp.inputs["Fac"])
    links.new(ramp.outputs["Color"], nodes["Background"].inputs["Color"])
    world.cycles_visibility.diffuse = False
    world.cycles.sampling_method = "NONE"
