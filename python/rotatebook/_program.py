"""What the program does: it is run, and its JSON is taken."""

from __future__ import annotations

import base64
import contextlib
import hashlib
import html
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
from typing import Any, Iterator, Mapping, NoReturn, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from ._errors import Error, ProgramError, SceneError
from ._scene import Motion, Path, Progress, Scene

Report = dict[str, Any]
Options = Mapping[str, Any]

_PATIENCE = 0.02  # How long an interrupted program may take before the caller goes on without it. [s]
_ANSWERS = (0, 1, 4)  # Exit statuses of a run that has a result, good or not.
_KINDS = {".mp4": "video/mp4", ".webm": "video/webm", ".mov": "video/quicktime", ".gif": "image/gif", ".png": "image/png",
          ".apng": "image/apng"}
_WIDTHS = {"time": 1, "attitude": 4, "angular_velocity": 3}  # Of a motion's arrays.
_TABLE = "the table"  # The name in messages of one that arrays are written to.


def program() -> str:
    """Returns the program's path: ROTATEBOOK, or else beside Python's own programs, or on PATH."""
    given = os.environ.get("ROTATEBOOK")
    if given and not shutil.which(given):
        raise Error(f"ROTATEBOOK names {given}, which isn't a program")
    found = given or shutil.which("rotatebook", path=os.path.join(sys.prefix, "bin")) or shutil.which("rotatebook")
    if not found:
        raise Error("there is no program rotatebook on PATH; install it, or name it in ROTATEBOOK")
    return found


def _options(options: Options) -> list[str]:
    """Returns the words of options: size="640x360" is --size 640x360, no_png=True is --no-png, a list is repeated."""
    words = []
    for name, value in options.items():
        option = "--" + name.replace("_", "-")
        for each in value if isinstance(value, (list, tuple)) else [value]:
            if each is True:
                words.append(option)
            elif each is not None and each is not False:
                words += [option, str(each)]
    return words


def _abandon(child: subprocess.Popen[str]) -> None:
    """Interrupts the program, which goes on to its end for itself where that takes longer."""
    child.send_signal(signal.SIGINT)
    try:
        child.wait(_PATIENCE)
    except subprocess.TimeoutExpired:
        threading.Thread(target=child.wait, daemon=True).start()


def _raise(message: str, status: int, words: Sequence[str], names: Mapping[str, str]) -> NoReturn:
    """Throws what the program said, a SceneError if that is about a place in one of the files among `words`."""
    for word in words:
        if re.match(rf"{re.escape(word)}:\d+:\d+: ", message):
            raise SceneError.of(message, word, names.get(word, word))
    for file, name in names.items():
        message = message.replace(file, name)
    raise ProgramError(message, status)


def run(words: Sequence[str], progress: Optional[Progress] = None, *, names: Mapping[str, str] = {}) -> Report:
    """Runs the program with --json; returns its object, whatever it says of bounds that aren't kept.

    `names` are what messages call files. Throws SceneError for a scene that is refused, ProgramError for what else fails. Ctrl-C ends the program.
    """
    command = [program(), *words, "--json", "--progress", "json"]
    said = []
    with tempfile.TemporaryFile("w+") as out:
        # In a session of its own: a terminal's Ctrl-C goes to all of one, and a second signal ends the program at once.
        child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.PIPE, text=True,
                                 start_new_session=True)
        assert child.stderr is not None
        try:
            for line in child.stderr:
                if not line.startswith('{"progress":'):
                    said.append(line)
                elif progress is not None:
                    counts = json.loads(line)
                    progress(counts["done"], counts["total"])
            status = child.wait()
        except BaseException:
            _abandon(child)
            raise
        finally:
            child.stderr.close()
        out.seek(0)
        text = out.read()
    if text.startswith("{") and status in _ANSWERS:
        report: Report = json.loads(text)
        return report
    _raise("".join(said).strip().removeprefix("rotatebook: "), status, words, names)


def _still_has(file: pathlib.Path, text: str) -> bool:
    """Returns whether a file is as it was when `text` was read from it."""
    try:
        return file.read_text(encoding="utf-8") == text
    except (OSError, UnicodeDecodeError):
        return False


