#!/usr/bin/env python3
"""The book and other bodies beside a path tracer: drawn by rotatebook and by Blender's Cycles, from the same mesh,
pictures, camera and studio, and how far they are apart.

    bench/beside/beside_cycles.py PROGRAM FOLDER

Writes FOLDER/book.png, FOLDER/checks.png and FOLDER/bodies.png, a row for each view: rotatebook's, Cycles', and their
difference on grey; prints a table. The grain of metal and wood lies elsewhere in Cycles' pictures, which are those of
what is exported. Needs blender, python3-numpy, python3-skimage; some 25 minutes on two cores.
"""
import argparse
import os
import shutil
import subprocess
import sys

import numpy as np
from skimage import color, filters, io

HERE = os.path.dirname(os.path.abspath(__file__))
# Rotations about x, y and z in turn. [rad] The last four show the covers from beneath and edges at grazing light.
VIEWS = [(-0.5, 0.55, 0.12), (0.9, -0.7, 0.3), (-0.35, -1.15, 0.2), (1.25, 0.15, -0.4),
         (-1.2, 0.3, 0.1), (0.4, 1.45, 0.0), (-1.45, 2.6, 0.2), (0.2, 3.4, 1.5)]
# Others, for a check.
CHECKS = [(0.75, 0.5, -0.2), (-0.8, -0.6, 0.5), (1.1, -1.0, 0.1), (-0.6, 1.9, -0.3)]
BODIES_FOLDER = os.path.join(HERE, "../../scenes/bodies")
# The body and its rotations. [rad]
BODIES = {
    "t-handle": ('shape = "t-handle"', (0.6, 0.5, 0.2)), "wing-nut": ('shape = "wing-nut"', (-0.9, 0.2, 0.3)),
    "knot": ('mesh = "knot.ply"\ndensity = 1200', (0.3, 0.4, 0.0)),
    "racket": ('shape = "racket"', (-0.6, 0.3, 0.4)), "cards": ('shape = "cards"', (-0.8, 0.4, 0.2)),
    "phone": ('shape = "phone"', (-0.5, 0.5, 0.2)), "weighted-disc": ('shape = "weighted-disc"', (-0.9, 0.3, 0.2)),
    "toutatis": ('shape = "toutatis"', (0.3, 0.4, 0.2)),
    "mallet": ("", (-0.4, 0.6, 0.3)),
}
SCENE = """title = "Beside a path tracer"
{}
[simulation]
model = "exact"
[initial]
angular_velocity = [0, 0, 1]
attitude = [{}]
{}
[look]
background = "transparent"
[clip]
duration = 1
size = [{}, {}]
"""
BLUR = 1.0  # Standard deviation of what an eye blurs, at a picture's usual distance. [pixels of 640x360]


def quaternion(x, y, z):
    """Returns [w, x, y, z] of rotations about the world's x, then y, then z axis."""
    def times(a, b):
        return np.array([a[0] * b[0] - a[1:] @ b[1:], *(a[0] * b[1:] + b[0] * a[1:] + np.cross(a[1:], b[1:]))])
    turns = [np.array([np.cos(angle / 2), *(np.sin(angle / 2) * axis)])
             for angle, axis in zip((x, y, z), np.eye(3))]
    return times(turns[2], times(turns[1], turns[0]))


def tone_mapped(radiance):
    """Returns the sRGB value of linear light, as shaders/tone_curve.frag has it: Khronos' PBR neutral curve."""
    start, desaturation = 0.8 - 0.04, 0.15
    least = radiance.min(-1, keepdims=True)
    radiance = radiance - np.where(least < 0.08, least - 6.25 * least ** 2, 0.04)
    peak = radiance.max(-1, keepdims=True)
    room = 1 - start
    new_peak = 1 - room ** 2 / (peak + room - start)
    grey = 1 - 1 / (desaturation * (peak - new_peak) + 1)
    bright = radiance * new_peak / np.maximum(peak, 1e-9) * (1 - grey) + new_peak * grey
    light = np.clip(np.where(peak < start, radiance, bright), 0, 1)
    return np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)


def drawn(program, folder, name):
    """Draws the view by rotatebook, and exports it; returns the picture."""
    picture = os.path.join(folder, name + ".png")
    exported = os.path.join(folder, name + ".glb")
    for words in (["still", "--time", "0", "-o", picture], ["export", "-o", exported]):
        if os.path.exists(words[-1]):
            os.remove(words[-1])
        subprocess.run([program, "-q", words[0], os.path.join(folder, name + ".toml"), *words[1:]], check=True)
    return io.imread(picture) / 255


