"""The core's functions of C, by ctypes, which gives the interpreter's lock back while one runs."""

from __future__ import annotations

import ctypes
import functools
import json
import math
import pathlib
import time
import weakref
from typing import Any, Iterator, Mapping

from ._errors import SceneError

BUFFER = 1 << 20  # Of a context, unless a file is longer. [bytes]
SLICE = 0.02  # How long a call of the core is to take, so that Ctrl-C is soon answered. [s]
MOST = 2**31 - 1


@functools.lru_cache(maxsize=None)
def _library() -> ctypes.CDLL:
    library = ctypes.CDLL(str(pathlib.Path(__file__).with_name("librotatebook_c.so")))
    number, address = ctypes.c_int32, ctypes.c_void_p
    for name, result, arguments in (
            ("new", address, [number, number]), ("delete", None, [address]), ("buffer", address, [address]),
            ("toml_to_json", number, [address, number]), ("json_to_toml", number, [address, number]),
            ("file", number, [address, number, number]), ("read", number, [address, number, number]),
            ("scene_text", number, [address, number]), ("advance", number, [address, number, number, number]),
            ("message", number, [address]), ("frames", number, [address, number]),
            ("samples", address, [address, number, number, ctypes.POINTER(number)]),
            ("sample_layout", number, [address]), ("checksum", number, [address, number]),
            ("table_checksum", number, [address, number]), ("spin", number, [address, number, number])):
        function = getattr(library, "rb_" + name)
        function.restype, function.argtypes = result, arguments
    return library


def _plain(value: Any) -> Any:
    """Returns NumPy's arrays and numbers as Python's own."""
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"a scene's tables can't hold {value!r}")


def _leaves(value: Any, key: str, holders: tuple[Any, ...] = ()) -> Iterator[tuple[str, Any]]:
    """Yields the values in a scene's tree that hold no others, with their keys: ("initial.tilt[0]", 0.1)."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if any(value is holder for holder in holders):
        raise ValueError(f"{key} holds itself, which no table of a scene can")
    if isinstance(value, Mapping):
        for name, item in value.items():
            yield from _leaves(item, f"{key}.{name}" if key else str(name), (*holders, value))
    elif isinstance(value, (list, tuple)):
        for index, item in enumerate(value):
            yield from _leaves(item, f"{key}[{index}]", (*holders, value))
    else:
        yield key, value


class Context:
    """A scene and its motions in the core. One thread at a time uses it."""

    def __init__(self, name: str, files: Mapping[str, bytes] = {}) -> None:
        """Takes the files that the scene names; messages call the scene `name`."""
        self._name = name
        size = max([BUFFER] + [len(file.encode()) + len(content) for file, content in files.items()])
        self._handle = _library().rb_new(MOST, size)
        if not self._handle:
            raise MemoryError("there is no memory for a scene")
        weakref.finalize(self, _library().rb_delete, self._handle).atexit = False
        self._size = size
        for file, content in files.items():
            self._put(file.encode() + content)
            self._text("file", len(file.encode()), len(content))

    def _call(self, name: str, *values: Any) -> Any:
        return getattr(_library(), "rb_" + name)(self._handle, *values)

    def _put(self, content: bytes) -> int:
        if len(content) > self._size:
            raise SceneError(f"{self._name}: longer than {self._size} bytes")
        ctypes.memmove(self._call("buffer"), content, len(content))
        return len(content)

    def _text(self, name: str, *values: Any) -> str:
        """Returns the text that a function answers. Throws SceneError with the message that it answers."""
        length = self._call(name, *values)
        text = ctypes.string_at(self._call("buffer"), abs(length)).decode()
        if length < 0:
            raise SceneError.of(text, "scene.toml", self._name)
        return text

    def tree_of(self, text: str) -> Any:
        return json.loads(self._text("toml_to_json", self._put(text.encode())))

    def text_of(self, tree: Mapping[str, Any]) -> str:
        for key, value in _leaves(tree, ""):
            if value is None:
                raise SceneError(f"{self._name}: {key} is None, which a scene doesn't know; leave the key out")
            if isinstance(value, float) and not math.isfinite(value):
                raise SceneError(f"{self._name}: {key} is {value}, which is no number of a scene")
        text = json.dumps(tree, default=_plain)
        return self._text("json_to_toml", self._put(text.encode()))

    def read(self, text: str) -> Any:
        return json.loads(self._text("read", 0, self._put(text.encode())))

    def whole_text(self) -> str:
        return self._text("scene_text", 0)

    def spin(self, motion: int) -> Any:
        return json.loads(self._text("spin", 0, motion))

    def checksum(self) -> str:
        return self._text("checksum", 0)

    def table_checksum(self) -> str:
        return self._text("table_checksum", 0)

    @property
    def frames(self) -> int:
        return int(self._call("frames", 0))

    def advance(self, steps: int) -> int:
        """Returns the frames so far, after at least one frame and about so many steps more."""
        frames = int(self._call("advance", 0, MOST, steps))
        if frames < 0:
            raise SceneError.of(self._text("message"), "scene.toml", self._name)
        return frames

    def simulate(self) -> Any:
        """Simulates to the end in slices; yields the frames so far after each."""
        steps = 10_000
        frames = 0
        while frames < self.frames:
            start = time.perf_counter()
            frames = self.advance(steps)
            taken = time.perf_counter() - start
            steps = int(min(max(steps * min(SLICE / max(taken, 1e-6), 4), 1), 1e9))
            yield frames

    def samples(self, motion: int) -> tuple[int, int]:
        """Returns the address of a motion's samples, and how many there are."""
        count = ctypes.c_int32()
        address = self._call("samples", 0, motion, ctypes.byref(count))
        if not address:
            raise IndexError(f"there is no motion {motion}")
        return address, count.value

    def layout(self) -> Any:
        return json.loads(self._text("sample_layout"))
