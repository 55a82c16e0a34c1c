"""The worked examples that need no browser: batches on a cluster and by GNU parallel, and a repository that tests its teeth."""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import odontoscope
from shapes import circle

PROGRAM = pathlib.Path(os.environ["ODONTOSCOPE_PROGRAM"])
EXAMPLES = pathlib.Path(os.environ["ODONTOSCOPE_SOURCE"]) / "examples"


class InFolder(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)
        (self.folder / "bin").mkdir()
        (self.folder / "bin/odontoscope").symlink_to(PROGRAM)

    def run_here(self, *words, folder="", **variables):
        return subprocess.run([str(word) for word in words], cwd=self.folder / folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              env={**os.environ, "PATH": f"{self.folder}/bin:{os.environ['PATH']}", **variables})


class Batches(InFolder):
    """Seven teeth, of which one is none."""

    def setUp(self):
        super().setUp()
        (self.folder / "teeth").mkdir()
        for n in range(6):
            odontoscope.Contours([(z, circle(radius=1 + 0.1 * n + 0.05 * z)) for z in range(4)]).save(self.folder / f"teeth/tooth-{n}.json")
        (self.folder / "teeth/bad.json").write_text('{"format":"odontoscope.contours","version":1,"unit":"mm","slices":[]}')
        (self.folder / "teeth.txt").write_text("# all of them\n" + "".join(f"teeth/{name}\n" for name in sorted(os.listdir(self.folder / "teeth"))))

    def judge(self, done, kept):
        self.assertEqual(done.returncode, 1, done.stdout)   # one failed
        report = json.loads((self.folder / "models/batch.json").read_text())
        self.assertEqual((report["counts"]["inputs"], report["counts"]["made"], report["counts"]["failed"], report["counts"]["kept"]), (7, 6, 1, kept), report["counts"])
        self.assertEqual([item["name"] for item in report["items"] if not item["made"]], ["bad"])
        for n in range(6):
            self.assertTrue((self.folder / f"models/tooth-{n}.glb").exists())

    def test_as_a_slurm_array(self):
        script = EXAMPLES / "batch/slurm-array.sh"
        self.assertIn("#SBATCH", script.read_text())
        for task in (1, 2, 3):
            done = self.run_here(script, "teeth.txt", "models", "--format", ".glb", SLURM_ARRAY_TASK_ID=str(task), SLURM_ARRAY_TASK_COUNT="3", SLURM_CPUS_PER_TASK="2")
            self.assertIn(done.returncode, (0, 1), done.stdout)
            part = json.loads((self.folder / f"models/batch-{task}-of-3.json").read_text())
            self.assertEqual(part["counts"]["inputs"], 3 if task == 1 else 2)
        self.judge(self.run_here("odontoscope", "batch", "teeth.txt", "-o", "models", "--format", ".glb"), kept=6)

    @unittest.skipUnless(shutil.which("parallel"), "GNU parallel is not installed; Debian has it as parallel")
    def test_by_gnu_parallel(self):
        done = self.run_here(EXAMPLES / "batch/parallel.sh", "teeth.txt", "models", "--format", ".glb", PARTS="3", HOME=str(self.folder))
        self.judge(done, kept=6)
        self.assertEqual(len(list((self.folder / "models").glob("batch-*-of-3.json"))), 3)


class ScreenshotTests(InFolder):
    def setUp(self):
        super().setUp()
        self.here = self.folder / "repository"
        shutil.copytree(EXAMPLES / "screenshot-tests", self.here)

    def pixel(self):
        """The view "cut" as it is drawn here, with one pixel a little redder: as a PNG."""
        model = odontoscope.reconstruct(odontoscope.contours(self.here / "teeth/incisor.json"))
        pixels = model.render(scene=self.here / "views/cut.json").copy()
        self.assertEqual(odontoscope.png(pixels), (self.here / "actual/incisor-cut.png").read_bytes(), "the package draws what the program draws")
        pixels[150, 200, 0] ^= 4
        return odontoscope.png(pixels)

    def test_pass_find_one_pixel_and_show_it(self):
        done = self.run_here("./test-pictures", folder="repository")
        self.assertEqual(done.returncode, 0, f"{done.stdout}: not what examples/screenshot-tests/expected has; look, then ./test-pictures --accept")
        self.assertIn("4 of 4 pictures alike", done.stdout)
        self.assertEqual(self.run_here("./test-pictures", "--accept", folder="repository").returncode, 0)
        (self.here / "expected/incisor-cut.png").write_bytes(self.pixel())
        strict = {"TOLERANCE": "--channel 0 --share 0"}
        self.assertEqual(self.run_here("./test-pictures", folder="repository").returncode, 0, "the usual tolerance lets it pass")
        done = self.run_here("./test-pictures", folder="repository", **strict)
        self.assertEqual(done.returncode, 1, done.stdout)
        verdict = json.loads((self.here / "verdict.json").read_text())
        found = {one["name"]: one for one in verdict["pictures"]}
        self.assertEqual({name: one["outcome"] for name, one in found.items()}, {"incisor.png": "alike", "incisor-buccal.png": "alike", "incisor-cut.png": "different", "incisor-window-cut.png": "alike"})
        self.assertEqual((found["incisor-cut.png"]["pixels"], found["incisor-cut.png"]["largest"], found["incisor-cut.png"]["box"]), (1, 4, [200, 150, 200, 150]))
        page = (self.here / "failures.html").read_text()
        self.assertIn("incisor-cut.png", page)
        self.assertNotIn("incisor-buccal.png", page)
        self.assertIn("data:image/png;base64,", page)

    @unittest.skipUnless(shutil.which("chromium"), "Chromium was not found (Debian: chromium)")
    def test_pages_are_shot_and_one_pixel_is_found(self):
        strict = {"TOLERANCE": "--channel 0 --share 0", "PAGES": "yes"}
        self.assertEqual(self.run_here("./test-pictures", folder="repository", **strict).returncode, 1, "nothing is expected of the page yet")
        done = self.run_here("./test-pictures", "--accept", folder="repository", **strict)
        self.assertEqual(done.returncode, 0, done.stdout)
        done = self.run_here("./test-pictures", folder="repository", **strict)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("5 of 5 pictures alike", done.stdout)


if __name__ == "__main__":
    unittest.main()
