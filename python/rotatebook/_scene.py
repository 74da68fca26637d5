"""Scenes, and their motions as arrays on the core's memory."""

from __future__ import annotations

import os
import pathlib
from typing import Any, Callable, Iterator, Mapping, Optional, Sequence, Union, overload

import numpy as np
import numpy.typing as npt

from ._core import Context
from ._errors import SceneError

Path = Union[str, "os.PathLike[str]"]
Numbers = npt.NDArray[np.float64]
Progress = Callable[[int, int], None]  # Called with what is done, and with how much there is.

_CORE_FILES = {"file", "mesh", "words"}  # The last parts of keys that name files which the core reads.
_FILES = _CORE_FILES | {"front", "spine", "back"}


def _names_in(tree: Any, keys: set[str]) -> Iterator[str]:
    """Yields the files that a scene's tree names by such keys."""
    if isinstance(tree, list):
        for value in tree:
            yield from _names_in(value, keys)
    elif isinstance(tree, dict):
        for key, value in tree.items():
            if isinstance(value, str) and key.rsplit(".")[-1] in keys:
                yield value
            yield from _names_in(value, keys)


class Scene:
    """A scene that is read and checked. Throws SceneError, with line and column, for one that isn't valid."""

    def __init__(self, text: str, *, folder: Optional[Path] = None, name: str = "scene") -> None:
        """Reads the TOML `text`. The files that it names are looked for in `folder`, and nowhere else."""
        if name != os.path.basename(name) or not name:
            raise ValueError(f"a scene's name, which its files get, has no slash and isn't empty, unlike {name!r}")
        if not isinstance(text, str) or text.endswith(".toml") and "\n" not in text:
            given = text if isinstance(text, str) else f"a {type(text).__name__}"
            raise TypeError(f"Scene() takes TOML, not {given}; Scene.from_file() reads a file, Scene.from_dict() takes tables")
        self.text = text
        self.folder = pathlib.Path(folder or ".")
        self.name = name
        self.file: Optional[pathlib.Path] = None
        self._open()  # Refuses it at once.

    @classmethod
    def from_file(cls, file: Path) -> Scene:
        """Reads a scene file."""
        path = pathlib.Path(file)
        try:
            text = path.read_text(encoding="utf-8")
        except UnicodeDecodeError as error:
            raise SceneError(f"{path}: it isn't UTF-8: {error}") from None
        scene = cls(text, folder=path.parent, name=path.stem)
        scene.file = path
        return scene

    @classmethod
    def from_dict(cls, tree: Mapping[str, Any], *, folder: Optional[Path] = None, name: str = "scene") -> Scene:
        """Takes a scene as the tables of its TOML."""
        if not isinstance(tree, Mapping):
            raise TypeError(f"a scene's tables are a dict, not a {type(tree).__name__}")
        return cls(Context(f"{name}.toml").text_of(tree), folder=folder, name=name)

    def to_dict(self) -> dict[str, Any]:
        """Returns the scene as it is written, without defaults."""
        tree: dict[str, Any] = self._context().tree_of(self.text)
        return tree

    def whole_text(self) -> str:
        """Returns the scene as TOML with each default written out."""
        return self._open()[0].whole_text()

    def spin(self, motion: int = 0) -> dict[str, Any]:
        """Returns what follows from the spin that a motion starts with: its axis, when it flips, and so on."""
        context, read = self._open()
        if not 0 <= motion < len(read["motions"]):
            raise IndexError(f"there is no motion {motion}; the scene has {len(read['motions'])}, counted from 0")
        spin: dict[str, Any] = context.spin(motion)
        return spin

    def simulate(self, progress: Optional[Progress] = None) -> Simulation:
        """Simulates the scene's motions. Ctrl-C is answered between slices of some 20 ms."""
        context, read = self._open()
        for frames in context.simulate():
            if progress is not None:
                progress(frames, context.frames)
        return Simulation(context, read)

    def files(self) -> dict[str, bytes]:
        """Returns the files that it names, those that there are in its folder, by name."""
        return self._files(_FILES)

    def _files(self, keys: set[str]) -> dict[str, bytes]:
        files = {}
        root = self.folder.resolve()
        for name in _names_in(self._context().tree_of(self.text), keys):
            path = (root / name).resolve()
            if root in path.parents and path.is_file():
                files[name] = path.read_bytes()
        return files

    def _context(self, files: Mapping[str, bytes] = {}) -> Context:
        return Context(f"{self.name}.toml", files)

    def _open(self) -> tuple[Context, Any]:
        context = self._context(self._files(_CORE_FILES))
        return context, context.read(self.text)

    def __repr__(self) -> str:
        return f"<Scene {self.name}>"


