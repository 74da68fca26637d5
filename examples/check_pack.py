"""Compares an engine with the exact motions of `rotatebook judge --pack`: check_pack.py pack.json

engine.py, beside it or on PYTHONPATH, is yours: simulate(inertia, start, times) returns a state for
each time, [t, qw, qx, qy, qz, wx, wy, wz] as the pack has them, of which the first is `start`.
"""

import json
import math
import sys

from engine import simulate


def in_body(state):
    """Returns the rates along the body's axes."""
    _, w, x, y, z, *rates = state
    matrix = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
              [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
              [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    return [sum(matrix[row][column] * rates[row] for row in range(3)) for column in range(3)]


def kept(inertia, state):
    """Returns the energy, and the size of the angular momentum."""
    momentum = [moment * rate for moment, rate in zip(inertia, in_body(state))]
    return sum(l * rate for l, rate in zip(momentum, in_body(state))) / 2, math.hypot(*momentum)


def differences(motion):
    """Returns how far the engine is off: {name of a bound: largest value}."""
    exact, inertia = motion["states"], motion["inertia"]
    states = simulate(inertia, exact[0], [state[0] for state in exact])
    energy, momentum = kept(inertia, exact[0])
    worst = {"error_deg": 0.0, "energy_drift": 0.0, "L_drift": 0.0}
    for state, due in zip(states, exact, strict=True):
        along = min(abs(sum(a * b for a, b in zip(state[1:5], due[1:5]))), 1)
        now, turning = kept(inertia, state)
        for name, value in (("error_deg", math.degrees(2 * math.acos(along))), ("energy_drift", abs(now / energy - 1)),
                            ("L_drift", abs(turning / momentum - 1))):
            worst[name] = max(worst[name], math.inf if math.isnan(value) else value)
    return worst


def main(file):
    met = True
    for motion in json.load(open(file))["motions"]:
        for name, value in differences(motion).items():
            keeps = value <= motion["bounds"][name]
            met = met and keeps
            print(f"{'met' if keeps else 'not met'}: {motion['name']}: {name} {value:.3g}, at most {motion['bounds'][name]}")
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
