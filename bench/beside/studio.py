"""The studio that shaders/studio_shine.glsl describes: its radiance, and what matt surfaces scatter of it.

Prints the constants of shaders/studio_scatter.glsl. Run by a path tracer's Python, too.
"""
import os
import re

import numpy as np

SHADERS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../shaders")
TERMS = ["kEven", "kX", "kY", "kZ", "kXy", "kYz", "kZx", "kXxYy", "kZz", "kFourth"]


def read(name):
    with open(os.path.join(SHADERS, name), encoding="utf8") as file:
        return file.read()


def constant(text, name):
    """Returns the vector that the shader's text calls `name`."""
    return np.array([float(part) for part in re.search(rf"{name} = vec\d\(([^)]*)\)", text)[1].split(",")])


def smoothstep(low, high, x):
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def radiance(direction):
    """Returns the radiance, n x 3, from n directions, as a perfect mirror shows it; +y is up, +z to the camera."""
    text = read("studio_scatter.glsl") + read("studio_shine.glsl")
    height = smoothstep(-0.5, 0.7, direction[:, 1])[:, None]
    light = constant(text, "kBelow") * (1 - height) + constant(text, "kAbove") * height
    light = light + constant(text, "kWall") * smoothstep(0.1, 1, direction[:, 2])[:, None]
    for name in ("Key", "Fill", "Rim"):
        toward, half = constant(text, f"k{name}Direction"), constant(text, f"k{name}Size")
        side = np.array([toward[2], 0, -toward[0]])
        side /= np.linalg.norm(side)
        ahead, across = direction @ toward, direction @ side
        up = direction @ np.cross(toward, side)
        inside = (ahead > 0) & (np.abs(across) < half[0] * ahead) & (np.abs(up) < half[1] * ahead)
        light = light + inside[:, None] * constant(text, f"k{name}Radiance")
    return light


def even_directions(count):
    """Returns `count` x 3 directions, evenly spread (a spherical Fibonacci lattice)."""
    i = np.arange(count) + 0.5
    z, longitude = 1 - 2 * i / count, np.pi * (1 + 5 ** 0.5) * i
    across = np.sqrt(1 - z * z)
    return np.stack([across * np.cos(longitude), across * np.sin(longitude), z], -1)


def terms(normal):
    """Returns TERMS, n x 10, of n normals: the polynomials of second order on the sphere, and one of fourth order."""
    x, y, z = normal.T
    key = (normal @ constant(read("studio_scatter.glsl"), "kKeyDirection")) ** 2
    fourth = (4.375 * key - 3.75) * key + 0.375
    return np.stack([np.ones_like(x), x, y, z, x * y, y * z, z * x, x * x - y * y, 3 * z * z - 1, fourth], -1)


def scattered(normal, directions):
    """Returns the irradiance / pi, n x 3, of n normals, from light of so many directions."""
    direction = even_directions(directions)
    light = radiance(direction)
    return np.array([4 * (np.maximum(direction @ toward, 0)[:, None] * light).mean(0) for toward in normal])


def fitted(directions=400000, normals=2000):
    """Returns the constants, 10 x 3, whose polynomial is nearest to the scattered light, and how far off it is."""
    normal = even_directions(normals)
    light = scattered(normal, directions)
    constants = np.linalg.lstsq(terms(normal), light, rcond=None)[0]
    return constants, np.sqrt(((terms(normal) @ constants - light) ** 2).mean())


if __name__ == "__main__":
    found, apart = fitted()
    print(f"// Off by {apart:.3f} in the mean.")
    for term, row in zip(TERMS, found):
        print(f"const vec3 {term} = vec3({', '.join(f'{part:.4f}' for part in row)});")
