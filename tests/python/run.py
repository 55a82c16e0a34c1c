"""Runs the tests of one part: run.py package."""
import importlib
import pathlib
import sys
import unittest

NEEDED = {"package": ["numpy"], "arrays": ["numpy"], "vtk": ["numpy", "vtkmodules.util.vtkAlgorithm"], "draw": ["numpy"], "notebook": ["numpy", "nbclient", "ipykernel"]}

part = sys.argv[1]
for module in NEEDED[part]:
    try:
        importlib.import_module(module)
    except ImportError as error:
        print(f"SKIPPED: {error}; Debian has it as {'python3-vtk9' if 'vtk' in module else 'python3-' + module}")
        sys.exit(0)
sys.path.insert(0, str(pathlib.Path(__file__).parent))
suite = unittest.defaultTestLoader.loadTestsFromName(f"{part}_test")
sys.exit(0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1)
