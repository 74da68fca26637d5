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
book.color = "#2b5d8a"
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
x = { key = "initial.tilt.0", values = [0.1, 0.01, 0.001] }
measure = ["half_turns"]
"""
WORKS = {"render": "clip", "map": "grid", "study": "sweep"}
CHUNKS = {"render": ["--chunk", "24"], "map": ["--chunk", "3"], "study": []}


SECONDS_OF_A_KILL = 6


def send(pid, number):
    """Returns whether the process was there."""
    try:
        os.kill(pid, number)
    except ProcessLookupError:
        return False
    return True


class Proof:
    def __init__(self, program, folder, seed):
        self.program = pathlib.Path(program).resolve()
        self.folder = folder
        self.random = random.Random(seed)
        self.lost = 0
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

    def submit(self, nodes, out):
        return [self.call("submit", work, self.scene(work), "-o", out, "--slurm", *CHUNKS[work],
                          environment=nodes.environment) for work in WORKS]

    def submit_clip(self, nodes, out, **settings):
        """Submits the clip in fewer parts; returns the first line that is printed."""
        environment = nodes.environment | settings
        return self.call("submit", "render", self.scene("render"), "-o", out, "--slurm", "--chunk",
                         48, environment=environment).splitlines()[0]

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

    # Each returns whether there was something to kill.

    def kill_task(self, _, job, __):
        return any([send(pid, signal.SIGKILL) for pid in self.processes_of(job)])

    def kill_supervisor(self, nodes, job, node):
        """What it looked after goes on. The cluster notices within 40 s, once; later ones' nodes
        are set down, as there isn't time, and as it holds a task that it loses five times."""
        hit = False
        for entry in pathlib.Path("/proc").iterdir():
            try:
                words = (entry / "cmdline").read_bytes()
            except OSError:
                continue
            if words.startswith(f"slurmstepd: [{job}.".encode()):
                hit = send(int(entry.name), signal.SIGKILL) or hit
        if hit and self.lost:
            self.kill_node(nodes, job, node)
        self.lost += hit
        return hit

    def kill_daemon(self, nodes, _, node):
        """What ran there may go on, beside the copy that the cluster starts again."""
        nodes.stop_node(node, signal.SIGKILL)
        time.sleep(self.random.choice([0.5, 8]))
        nodes.start_node(node)
        return True

    def kill_node(self, nodes, _, node):
        nodes.ask("scontrol", "update", f"nodename={node}", "state=down", "reason=test")
        time.sleep(1)
        nodes.resume(node)
        return True

    def kill_one(self, nodes):
        """Kills something of a task that runs; returns what, or nothing if there was nothing."""
        running = nodes.running()
        self.random.shuffle(running)
        for array, task, _, node, job, _ in running:
            kill = self.random.choice(
                [self.kill_task, self.kill_supervisor, self.kill_daemon, self.kill_node])
            if kill(nodes, job, node):
                return f"{kill.__name__} {array}_{task} on {node}"
        return ""

    def run_twice(self, out):
        """Starts the clip's first task, which the cluster runs too."""
        line = (out / "farm/render/tasks.txt").read_text().splitlines()[0]
        return subprocess.Popen(["sh", "-c", line], stdout=subprocess.DEVNULL,
                                stderr=subprocess.DEVNULL)

    def run_round(self, nodes, out, kills, deadline):
        """Submits all; returns the number of kills until all was done."""
        nodes.start_tasks(False)
        self.submit(nodes, out)
        nodes.start_tasks(True)
        twin = self.run_twice(out)
        killed = 0
        while killed < kills and time.monotonic() < deadline and not nodes.is_settled():
            time.sleep(self.random.uniform(0, 2))
            what = self.kill_one(nodes)
            if what:
                killed += 1
                print(f"  {what}", flush=True)
        nodes.restore()
        if twin.wait(timeout=120) not in (0, 75):
            sys.exit(f"the task that ran twice ended with {twin.returncode}")
        nodes.wait_until(nodes.is_settled, 120, "all jobs have ended, or are held")
        # What was given up after too many failures is sent once more, and nothing else.
        if not all(plan["whole"] for plan in self.states(nodes, out).values()):
            print("  submitted again: " + " | ".join(
                text.replace("\n", "; ") for text in self.submit(nodes, out)))
            nodes.wait_until(nodes.is_idle, 100, "all jobs have ended")
        for work, plan in self.states(nodes, out).items():
            if not plan["whole"]:
                sys.exit(f"{work} isn't whole: {json.dumps(plan, indent=1)}\n{nodes.logs()}")
        for text in self.submit(nodes, out):
            if "nothing was sent" not in text:
                sys.exit(f"what is done was sent again: {text}")
        return killed

    def prove_kills(self, nodes, kills):
        """On a slow machine there may be fewer kills: the time for them is bounded."""
        killed = rounds = 0
        deadline = time.monotonic() + SECONDS_OF_A_KILL * kills
        while killed < kills and (time.monotonic() < deadline or not killed and rounds < 5):
            out = self.folder / f"many{rounds}"
            killed += self.run_round(nodes, out, kills - killed, deadline)
            files = self.require_same(out)
            shutil.rmtree(out)
            rounds += 1
        if not killed:
            sys.exit(f"nothing was killed in {rounds} rounds")
        print(f"{killed} kills in {rounds} rounds, each in the end {files} files, byte for byte "
              "those of one process")

    def begin_clip(self, nodes, out, **settings):
        """Submits the clip to one node, so that most is still to do once its first part runs."""
        nodes.drain(*nodes.nodes[1:])
        self.submit_clip(nodes, out, **settings)
        nodes.wait_until((out / "clip/frames.manifest").exists, 60, "the first part has begun")

    def prove_refusal(self, nodes):
        """The last node draws by another renderer: its tasks are refused, and said."""
        out, other = self.folder / "mixed", nodes.nodes[-1]
        # Each job's shell reads it.
        rule = self.folder / "renderer.sh"
        rule.write_text(f'[ "$SLURMD_NODENAME" != {other} ] || export LP_NATIVE_VECTOR_WIDTH=128\n')
        self.begin_clip(nodes, out, BASH_ENV=str(rule))
        nodes.drain(nodes.nodes[0])
        nodes.resume(other)

        def refused():
            ends = out.glob("farm/render/ends/[0-9]*")
            return [end.name for end in ends if end.read_text().split()[:2] == ["2", other]]
        nodes.wait_until(refused, 60, f"{other} has refused a task")
        nodes.drain(other)
        task = self.states(nodes, out)["render"]["tasks"][int(refused()[0]) - 1]
        if "renderer" not in (out / f"farm/render/log/{refused()[0]}.txt").read_text():
            sys.exit(f"the refusal doesn't name the renderer: {task}")
        for node in nodes.nodes[:-1]:
            nodes.resume(node)
        nodes.wait_until(nodes.is_idle, 100, "all jobs have ended")
        if not self.states(nodes, out)["render"]["whole"]:
            self.submit_clip(nodes, out)
            nodes.wait_until(nodes.is_idle, 100, "all jobs have ended")
        nodes.resume(other)
        self.require_clip(out)
        print(f"a node with another renderer was refused: {task['state']}, {task['reason']}",
              flush=True)

    def prove_cancelling(self, nodes):
        """What the user cancels stays cancelled; the same command sends the rest."""
        out = self.folder / "cancelled"
        self.begin_clip(nodes, out)
        nodes.run("scancel", "-u", "root")
        nodes.restore()
        nodes.wait_until(nodes.is_idle, 60, "all jobs have ended")
        plan = self.states(nodes, out)["render"]
        if plan["whole"] or not plan["failed"]:
            sys.exit(f"what was cancelled went on: {json.dumps(plan, indent=1)}")
        reasons = {task["reason"].split(":")[0] for task in plan["tasks"] if task["reason"]}
        if reasons != {"CANCELLED"}:
            sys.exit(f"other failures than cancelled ones: {reasons}")
        text = self.submit_clip(nodes, out)
        nodes.wait_until(nodes.is_idle, 100, "all jobs have ended")
        self.require_clip(out)
        print("cancelled, and sent again: " + text, flush=True)

    def submit_with(self, nodes, out, rule):
        """Submits the clip, whose first task's shell does what the rule says at its first try."""
        file = self.folder / "first-try.sh"
        file.write_text('if [ "$SLURM_ARRAY_TASK_ID$SLURM_RESTART_COUNT" = 1 ]; then\n'
                        f"{rule}\nfi\n")
        self.submit_clip(nodes, out, BASH_ENV=str(file))

    def prove_holding(self, nodes):
        """What the cluster gives up counts as failed; the same command sends it again."""
        out = self.folder / "held"
        self.submit_with(nodes, out, "sleep 600")

        def waits():
            return [row[4] for row in nodes.running() if row[1] == "1"]
        nodes.wait_until(waits, 60, "the first task runs")
        nodes.ask("scontrol", "requeuehold", waits()[0])
        nodes.wait_until(nodes.is_settled, 100, "all jobs have ended, but for one that is held")
        plan = self.states(nodes, out)["render"]
        reasons = [task["reason"] for task in plan["tasks"] if task["state"] == "failed"]
        if len(reasons) != 1 or not reasons[0].startswith("held by the cluster"):
            sys.exit(f"not one task is held: {json.dumps(plan, indent=1)}\n{nodes.logs()}")
        text = self.submit_clip(nodes, out)
        nodes.wait_until(nodes.is_idle, 100, "all jobs have ended")
        self.require_clip(out)
        print(f"{reasons[0].split(':')[0]}, and sent again: {text}", flush=True)

    def prove_requeue_by_command(self, nodes):
        """A cluster whose RequeueExit has no 75 tries tasks again, too."""
        out = self.folder / "by-command"
        self.submit_with(nodes, out, "(until pkill -KILL -x -P $$ rotatebook; do :; done) &")
        nodes.wait_until(nodes.is_idle, 100, "all jobs have ended")
        restarts = nodes.ask("scontrol", "-o", "show", "job").count("Restarts=1")
        if restarts != 1:
            sys.exit(f"{restarts} tasks were tried again, of one killed\n{nodes.logs()}")
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
            proof.prove_holding(nodes)
        with cluster.Cluster(pathlib.Path(folder) / "other", nodes=2, requeue_exit="99") as nodes:
            proof.prove_requeue_by_command(nodes)


if __name__ == "__main__":
    main()
