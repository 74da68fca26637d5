"""Checked motions and videos of a book that tumbles about its middle axis.

    import rotatebook
    scene = rotatebook.Scene.from_file("my.toml")
    motion = scene.simulate()[0]            # NumPy arrays on the core's memory
    clip = rotatebook.render(scene)         # by the program rotatebook
    clip.verify()

Motions are simulated by the core, which is in this package. What draws and what runs motions by the
hundred is the program's, which is looked for on PATH, or named by the variable ROTATEBOOK.
"""

from ._errors import Error, Mistake, ProgramError, SceneError
from ._program import Clip, Export, Proof, export, judge, map, program, render, run, study, toss, verify
from ._scene import Motion, Scene, Simulation

__all__ = ["Clip", "Error", "Export", "Mistake", "Motion", "ProgramError", "Proof", "Scene", "SceneError", "Simulation",
           "export", "judge", "map", "program", "render", "run", "study", "toss", "verify"]
