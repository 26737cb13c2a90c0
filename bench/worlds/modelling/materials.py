# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Materials with texture at all scales, as real surfaces have: without it direct alignment has nothing to hold on to.

Textures are fixed to the part that has them, in metres. Their finest detail is as fine as a pixel where they are seen,
so that a few samples a pixel do not flicker. Colours are (red, green, blue), linear, 0 to 1."""
import math

import bpy

# Turns a pattern, which lies in x and y, so that its rows are level on walls that face along y, or along x.
ON_FRONT = (math.pi / 2, 0, 0)
ON_SIDE = (math.pi / 2, 0, math.pi / 2)


def grey(value):
    return (value, value, value)


def lighter(colour, factor, offset):
    return tuple(min(1, channel * factor + offset) for channel in colour)


def darker(colour, factor):
    return tuple(channel * factor for channel in colour)


def random_colours(random, count, low, high):
    return [tuple(random.uniform(low, high) for _ in range(3)) for _ in range(count)]


class Materials:
    """Makes Blender's materials. Arguments that most have in common:

    colours   from dark to light parts of the pattern, two or more
    scale     repetitions a metre
    contrast  share of the pattern's values over which the colours run: the less, the harder their edges
    seed      another one is another part of the same pattern
    """

    def __init__(self, focal_length):
        """The focal length in pixels tells how fine a texture may be."""
        self.focal_length = focal_length
        self._ambient = 0.3, 0.14
        self._ambient_nodes = []

    def set_ambient(self, base, upwards):
        """The light that every surface has by itself: its strength, and how much more it is on those that face up."""
        self._ambient = base, upwards
        for node in self._ambient_nodes:
            node.inputs[1].default_value = upwards
            node.inputs[2].default_value = base

    def plain(self, colour):
        """One colour."""
        builder = _Builder(self.focal_length)
        return self._finished(builder, _opaque(colour))

    def noise(self, colours, scale=3.0, detail=8, contrast=0.5, seed=0, gloss=None):
        """Clouds, with `detail` finer ones, each half as large as the one before. `gloss` is (roughness, share of
        mirrored light)."""
        builder = _Builder(self.focal_length, seed)
        clouds = builder.clouds(scale, detail, Roughness=0.72)
        return self._finished(builder, builder.ramp(clouds, colours, contrast), gloss)

    def cells(self, colours, scale=3.0, seed=0):
        """Cells of single colours, as crushed stone or a printed carton has."""
        builder = _Builder(self.focal_length, seed)
        cells = builder.textured("ShaderNodeTexVoronoi", Scale=scale)
        split = builder.node("ShaderNodeSeparateColor", Color=cells.outputs["Color"])
        return self._finished(builder, builder.grained(builder.ramp(split.outputs[0], colours), scale))

    def checks(self, colours, scale=3.0, seed=0):
        """Squares of the first and the last colour."""
        builder = _Builder(self.focal_length, seed)
        squares = builder.textured("ShaderNodeTexChecker", Scale=scale, Color1=_opaque(colours[0]),
                                   Color2=_opaque(colours[-1]))
        return self._finished(builder, builder.grained(squares.outputs["Color"], scale))

    def waves(self, colours, scale=3.0, distortion=8, seed=0, stretch=(1, 1, 1)):
        """Bands, as of wood or cloth; `stretch` makes them that much finer along x, y, z."""
        builder = _Builder(self.focal_length, seed, stretch=stretch)
        waves = builder.textured("ShaderNodeTexWave", Scale=scale, Distortion=distortion)
        return self._finished(builder, builder.grained(builder.ramp(waves.outputs["Color"], colours), scale))

    def bricks(self, colours, size, mortar=0.012, seed=0, turn=(0, 0, 0)):
        """Bricks of two colours, the third one is the mortar's. Their size is (width, height) in metres."""
        builder = _Builder(self.focal_length, seed, turn)
        bricks = builder.textured("ShaderNodeTexBrick", **{
            "Scale": 1.0, "Brick Width": size[0], "Row Height": size[1], "Mortar Size": mortar,
            "Color1": _opaque(colours[0]), "Color2": _opaque(colours[1]), "Mortar": _opaque(colours[2])})
        return self._finished(builder, builder.grained(bricks.outputs["Color"], 1.0))

    def _finished(self, builder, colour, gloss=None):
        """The surface: it reflects the sun, and has the ambient light by itself."""
        if gloss:
            surface = builder.node("ShaderNodeBsdfPrincipled", Roughness=gloss[0], Specular=gloss[1],
                                   **{"Base Color": colour})
        else:
            surface = builder.node("ShaderNodeBsdfDiffuse", Color=colour)
        facing = builder.node("ShaderNodeVectorMath", operation="DOT_PRODUCT")
        facing.inputs[1].default_value = (0.25, -0.15, 1)
        builder.links.new(builder.node("ShaderNodeNewGeometry").outputs["Normal"], facing.inputs[0])
        base, upwards = self._ambient
        ambient = builder.maths("MULTIPLY_ADD", facing.outputs["Value"], upwards, base)
        self._ambient_nodes.append(ambient)
        glow = builder.node("ShaderNodeEmission", Color=colour, Strength=ambient.outputs[0])
        both = builder.node("ShaderNodeAddShader")
        builder.links.new(surface.outputs[0], both.inputs[0])
        builder.links.new(glow.outputs[0], both.inputs[1])
        builder.node("ShaderNodeOutputMaterial", Surface=both.outputs[0])
        builder.material.cycles.sample_as_light = False
        return builder.material


