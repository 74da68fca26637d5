"""Tests of speed.py: speed_test.py PROGRAM FOLDER. What it calculates, and that a quick run has every row."""
import os
import subprocess
import sys
import unittest

import speed

PROGRAM, FOLDER = sys.argv[1:3]


def result(wall, processor):
    """As `rotatebook bench --json` has it; each stage alike."""
    times = {"wall": wall, "processor": processor}
    return {"cores": 2, "start_up_s": wall / 10, "whole": {"wall": 2 * wall, "processor": 5 * processor},
            "stages": {name: times for name in speed.STAGES}}


class Numbers(unittest.TestCase):
    """Known ones in, known ones out."""

    def test_median_is_that_of_each_number(self):
        runs = [speed.Run(1, 9, 5, "a"), speed.Run(2, 7, 6, "b"), speed.Run(3, 8, 4, "c")]
        self.assertEqual(speed.median(runs), speed.Run(2, 8, 5, "a"))

    def test_median_of_stages(self):
        middle = speed.median_stages([result(1, 30), result(2, 10), result(9, 20)])
        self.assertEqual(middle["stages"]["png"], {"wall": 2, "processor": 20})
        self.assertEqual(middle["whole"], {"wall": 4, "processor": 100})

    def test_distance_to_the_limit(self):
        # Five stages of 2 ms on 2 cores can't take less than 5 ms.
        table = speed.stage_table(result(3, 2))
        self.assertIn("distance to the limit: 6.00 ms / (10.00 ms / 2 cores) = 1.20\n", table)

    def test_ratio_is_to_the_first_row(self):
        runs = {"ours": speed.Run(2, 4, 100, ""), "theirs": speed.Run(5, 1, 200, "")}
        rows = [line.split() for line in speed.end_to_end_table(runs, ["another"], 10).splitlines()]
        self.assertEqual(rows[1], ["ours", "5.0", "400.0", "100", "1.00"])
        self.assertEqual(rows[2], ["theirs", "2.0", "100.0", "200", "2.50"])
        self.assertEqual(" ".join(rows[3]), "another not installed: make bench-peers")


class Quick(unittest.TestCase):
    """The whole of it, with few frames."""

    def run_speed(self, *arguments):
        return subprocess.run([sys.executable, speed.__file__, "--quick", "-o", FOLDER, *arguments],
                              capture_output=True, text=True, check=False)

    def test_has_every_row_and_plot(self):
        done = self.run_speed("--program", PROGRAM, "--mujoco", "/nonexistent")
        self.assertEqual(done.returncode, 0, done.stderr)
        for row in ["processor", "renderer", "encoder", "compiler", *speed.STAGES.values(), "distance to the limit",
                    "to make drawing ready", "from the command to the end of a part of one frame",
                    "rotatebook, PNGs and MP4", "rotatebook, MP4 alone", "moderngl, PNGs by Pillow", "moderngl to ffmpeg",
                    "640x360", "1280x720", "8 "]:
            self.assertRegex(done.stdout, f"(?m)^{row}")
        self.assertRegex(done.stdout, "MuJoCo to ffmpeg, no PNGs +not installed: make bench-peers")
        for name in ("resolution.svg", "frames.svg"):
            self.assertGreater(os.path.getsize(os.path.join(FOLDER, name)), 1000)

    def test_names_a_missing_program(self):
        done = self.run_speed("--program", "/nonexistent/rotatebook")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr, "speed.py: there is no program /nonexistent/rotatebook; make program builds it\n")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
