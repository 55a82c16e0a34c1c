"""The package as a user meets it: doctests, files, options, progress, Ctrl-C, threads, errors."""
import ast
import doctest
import importlib.util
import inspect
import json
import os
import pathlib
import pickle
import signal
import subprocess
import tempfile
import threading
import time
import unittest

import numpy as np
import odontoscope
from odontoscope import _core, draw, model, options, reading
from shapes import SQUARE, ball, box, circle, root, volume_file

PROGRAM = os.environ["ODONTOSCOPE_PROGRAM"]
SOURCE = pathlib.Path(os.environ["ODONTOSCOPE_SOURCE"])


def load_tests(loader, tests, pattern):
    for module in (odontoscope, draw, model, options, reading):
        tests.addTests(doctest.DocTestSuite(module, optionflags=doctest.ELLIPSIS))
    tests.addTests(doctest.DocFileSuite(str(SOURCE / "docs/python.md"), module_relative=False, optionflags=doctest.ELLIPSIS))
    return tests


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def program(self, *words):
        return subprocess.run([PROGRAM, "--quiet", *map(str, words)], cwd=self.folder, check=True, capture_output=True, text=True)


class SameAsTheProgram(InFolder):
    def test_bytes_and_reports(self):
        odontoscope.Contours(root()).save(self.folder / "root.json")
        model = odontoscope.reconstruct(self.folder / "root.json")
        model.save(self.folder / "a.glb", self.folder / "a.vtu", self.folder / "a.stl")
        self.program("reconstruct", "root.json", "-o", "b.glb", "-o", "b.vtu", "-o", "b.stl", "--report", "b.json")
        for ending in ("glb", "vtu", "stl"):
            self.assertEqual((self.folder / f"a.{ending}").read_bytes(), (self.folder / f"b.{ending}").read_bytes(), ending)
        theirs, ours = json.loads((self.folder / "b.json").read_text()), model.report
        self.assertEqual(list(theirs), list(ours))
        for key in theirs:
            if key not in ("seconds", "threads"):
                self.assertEqual(theirs[key], ours[key], key)

    def test_defaults_are_the_programs(self):
        defaults = {name: parameter.default for name, parameter in inspect.signature(odontoscope.reconstruct).parameters.items()}
        told = self.program("reconstruct", "--help").stdout
        for name in ("correspondence", "between", "cases", "field"):
            self.assertIn(f"{defaults[name]} (default)", told.replace("\n", " "), name)
        self.assertIn(f"Grid points along x and y (default: {defaults['grid']})", told)
        named = set(inspect.signature(odontoscope.reconstruct).parameters) | set(inspect.signature(odontoscope.contours).parameters)
        for name in named - {"source", "progress", "reading", "threads"}:
            self.assertIn("--" + name.replace("_", "-"), told, name)

    def test_db_and_simplified(self):
        odontoscope.Contours(root()).save(self.folder / "root.json")
        odontoscope.reconstruct(self.folder / "root.json", method="db", grid="24x20", cases="consistent").save(self.folder / "a.ply")
        self.program("reconstruct", "root.json", "--method", "db", "--grid", "24x20", "--cases", "consistent", "-o", "b.ply")
        self.assertEqual((self.folder / "a.ply").read_bytes(), (self.folder / "b.ply").read_bytes())
        simple = odontoscope.reconstruct(self.folder / "root.json", triangles=200)
        self.assertLessEqual(len(simple["tooth"].triangles), 200)
        self.assertEqual(simple.report["simplification_aim"]["aim"], 200)

    def test_elements(self):
        odontoscope.Contours(root()).save(self.folder / "root.json")
        try:
            meshed = odontoscope.reconstruct(self.folder / "root.json", elements=1.0)
        except odontoscope.UsageError as error:
            self.skipTest(str(error))   # built without TetGen
        meshed.save(self.folder / "a.vtu")
        self.program("reconstruct", "root.json", "--elements", "1.0", "-o", "b.vtu")
        self.assertEqual((self.folder / "a.vtu").read_bytes(), (self.folder / "b.vtu").read_bytes())
        self.assertEqual(meshed.report["elements"]["asked"], 1.0)
        self.assertEqual(meshed.report["elements"]["structures"][0]["count"], len(meshed["tooth"].tetrahedra))
        for wrong in (0, -1, "small", float("nan")):
            with self.assertRaises(odontoscope.UsageError):
                odontoscope.reconstruct(self.folder / "root.json", elements=wrong)
        with self.assertRaises(odontoscope.UsageError):
            odontoscope.reconstruct(self.folder / "root.json", elements=1.0, triangles=100)

    def test_volumes(self):
        values = np.ascontiguousarray(ball() * 10, dtype="<f4")
        header = "NRRD0004\ntype: float\ndimension: 3\nsizes: 15 15 15\nencoding: raw\nendian: little\nspace: left-posterior-superior\n" \
                 "space directions: (0.5,0,0) (0,0.5,0) (0,0,0.25)\nspace origin: (1,2,3)\n\n"
        (self.folder / "ball.nrrd").write_bytes(header.encode() + values.tobytes())
        self.program("contours", "ball.nrrd", "--iso", "10=ball", "--min-area", "4", "--simplify", "0.01", "-o", "theirs.json")
        image = odontoscope.Volume(values, spacing=(0.5, 0.5, 0.25), origin=(1, 2, 3))
        for source in (image, self.folder / "ball.nrrd"):
            odontoscope.contours(source, iso="10=ball", min_area=4, simplify=0.01).save(self.folder / "ours.json")
            self.assertEqual((self.folder / "ours.json").read_bytes(), (self.folder / "theirs.json").read_bytes())
        np.testing.assert_array_equal(odontoscope.read_volume(self.folder / "ball.nrrd").values, values)
        labels = odontoscope.contours(odontoscope.Volume((ball() > 0).astype(np.uint8)), label={"pulp": 1}, smooth=0.2)
        self.assertEqual(labels.structures, ("pulp",))

    def same_stack(self, source, given, *words):
        self.program("contours", *words, "-o", "theirs.json")
        odontoscope.contours(source, **given).save(self.folder / "ours.json")
        self.assertEqual((self.folder / "ours.json").read_bytes(), (self.folder / "theirs.json").read_bytes(), given)

    def test_volumes_on_another_grid(self):
        image, file = volume_file(self.folder / "scan.nrrd")
        for given, words in [({"iso": "auto:3/2=core"}, ["--iso", "auto:3/2=core"]), ({"iso": 100, "crop": (1, 6, 2, 6, 4, 8)}, ["--iso", "100", "--crop", "1,6,2,6,4,8"]),
                             ({"iso": {"a": 100, "b": 150}, "resample": 0.2, "min_area": "0.1mm2"}, ["--iso", "100=a", "--iso", "150=b", "--resample", "0.2", "--min-area", "0.1mm2"])]:
            for source in (image, file):
                self.same_stack(source, given, "scan.nrrd", *words)
        np.testing.assert_array_equal(image.values, odontoscope.read_volume(file).values)   # it stays as it is
        for wrong in [{"crop": (1, 2)}, {"crop": "1,0,0,1,0,1"}, {"resample": -1}, {"iso": "auto:9/1"}, {"iso": "high"}, {"smooth": 0.1}]:
            with self.assertRaises(odontoscope.UsageError):
                odontoscope.contours(image, **{"iso": 100, **wrong})
        for wrong in [{"crop": (1, 6, 2, 6, 4, 8)}, {"upright": True}, {"label_names": "names.txt"}]:
            with self.assertRaises(odontoscope.UsageError):
                odontoscope.contours(root(), **wrong)

    def test_volumes_stood_upright_and_put_back(self):
        leaning = np.zeros((40, 30, 30), "<f4")
        k, j, i = np.mgrid[0:40, 0:30, 0:30]
        leaning[(np.hypot(i - 8 - 0.35 * k, j - 15) < 5) & (k > 3) & (k < 36)] = 100
        image = odontoscope.Volume(leaning, spacing=(0.5, 0.5, 0.5))
        header = "NRRD0004\ntype: float\ndimension: 3\nsizes: 30 30 40\nencoding: raw\nendian: little\nspace: left-posterior-superior\n" \
                 "space directions: (0.5,0,0) (0,0.5,0) (0,0,0.5)\nspace origin: (0,0,0)\n\n"
        (self.folder / "leaning.nrrd").write_bytes(header.encode() + leaning.tobytes())
        for given, words in [({}, []), ({"as_given": True}, ["--as-given"])]:
            self.program("reconstruct", "leaning.nrrd", "--iso", "50", "--upright", "-o", "theirs.ply", "--report", "theirs.json", *words)
            model = odontoscope.reconstruct(image, iso=50, upright=True, **given)
            model.save(self.folder / "ours.ply")
            self.assertEqual((self.folder / "ours.ply").read_bytes(), (self.folder / "theirs.ply").read_bytes())
            theirs = json.loads((self.folder / "theirs.json").read_text())
            self.assertEqual({**model.report["volume"], "remarks": []}, {**theirs["volume"], "remarks": []})
        with self.assertRaises(odontoscope.UsageError):
            model.save(self.folder / "aslant.inp")
        with self.assertRaises(odontoscope.UsageError):
            odontoscope.reconstruct(image, iso=50, as_given=True)

    def test_labels_with_names(self):
        labels = (ball() > 0).astype("<f4") * 3
        header = "NRRD0004\ntype: float\ndimension: 3\nsizes: 15 15 15\nencoding: raw\nendian: little\n\n"
        (self.folder / "labels.nrrd").write_bytes(header.encode() + labels.tobytes())
        (self.folder / "names.txt").write_text('3 255 0 0 1 1 1 "Pulp"\n')
        for source in (odontoscope.Volume(labels), self.folder / "labels.nrrd"):
            self.same_stack(source, {"label": "Pulp", "label_names": self.folder / "names.txt"}, "labels.nrrd", "--label", "Pulp", "--label-names", "names.txt", "--spacing", "1,1,1")
            with self.assertRaises(odontoscope.InputError) as caught:
                odontoscope.contours(source, label="Enamel", label_names=self.folder / "names.txt")
            self.assertEqual(caught.exception.cause, "label-not-found")

    def test_files_with_options(self):
        odontoscope.sample("incisor", slice_spacing=0.35, point_spacing=0.5).save(self.folder / "tooth.json")
        model = odontoscope.reconstruct(self.folder / "tooth.json")
        model.save(self.folder / "a.glb", self.folder / "a.3mf", self.folder / "a.seg.nrrd", tours=True, hotspots=True, variants=True, voxels=(0.3, 0.3, 0.3))
        self.program("reconstruct", "tooth.json", "-o", "b.glb", "-o", "b.3mf", "-o", "b.seg.nrrd", "--tours", "--hotspots", "--variants", "--voxels", "0.3,0.3,0.3")
        model.save(self.folder / "a.gltf", see_through=True, compress=True)
        self.program("reconstruct", "tooth.json", "-o", "b.gltf", "--see-through", "--compress")
        for ending in ("glb", "3mf", "seg.nrrd", "gltf"):
            self.assertEqual((self.folder / f"a.{ending}").read_bytes(), (self.folder / f"b.{ending}").read_bytes(), ending)
        tooth = odontoscope.contours(self.folder / "tooth.json")
        tooth.save(self.folder / "a.dcm")
        self.program("contours", "tooth.json", "-o", "b.dcm")
        self.assertEqual((self.folder / "a.dcm").read_bytes(), (self.folder / "b.dcm").read_bytes())
        for wrong in [lambda: model.save(self.folder / "x.stl", tours=True), lambda: model.save(self.folder / "x.stl", voxels=(1, 1, 1)), lambda: model.save(self.folder / "x.seg.nrrd"),
                      lambda: model.save(self.folder / "x.seg.nrrd", voxels=(1, 1)), lambda: odontoscope.reconstruct(box()).save(self.folder / "x.glb", hotspots=True),
                      lambda: odontoscope.reconstruct(box(), method="db", grid=16).save(self.folder / "x.seg.nrrd", voxels=(1, 1, 1))]:
            with self.assertRaises(odontoscope.UsageError):
                wrong()
        self.assertEqual(list(self.folder.glob("x.*")), [])

    def test_strict(self):
        ends = [(0, circle(radius=2)), (1, circle(radius=2)), (2, circle(9, 0))]
        amber = odontoscope.reconstruct(ends)
        self.assertEqual(amber.verdict, "amber")
        with self.assertRaises(odontoscope.WantingError) as caught:
            odontoscope.reconstruct(ends, strict=True)
        self.assertEqual(len(caught.exception.places), len(amber.report["attention"]))
        with self.assertRaises(odontoscope.WantingError):
            odontoscope.reconstruct(root(), triangles=1, strict=True)
        self.assertEqual(odontoscope.reconstruct(box(), strict=True).verdict, "green")

    def test_meshes(self):
        odontoscope.reconstruct(root()).save(self.folder / "root.glb")
        self.program("contours", "root.glb", "--spacing-z", "0.4", "-o", "theirs.json")
        odontoscope.contours(self.folder / "root.glb", spacing_z=0.4).save(self.folder / "ours.json")
        self.assertEqual((self.folder / "ours.json").read_bytes(), (self.folder / "theirs.json").read_bytes())
        self.assertTrue(odontoscope.check(self.folder / "root.glb")["closed_oriented_manifold"])
        outside, cavity = odontoscope.read_mesh(self.folder / "root.glb")
        self.assertGreater(outside.volume, 0)
        self.assertLess(cavity.volume, 0)
        self.assertIsNone(outside.tetrahedra)

    def test_comparison_and_anatomy(self):
        odontoscope.Contours(root()).save(self.folder / "root.json")
        self.program("compare", "root.json", "--grid", "24", "--report", "theirs.json")
        theirs, ours = json.loads((self.folder / "theirs.json").read_text()), odontoscope.compare(self.folder / "root.json", grid=24)
        self.assertEqual(list(theirs), list(ours))
        self.assertEqual(theirs["grid"], ours["grid"])
        self.program("anatomy", "root.json", "-o", "anatomy.json")
        theirs, ours = json.loads((self.folder / "anatomy.json").read_text()), odontoscope.anatomy(self.folder / "root.json")
        theirs.pop("source"), ours.pop("source")
        self.assertEqual(theirs, ours)
        self.program("anatomy", "root.json", "-o", "theirs.csv")
        odontoscope.anatomy(self.folder / "root.json", output=[self.folder / "ours.csv", self.folder / "ours.json"])
        self.assertEqual((self.folder / "ours.csv").read_bytes(), (self.folder / "theirs.csv").read_bytes())
        self.assertEqual(json.loads((self.folder / "ours.json").read_text())["canals"], ours["canals"])
        odontoscope.reconstruct(root()).save(self.folder / "root.glb")
        self.program("anatomy", "root.glb", "-o", "anatomy.json")
        self.assertEqual({**odontoscope.anatomy(self.folder / "root.glb"), "source": "root.glb"}, json.loads((self.folder / "anatomy.json").read_text()))
        self.program("compare", "root.json", "--grid", "24", "--report", "theirs.json")
        seen = odontoscope.compare(self.folder / "root.json", grid=24, html=self.folder / "page.html", report=self.folder / "ours.json")
        theirs = json.loads((self.folder / "theirs.json").read_text())
        self.assertEqual([one["seen_through"] for one in seen["methods"]], [one["seen_through"] for one in theirs["methods"]])
        self.assertIn("data:image/png", (self.folder / "page.html").read_text())


