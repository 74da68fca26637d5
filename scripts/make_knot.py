#!/usr/bin/env python3
"""Writes scenes/bodies/knot.ply: a trefoil knot as a closed tube, stretched along x so that its
three moments differ.

    scripts/make_knot.py scenes/bodies/knot.ply
"""
import math
import struct
import sys

ALONG, AROUND = 240, 16
SIZE, TUBE, STRETCH = 0.03, 0.015, 1.25  # [m], but for the stretch


def point(t):
    """The middle line (sin t + 2 sin 2t, cos t - 2 cos 2t, -sin 3t)."""
    return (STRETCH * SIZE * (math.sin(t) + 2 * math.sin(2 * t)),
            SIZE * (math.cos(t) - 2 * math.cos(2 * t)), -SIZE * math.sin(3 * t))


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return tuple(x / length for x in v)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def main():
    vertices, faces = [], []
    for i in range(ALONG):
        t, step = 2 * math.pi * i / ALONG, 1e-4
        middle = point(t)
        along = unit([b - a for a, b in zip(point(t - step), point(t + step))])
        # The knot never rises straight up, so this level direction varies smoothly along it.
        side = unit(cross(along, (0, 0, 1)))
        up = cross(side, along)
        for k in range(AROUND):
            a = 2 * math.pi * k / AROUND
            vertices.append([m + TUBE * (math.cos(a) * s + math.sin(a) * u)
                             for m, s, u in zip(middle, side, up)])
    for i in range(ALONG):
        for k in range(AROUND):
            a, b = i * AROUND + k, i * AROUND + (k + 1) % AROUND
            c, d = [(n + AROUND) % len(vertices) for n in (a, b)]
            faces += [(a, c, d), (a, d, b)]
    header = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\n"
              "property float x\nproperty float y\nproperty float z\n"
              f"element face {len(faces)}\nproperty list uchar ushort vertex_indices\n"
              "end_header\n")
    with open(sys.argv[1], "wb") as file:
        file.write(header.encode())
        for vertex in vertices:
            file.write(struct.pack("<3f", *vertex))
        for face in faces:
            file.write(struct.pack("<B3H", 3, *face))


if __name__ == "__main__":
    main()
