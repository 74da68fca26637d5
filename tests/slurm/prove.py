#!/usr/bin/env python3
"""Proves on a real cluster, of four nodes on this machine, that many machines make what one makes.

A clip, a map and a study are submitted to Slurm. While they run, tasks, their supervisors, nodes'
daemons and whole nodes are killed at random instants, one task runs twice, and in the end every
file is, byte for byte, that of a single process. A node whose renderer draws otherwise is refused.

    tests/slurm/prove.py build/release/rotatebook
    tests/slurm/prove.py build/release/rotatebook --seed 7 --kills 30
    tests/slurm/prove.py build/release/rotatebook --benchmark
"""
import argparse
import filecmp
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import cluster

SKIPPED = 77
CLIP = """title = "Many machines"
[initial]
angular_velocity = [5.0, 3.0, 1.0]
[clip]
size = [320, 180]
duration = 4.0
[overlay]
show = ["omega", "clock"]
"""
MAP = """title = "Delay"
[initial]
angular_velocity = [5.0, 0.0, 0.0]
tilt = [0.001, "z"]
[simulation]
integrator = "rk4"
[map]
x = { key = "simulation.substeps", from = 1, to = 16, scale = "log" }
y = { key = "initial.tilt.0", from = 1e-6, to = 1.0, scale = "log" }
measure = "half_turns"
size = [320, 256]
duration = 3
"""
STUDY = """title = "Sweep"
[initial]
angular_velocity = [5.0, 0.0, 0.0]
tilt = [0.01, "z"]
[clip]
duration = 5.0
[study]
over = "initial.tilt.0"
values = [0.1, 0.01, 0.001]
measure = ["half_turns"]
"""
WORKS = {"render": "clip", "map": "grid", "study": "sweep"}
CHUNKS = {"render": ["--chunk", "24"], "map": ["--chunk", "3"], "study": []}