class _Block:
    """A motion's samples on the core's memory, which stays as long as an array that was made of them."""

    def __init__(self, context: Context, motion: int) -> None:
        self._context = context
        address, count = context.samples(motion)
        layout = context.layout()
        fields = layout["fields"]
        self.dtype = np.dtype({
            "names": list(fields),
            "formats": [(field["type"], tuple(field["shape"])) for field in fields.values()],
            "offsets": [field["offset"] for field in fields.values()], "itemsize": layout["size"]})
        self.__array_interface__ = {"version": 3, "shape": (count,), "typestr": f"|V{layout['size']}",
                                    "data": (address, True)}  # Read-only.


class Motion:
    """A motion: a row of `samples` for each frame, in SI units, along the world's axes.

    The fields are arrays on the core's memory, without a copy, and read-only:
    time, attitude (a unit quaternion, world from body, in SciPy's order x, y, z, w),
    angular_velocity, angular_momentum, kinetic, potential, rotational (energies), tilt_deg, flips,
    stretch_min, stretch_max, error_deg (the angle to the exact motion), regime, corners.
    """

    def __init__(self, context: Context, index: int, read: Mapping[str, Any]) -> None:
        block = _Block(context, index)
        self.samples: npt.NDArray[Any] = np.asarray(block).view(block.dtype)
        self.label: str = read["label"]
        self.model: str = read["model"]
        self.size = np.array(read["body"], dtype=np.float64)
        self.moments = np.array(read["moments"], dtype=np.float64)

    def __getattr__(self, name: str) -> Numbers:
        samples: Optional[npt.NDArray[Any]] = self.__dict__.get("samples")  # None in a copy that is being made.
        if samples is None or name not in (samples.dtype.names or ()):
            raise AttributeError(f"a motion has no {name}")
        field: Numbers = samples[name]
        return field

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *(self.samples.dtype.names or ())]

    def __len__(self) -> int:
        return len(self.samples)

    def __repr__(self) -> str:
        return f"<Motion {self.label or self.model}: {len(self)} samples, {int(self.samples['flips'][-1])} flips>"


class Simulation(Sequence[Motion]):
    """A scene's motions, which are all simulated.

    `checksum` is that of a clip's record, `table_checksum` that of the motions' CSV tables; `rate` is
    the number of frames a second.
    """

    def __init__(self, context: Context, read: Mapping[str, Any]) -> None:
        self.checksum = context.checksum()
        self._context = context
        self.rate = read["rate"][0] / read["rate"][1]
        self._motions = tuple(Motion(context, index, motion) for index, motion in enumerate(read["motions"]))

    @property
    def table_checksum(self) -> str:
        return self._context.table_checksum()

    @overload
    def __getitem__(self, index: int) -> Motion: ...

    @overload
    def __getitem__(self, index: slice) -> Sequence[Motion]: ...

    def __getitem__(self, index: Union[int, slice]) -> Union[Motion, Sequence[Motion]]:
        return self._motions[index]

    def __len__(self) -> int:
        return len(self._motions)

    def __repr__(self) -> str:
        return f"<Simulation {self.checksum}: {', '.join(map(repr, self))}>"