class Partition(InFolder):
    def rows(self):
        """A pulp within dentine: two structures with a common wall."""
        return [(z, circle(radius=r), name) for z in (0, 1, 2) for r, name in ((2, "dentine"), (1, "pulp"))]

    def test_shares_faces_and_adds_up(self):
        model = odontoscope.reconstruct(self.rows(), partition=True)
        shared = model.complex
        self.assertEqual(set(shared.structures), {"dentine", "pulp"})
        a, b, c, d = (shared.points[shared.tetrahedra[:, n]] for n in range(4))
        volumes = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6
        self.assertGreater(volumes.min(), 0)
        for label, name in enumerate(shared.structures, 1):
            self.assertAlmostEqual(volumes[shared.labels == label].sum(), model[name].volume, places=9)
        walls = {tuple(pair) for pair in shared.interface_labels}
        self.assertEqual(walls, {(1, 0), (2, 0), (1, 2)})
        between = shared.interfaces[(shared.interface_labels == (1, 2)).all(axis=1)]
        self.assertGreater(len(between), 0)
        self.assertLess(between.max(), len(shared.points))
        self.assertTrue(np.shares_memory(shared.interfaces, model.complex.interfaces))
        with self.assertRaises(ValueError):
            shared.interfaces[0] = 0
        kept, copy = shared.interface_labels, shared.interface_labels.copy()
        del model, shared
        np.testing.assert_array_equal(kept, copy)

    def test_of_a_filled_sample(self):
        self.program("sample", "incisor", "--filled", "--slice-spacing", "0.35", "-o", "theirs.json")
        tooth = odontoscope.sample("incisor", filled=True, slice_spacing=0.35)
        tooth.save(self.folder / "ours.json")
        self.assertEqual((self.folder / "ours.json").read_bytes(), (self.folder / "theirs.json").read_bytes())

    def test_is_the_programs(self):
        odontoscope.Contours(self.rows()).save(self.folder / "t.json")
        odontoscope.reconstruct(self.folder / "t.json", partition=True, priority="pulp,dentine").save(self.folder / "a.vtu")
        self.program("reconstruct", "t.json", "--partition", "--priority", "pulp,dentine", "-o", "b.vtu")
        self.assertEqual((self.folder / "a.vtu").read_bytes(), (self.folder / "b.vtu").read_bytes())

    def test_is_refused_with_what_does_not_go_with_it(self):
        for options in [{"link": "tooth:0:0-0"}, {"method": "db"}, {"gap": -1}, {"correspondence": "medial"}, {"triangles": 0}]:
            with self.assertRaises(odontoscope.UsageError):
                odontoscope.reconstruct(self.rows(), partition=True, **options)
        for options in [{"gap": 1}, {"priority": "a,b"}]:
            with self.assertRaises(odontoscope.UsageError):
                odontoscope.reconstruct(self.rows(), **options)
        self.assertIsNotNone(odontoscope.reconstruct(self.rows()).complex)   # they overlap
        self.assertIsNone(odontoscope.reconstruct(self.rows(), partition=False).complex)


