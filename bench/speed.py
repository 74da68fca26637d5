#!/usr/bin/env python3
"""How fast rotatebook renders: by stage, end to end, and beside other programs; two plots of how it scales.

Needs nothing but Python and the program. `make bench` runs it.
"""
import argparse
import json
import os
import platform
import statistics
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass

import speed_plots

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(HERE)
SCENE = os.path.join(ROOT, "scenes/figures/fig05-unstable-x.toml")
PEER = os.path.join(HERE, "peers/tumbling_box.py")
SIZES = [(640, 360), (1280, 720), (1920, 1080), (2560, 1440), (3840, 2160)]
STAGES = {"simulate": "simulate", "book": "draw the book", "compose": "edges, overlays", "png": "PNG",
          "video": "convert and encode"}


@dataclass
class Run:
    """What a process, and those that it started, took."""
    seconds: float
    processor: float  # [s]
    peak: float  # [MB]
    output: str


def run(command):
    """Runs `command` in an empty folder; stops everything, with its words, if it fails."""
    with tempfile.TemporaryDirectory(prefix="rotatebook-bench-") as folder, \
            tempfile.TemporaryFile("w+") as output, tempfile.TemporaryFile("w+") as errors:
        start = time.monotonic()
        process = subprocess.Popen(command, stdout=output, stderr=errors, cwd=folder)
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.monotonic() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        errors.seek(0)
        if process.returncode != 0:
            sys.exit(f"speed.py: {' '.join(command)}\nfailed with status {process.returncode}: {errors.read()}")
        output.seek(0)
        return Run(seconds, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, output.read())


def median(runs):
    """The run that stands for `runs`: of each number the median."""
    return Run(*(statistics.median(getattr(one, name) for one in runs)
                 for name in ("seconds", "processor", "peak")), runs[0].output)


def render_command(program, frames, *options):
    """A part, because its motion is the whole scene's, which meets what the scene expects."""
    return [program, "render", SCENE, "-o", "clip", "--frames", f"0:{frames}", *options]


def measure_stages(program, frames, *options):
    """What `rotatebook bench` says."""
    return json.loads(run([program, "bench", SCENE, "--json", "--frames", str(frames), *options]).output)


# --- Other programs ---

def python_with_moderngl():
    """The first Python that can run the peers; Debian's packages are for Debian's own."""
    for python in (sys.executable, "/usr/bin/python3"):
        test = subprocess.run([python, "-c", "import moderngl, PIL"], capture_output=True, check=False)
        if test.returncode == 0:
            return python
    return None


def peers(mujoco, frames):
    """Command by name; None for what isn't installed."""
    python = python_with_moderngl()

    def box(way):
        return python and [python, PEER, way, "clip.mp4", "--frames", str(frames)]
    has_mujoco = os.path.isfile(mujoco)
    cover = os.path.join(ROOT, "assets/front.png")
    return {"moderngl, PNGs by Pillow, then ffmpeg": box("png"),
            "moderngl to ffmpeg, no PNGs": box("raw"),
            "MuJoCo to ffmpeg, no PNGs": [mujoco, cover, "clip.mp4", str(frames)] if has_mujoco else None}


# --- The machine ---

def first_line(command):
    """Of what a program prints; nothing if there is no such program."""
    try:
        result = subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError:
        return ""
    return (result.stdout.splitlines() or [""])[0]


def processor_name():
    """As the kernel has it."""
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            names = [line.split(":", 1)[1].strip() for line in file if line.startswith("model name")]
    except OSError:
        names = []
    return names[0] if names else platform.machine()


def version(package):
    """Of an installed Debian package; of several that match the first."""
    return first_line(["dpkg-query", "-W", "-f", "${Version}\n", package]) or "unknown"


def machine_text(stages):
    """What the numbers depend on."""
    return (f"processor  {processor_name()}, {stages['cores']} cores\n"
            f"renderer   {stages['renderer']}; Mesa {version('libgl1-mesa-dri')}\n"
            f"encoder    {stages['encoder']} {version('libx264-[0-9]*')}; FFmpeg {version('libavcodec[0-9]*')}\n"
            f"compiler   {first_line(['c++', '--version']) or 'unknown'}\n")


# --- Tables ---

def median_stages(results):
    """Of `rotatebook bench --json`, run several times: the medians of all times."""
    merged = dict(results[0])

    def of(pick):
        return {clock: statistics.median(pick(one)[clock] for one in results) for clock in ("wall", "processor")}
    merged["whole"] = of(lambda one: one["whole"])
    merged["stages"] = {name: of(lambda one, name=name: one["stages"][name]) for name in STAGES}
    merged["start_up_s"] = statistics.median(one["start_up_s"] for one in results)
    return merged