class Proof:
    def __init__(self, program, folder, seed):
        self.program = pathlib.Path(program).resolve()
        self.folder = folder
        self.random = random.Random(seed)
        for name, text in (("clip", CLIP), ("grid", MAP), ("sweep", STUDY)):
            (folder / f"{name}.toml").write_text(text)
        self.one = folder / "one"

    def scene(self, work):
        return self.folder / f"{WORKS[work]}.toml"

    def call(self, *arguments, status=0, environment=None):
        """Runs the program, and returns what it printed."""
        done = subprocess.run([self.program, *map(str, arguments)], text=True, timeout=600,
                              capture_output=True, env=environment, check=False)
        if done.returncode != status:
            sys.exit(f"{' '.join(map(str, arguments))} ended with {done.returncode}, not "
                     f"{status}:\n{done.stdout}{done.stderr}")
        return done.stdout

    def make_alone(self):
        for work in WORKS:
            self.call(work, self.scene(work), "-o", self.one)

    def submit(self, nodes, out, works=tuple(WORKS), **settings):
        environment = nodes.environment | settings.get("environment", {})
        return [self.call("submit", work, self.scene(work), "-o", out, "--slurm", *CHUNKS[work],
                          environment=environment) for work in works]

    def states(self, nodes, out):
        done = subprocess.run([self.program, "status", out, "--json"], env=nodes.environment,
                              text=True, capture_output=True, check=False)
        return {plan["command"]: plan for plan in json.loads(done.stdout)["plans"]}

    def require_same(self, out):
        """Nothing but the plans may be in `out` beside the files of a single process."""
        count = 0
        for path in sorted(self.one.rglob("*")):
            if not path.is_file() or path.name.startswith("."):
                continue
            other = out / path.relative_to(self.one)
            if not other.is_file() or not filecmp.cmp(path, other, shallow=False):
                sys.exit(f"{other} differs from {path}, which a single process made")
            count += 1
        names = {path.relative_to(out) for path in out.rglob("*") if path.is_file()}
        more = sorted(str(name) for name in names if name.parts[0] != "farm"
                      and not (self.one / name).exists() and ".rotatebook-" not in name.name
                      and not name.match("*/frames.*.xxh128"))
        if more:
            sys.exit(f"{out} holds more than a single process leaves: {more}")
        return count

    def processes_of(self, job):
        """The program's processes in a job of the cluster."""
        found = []
        for entry in pathlib.Path("/proc").iterdir():
            if not entry.name.isdigit():
                continue
            try:
                variables = (entry / "environ").read_bytes().split(b"\0")
                if f"SLURM_JOB_ID={job}".encode() not in variables:
                    continue
                if (entry / "exe").resolve() == self.program:
                    found.append(int(entry.name))
            except OSError:
                continue
        return found

    def kill_task(self, _, job, __):
        for pid in self.processes_of(job):
            os.kill(pid, signal.SIGKILL)

    def kill_supervisor(self, _, job, __):
        for entry in pathlib.Path("/proc").iterdir():
            try:
                words = (entry / "cmdline").read_bytes()
            except OSError:
                continue
            if words.startswith(f"slurmstepd: [{job}.".encode()):
                os.kill(int(entry.name), signal.SIGKILL)

    def kill_daemon(self, nodes, _, node):
        """What ran there may go on, beside the copy that the cluster starts again."""
        nodes.stop_node(node, signal.SIGKILL)
        time.sleep(self.random.choice([0.5, 8]))
        nodes.start_node(node)

    def kill_node(self, nodes, _, node):
        nodes.run("scontrol", "update", f"nodename={node}", "state=down", "reason=test")
        time.sleep(1)
        nodes.resume(node)

    def kill_one(self, nodes):
        """Kills something of a task that runs; returns what, or nothing if none does."""
        running = [row for row in nodes.jobs() if row[2] == "RUNNING"]
        if not running:
            return ""
        array, task, _, node, job = self.random.choice(running)
        kill = self.random.choice(
            [self.kill_task, self.kill_supervisor, self.kill_daemon, self.kill_node])
        kill(nodes, job, node)
        return f"{kill.__name__} {array}_{task} on {node}"

    def run_twice(self, out):
        """Starts the clip's first task, which the cluster runs too."""
        line = (out / "farm/render/tasks.txt").read_text().splitlines()[0]
        return subprocess.Popen(["sh", "-c", line], stdout=subprocess.DEVNULL,
                                stderr=subprocess.DEVNULL)

    def run_round(self, nodes, out, kills):
        """Submits all; returns the number of kills until all was done."""
        self.submit(nodes, out)
        twin = self.run_twice(out)
        killed = 0
        deadline = time.monotonic() + 120
        while killed < kills and not nodes.is_idle() and time.monotonic() < deadline:
            time.sleep(self.random.uniform(0, 2))
            what = self.kill_one(nodes)
            if what:
                killed += 1
                print(f"  {what}", flush=True)
        if twin.wait(timeout=300) not in (0, 75):
            sys.exit(f"the task that ran twice ended with {twin.returncode}")
        nodes.wait_until_idle(200)
        # What was given up after too many failures is sent once more, and nothing else.
        if not all(plan["whole"] for plan in self.states(nodes, out).values()):
            print("  submitted again: " + " | ".join(
                text.replace("\n", "; ") for text in self.submit(nodes, out)))
            nodes.wait_until_idle(200)
        for work, plan in self.states(nodes, out).items():
            if not plan["whole"]:
                sys.exit(f"{work} isn't whole: {json.dumps(plan, indent=1)}\n{nodes.logs()}")
        for text in self.submit(nodes, out):
            if "nothing was sent" not in text:
                sys.exit(f"what is done was sent again: {text}")
        return killed

    def prove_kills(self, nodes, kills):
        killed = rounds = 0
        while killed < kills:
            out = self.folder / f"many{rounds}"
            killed += self.run_round(nodes, out, kills - killed)
            files = self.require_same(out)
            shutil.rmtree(out)
            rounds += 1
        print(f"{killed} kills in {rounds} rounds, each in the end {files} files, byte for byte "
              "those of one process")

    def prove_refusal(self, nodes):
        """The last node draws by another renderer: its tasks are refused, and said."""
        out, other = self.folder / "mixed", nodes.nodes[-1]
        # Each job's shell reads it.
        rule = self.folder / "renderer.sh"
        rule.write_text(f'[ "$SLURMD_NODENAME" != {other} ] || export LP_NATIVE_VECTOR_WIDTH=128\n')
        def drain(names):
            nodes.run("scontrol", "update", f"nodename={','.join(names)}", "state=drain",
                      "reason=later")

        def refused():
            ends = out.glob("farm/render/ends/[0-9]*")
            return [end.name for end in ends if end.read_text().split()[:2] == ["2", other]]

        # One node begins, so that there is work left for the other
        drain(nodes.nodes[1:])
        self.submit(nodes, out, ["render"], environment={"BASH_ENV": str(rule)})
        nodes.wait_until((out / "clip/frames.manifest").exists, 60, "the first part has begun")
        drain(nodes.nodes[:1])
        nodes.resume(other)
        nodes.wait_until(refused, 120, f"{other} has refused a task")
        drain([other])
        for node in nodes.nodes[:-1]:
            nodes.resume(node)
        task = self.states(nodes, out)["render"]["tasks"][int(refused()[0]) - 1]
        if "renderer" not in (out / f"farm/render/log/{refused()[0]}.txt").read_text():
            sys.exit(f"the refusal doesn't name the renderer: {task}")
        nodes.wait_until_idle(200)
        if not self.states(nodes, out)["render"]["whole"]:
            self.submit(nodes, out, ["render"])
            nodes.wait_until_idle(200)
        nodes.resume(other)
        self.require_clip(out)
        print(f"a node with another renderer was refused: {task['state']}, {task['reason']}")

    def prove_cancelling(self, nodes):
        """What the user cancels stays cancelled; the same command sends the rest."""
        out = self.folder / "cancelled"
        self.submit(nodes, out, ["render"])
        nodes.wait_until((out / "clip/frames.manifest").exists, 60, "the first part has begun")
        nodes.run("scancel", "-u", "root")
        nodes.wait_until_idle(60)
        plan = self.states(nodes, out)["render"]
        if plan["whole"] or not plan["failed"]:
            sys.exit(f"what was cancelled went on: {json.dumps(plan, indent=1)}")
        reasons = {task["reason"].split(":")[0] for task in plan["tasks"] if task["reason"]}
        if reasons != {"CANCELLED"}:
            sys.exit(f"other failures than cancelled ones: {reasons}")
        text = self.submit(nodes, out, ["render"])[0]
        nodes.wait_until_idle(200)
        self.require_clip(out)
        print("cancelled, and sent again: " + text.splitlines()[0])

    def prove_requeue_by_command(self, nodes):
        """A cluster whose RequeueExit has no 75 tries tasks again, too."""
        out = self.folder / "by-command"
        self.submit(nodes, out, ["render"])
        nodes.wait_until((out / "clip/frames.manifest").exists, 60, "the first part has begun")
        killed = 0
        while not killed and not nodes.is_idle():
            for row in nodes.jobs():
                killed += row[2] == "RUNNING" and len(self.processes_of(row[4]))
                self.kill_task(nodes, row[4], row[3])
                if killed:
                    break
        nodes.wait_until_idle(200)
        restarts = nodes.run("scontrol", "-o", "show", "job").count("Restarts=1")
        if not killed or not restarts:
            sys.exit(f"{killed} killed and {restarts} tried again, where scontrol does it")
        self.require_clip(out)
        print(f"without RequeueExit, {restarts} killed task was tried again by scontrol")

    def require_clip(self, out):
        for name in ("clip.mp4", "clip.csv", "clip/frames.manifest", "clip/frames.xxh128"):
            if not filecmp.cmp(out / name, self.one / name, shallow=False):
                sys.exit(f"{out / name} differs from that of one process")

    def measure(self, nodes, seconds=20, tasks=12):
        """Prints the wall time of equal sleeping tasks over that of a perfect split."""
        out = self.folder / "asleep"
        frames = 240
        self.call("submit", "render", self.scene("render"), "-o", out, "--plan", "list", "--chunk",
                  frames // tasks)
        (out / "farm/render/tasks.txt").write_text(f"sleep {seconds}\n" * tasks)
        begin = time.monotonic()
        text = self.call("submit", "render", self.scene("render"), "-o", out, "--slurm",
                         environment=nodes.environment)
        array = text.split(" as job ")[1].split()[0]
        over = ("COMPLETED", "FAILED")
        nodes.wait_until(lambda: all(row[2] in over for row in nodes.jobs() if row[0] == array),
                         600, "all sleep")
        wall = time.monotonic() - begin
        perfect = seconds * tasks / len(nodes.nodes)
        print(f"{tasks} tasks of {seconds} s on {len(nodes.nodes)} nodes of one core: {wall:.1f} s "
              f"from before the submission, {wall / perfect:.3f} of the perfect split")
        subprocess.run(["scancel", "-u", "root"], env=nodes.environment, check=False)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--kills", type=int, default=10)
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(10**6))
    parser.add_argument("--benchmark", action="store_true", help="measure the wall time instead")
    arguments = parser.parse_args()
    reason = cluster.lacking()
    if reason:
        print(f"skipped: {reason}")
        sys.exit(SKIPPED)
    print(f"seed {arguments.seed}", flush=True)
    with tempfile.TemporaryDirectory(prefix="rotatebook-slurm-") as folder:
        proof = Proof(arguments.program, pathlib.Path(folder).resolve(), arguments.seed)
        with cluster.Cluster(pathlib.Path(folder) / "cluster", nodes=4) as nodes:
            if arguments.benchmark:
                proof.measure(nodes)
                return
            proof.make_alone()
            proof.prove_kills(nodes, arguments.kills)
            proof.prove_refusal(nodes)
            proof.prove_cancelling(nodes)
        with cluster.Cluster(pathlib.Path(folder) / "other", nodes=2, requeue_exit="99") as nodes:
            proof.prove_requeue_by_command(nodes)


if __name__ == "__main__":
    main()
