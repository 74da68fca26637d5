"""The pack of exact motions, beside an engine that is written here: it meets the bounds, and a broken one doesn't."""

import csv
import json
import math
import os
import pathlib
import subprocess
import sys
import unittest

import rotatebook

SOURCE = pathlib.Path(os.environ["ROTATEBOOK_SOURCE"])
STEPS = 240  # A second.


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def product(p, q):
    """Returns the product of quaternions w, x, y, z."""
    x, y, z = cross(p[1:], q[1:])
    return [p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3], p[0] * q[1] + q[0] * p[1] + x,
            p[0] * q[2] + q[0] * p[2] + y, p[0] * q[3] + q[0] * p[3] + z]


def turned(q, v):
    return product(product(q, [0, *v]), [q[0], -q[1], -q[2], -q[3]])[1:]


def slope(state, inertia):
    """Euler's equations in the body's axes, and dq/dt = q w / 2."""
    q, w = state[:4], state[4:]
    torque = cross([i * each for i, each in zip(inertia, w)], w)
    return [each / 2 for each in product(q, [0, *w])] + [each / i for each, i in zip(torque, inertia)]


def plus(state, h, change):
    return [s + h * c for s, c in zip(state, change)]


def rk4(state, h, inertia):
    a = slope(state, inertia)
    b = slope(plus(state, h / 2, a), inertia)
    c = slope(plus(state, h / 2, b), inertia)
    d = slope(plus(state, h, c), inertia)
    return plus(state, h / 6, [a[i] + 2 * b[i] + 2 * c[i] + d[i] for i in range(7)])


def euler(state, h, inertia):
    return plus(state, h, slope(state, inertia))


def without_torque(state, h, inertia):
    return plus(state, h, [*slope(state, inertia)[:4], 0, 0, 0])


def without_numbers(state, h, inertia):
    return [math.nan] * 7


def simulate(step, inertia, start, times):
    """Returns a state for each time, as the pack has them."""
    state, states = [*start[1:5], *start[5:8]], [start]  # Body and world have the same axes.
    for before, after in zip(times, times[1:]):
        count = round((after - before) * STEPS)
        for _ in range(count):
            state = step(state, (after - before) / count, inertia)
            length = math.hypot(*state[:4])
            state[:4] = [each / length for each in state[:4]]
        states.append([after, *state[:4], *turned(state[:4], state[4:])])
    return states


class Pack(unittest.TestCase):
    def setUp(self):
        ended = subprocess.run([rotatebook.program(), "judge", "--pack", "pack"], check=True, text=True,
                               stdout=subprocess.PIPE)
        self.assertEqual(ended.stdout, "wrote pack/pack.json and a table for each of its motions\n")
        self.pack = json.loads(pathlib.Path("pack/pack.json").read_text())

    def check(self, step):
        """Returns the exit status and the lines of examples/check_pack.py with an engine that steps so."""
        pathlib.Path("engine.py").write_text(
            f"import functools, pack_test\nsimulate = functools.partial(pack_test.simulate, pack_test.{step.__name__})\n")
        path = os.pathsep.join([str(pathlib.Path(__file__).parent), os.getcwd()])
        ended = subprocess.run([sys.executable, SOURCE / "examples/check_pack.py", "pack/pack.json"], text=True,
                               stdout=subprocess.PIPE, env={**os.environ, "PYTHONPATH": path})
        return ended.returncode, ended.stdout.splitlines()

    def test_is_met_by_a_good_engine_alone(self):
        status, lines = self.check(rk4)
        self.assertEqual((status, len(lines)), (0, 12), lines)
        self.assertEqual([line for line in lines if not line.startswith("met: ")], [])
        for broken in (euler, without_torque, without_numbers):
            status, lines = self.check(broken)
            self.assertEqual(status, 1)
            for motion in self.pack["motions"]:
                self.assertTrue(any(line.startswith(f"not met: {motion['name']}: ") for line in lines), lines)

    def test_has_tables_of_the_same_numbers(self):
        for motion in self.pack["motions"]:
            with open(pathlib.Path("pack") / motion["table"], newline="") as file:
                rows = list(csv.reader(file))
            self.assertEqual([name.split()[0] for name in rows[0]], motion["columns"])
            self.assertEqual([[float(number) for number in row] for row in rows[1:]], motion["states"])
            self.assertEqual(len(motion["states"]), 101)
        self.assertEqual([motion["name"] for motion in self.pack["motions"]],
                         ["book", "t-handle", "disc", "near-separatrix"])

    def test_takes_the_place_of_a_pack_alone(self):
        before = pathlib.Path("pack/pack.json").read_bytes()
        ended = subprocess.run([rotatebook.program(), "judge", "--pack", "pack"], check=True, text=True,
                               stdout=subprocess.PIPE)
        self.assertEqual(ended.stdout, "wrote pack/pack.json and a table for each of its motions\n")
        self.assertEqual(pathlib.Path("pack/pack.json").read_bytes(), before)
        pathlib.Path("mine").mkdir(exist_ok=True)
        pathlib.Path("mine/book.csv").write_text("my notes\n")
        refused = subprocess.run([rotatebook.program(), "judge", "--pack", "mine"], capture_output=True, text=True)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("mine/book.csv", refused.stderr)
        self.assertEqual([file.name for file in pathlib.Path("mine").iterdir()], ["book.csv"])
        file = subprocess.run([rotatebook.program(), "judge", "--pack", "mine/book.csv"], capture_output=True, text=True)
        self.assertIn("can't make the folder mine/book.csv: mine/book.csv is not a folder", file.stderr)


if __name__ == "__main__":
    unittest.main()