class Links(InFolder):
    def two(self):
        """Two rods beside each other: what is forced, joins them; what is forbidden, parts one."""
        return [(z, circle(x, 0)) for z in (0, 1, 2) for x in (-1.5, 1.5)]

    def test_round_trip_and_win(self):
        model = odontoscope.reconstruct(self.two())
        again = odontoscope.reconstruct(self.two(), links=model.links)
        np.testing.assert_array_equal(model["tooth"].triangles, again["tooth"].triangles)
        apart = odontoscope.reconstruct(self.two(), unlink="tooth:0:0-0")
        self.assertNotIn((0, 0, 0), {(one["slice"], one["lower"], one["upper"]) for one in apart.links if one["connect"]})
        joined = odontoscope.reconstruct(self.two(), link=["tooth:0:0-1"])
        self.assertIn((0, 0, 1), {(one["slice"], one["lower"], one["upper"]) for one in joined.links})

    def test_that_name_nothing_are_refused(self):
        with self.assertRaises(odontoscope.InputError) as caught:
            odontoscope.reconstruct(self.two(), link="tooth:0:0-7")
        self.assertEqual(caught.exception.cause, "link-unknown-contour")
        for senseless in ("tooth:0", ["pulp"], ":0:0-1"):
            with self.assertRaises(odontoscope.UsageError):
                odontoscope.reconstruct(self.two(), link=senseless)
        with self.assertRaises(odontoscope.FileError):
            odontoscope.reconstruct(self.two(), links=self.folder / "none.json")


