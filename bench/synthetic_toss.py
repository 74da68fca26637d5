#!/usr/bin/env python3
"""Writes docs/toss.csv: a phone's recording of a tossed book, simulated.

    rotatebook simulate TOSS.toml --csv - | bench/synthetic_toss.py > docs/toss.csv

TOSS.toml is of the model "exact", with simulation.time_per_frame = 0.01.
"""
import csv
import random
import sys

NOISE = 8.7e-4  # of a rate, 0.05 deg/s [rad/s]
BIAS = (0.01, -0.02, 0.015)  # of the gyroscope [rad/s]
LEVER = 0.02  # of the accelerometer, along y [m]


def body_rate(row):
    """Returns the angular velocity in body axes: turned by the inverse of the attitude."""
    w, x, y, z = (float(row[name]) for name in ("qw", "qx", "qy", "qz"))
    v = [float(row[name]) for name in ("wx", "wy", "wz")]
    u = (-x, -y, -z)
    cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    t = [2 * one for one in cross(u, v)]
    s = cross(u, t)
    return [v[i] + w * t[i] + s[i] for i in range(3)]


def main():
    """Writes a rest of a second, a swing, the flight and a catch."""
    random.seed(2)
    flight = [body_rate(row) for row in csv.DictReader(sys.stdin)]
    still, swing = ([0, 0, 0], [0, 0, 9.81]), ([3, 1, -2], [5, -20, 9])
    readings = [still] * 100 + [swing] * 20
    readings += [(rate, [0, LEVER * sum(one * one for one in rate), 0]) for rate in flight]
    readings += [swing] * 20
    names = [f"Gyroscope {axis} (rad/s)" for axis in "xyz"] + [f"Acceleration {axis} (m/s^2)" for axis in "xyz"]
    print(",".join(f'"{name}"' for name in ["Time (s)"] + names))
    for index, (rate, force) in enumerate(readings):
        noisy = [rate[i] + BIAS[i] + random.gauss(0, NOISE) for i in range(3)]
        print(",".join(f"{value:.6g}" for value in [index / 100] + noisy + list(force)))


main()
