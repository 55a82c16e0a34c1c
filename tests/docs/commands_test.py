"""The commands of the docs, copied from the page and run: commands_test.py [PAGE ...].

What a page calls its files is laid out first, from the sample teeth. Every command must end with 0 unless ENDS says otherwise, and none is left out but for a reason
in LEFT_OUT; a reason that no command needs any more fails, too.
"""
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import unittest

SOURCE = pathlib.Path(os.environ.get("ODONTOSCOPE_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
PROGRAM = pathlib.Path(os.environ.get("ODONTOSCOPE_PROGRAM", SOURCE / "build/release/engine/app/odontoscope"))
PACKAGE = os.environ.get("PYTHONPATH", str(SOURCE / "build/release/python"))
COMMANDS = ("odontoscope ", "sbatch ", "web/wasm/build", "cd ", "cpack", "PARTS=", "MACHINES=", "apt-get ", "/usr/bin/python3 ", "venv/bin/", "package=", "PYTHONPATH=", "tests/")

#: Beginnings of commands that are not run here, and why.
LEFT_OUT = {
    "python.md": {"apt-get install python3-dev": "installs", "/usr/bin/python3 -m venv": "with the next", "venv/bin/pip install .": "compiles for minutes: pip install is tried by hand",
                  "PYTHONPATH=$(dirname": "ParaView: tests/python/paraview_root", "tests/python/paraview_root": "makes a root"},
    "batch.md": {"MACHINES=": "wants several machines"},
    "studio.md": {"web/wasm/build": "compiles for twenty minutes"},
    "packages.md": {"cd build/release": "changes what follows", "cpack": "with the next", "tests/packages/in_bare_root": "makes a root"},
}
#: Exit codes other than 0 that the page speaks of.
ENDS = {}


def blocks(page):
    """(language, lines): fenced, and indented by four spaces (language "indented")."""
    fence, kept, indented = None, [], []
    for line in page.splitlines():
        if line.startswith("```"):
            if fence is None:
                fence, kept = line[3:].strip(), []
            else:
                yield fence, kept
                fence = None
        elif fence is not None:
            kept.append(line)
        elif line.startswith("    "):
            indented.append(line[4:])
        elif indented:
            yield "indented", indented
            indented = []


def commands(page):
    for language, lines in blocks(page):
        if language not in ("sh", "indented"):
            continue
        for line in lines:
            command = re.split(r"\s{3,}(?=\S)|\s+#\s", line)[0].strip()   # words beside it
            if command.startswith(COMMANDS):
                yield command


def scan(file):
    """A ball of dentine around a denser core, in air, as NRRD."""
    sides, step = (22, 20, 24), (0.3, 0.3, 0.25)
    values = []
    for k in range(sides[2]):
        for j in range(sides[1]):
            for i in range(sides[0]):
                far = sum((s * (n - (side - 1) / 2)) ** 2 for s, n, side in zip(step, (i, j, k), sides)) ** 0.5
                values.append(190 if far < 1.1 else 130 + 3 * (k % 3) if far < 2.3 else 15)
    header = f"NRRD0004\ntype: float\ndimension: 3\nsizes: {sides[0]} {sides[1]} {sides[2]}\nencoding: raw\nendian: little\nspace: left-posterior-superior\n" \
             f"space directions: ({step[0]},0,0) (0,{step[1]},0) (0,0,{step[2]})\nspace origin: (1,2,3)\n\n"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(header.encode() + struct.pack(f"<{len(values)}f", *values))


class InFolder(unittest.TestCase):
    page = ""

    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.kept.cleanup)
        cls.folder = pathlib.Path(cls.kept.name)
        (cls.folder / "bin").mkdir()
        (cls.folder / "bin/odontoscope").symlink_to(PROGRAM)
        # Slurm runs a script once for each task of its array.
        sbatch = cls.folder / "bin/sbatch"
        sbatch.write_text('#!/bin/sh\nfor task in 1 2 3; do\n  SLURM_ARRAY_TASK_ID=$task SLURM_ARRAY_TASK_COUNT=3 SLURM_CPUS_PER_TASK=1 sh "$@" || exit\ndone\n')
        sbatch.chmod(0o755)
        cls.text = (SOURCE / "docs" / cls.page).read_text(encoding="utf-8") if cls.page else ""
        cls.laid_out("odontoscope --quiet sample molar --slice-spacing 0.35 -o molar.json")

    @classmethod
    def shell(cls, command, cwd=None):
        return subprocess.run(["bash", "-c", command], cwd=cwd or cls.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, timeout=600,
                              env={**os.environ, "PATH": f"{cls.folder}/bin:{os.environ['PATH']}", "PYTHONPATH": PACKAGE, "PARTS": "3"})

    @classmethod
    def laid_out(cls, command):
        done = cls.shell(command)
        assert done.returncode == 0, f"{command}\n{done.stdout}"

    def run_page(self, cwd=None):
        if not self.page:
            return
        left_out, used, count = dict(LEFT_OUT.get(self.page, {})), set(), 0
        studio = "odontoscope web --studio"
        if studio in self.text and "without the studio" in self.shell(f"{studio} -o studio.html").stdout:
            left_out[studio] = "this program was built without the studio"
        for command in commands(self.text):
            reason = next((begin for begin in left_out if command.startswith(begin)), None)
            if reason is not None:
                used.add(reason)
                print(f"  left out ({left_out[reason]}): {command}")
                continue
            begin = time.monotonic()
            done = self.shell(command, cwd)
            print(f"  {time.monotonic() - begin:6.1f} s  {done.returncode}  {command}", flush=True)
            self.assertEqual(done.returncode, ENDS.get(command, 0), f"{command}\n{done.stdout}")
            count += 1
        self.assertEqual(set(left_out) - used, set(), "a reason to leave out what is no more there")
        self.assertGreater(count + len(used), 0, "the page has no commands")


class Python(InFolder):
    page = "python.md"

    def test_commands(self):
        self.run_page()

    def test_what_python_runs(self):
        """Blocks without prompts: those with them are doctests (python/package)."""
        try:
            import vtkmodules.util.vtkAlgorithm   # noqa: F401
            import numpy   # noqa: F401
        except ImportError as error:
            self.skipTest(f"{error}: python3-vtk9 and python3-numpy")
        scan(self.folder / "scan.nii.nrrd")
        for language, lines in blocks(self.text):
            if language != "python" or any(line.startswith(">>>") for line in lines) or "sitk." in "\n".join(lines) or "LoadPlugin" in "\n".join(lines):
                continue   # SimpleITK is none of Debian's here; ParaView: tests/python/paraview_root
            done = subprocess.run(["/usr/bin/python3", "-c", "\n".join(lines)], cwd=self.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  env={**os.environ, "PYTHONPATH": PACKAGE}, timeout=300)
            self.assertEqual(done.returncode, 0, "\n".join(lines) + "\n" + done.stdout)
            self.assertNotIn("Traceback", done.stdout)


class Batch(InFolder):
    page = "batch.md"

    def test_commands(self):
        for name in ("premolar", "incisor"):
            (self.folder / "teeth").mkdir(exist_ok=True)
            self.laid_out(f"odontoscope --quiet sample {name} --slice-spacing 0.35 -o teeth/{name}.json")
        for file in ("ct/upper-14.nrrd", "ct/lower left.nrrd"):
            scan(self.folder / file)
        (self.folder / "contours").mkdir()
        shutil.copy(self.folder / "molar.json", self.folder / "contours")
        shutil.copytree(SOURCE / "examples/batch", self.folder, dirs_exist_ok=True)
        # The page's own list.
        listed = next(lines for language, lines in blocks(self.text) if language == "" and lines[0].strip("# ") == "teeth.txt")
        (self.folder / "teeth.txt").write_text("\n".join(listed) + "\n")
        (self.folder / "models").mkdir()
        self.run_page()


class ScreenshotTests(InFolder):
    page = "screenshot-tests.md"

    def test_commands(self):
        for folder in ("views", "actual", "expected"):
            (self.folder / folder).mkdir()
        self.laid_out("odontoscope --quiet render molar.json --size 320x240 --view buccal --save-scene views/buccal.json -o expected/buccal.png")
        self.run_page()


class Web(InFolder):
    page = "web.md"

    def test_commands(self):
        scan(self.folder / "tooth.nrrd")
        shutil.copy(next((SOURCE / "assets/lessons").glob("02-canals*")), self.folder / "canals.tour.json")
        self.run_page()


class Studio(InFolder):
    page = "studio.md"

    def test_commands(self):
        if "without the studio" in self.shell("odontoscope web --studio -o studio.html").stdout:
            self.skipTest("this program has no studio in it: web/wasm/build")
        self.run_page()


class Packages(InFolder):
    page = "packages.md"

    def test_commands(self):
        self.run_page()


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *(f"{page}" for page in sys.argv[1:])], verbosity=2)