class Errors(InFolder):
    def test_have_cause_place_and_remedy(self):
        (self.folder / "bad.json").write_text('{"format":"odontoscope.contours","version":1,"unit":"mm","slices":[{"z":0,"contours":[{"points":[[0,0],[4,4],[4,0],[0,4]]}]}]}')
        with self.assertRaises(odontoscope.InputError) as caught:
            odontoscope.contours(self.folder / "bad.json")
        error = caught.exception
        self.assertTrue(error.cause and error.remedy and error.wrong)
        self.assertEqual(error.place["file"], str(self.folder / "bad.json"))
        self.assertIn(error.wrong, str(error))
        self.assertIn(error.remedy, str(error))
        self.assertIsInstance(error, ValueError)

    def test_of_files_are_os_errors(self):
        with self.assertRaises(OSError) as caught:
            odontoscope.contours(self.folder / "none.json")
        self.assertIsInstance(caught.exception, odontoscope.FileError)
        self.assertEqual(caught.exception.place, {"file": str(self.folder / "none.json")})
        with self.assertRaises(odontoscope.FileError):
            odontoscope.Contours(box()).save(self.folder / "none" / "x.json")

    def test_survive_pickling(self):
        try:
            odontoscope.Contours([(0, SQUARE)])
        except odontoscope.InputError as error:
            again = pickle.loads(pickle.dumps(error))
            self.assertEqual((type(again), str(again), again.cause, again.place, again.remedy), (type(error), str(error), error.cause, error.place, error.remedy))
        stack = odontoscope.Contours(root())
        self.assertEqual(pickle.loads(pickle.dumps(stack)), stack)

    def test_of_senseless_calls(self):
        model = odontoscope.reconstruct(box())
        for call in [lambda: odontoscope.reconstruct(box(), method="mc"), lambda: odontoscope.reconstruct(box(), threads=-1), lambda: odontoscope.reconstruct(box(), triangles=0),
                     lambda: odontoscope.reconstruct(box(), grid="128y"), lambda: odontoscope.reconstruct(box(), method="db", grid=(1, 2, 3)), lambda: odontoscope.reconstruct(box(), iso=3),
                     lambda: odontoscope.contours(3), lambda: odontoscope.contours(odontoscope.Volume(ball())), lambda: model.save("x.docx"), lambda: odontoscope.sample("tusk"),
                     lambda: odontoscope.reconstruct(box(), method="db", field="x"), lambda: odontoscope.contours(odontoscope.Volume(ball()), iso=0, min_area="4 acres")]:
            with self.assertRaises((odontoscope.UsageError, TypeError)) as caught:
                call()
            self.assertTrue(str(caught.exception))

    def test_repair_tells_what_it_changed(self):
        eight = [(0, 0), (4, 4), (4, 0), (0, 4)]
        stack = odontoscope.Contours([(0, eight), (1, SQUARE)], repair=True)
        self.assertIn("crossed itself", stack.changes[0])
        self.assertTrue(odontoscope.reconstruct(stack).certified)


