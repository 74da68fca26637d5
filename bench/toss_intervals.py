#!/usr/bin/env python3
"""Prints how many intervals of `rotatebook toss` hold, as docs/recorded.md has them.

    bench/toss_intervals.py build/release/rotatebook

Of simulated tosses of random cuboids about their middle axes, with random mountings of the phone and
random rates of readings: a rest of a second, a flight of 0.8 s, and noise of 0.05 deg/s.
"""
import json
import math
import random
import subprocess
import sys
import tempfile

TOSSES = 300
DEGREE = math.pi / 180
NOISE = 0.05 * DEGREE  # [rad/s]
REST, FLIGHT = 1.0, 0.8  # [s]
KINDS = {
    "noise alone": {},
    "scales wrong by 0.5 %": {"scale": 0.005},
    "stamps wrong by 0.5 ms": {"stamps": 5e-4},
    "a bias that walks by 0.05 deg/s in a second": {"walk": 0.05 * DEGREE},
}


def random_rotation():
    """Returns the rows of a rotation."""
    q = [random.gauss(0, 1) for _ in range(4)]
    w, x, y, z = (part / math.hypot(*q) for part in q)
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]


def advanced(spin, moments, time):
    """Returns the spin after a free motion, by the classical Runge-Kutta method."""
    change = lambda w: [
        (moments[(i + 1) % 3] - moments[(i + 2) % 3]) / moments[i] * w[(i + 1) % 3] * w[(i + 2) % 3]
        for i in range(3)
    ]
    along = lambda w, k, h: [a + h * b for a, b in zip(w, k)]
    steps = max(1, math.ceil(time * 1000))
    h = time / steps
    for _ in range(steps):
        k1 = change(spin)
        k2 = change(along(spin, k1, h / 2))
        k3 = change(along(spin, k2, h / 2))
        k4 = change(along(spin, k3, h))
        spin = [w + h / 6 * (a + 2 * b + 2 * c + d) for w, a, b, c, d in zip(spin, k1, k2, k3, k4)]
    return spin


def toss(scale=0.0, stamps=0.0, walk=0.0):
    """Returns a table of a toss, and the ratios of its body."""
    edges = [random.uniform(0.03, 0.3) ** 2 for _ in range(3)]
    moments = sorted([edges[1] + edges[2], edges[0] + edges[2], edges[0] + edges[1]])
    step = 1 / random.uniform(50, 400)
    mounting = random_rotation()
    aside = random_rotation()[0]
    spin = [random.uniform(8, 12) * ((i == 1) + 0.3 * aside[i]) for i in range(3)]
    bias = [random.gauss(0, 0.02) for _ in range(3)]
    gains = [1 + scale, 1 - scale, 1]
    lines = ["t (s)," + ",".join(f"gyro_{axis} (rad/s)" for axis in "xyz")]
    time, before = 0.0, 0.0
    while time < REST + FLIGHT:
        if time >= REST:
            spin = advanced(spin, moments, time - max(before, REST))
        rate = [sum(a * w for a, w in zip(row, spin)) if time >= REST else 0 for row in mounting]
        bias = [one + random.gauss(0, walk * math.sqrt(step)) for one in bias]
        read = [g * w + b + random.gauss(0, NOISE) for g, w, b in zip(gains, rate, bias)]
        lines.append(f"{time + random.gauss(0, stamps):.7f}," + ",".join(f"{one:.7g}" for one in read))
        before, time = time, time + step
    return "\n".join(lines) + "\n", (moments[0] / moments[2], moments[1] / moments[2])


def main():
    """Prints a row of the table for each kind of errors."""
    program = sys.argv[1]
    for kind, errors in KINDS.items():
        random.seed(1)
        held, narrow, refused = [0, 0], [0, 0], 0
        for _ in range(TOSSES):
            text, ratios = toss(**errors)
            with tempfile.NamedTemporaryFile("w", suffix=".csv") as table:
                table.write(text)
                table.flush()
                part = ["--from", str(REST + 0.005), "--to", str(REST + FLIGHT)]
                run = subprocess.run(
                    [program, "toss", table.name, "--json"] + part, capture_output=True, text=True, check=False
                )
            if run.returncode != 0:
                refused += 1
                continue
            fit = json.loads(run.stdout)
            for i, name in enumerate(("I1_over_I3", "I2_over_I3")):
                value, low, high = (fit[name][key] for key in ("value", "low", "high"))
                held[i] += low <= ratios[i] <= high
                factor = fit["widening"]
                narrow[i] += value - (value - low) / factor <= ratios[i] <= value + (high - value) / factor
        percent = lambda counts: ", ".join(f"{100 * one / (TOSSES - refused):.0f}" for one in counts) + " %"
        print(f"{kind}: {percent(held)} (not widened {percent(narrow)}); {refused} refused", flush=True)


main()
