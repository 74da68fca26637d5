"""Installs the wheel into an environment of its own, without a network, and runs what tests it there:

    run.py SOURCE LIBRARY PROGRAM FOLDER
"""

import os
import pathlib
import shutil
import subprocess
import sys
import venv

source, library, program, folder = map(pathlib.Path, sys.argv[1:])
shutil.rmtree(folder, ignore_errors=True)
venv.create(folder / "venv", system_site_packages=True)
python = folder / "venv/bin/python"
environment = {**os.environ, "ROTATEBOOK": str(program), "ROTATEBOOK_SOURCE": str(source), "ROTATEBOOK_LIBRARY": str(library),
               "PIP_DISABLE_PIP_VERSION_CHECK": "1", "PYTHONDONTWRITEBYTECODE": "1"}
environment.pop("PYTHONPATH", None)
subprocess.run([python, "-m", "pip", "install", "--quiet", "--no-index", "--no-compile", source / "python"],
               check=True, env=environment)
tests = pathlib.Path(__file__).parent
sys.exit(subprocess.run([python, "-m", "unittest", "discover", "-s", tests, "-p", "*_test.py"],
                        cwd=folder, env=environment).returncode)