def move_texture(material, offset):
    """Shifts the texture of a material, in metres, as the waves of water."""
    mapping = next(node for node in material.node_tree.nodes if node.type == "MAPPING")
    mapping.inputs["Location"].default_value = offset


def _opaque(colour):
    return (*colour, 1)


class _Builder:
    """Blender's network of nodes of one material."""

    def __init__(self, focal_length, seed=0, turn=(0, 0, 0), stretch=(1, 1, 1)):
        self.focal_length = focal_length
        self.material = bpy.data.materials.new("material")
        self.material.use_nodes = True
        self.nodes, self.links = self.material.node_tree.nodes, self.material.node_tree.links
        self.nodes.clear()
        self.place = self.node("ShaderNodeMapping", Location=(seed * 3.17, seed * 1.73, seed * 0.71), Rotation=turn,
                               Scale=stretch, Vector=self.node("ShaderNodeTexCoord").outputs["Object"])

    def node(self, kind, operation=None, **inputs):
        """A node; an input is a value, or the output of another node."""
        node = self.nodes.new(kind)
        if operation:
            node.operation = operation
        for name, value in inputs.items():
            if isinstance(value, bpy.types.NodeSocket):
                self.links.new(value, node.inputs[name])
            else:
                node.inputs[name].default_value = value
        return node

    def textured(self, kind, **inputs):
        """A texture's node at the surface's point."""
        return self.node(kind, Vector=self.place.outputs["Vector"], **inputs)

    def maths(self, operation, *operands):
        node = self.node("ShaderNodeMath", operation)
        for socket, value in zip(node.inputs, operands):
            if isinstance(value, bpy.types.NodeSocket):
                self.links.new(value, socket)
            else:
                socket.default_value = value
        return node

    def clouds(self, scale, detail, **inputs):
        """Noise of at most `detail` octaves below `scale`: fewer where the finest would be smaller than some pixels."""
        depth = self.node("ShaderNodeCameraData").outputs["View Z Depth"]
        pixels = self.maths("DIVIDE", self.focal_length / scale / 1.6, depth)
        octaves = self.maths("LOGARITHM", pixels.outputs[0], 2)
        limited = self.node("ShaderNodeClamp", Min=0, Max=detail, Value=octaves.outputs[0])
        return self.textured("ShaderNodeTexNoise", Scale=scale, Detail=limited.outputs[0], **inputs).outputs["Fac"]

    def ramp(self, value, colours, contrast=0.5):
        """The colours over the middle of the values."""
        node = self.node("ShaderNodeValToRGB", Fac=value)
        elements = node.color_ramp.elements
        while len(elements) < len(colours):
            elements.new(0.5)
        for i, colour in enumerate(colours):
            elements[i].position = 0.5 + contrast * (i / (len(colours) - 1) - 0.5)
            elements[i].color = _opaque(colour)
        return node.outputs["Color"]

    def grained(self, colour, scale):
        """The same colour with finer noise laid over it."""
        fine = self.clouds(max(scale * 3, 8), 6)
        mix = self.node("ShaderNodeMixRGB", Fac=0.55, Color1=colour, Color2=fine)
        mix.blend_type = "OVERLAY"
        return mix.outputs["Color"]