class LongWork(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tooth = odontoscope.sample("incisor")

    def test_tells_how_far_it_is(self):
        told = []
        odontoscope.reconstruct(self.tooth, progress=lambda stage, fraction: told.append((stage, fraction, threading.get_ident())))
        self.assertGreater(len({stage for stage, _, _ in told}), 2, told)
        self.assertTrue(all(0 <= fraction <= 1 for _, fraction, _ in told))
        self.assertEqual({thread for _, _, thread in told}, {threading.get_ident()})

    def test_ends_when_the_listener_raises(self):
        def listener(stage, fraction):
            raise LookupError(stage)

        start = time.monotonic()
        with self.assertRaises(LookupError):
            odontoscope.reconstruct(self.tooth, progress=listener)
        self.assertLess(time.monotonic() - start, 30)

    def test_ends_on_ctrl_c(self):
        """In the middle of the work: an interpreter that looks for signals only afterwards would raise, too, but late."""
        tooth = odontoscope.sample("molar")
        start = time.monotonic()
        odontoscope.reconstruct(tooth, threads=1)
        whole = time.monotonic() - start
        timer = threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT))
        start = time.monotonic()
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            odontoscope.reconstruct(tooth, threads=1)
        self.assertLess(time.monotonic() - start, 0.7 * whole)
        timer.join()
        self.assertTrue(odontoscope.reconstruct(box()).certified)   # and all is well afterwards

    def test_leaves_the_interpreter_to_others(self):
        beats, over = [], threading.Event()

        def beat():
            while not over.wait(0.005):
                beats.append(time.monotonic())

        thread = threading.Thread(target=beat)
        thread.start()
        start = time.monotonic()
        odontoscope.reconstruct(self.tooth, threads=1)
        end = time.monotonic()
        over.set()
        thread.join()
        within = [moment for moment in beats if start < moment < end]
        self.assertGreater(len(within), 10 * (end - start), "one beat takes 5 ms; the work held the lock")

    def test_runs_twice_at_once_and_gives_the_same(self):
        models = [None, None]

        def make(n):
            models[n] = odontoscope.reconstruct(root())

        threads = [threading.Thread(target=make, args=(n,)) for n in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        np.testing.assert_array_equal(models[0]["tooth"].points, models[1]["tooth"].points)


class Remedies(InFolder):
    def test_say_what_to_do_whatever_was_wrong(self):
        """One fault of each kind, from readers of every kind: wrong and remedy are told apart, and together are the message."""
        def put(name, content):
            (self.folder / name).write_bytes(content.encode() if isinstance(content, str) else content)
            return self.folder / name

        nrrd = "NRRD0004\ntype: short\ndimension: 3\nsizes: 4 4 4\nencoding: raw\n\n"
        faults = [lambda: odontoscope.read_volume(put("short.nrrd", nrrd)), lambda: odontoscope.read_volume(put("odd.nrrd", nrrd.replace("dimension: 3", "dimension: x"))),
                  lambda: odontoscope.read_volume(self.folder / "none.nrrd"), lambda: odontoscope.read_volume(put("empty.mha", "")), lambda: odontoscope.read_volume(put("text.nii", "text")),
                  lambda: odontoscope.contours(put("a.json", "{")), lambda: odontoscope.contours(put("a.csl", "CSLC\n1")), lambda: odontoscope.contours(self.folder / "none.json"),
                  lambda: odontoscope.read_mesh(put("a.stl", "solid x\n")), lambda: odontoscope.read_mesh(put("a.glb", b"glTF\2\0\0\0")), lambda: odontoscope.check(put("a.ply", "ply\n")),
                  lambda: odontoscope.reconstruct(odontoscope.Volume(ball()), iso=1e9), lambda: odontoscope.reconstruct(odontoscope.Volume(ball()), label=7), lambda: odontoscope.sample("tusk"),
                  lambda: odontoscope.reconstruct(box(), correspondence="near"), lambda: odontoscope.Contours([(0, SQUARE), (0, SQUARE)])]
        for fault in faults:
            with self.assertRaises(odontoscope.Error) as caught:
                fault()
            error = caught.exception
            self.assertTrue(error.wrong and error.remedy, f"{error}: nothing says what to do")
            self.assertTrue(error.remedy[0].isupper(), str(error))
            self.assertIn(f"{error.wrong}. {error.remedy}", str(error))


class Stubs(unittest.TestCase):
    def test_name_what_is_there(self):
        for module in ("_core", "_draw"):
            if importlib.util.find_spec(f"odontoscope.{module}") is None:
                continue
            compiled = importlib.import_module(f"odontoscope.{module}")
            tree = ast.parse((pathlib.Path(odontoscope.__file__).parent / f"{module}.pyi").read_text())
            declared = {}
            for node in tree.body:
                if isinstance(node, ast.FunctionDef):
                    declared[node.name] = None
                if isinstance(node, ast.ClassDef):
                    declared[node.name] = {one.name for one in node.body if isinstance(one, ast.FunctionDef)}
            there = {name for name in vars(compiled) if not name.startswith("_")}
            self.assertEqual(set(declared), there)
            for name, members in declared.items():
                if members is not None:
                    self.assertEqual(members, {one for one in vars(getattr(compiled, name)) if not one.startswith("_")}, name)

    def test_everything_public_says_its_types_and_what_it_does(self):
        for name in odontoscope.__all__:
            public = getattr(odontoscope, name)
            members = [(name, public)]
            if inspect.isclass(public) and not issubclass(public, Exception):
                members += [(f"{name}.{inner}", member) for inner, member in vars(public).items() if inspect.isfunction(member) and not inner.startswith("_")]
                members += [(f"{name}.{inner}", member.fget) for inner, member in vars(public).items() if isinstance(member, property)]
            for called, member in members:
                self.assertTrue(member.__doc__, f"{called} has no docstring")
                if inspect.isfunction(member):
                    signature = inspect.signature(member)
                    untyped = [one.name for one in signature.parameters.values() if one.name != "self" and one.annotation is one.empty]
                    self.assertEqual(untyped, [], called)
                    self.assertIsNot(signature.return_annotation, signature.empty, called)

    def test_mark_the_package_as_typed(self):
        self.assertTrue((pathlib.Path(odontoscope.__file__).parent / "py.typed").exists())


if __name__ == "__main__":
    unittest.main()
