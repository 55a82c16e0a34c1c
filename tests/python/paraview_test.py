"""The plugin, in ParaView's own interpreter and with its own VTK; and the state file of examples/paraview."""
import os
import pathlib
import random
import subprocess
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = pathlib.Path(os.environ["ODONTOSCOPE_SOURCE"])
PACKAGE = os.environ["PYTHONPATH"].split(os.pathsep)[0]


def by_paraview(script, *words):
    search = [PACKAGE, f"{PACKAGE}/odontoscope/paraview", os.environ.get("ODONTOSCOPE_PARAVIEW_PYTHON", "")]
    for _ in range(3):   # a display that somebody else took at the same moment (also one outside this root), or that is not there yet
        done = subprocess.run(["xvfb-run", "-a", "-n", str(random.randint(200, 900)), "-s", "-screen 0 1280x1024x24 -nolisten tcp", "pvbatch", str(script), *map(str, words)],
                              env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, search))}, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=250)
        if "bad X server connection" not in done.stdout:
            break
    return done


class Plugin(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)

    def test_does_in_paraview_what_it_does_in_vtk(self):
        done = by_paraview(HERE / "paraview_script.py", self.folder)
        self.assertIn("PASSED", done.stdout)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertNotIn("Traceback", done.stdout)
        self.assertIn('Grid: "many" cannot be understood', done.stdout)
        self.assertGreater((self.folder / "tooth.png").stat().st_size, 3000)
        self.assertIn("OdontoscopeContoursToTetrahedra", (self.folder / "tooth.pvsm").read_text())

    def test_the_state_of_the_docs_opens(self):
        done = by_paraview(SOURCE / "examples/paraview/make_picture.py", self.folder / "tooth.png", "--state", SOURCE / "examples/paraview/tooth.pvsm")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertGreater((self.folder / "tooth.png").stat().st_size, 30000, done.stdout)


if __name__ == "__main__":
    unittest.main()
