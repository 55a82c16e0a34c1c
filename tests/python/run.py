"""Runs the tests of one part: run.py package."""
import importlib.util
import os
import pathlib
import shutil
import sys
import unittest

MODULES = {"vtk": ["vtkmodules.util.vtkAlgorithm"], "slicer": ["vtkmodules.util.vtkAlgorithm"], "notebook": ["nbclient", "ipykernel"]}
PROGRAMS = {"paraview": ["pvbatch", "xvfb-run"]}
PACKAGES = {"vtkmodules": "python3-vtk9", "pvbatch": "paraview and python3-paraview", "xvfb-run": "xvfb"}


def skip(missing):
    name = missing.split(".")[0]
    print(f"SKIPPED: {missing} is not there; Debian has it as {PACKAGES.get(name, 'python3-' + name)}")
    sys.exit(0)


part = sys.argv[1]
if part == "paraview" and os.environ.get("ODONTOSCOPE_PARAVIEW_PYTHON"):
    sys.path.append(os.environ["ODONTOSCOPE_PARAVIEW_PYTHON"])
for module in ["numpy", *MODULES.get(part, []), *(["paraview"] if part == "paraview" else [])]:
    try:
        found = importlib.util.find_spec(module)
    except ImportError:
        found = None
    if found is None:
        skip(module)
for program in PROGRAMS.get(part, []):
    if shutil.which(program) is None:
        skip(program)
sys.path.insert(0, str(pathlib.Path(__file__).parent))
suite = unittest.defaultTestLoader.loadTestsFromName(f"{part}_test")
sys.exit(0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1)