@contextlib.contextmanager
def _file_of(scene: Union[Scene, Path]) -> Iterator[tuple[str, dict[str, str]]]:
    """Gives a file of the scene for as long as the program needs it, and what messages call it."""
    if not isinstance(scene, (Scene, str, os.PathLike)):
        raise TypeError(f"a scene is a Scene or a file's name, not a {type(scene).__name__}; Scene.from_dict() takes tables")
    if not isinstance(scene, Scene):
        yield os.fspath(scene), {}
    elif scene.file is not None and _still_has(scene.file, scene.text):
        yield os.fspath(scene.file), {}
    else:
        with tempfile.TemporaryDirectory() as folder:
            for name, content in scene.files().items():
                path = pathlib.Path(folder) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(content)
            file = pathlib.Path(folder) / f"{scene.name}.toml"
            file.write_text(scene.text, encoding="utf-8")
            yield os.fspath(file), {os.fspath(file): file.name}


class Proof:
    """What `verify()` found: `proved`, the `verdict` in a word, and the whole `report`."""

    def __init__(self, report: Report) -> None:
        self.report = report
        self.proved: bool = report["proved"]
        self.verdict: str = report["verdict"]

    def __repr__(self) -> str:
        return f"<Proof: {self.verdict}>"


def _digest(file: pathlib.Path) -> bytes:
    return hashlib.sha256(file.read_bytes()).digest()


class Clip:
    """A video file, which a notebook plays; "proved" stands beneath it only after verify() has proved these bytes."""

    def __init__(self, file: Path, report: Optional[Report] = None) -> None:
        self.file = pathlib.Path(file)
        self.report = report or {}
        self.proof: Optional[Proof] = None
        self._proved = b""  # Digest of the bytes that `proof` is of.

    def verify(self, *, progress: Optional[Progress] = None, **options: Any) -> Proof:
        """Proves that the clip shows its scene; see verify()."""
        before = _digest(self.file)
        self.proof = verify(self.file, progress=progress, **options)
        self._proved = before
        return self.proof

    def _repr_html_(self) -> str:
        content = self.file.read_bytes()
        kind = _KINDS.get(self.file.suffix.lower())
        if kind is None:
            return f"<code>{html.escape(str(self.file))}</code>"
        data = f"data:{kind};base64,{base64.b64encode(content).decode()}"
        name = html.escape(self.file.name)
        shown = (f'<video controls loop src="{data}" title="{name}"></video>' if kind.startswith("video")
                 else f'<img src="{data}" alt="{name}">')
        if self.proof is None or hashlib.sha256(content).digest() != self._proved:
            return f"<figure>{shown}</figure>"
        return f"<figure>{shown}<figcaption>{html.escape(self.proof.verdict)}</figcaption></figure>"

    def __repr__(self) -> str:
        return f"<Clip {self.file}>"


def render(scene: Union[Scene, Path], output: Path = "out", *, progress: Optional[Progress] = None,
           **options: Any) -> Clip:
    """Renders a scene to the folder or video `output`, by default without PNG frames.

    Options are the command's, such as size="640x360", overwrite=True, resume=True, set=["clip.fps=30"].
    `progress` is called every second and at the end, with the frames that are done, and how many there are.
    """
    if os.fspath(output) == "-":
        raise ValueError("render() makes a file, to be shown and verified: name a video or a folder, not -, the standard output")
    options = {"no_png": True, **options}
    with _file_of(scene) as (file, names):
        words = ["render", file, "-o", os.fspath(output), *_options(options)]
        report = run(words, progress, names=names)["scenes"][0]
    videos = [name for name in report["files"] if pathlib.Path(name).suffix in _KINDS and not name.endswith(".poster.png")]
    if not videos:
        raise Error(f"the render made no video, but {report['files']}")
    return Clip(videos[0], report)


class Export:
    """An animated file for other programs: where it is, and the whole `report`, with "keys", "error_deg" and "notes"."""

    def __init__(self, report: Report) -> None:
        self.report = report
        self.file = pathlib.Path(report["file"])
        self.notes: list[str] = report["notes"]

    def __repr__(self) -> str:
        return f"<Export {self.file}>"


def export(scene: Union[Scene, Path], output: Optional[Path] = None, **options: Any) -> Export:
    """Writes a motion to `output`, a .glb or .usdz, by default NAME.glb; other options are the command's, such as panel=2, keys=30, tangents=True.

    Returns the file, and what is to be said of it.
    """
    with _file_of(scene) as (file, names):
        place = [] if output is None else ["-o", os.fspath(output)]
        return Export(run(["export", file, *place, *_options(options)], names=names))


