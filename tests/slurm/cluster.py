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
        return f"there is no {missing[0]}: scripts/setup.sh scripts/packages-slurm.txt"
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
        for node in self.nodes:
            self.start_node(node)
        self.wait_until(lambda: self.idle_nodes() == len(self.nodes), 60, "all nodes are idle")
        return self

    def __exit__(self, *_):
        """Stops what was started, by its process's number, and waits for it."""
        subprocess.run(["scancel", "-u", "root"], env=self.environment, timeout=20, check=False,
                       capture_output=True)
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
        return subprocess.run(command, env=self.environment, check=True, text=True, timeout=120,
                              stdout=subprocess.PIPE, **settings).stdout

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

    def resume(self, node):
        """Takes a node that was set down or drained back; one that came back by itself stays."""
        subprocess.run(["scontrol", "update", f"nodename={node}", "state=resume"], check=False,
                       env=self.environment, capture_output=True, timeout=60)

    def idle_nodes(self):
        return self.run("sinfo", "-h", "-N", "-o", "%T").split().count("idle")

    def jobs(self):
        """Rows of job, task, state, node, and number of the process's job."""
        lines = self.run("squeue", "-h", "-r", "-t", "all", "-o", "%F|%K|%T|%N|%A").splitlines()
        return [line.split("|") for line in lines]

    def is_idle(self):
        over = {"COMPLETED", "FAILED", "CANCELLED", "TIMEOUT"}
        return all(row[2] in over for row in self.jobs())

    def wait_until_idle(self, seconds):
        """Waits until all jobs have ended, and does what an operator would: takes nodes back that
        stayed down, and releases jobs that the cluster holds after a start that failed."""
        repaired = time.monotonic()

        def is_idle():
            nonlocal repaired
            if time.monotonic() > repaired + 10:
                self.repair()
                repaired = time.monotonic()
            return self.is_idle()
        self.wait_until(is_idle, seconds, "all jobs have ended")

    def repair(self):
        for line in self.run("sinfo", "-h", "-N", "-o", "%N %T").splitlines():
            node, state = line.split()
            if state.startswith("down"):
                self.resume(node)
        for line in self.run("squeue", "-h", "-r", "-t", "PD", "-o", "%A %r").splitlines():
            job, reason = line.split(maxsplit=1)
            if "held" in reason or "Held" in reason or "Hold" in reason:
                subprocess.run(["scontrol", "release", job], check=False, env=self.environment,
                               capture_output=True, timeout=60)

    def wait_until(self, condition, seconds, what):
        deadline = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > deadline:
                raise TimeoutError(f"not within {seconds} s: {what}\n{self.logs()}")
            time.sleep(0.1)

    def logs(self):
        state = subprocess.run(["squeue", "-r", "-t", "all"], env=self.environment, text=True,
                               capture_output=True, check=False).stdout
        return state + subprocess.run(["sinfo", "-N", "-l"], env=self.environment, text=True,
                                      capture_output=True, check=False).stdout
