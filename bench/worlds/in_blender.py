# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What Blender runs: builds a world, writes the poses of all its frames and renders some of them.

    blender -b --python-exit-code 1 -P in_blender.py -- WORLD FOLDER FIRST END THREADS

render.py starts it and reads what it writes (rendered.py)."""
import dataclasses
import importlib
import json
import os
import sys
import time

import bpy
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from modelling.renderer import Renderer  # noqa: E402
from modelling.scene import Scene  # noqa: E402


def write_poses(scene, recording, advance, folder):
    """poses.npz: to the world, (frames, n, 4, 4), of the camera (n is left out), of each part and of each thing, and
    the thing that each part belongs to. recording.json: the recording and the kinds of the things."""
    shown = {"camera": [], "parts": [], "things": []}
    for frame in range(recording.frames):
        advance(frame / recording.rate)
        bpy.context.view_layer.update()
        shown["camera"].append(np.array(scene.camera.item.matrix_world))
        shown["parts"].append([np.array(part.matrix_world) for part, _ in scene.parts])
        shown["things"].append([np.array(thing.item.matrix_world) for thing in scene.roots])
    np.savez(f"{folder}/poses.npz", thing_of_part=[thing for _, thing in scene.parts],
             **{name: np.array(poses, dtype=float) for name, poses in shown.items()})
    with open(f"{folder}/recording.json", "w", encoding="utf-8") as file:
        json.dump({"recording": dataclasses.asdict(recording), "kinds": scene.kinds}, file)


def main():
    if not (3, 3) <= bpy.app.version < (4, 0):
        sys.exit(f"Blender {bpy.app.version_string}: the worlds are made for Blender 3.4, whose names 4.0 changed")
    world_name, folder, *numbers = sys.argv[sys.argv.index("--") + 1:]
    first, end, threads = map(int, numbers)
    world = importlib.import_module(f"places.{world_name}")
    scene = Scene(world.RECORDING)
    advance = world.build(scene)
    write_poses(scene, world.RECORDING, advance, folder)
    renderer = Renderer(world.RECORDING, folder, threads)
    for frame in range(first, min(end, world.RECORDING.frames)):
        begin = time.monotonic()
        advance(frame / world.RECORDING.rate)
        bpy.context.view_layer.update()
        renderer.render(frame)
        print(f"rendered frame {frame} in {time.monotonic() - begin:.1f} s", flush=True)


main()
