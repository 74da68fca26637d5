"""A Slurm cluster of several nodes on this machine, for tests: without systemd, control groups and
accounting, bound to 127.0.0.1, started and stopped by whoever uses it. Needs root."""
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import time

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol", "sinfo", "scancel")
CONTROLLER_PORT = 16817
OVER = {"COMPLETED", "FAILED", "CANCELLED", "TIMEOUT", "NODE_FAIL", "OUT_OF_MEMORY", "DEADLINE",
        "BOOT_FAIL", "REVOKED", "PREEMPTED"}

# A job that is put into the queue again waits for a second more than cred_expire, whose least is 5.
CONF = """ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool/%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/log/slurmctld.log
SlurmdLogFile={folder}/log/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,bf_interval=1,batch_sched_delay=0
SlurmdParameters=config_overrides
ReturnToService=2
SlurmdTimeout=6
BatchStartTimeout=5
MinJobAge=3600
KillWait=2
JobRequeue=1
RequeueExit={requeue_exit}
DependencyParameters=kill_invalid_depend
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
"""


def lacking():
    """Says why there can be no cluster here; empty if there can."""
    missing = [name for name in PROGRAMS if shutil.which(name) is None]
    if missing:
        return f"there is no {missing[0]}: scripts/setup.sh slurm"
    if os.geteuid() != 0:
        return "only root can start the nodes of a cluster"
    try:
        if not socket.gethostbyname(socket.gethostname()).startswith("127."):
            return "the machine's name isn't an address of its own (127.x in /etc/hosts)"
    except OSError:
        return "the machine's name has no address; add it to /etc/hosts"
    with socket.socket() as port:
        if port.connect_ex(("127.0.0.1", CONTROLLER_PORT)) == 0:
            return f"port {CONTROLLER_PORT} is in use, by another cluster"
    return ""


def is_held(row):
    """The cluster has given it up, as after five losses of its node (JobHoldMaxRequeue)."""
    return row[2] in ("REQUEUE_HOLD", "SPECIAL_EXIT") or (
        row[2] == "PENDING" and ("requeued" in row[5] or row[5] == "JobHoldMaxRequeue"))


def is_alive(pid):
    try:
        state = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0]
    except (OSError, IndexError):
        return False
    return state != "Z"