def stage_table(stages):
    """By stage, and how far the whole is from what the stages' work allows."""
    lines = [f"{'each stage alone':38}{'ms a frame':>12}{'processor ms':>14}"]
    for name, words in STAGES.items():
        times = stages["stages"][name]
        lines.append(f"{words:38}{times['wall']:12.2f}{times['processor']:14.2f}")
    work = sum(times["processor"] for times in stages["stages"].values())
    limit, wall = work / stages["cores"], stages["whole"]["wall"]
    lines += [f"{'all':38}{'':12}{work:14.2f}",
              f"{'all together, after the start':38}{wall:12.2f}{stages['whole']['processor']:14.2f}",
              f"distance to the limit: {wall:.2f} ms / ({work:.2f} ms / {stages['cores']} cores) = {wall / limit:.2f}",
              f"to make drawing ready: {stages['start_up_s']:.2f} s"]
    return "\n".join(lines) + "\n"


def end_to_end_table(runs, missing, frames):
    """Whole processes, start included; the ratio is that of the first row's speed to each."""
    title = f"end to end, {frames} frames of 1280x720"
    lines = [f"{title:38}{'frames/s':>12}{'processor ms':>14}{'peak MB':>9}{'ratio':>8}"]
    ours = next(iter(runs.values())).seconds
    for name, one in runs.items():
        lines.append(f"{name:38}{frames / one.seconds:12.1f}{1000 * one.processor / frames:14.1f}"
                     f"{one.peak:9.0f}{one.seconds / ours:8.2f}")
    lines += [f"{name:38}{'not installed: make bench-peers':>43}" for name in missing]
    return "\n".join(lines) + "\nratio: how many times as fast the first row is; processor time includes ffmpeg's\n"


def measure_tables(options):
    """Prints the tables; every program takes its turn in each repetition."""
    commands = {"rotatebook, PNGs and MP4": render_command(options.program, options.frames),
                "rotatebook, MP4 alone": render_command(options.program, options.frames, "--no-png"),
                **peers(options.mujoco, options.frames)}
    missing = [name for name, command in commands.items() if command is None]
    runs = {name: [] for name, command in commands.items() if command is not None}
    stages, starts = [], []
    for _ in range(options.repetitions):
        for name, results in runs.items():
            results.append(run(commands[name]))
        stages.append(measure_stages(options.program, options.frames))
        starts.append(run(render_command(options.program, 1)).seconds)
    middle = median_stages(stages)
    print(machine_text(middle))
    print(f"medians of {options.repetitions} runs\n")
    print(stage_table(middle) +
          f"from the command to the end of a part of one frame: {statistics.median(starts):.2f} s\n")
    print(end_to_end_table({name: median(results) for name, results in runs.items()}, missing, options.frames))


# --- How it scales ---

def measure_sizes(options):
    """Rows of size, megapixels a picture and frames/s after the start."""
    rows = []
    for width, height in SIZES[:2] if options.quick else SIZES:
        frames = max(2, options.frames // 5)
        speed = measure_stages(options.program, frames, "--size", f"{width}x{height}")
        rows.append((f"{width}x{height}", width * height / 1e6, speed["frames_per_second"]))
        print(f"{rows[-1][0]:38}{rows[-1][2]:12.1f}", flush=True)
    return rows


def measure_counts(options):
    """Rows of frames, seconds and peak memory."""
    rows = []
    for share in (1, 2) if options.quick else (0.25, 0.5, 1, 2, 4):
        frames = int(options.frames * share)
        one = run(render_command(options.program, frames))
        rows.append((frames, one.seconds, one.peak))
        print(f"{frames:<38}{one.seconds:12.2f}{one.peak:14.0f}", flush=True)
    return rows


def measure_scaling(options):
    """Prints two tables and draws them."""
    print(f"{'size':38}{'frames/s':>12}")
    sizes = measure_sizes(options)
    print(f"\n{'frames of 1280x720':38}{'seconds':>12}{'peak MB':>14}")
    counts = measure_counts(options)
    files = speed_plots.draw(sizes, counts, options.output)
    print(f"\nwrote {' and '.join(files)}")


def parsed_options():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default=os.path.join(ROOT, "build/release/rotatebook"))
    parser.add_argument("--mujoco", default=os.path.join(ROOT, "build/peers/mujoco_box"), help="the built peer")
    parser.add_argument("-o", "--output", default=os.path.join(ROOT, "out/bench"), help="folder for the plots")
    parser.add_argument("--frames", type=int, default=300, help="of 1280x720, up to 360")
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("--no-plots", action="store_true", help="the tables alone")
    parser.add_argument("--quick", action="store_true", help="few frames, one repetition: only to see that it works")
    options = parser.parse_args()
    if options.quick:
        options.frames, options.repetitions = 4, 1
    options.program, options.mujoco = os.path.abspath(options.program), os.path.abspath(options.mujoco)
    if not 1 <= options.frames <= 360 or options.repetitions < 1:
        parser.error("--frames must be 1 to 360, a quarter of the scene's, and --repetitions at least 1")
    return options


def main():
    options = parsed_options()
    if not os.access(options.program, os.X_OK):
        sys.exit(f"speed.py: there is no program {options.program}; make program builds it")
    measure_tables(options)
    if not options.no_plots:
        measure_scaling(options)


if __name__ == "__main__":
    main()
