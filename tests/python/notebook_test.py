"""The tutorial runs from its first cell to its last, and shows what it promises."""
import os
import pathlib
import shutil
import unittest

import nbformat
from nbclient import NotebookClient

FILE = pathlib.Path(os.environ["ODONTOSCOPE_SOURCE"]) / "examples/notebook/tooth-under-load.ipynb"


def run(notebook):
    NotebookClient(notebook, timeout=100, kernel_name="python3", resources={"metadata": {"path": str(FILE.parent)}}).execute()
    return notebook


def outputs(notebook, kind):
    return [output["data"][kind] for cell in notebook.cells for output in cell.get("outputs", []) if kind in output.get("data", {})]


def said(notebook):
    return "".join(output.get("text", "") for cell in notebook.cells for output in cell.get("outputs", []))


class Tutorial(unittest.TestCase):
    def setUp(self):
        self.notebook = nbformat.read(FILE, as_version=4)

    def test_is_committed_without_outputs(self):
        nbformat.validate(self.notebook)
        for cell in self.notebook.cells:
            self.assertFalse(cell.get("outputs"), "clear the outputs: they are some megabytes, and this test makes them anew")

    @unittest.skipUnless(shutil.which("ccx"), "SKIPPED: CalculiX is not installed; Debian has it as calculix-ccx")
    def test_runs(self):
        done = run(self.notebook)
        self.assertRegex(said(done), r"reaction \[ *-?0\.\d* *-?0\.\d* *100\. *\] N")
        self.assertRegex(said(done), r"enamel +von Mises: mean +\d")
        self.assertEqual(len(outputs(done, "image/png")), 2, "the model's picture, and the cut at the end")
        page = [text for text in outputs(done, "text/html") if "srcdoc=" in text]
        self.assertLessEqual(len(page), 1)   # none where the page is not built


if __name__ == "__main__":
    unittest.main()