class Cluster:
    """Nodes n1, n2 ... of `cpus` processors each, in the partition main."""

    def __init__(self, folder, nodes, cpus=1, requeue_exit="75"):
        self.folder = pathlib.Path(folder).resolve()
        self.nodes = [f"n{i + 1}" for i in range(nodes)]
        self.environment = dict(os.environ, SLURM_CONF=str(self.folder / "slurm.conf"))
        for name in ("state", "log", "spool"):
            (self.folder / name).mkdir(parents=True, exist_ok=True)
        host = socket.gethostname().split(".")[0]
        conf = CONF.format(host=host, port=CONTROLLER_PORT, folder=self.folder,
                           requeue_exit=requeue_exit)
        for number, node in enumerate(self.nodes, CONTROLLER_PORT + 4):
            conf += (f"NodeName={node} NodeHostname={host} NodeAddr=127.0.0.1 Port={number} "
                     f"CPUs={cpus} RealMemory=1000 State=UNKNOWN\n")
        conf += "PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP\n"
        (self.folder / "slurm.conf").write_text(conf)
        # Without it slurmd ends where /sys/fs/cgroup isn't mounted.
        (self.folder / "cgroup.conf").write_text("CgroupPlugin=cgroup/v1\nCgroupAutomount=no\n")
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)

    def __enter__(self):
        folder = self.folder
        self.run("munged", f"--key-file={folder}/munge.key", f"--socket={folder}/munge.socket",
                 f"--pid-file={folder}/munged.pid", f"--seed-file={folder}/munged.seed",
                 f"--log-file={folder}/log/munged.log", "--force")
        self.run("slurmctld")
        try:
            for node in self.nodes:
                self.start_node(node)
            self.wait_until(lambda: self.idle_nodes() == len(self.nodes), 60, "all nodes are idle")
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        """Stops what was started, by its process's number, and waits for it."""
        try:
            subprocess.run(["scancel", "-u", "root"], env=self.environment, timeout=20,
                           check=False, capture_output=True)
        except subprocess.TimeoutExpired:
            pass
        time.sleep(0.5)
        for name in [f"slurmd-{node}" for node in self.nodes] + ["slurmctld", "munged"]:
            pid = self.pid(name)
            if pid is None or not is_alive(pid):
                continue
            os.kill(pid, signal.SIGTERM)
            deadline = time.monotonic() + 15
            while is_alive(pid) and time.monotonic() < deadline:
                time.sleep(0.05)
            if is_alive(pid):
                os.kill(pid, signal.SIGKILL)

    def run(self, *command, **settings):
        """Runs a command to its end, and returns what it printed."""
        return subprocess.run(command, env=self.environment, check=True, text=True, timeout=60,
                              stdout=subprocess.PIPE, **settings).stdout

    def ask(self, *command):
        """Runs what may be run again, as a controller that is busy doesn't answer in time."""
        for _ in range(3):
            try:
                return self.run(*command)
            except subprocess.CalledProcessError:
                time.sleep(1)
        return self.run(*command)

    def pid(self, name):
        try:
            return int((self.folder / f"{name}.pid").read_text())
        except (OSError, ValueError):
            return None

    def start_node(self, node, **environment):
        subprocess.run(["slurmd", "-N", node], env=self.environment | environment, check=True,
                       timeout=60)

    def stop_node(self, node, number=signal.SIGTERM):
        """Stops a slurmd; what runs there goes on."""
        pid = self.pid(f"slurmd-{node}")
        if pid is None or not is_alive(pid):
            return
        os.kill(pid, number)
        self.wait_until(lambda: not is_alive(pid), 20, f"{node} has stopped")

    def start_tasks(self, start):
        """Has what is submitted begin, or wait."""
        self.ask("scontrol", "update", "partitionname=main", f"state={'up' if start else 'down'}")

    def drain(self, *nodes):
        """Has these nodes begin no other task."""
        for node in nodes:
            self.ask("scontrol", "update", f"nodename={node}", "state=drain", "reason=later")

    def restore(self):
        """Has all nodes work, as whoever looks after a cluster does."""
        for node in self.nodes:
            pid = self.pid(f"slurmd-{node}")
            if pid is None or not is_alive(pid):
                self.start_node(node)
            self.resume(node)

    def resume(self, node):
        """Takes a node that was set down or drained back; one that came back by itself stays."""
        subprocess.run(["scontrol", "update", f"nodename={node}", "state=resume"], check=False,
                       env=self.environment, capture_output=True, timeout=60)

    def idle_nodes(self):
        return self.ask("sinfo", "-h", "-N", "-o", "%T").split().count("idle")

    def jobs(self):
        """Rows of job, task, state, node, number of the process's job, and why it waits."""
        lines = self.ask("squeue", "-h", "-r", "-t", "all", "-o", "%F|%K|%T|%N|%A|%r").splitlines()
        return [line.split("|") for line in lines]

    def running(self):
        return [row for row in self.jobs() if row[2] == "RUNNING"]

    def is_idle(self):
        return all(row[2] in OVER for row in self.jobs())

    def is_settled(self):
        """Nothing goes on by itself: all is over, or held, or waits for what is held."""
        rows = [row for row in self.jobs() if row[2] not in OVER]
        held = [row for row in rows if is_held(row)]
        return not rows or bool(held) and all(
            row in held or row[5] == "Dependency" for row in rows)

    def wait_until(self, condition, seconds, what):
        deadline = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > deadline:
                raise TimeoutError(f"not within {seconds} s: {what}\n{self.logs()}")
            time.sleep(0.1)

    def logs(self):
        """What there is to say about jobs that aren't over, about nodes, and by the controller."""
        text = ""
        for command in (["squeue", "-r", "-o", "%F|%K|%T|%N|%A|%r|%E"], ["sinfo", "-N", "-l"]):
            text += subprocess.run(command, env=self.environment, text=True, timeout=60,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   check=False).stdout
        daemons = [f"slurmd-{node}" for node in self.nodes] + ["slurmctld", "munged"]
        gone = [name for name in daemons if not is_alive(self.pid(name) or 0)]
        text += f"not running: {' '.join(gone) or 'none'}\n"
        try:
            lines = (self.folder / "log/slurmctld.log").read_text(errors="replace").splitlines()
        except OSError:
            lines = []
        return text + "\n".join(lines[-40:])
