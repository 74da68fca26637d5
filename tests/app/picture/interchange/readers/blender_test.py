"""What `rotatebook export` wrote, as Blender plays it, beside the motion's table:

    blender --background --factory-startup --python-exit-code 1 --python blender_test.py -- CASES

CASES is the folder of cases.json that `run` leaves.
"""

import csv
import json
import math
import pathlib
import sys

import bpy
import numpy
from mathutils import Vector

numpy.bool = bool  # Debian 12's importer asks for it, and its NumPy has it no more.

CLOSE = math.radians(0.05)  # As seen from the centre of the body.
EACH = 150  # Of so many vertices one is looked at.


def in_gltf(at):
    """Blender's z is up, and glTF's y."""
    return Vector((at.x, at.z, -at.y))


def at_rest(mesh, vertex):
    """All shapes at half their weight."""
    base = mesh.vertices[vertex].co
    shapes = mesh.shape_keys.key_blocks[1:] if mesh.shape_keys else []
    return sum(((shape.data[vertex].co - base) / 2 for shape in shapes), base.copy())


def table_of(path, rate, last):
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            time = int(row["frame"]) / rate
            if time <= last:
                yield time, [Vector(float(row[f"c{i}{axis}"]) for axis in "xyz") for i in range(8)]


def placed(rest, size, corners):
    at = Vector((0, 0, 0))
    for i, corner in enumerate(corners):
        weight = 1.0
        for axis in range(3):
            u = rest[axis] / size[axis] + 0.5
            weight *= u if i >> axis & 1 else 1 - u
        at += weight * corner
    return at


def compare(case, folder):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=str(folder / case["glb"]))
    scene = bpy.context.scene
    mesh = next(item for item in scene.objects if item.type == "MESH" and item.name.startswith(("body", "book")))
    rate = scene.render.fps / scene.render.fps_base
    last = max(action.frame_range[1] for action in bpy.data.actions) / rate
    places = range(0, len(mesh.data.vertices), EACH)
    rest = [in_gltf(at_rest(mesh.data, i)) for i in places]
    largest, frames, size = 0.0, 0, None
    for time, corners in table_of(folder / case["csv"], case["rate"], last):
        size = size or corners[7] - corners[0]
        frame = math.floor(time * rate)
        scene.frame_set(frame, subframe=time * rate - frame)
        shown = mesh.evaluated_get(bpy.context.evaluated_depsgraph_get())
        for i, still in zip(places, rest):
            at = in_gltf(shown.matrix_world @ shown.data.vertices[i].co)
            largest = max(largest, (at - placed(still, size, corners)).length)
        frames += 1
    degrees = math.degrees(largest / (size.length / 2))
    print(f"{case['name']}: {frames} frames, {degrees:.4f} degrees", flush=True)
    return frames >= 1000 and degrees < math.degrees(CLOSE)


folder = pathlib.Path(sys.argv[sys.argv.index("--") + 1])
results = [compare(case, folder) for case in json.loads((folder / "cases.json").read_text())]
sys.exit(0 if all(results) else 1)
