#!/usr/bin/env python3
"""Kills renders at random instants and lets others go on, until all files are there.

After each kill no file under a final name may be half-written, and no folder may hold frames of two
renders; in the end all must be, byte for byte, what a render leaves that was never killed. Every
second clip takes the place of an older one of other settings; of the others, parts are rendered
now and then, too.

    tests/reliability/kill_render.py build/release/rotatebook
"""
import argparse
import filecmp
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

SCENE = """title = "Killed"
book.color = "#2b5d8a"
[initial]
angular_velocity = [5.0, 3.0, 1.0]
[clip]
size = [320, 180]
duration = 1.0
"""
OLDER = ["--set", "body.mass=2", "--format", "gif,apng"]
PARTS = [["--frames", "10:40", "--no-mp4"], ["--part", "2/3"]]
NAME = "killed"
ON_ITS_WAY = ("rotatebook-", "frames.", ".partial.mp4")


def render(program, out, *options, **settings):
    command = [program, "render", out.parent / f"{NAME}.toml", "-o", out, *options]
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                            **settings)


def finish(process):
    error = process.communicate()[1]
    if process.returncode != 0:
        sys.exit(f"a render that wasn't killed ended with {process.returncode}: {error}")


def files_in(folder):
    return sorted(path.relative_to(folder) for path in folder.rglob("*") if path.is_file())


def same(a, b):
    return a.is_file() and b.is_file() and filecmp.cmp(a, b, shallow=False)


def require_whole(out, references):
    """Every file is that of one of the references, and all of a folder's are the same one's."""
    possible = {}
    for path in files_in(out):
        if any(part in path.name for part in ON_ITS_WAY):
            continue
        folder = path.parts[0] if len(path.parts) > 1 else path.name
        wanted = pathlib.Path(NAME, *path.parts[1:]) if len(path.parts) > 1 else path
        found = {reference for reference in references if same(out / path, reference / wanted)}
        possible[folder] = possible.get(folder, set(references)) & found
        # While an old folder is emptied, nobody takes it for a clip.
        if not possible[folder] and not folder.endswith(".replaced"):
            sys.exit(f"{out / path} is half-written, or of another render than its neighbours")


def require_same(out, reference):
    others = set(files_in(out)) ^ set(files_in(reference))
    if others:
        sys.exit(f"other files in {out} than in {reference}: {sorted(map(str, others))}")
    for path in files_in(reference):
        if not same(out / path, reference / path):
            sys.exit(f"{out / path} differs from {reference / path}")


def kill_once(program, out, latest, options):
    """False if the render ended before it was killed."""
    process = render(program, out, *options)
    try:
        process.wait(random.uniform(0, latest))
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGKILL)
        process.communicate()
        return True
    finish(process)
    return False


def run(program, kills, folder):
    (folder / f"{NAME}.toml").write_text(SCENE)
    whole, older, over = folder / "whole", folder / "older", folder / "over"
    start = time.monotonic()
    finish(render(program, whole))
    latest = 1.1 * (time.monotonic() - start)
    finish(render(program, older, *OLDER))
    # What a render that isn't killed leaves beside the older one's videos of other formats.
    shutil.copytree(older, over)
    finish(render(program, over))
    killed = clips = 0
    while killed < kills:
        out = folder / "out"
        shutil.rmtree(out, ignore_errors=True)
        replaces = clips % 2 == 1
        if replaces:
            shutil.copytree(older, out)
        reference = over if replaces else whole
        go_on = ["--resume", "--overwrite"] if replaces else ["--resume"]
        ways = [go_on] if replaces else [go_on, go_on + random.choice(PARTS)]
        while killed < kills and kill_once(program, out, latest, random.choice(ways)):
            killed += 1
            require_whole(out, [over, older] if replaces else [whole])
        finish(render(program, out, *go_on))
        require_same(out, reference)
        clips += 1
    print(f"{killed} kills over {clips} clips, each in the end the same, byte for byte")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("--kills", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1, help="of the instants")
    arguments = parser.parse_args()
    random.seed(arguments.seed)
    with tempfile.TemporaryDirectory() as folder:
        run(arguments.program, arguments.kills, pathlib.Path(folder))


if __name__ == "__main__":
    main()