def trace(folder, name, size, samples):
    """Path traces the exported view into NAME.npy."""
    output = os.path.join(folder, name + ".npy")
    with open(os.path.join(folder, name + ".log"), "w", encoding="utf8") as log:
        subprocess.run(["blender", "--background", "--python-exit-code", "1", "--python",
                        os.path.join(HERE, "cycles_view.py"), "--", os.path.join(folder, name + ".glb"), output,
                        *map(str, size), str(samples)], check=True, stdout=log, stderr=log)


def traced(folder, name):
    """Returns what trace() wrote as a picture: sRGB and alpha."""
    pixels = np.load(os.path.join(folder, name + ".npy")).astype(float)
    alpha = pixels[..., 3:]
    return np.concatenate([tone_mapped(pixels[..., :3] / np.maximum(alpha, 1e-6)), alpha], -1)


def differences(ours, theirs, blur):
    """Returns, where both have the body: the mean difference in 8 bits, with its sign, too, and what is seen of it."""
    body = (ours[..., 3] > 0.999) & (theirs[..., 3] > 0.999)
    blurred = [color.rgb2lab(filters.gaussian(picture[..., :3] * body[..., None], blur, channel_axis=-1)
                             / np.maximum(filters.gaussian(body.astype(float), blur), 1e-6)[..., None])
               for picture in (ours, theirs)]
    seen = color.deltaE_ciede2000(*blurred)[body]
    apart = 255 * (ours - theirs)[..., :3][body]
    return np.abs(apart).mean(), apart.mean(), seen.mean(), np.percentile(seen, 95)


def over_grey(picture):
    return picture[..., :3] * picture[..., 3:] + 0.16 * (1 - picture[..., 3:])


def scenes(size):
    """Returns the text of each view's scene, by the name of its picture and of the view."""
    def scene(body, view, camera):
        return SCENE.format(body, ", ".join(map(repr, map(float, quaternion(*view)))), camera, *size)
    with open(os.path.join(BODIES_FOLDER, "mallet.toml"), encoding="utf8") as file:
        text = file.read()
    mallet = text[text.index("[[body.part]]"):text.index("[simulation]")]
    def books(name, views):
        return {f"{name}-{i}": scene("", view, "[camera]\nposition = [0, 0, 0.76]") for i, view in enumerate(views)}
    return {
        "book": books("view", VIEWS), "checks": books("check", CHECKS),
        "bodies": {name: scene(f"[body]\n{body}" if body else mallet, view, "")
                   for name, (body, view) in BODIES.items()},
    }


def compare(name, scene, arguments):
    """Draws a view by both; returns their differences, and the row of the picture."""
    folder = arguments.folder
    with open(os.path.join(folder, name + ".toml"), "w", encoding="utf8") as file:
        file.write(scene)
    ours = drawn(os.path.abspath(arguments.program), folder, name)
    if not (arguments.keep and os.path.exists(os.path.join(folder, name + ".npy"))):
        trace(folder, name, arguments.size, arguments.samples)
    theirs = traced(folder, name)
    row = [over_grey(ours), over_grey(theirs)]
    return (differences(ours, theirs, BLUR * arguments.size[0] / 640),
            np.concatenate([*row, np.clip(0.5 + row[0] - row[1], 0, 1)], 1))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder")
    parser.add_argument("--size", nargs=2, type=int, default=[640, 360], metavar=("WIDTH", "HEIGHT"))
    parser.add_argument("--samples", type=int, default=256)
    parser.add_argument("--keep", action="store_true", help="take Cycles' pictures that are in the folder")
    arguments = parser.parse_args()
    os.makedirs(arguments.folder, exist_ok=True)
    shutil.copy(os.path.join(BODIES_FOLDER, "knot.ply"), arguments.folder)
    print("view            mean difference   brighter by   seen (CIEDE2000): mean   95 %")
    for picture, views in scenes(arguments.size).items():
        results, rows = [], []
        for name, scene in views.items():
            result, row = compare(name, scene, arguments)
            print("{:13s} {:17.1f} {:13.1f} {:24.1f} {:6.1f}".format(name, *result), flush=True)
            results.append(result)
            rows.append(row)
        print("{:13s} {:17.1f} {:13.1f} {:24.1f} {:6.1f}\n".format("mean", *np.mean(results, 0)))
        io.imsave(os.path.join(arguments.folder, picture + ".png"),
                  (255 * np.concatenate(rows) + 0.5).astype(np.uint8))


if __name__ == "__main__":
    sys.exit(main())
