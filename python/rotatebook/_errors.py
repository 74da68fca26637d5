"""What is thrown."""

from __future__ import annotations

import re
from typing import NamedTuple, Optional


class Error(Exception):
    """Something that rotatebook refuses, with the message that the program prints."""


class Mistake(NamedTuple):
    """A mistake in a scene, and its place, counted from 1; None if it has none."""

    line: Optional[int]
    column: Optional[int]
    message: str


class SceneError(Error):
    """A scene that is refused: `mistakes` are in it; `line` and `column` are the first one's."""

    def __init__(self, message: str, mistakes: tuple[Mistake, ...] = ()) -> None:
        super().__init__(message)
        self.mistakes = mistakes or (Mistake(None, None, message),)
        self.line, self.column, _ = self.mistakes[0]

    @classmethod
    def of(cls, message: str, name: str, shown: str) -> SceneError:
        """Takes apart a message about the scene `name`, which is called `shown`."""
        place = re.compile(rf"^\s*{re.escape(name)}(?::(\d+)(?::(\d+))?)?: ", re.MULTILINE)
        starts = list(place.finditer(message))
        ends = [start.start() for start in starts[1:]] + [len(message)]
        mistakes = tuple(Mistake(_number(start[1]), _number(start[2]), message[start.end():end].strip())
                         for start, end in zip(starts, ends))
        return cls(re.sub(rf"^(\s*){re.escape(name)}(?=:)", rf"\g<1>{shown}", message, flags=re.MULTILINE), mistakes)


def _number(text: Optional[str]) -> Optional[int]:
    return int(text) if text else None


class ProgramError(Error):
    """A run of the program that failed: what it said, and `status`, its exit status."""

    def __init__(self, message: str, status: int) -> None:
        super().__init__(message)
        self.status = status
