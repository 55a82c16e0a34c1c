"""Builds the wheel that `pip install .` asks for (PEP 517): the library and the package by CMake, zipped.

Needs nothing from the Python package index. CMake's own variables are heeded (CMAKE_BUILD_PARALLEL_LEVEL, CMAKE_CXX_COMPILER_LAUNCHER,
CMAKE_ARGS); ODONTOSCOPE_BUILD_DIR names a folder to build in, kept for the next time, instead of a temporary one.
"""

from __future__ import annotations

import base64
import hashlib
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent


def _version() -> str:
    return re.search(r"project\(odontoscope VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)


def _tag() -> str:
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def _metadata() -> dict[str, str]:
    head = f"Metadata-Version: 2.1\nName: odontoscope\nVersion: {_version()}\nSummary: Solid, certified models of teeth from planar contours or CT volumes\n" \
           "License: GPL-3.0-or-later\nRequires-Python: >=3.9\nRequires-Dist: numpy>=1.21\nDescription-Content-Type: text/markdown\n\n"
    return {"METADATA": head + (ROOT / "docs/python.md").read_text(encoding="utf-8"),
            "WHEEL": f"Wheel-Version: 1.0\nGenerator: odontoscope\nRoot-Is-Purelib: false\nTag: {_tag()}\n"}


def _run(*words: str) -> None:
    try:
        subprocess.run(words, check=True, cwd=ROOT)
    except FileNotFoundError:
        sys.exit(f"{words[0]} is not installed. Debian has it: apt-get install cmake ninja-build g++ pybind11-dev python3-dev, and what third_party/packages.debian lists")
    except subprocess.CalledProcessError as error:
        sys.exit(f"{words[0]} failed with {error.returncode}; its words are above. What must be installed: third_party/packages.debian, pybind11-dev and python3-dev")


def _build(to: pathlib.Path, folder: pathlib.Path) -> None:
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    _run("cmake", "-S", str(ROOT), "-B", str(folder), *generator, "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=12",
         "-DODONTOSCOPE_ENGINE=OFF", "-DODONTOSCOPE_TESTS=OFF", "-DODONTOSCOPE_PYTHON=ON", f"-DPython_EXECUTABLE={sys.executable}",
         *shlex.split(os.environ.get("CMAKE_ARGS", "")))
    _run("cmake", "--build", str(folder), "--target", "odontoscope_python_all")
    _run("cmake", "--install", str(folder), "--component", "python", "--prefix", str(to), "--strip")


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None) -> str:
    name = f"odontoscope-{_version()}-{_tag()}.whl"
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(os.environ.get("ODONTOSCOPE_BUILD_DIR") or pathlib.Path(scratch) / "build")
        built = pathlib.Path(scratch) / "installed"
        _build(built, folder)
        files = {str(path.relative_to(built)): path.read_bytes() for path in sorted(built.rglob("*")) if path.is_file()}
    info = f"odontoscope-{_version()}.dist-info"
    files |= {f"{info}/{file}": text.encode() for file, text in _metadata().items()}
    files[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    record = "".join(f"{file},sha256={base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b'=').decode()},{len(content)}\n" for file, content in files.items())
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for file, content in files.items():
            wheel.writestr(file, content)
    return name


def build_sdist(sdist_directory, config_settings=None) -> str:
    raise NotImplementedError("the package is built from a clone of the repository: pip install .")
