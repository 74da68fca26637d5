"""Builds the wheel, by Python's own library and CMake alone: `pip install` needs no network for it.

ROTATEBOOK_LIBRARY names the core's library if it is built already; without it, it is built in
../build/python.
"""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
TAG = "py3-none-linux_x86_64"
LIBRARY = "librotatebook_c.so"


def _project():
    """Returns the fields of pyproject.toml that the wheel repeats, which are texts in lines of their own."""
    text = (HERE / "pyproject.toml").read_text()
    return {key: value for key, value in re.findall(r'^([\w-]+) = "(.*)"$', text, re.MULTILINE)}


def _library():
    """Returns the bytes of the core's library."""
    given = os.environ.get("ROTATEBOOK_LIBRARY")
    if given:
        return pathlib.Path(given).read_bytes()
    build = HERE.parent / "build" / "python"
    subprocess.run(["cmake", "-S", HERE.parent, "-B", build, "-DROTATEBOOK_CORE_ONLY=ON", "-DBUILD_TESTING=OFF",
                    "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON"], check=True)
    subprocess.run(["cmake", "--build", build, "--target", "rotatebook_c", "--parallel", str(os.cpu_count() or 1)],
                   check=True)
    return (build / LIBRARY).read_bytes()


def _metadata(project):
    return (f"Metadata-Version: 2.1\nName: {project['name']}\nVersion: {project['version']}\n"
            f"Summary: {project['description']}\nLicense: MIT\nRequires-Python: {project['requires-python']}\n"
            "Requires-Dist: numpy\nDescription-Content-Type: text/markdown\n\n" + (HERE / "README.md").read_text())


def _digest(content):
    return base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Writes the wheel, the same bytes from the same files; returns its name. (PEP 517)"""
    project = _project()
    name = f"{project['name']}-{project['version']}"
    info = f"{name}.dist-info"
    files = {f"rotatebook/{file.name}": file.read_bytes()
             for file in sorted((HERE / "rotatebook").iterdir()) if file.suffix in (".py", ".typed")}
    files[f"rotatebook/{LIBRARY}"] = _library()
    files[f"{info}/METADATA"] = _metadata(project).encode()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: rotatebook\nRoot-Is-Purelib: false\nTag: {TAG}\n".encode()
    files[f"{info}/LICENSE"] = (HERE.parent / "LICENSE").read_bytes()
    record = "".join(f"{file},sha256={_digest(content)},{len(content)}\n" for file, content in files.items())
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    wheel = f"{name}-{TAG}.whl"
    with zipfile.ZipFile(os.path.join(wheel_directory, wheel), "w", zipfile.ZIP_DEFLATED) as archive:
        for file, content in files.items():
            entry = zipfile.ZipInfo(file)  # Of 1980, whenever it is made.
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, content, zipfile.ZIP_DEFLATED)
    return wheel
