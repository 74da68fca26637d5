#!/usr/bin/env python3
"""Renders a clip of an hour and watches memory, open files and processor time a frame, which must be constant.

    tests/reliability/soak.py build/release/rotatebook
"""
import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

# The exact motion: Euler's would grow within an hour until the book leaves the picture.
SCENE = """title = "Soak"
[initial]
angular_velocity = [5.0, 3.0, 1.0]
[simulation]
model = "exact"
[clip]
size = [64, 36]
fps = 60
"""
NAME = "soak"
# Of the last quarter beside the second; the first has the start in it. An MP4's table of its frames
# grows until it is written. Measured 123 bytes a frame, and times of 0.82 to 1.05.
MOST_BYTES_A_FRAME, MOST_TIME = 200, 1.25


def memory(process):
    """Resident, in MB."""
    for line in pathlib.Path(f"/proc/{process.pid}/status").read_text().splitlines():
        if line.startswith("VmRSS:"):
            return int(line.split()[1]) / 1000
    return None


def processor_seconds(process):
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def open_files(process):
    return sum(1 for _ in pathlib.Path(f"/proc/{process.pid}/fd").iterdir())


class Frames:
    """Counts the frames that are done, by the lines of their checksums."""

    def __init__(self, folder):
        self.path = folder / f"{NAME}.partial" / "frames.xxh128"
        self.place = self.count = 0

    def done(self):
        if self.path.exists():
            with self.path.open("rb") as lines:
                lines.seek(self.place)
                new = lines.read()
            self.place += len(new)
            self.count += new.count(b"\n")
        return self.count


def watch(process, folder, every):
    """(processor seconds, frames, MB, files) again and again until it ends."""
    frames, seen = Frames(folder), []
    while process.poll() is None:
        time.sleep(every)
        try:
            now = (processor_seconds(process), frames.done(), memory(process), open_files(process))
        except OSError:  # It has ended meanwhile.
            break
        if now[2] is not None and 0 < now[1] and frames.path.exists():
            seen.append(now)
    return seen


def quarters(seen, total):
    """Of each quarter of the frames: median MB, most files, ms a frame."""
    rows = []
    for quarter in range(4):
        part = [now for now in seen if quarter <= 4 * now[1] / total < quarter + 1]
        if len(part) < 2:
            sys.exit("the clip is too short to be watched")
        per_frame = 1000 * (part[-1][0] - part[0][0]) / (part[-1][1] - part[0][1])
        rows.append((statistics.median(now[2] for now in part), max(now[3] for now in part),
                     per_frame))
        print(f"quarter {quarter + 1}: {rows[-1][0]:.1f} MB, {rows[-1][1]} open files, "
              f"{rows[-1][2]:.2f} ms a frame", flush=True)
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--seconds", type=int, default=3600, help="length of the clip")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / f"{NAME}.toml").write_text(SCENE + f"duration = {arguments.seconds}\n")
        process = subprocess.Popen([arguments.program.resolve(), "render", f"{NAME}.toml", "-o", "."],
                                   cwd=folder, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        seen = watch(process, folder, arguments.seconds / 3600)
        if process.returncode != 0:
            sys.exit(f"the render ended with {process.returncode}")
        rows = quarters(seen, 60 * arguments.seconds)
    grown = 1e6 * (rows[3][0] - rows[1][0]) / (30 * arguments.seconds)
    print(f"memory: {grown:.0f} bytes a frame")
    if grown > MOST_BYTES_A_FRAME:
        sys.exit("memory grows")
    if rows[3][2] > MOST_TIME * rows[1][2]:
        sys.exit(f"processor time a frame grows: {rows[3][2]:.2f} after {rows[1][2]:.2f} ms")
    if rows[3][1] > rows[1][1] + 1:
        sys.exit(f"open files grow: {rows[3][1]} after {rows[1][1]}")


if __name__ == "__main__":
    main()