def verify(clip: Path, *, progress: Optional[Progress] = None, **options: Any) -> Proof:
    """Proves that a clip shows its scene, by the program; options are the command's, such as all=True."""
    return Proof(run(["verify", os.fspath(clip), *_options(options)], progress))


def _columns_of(given: Mapping[str, Any]) -> list[npt.NDArray[Any]]:
    """Returns a motion's arrays as columns. Throws ValueError if one lacks, or hasn't a row for each time."""
    columns = []
    for name, width in _WIDTHS.items():
        if name not in given:
            if name == "angular_velocity":
                continue
            raise ValueError(f"a motion's arrays are {', '.join(_WIDTHS)}; there is no {name}")
        array = np.asarray(given[name])
        shape = (len(given["time"]), width) if width > 1 else (len(given["time"]),)
        if array.shape != shape:
            raise ValueError(f"{name} has the shape {array.shape}, not {shape}: a row for each time")
        columns.append(array.reshape(-1, width))
    return columns


def _write_table(file: pathlib.Path, motion: Union[Motion, Mapping[str, npt.ArrayLike]]) -> None:
    """Writes the times, attitudes and angular velocities of a motion as a table that the program reads."""
    given: Mapping[str, Any] = ({name: motion.samples[name] for name in ("time", "attitude", "angular_velocity")}
                                if isinstance(motion, Motion) else motion)
    columns = _columns_of(given)
    names = "t (s),qx,qy,qz,qw"
    if "angular_velocity" in given:
        names += ",wx (rad/s),wy (rad/s),wz (rad/s)"
    np.savetxt(file, np.hstack(columns), fmt="%.17g", delimiter=",", header=names, comments="")


def _judge_table(table: pathlib.Path, options: Options) -> Report:
    """Judges a table of arrays; messages name its rows as the arrays count them, from 0."""
    try:
        return run(["judge", str(table), *_options(options)], names={str(table): _TABLE})
    except ProgramError as error:
        # The file's first line has the columns' names
        message = re.sub(rf"^{_TABLE}:(\d+):", lambda line: f"{_TABLE}, row {int(line[1]) - 2}:", str(error))
        raise ProgramError(message, error.status) from None


def judge(motion: Union[Scene, Motion, Path, Mapping[str, npt.ArrayLike]], *,
          inertia: Optional[Sequence[float]] = None, **options: Any) -> Report:
    """Compares a motion with the exact one from the same start.

    `motion` is a scene, a table's file, or arrays of an engine of yours: "time" [s], "attitude" (x, y, z, w,
    world from body), and "angular_velocity" (along the world's axes, rad/s) if it is known. `inertia` is the
    principal moments of a table's body. Options are bounds: max_error_deg=5, max_energy_drift=0.01,
    max_L_drift=0.01, half_turns=True. Returns {"met", "motions": [verdicts]}.
    """
    if isinstance(motion, Motion) and inertia is None:
        inertia = [float(moment) for moment in motion.moments]
    if inertia is not None:
        options["inertia"] = ",".join(repr(float(moment)) for moment in inertia)
    if isinstance(motion, (Motion, Mapping)):
        with tempfile.TemporaryDirectory() as folder:
            table = pathlib.Path(folder) / "motion.csv"
            _write_table(table, motion)
            return _judge_table(table, options)
    with _file_of(motion) as (file, names):
        return run(["judge", file, *_options(options)], names=names)


def toss(recording: Path, **options: Any) -> Report:
    """Finds a body's inertia from the gyroscope that flew with it; options are the command's."""
    return run(["toss", os.fspath(recording), *_options(options)])


def map(scene: Union[Scene, Path], output: Path = "out", *, progress: Optional[Progress] = None,
        **options: Any) -> tuple[Report, npt.NDArray[Any]]:
    """Draws the scene's map into the folder `output`; returns the report, and the values of its pixels."""
    with _file_of(scene) as (file, names):
        report = run(["map", file, "-o", os.fspath(output), *_options(options)], progress, names=names)
        name = pathlib.Path(file).stem
    values: npt.NDArray[Any] = np.load(pathlib.Path(output) / f"{name}.npy")
    return report, values


def study(scene: Union[Scene, Path], output: Path = "out", *, progress: Optional[Progress] = None,
          **options: Any) -> Report:
    """Runs the scene's study, with tables and plots in the folder `output`; returns the report."""
    with _file_of(scene) as (file, names):
        return run(["study", file, "-o", os.fspath(output), *_options(options)], progress, names=names)
