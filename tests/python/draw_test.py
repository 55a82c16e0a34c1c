"""Pictures as arrays, and what a notebook shows: the same as the program's, to the pixel and the byte."""
import html
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import numpy as np
import odontoscope
from odontoscope import draw
from shapes import SQUARE, box, root, volume_file

PROGRAM = os.environ["ODONTOSCOPE_PROGRAM"]
SMALL = (160, 120)


class Pictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tooth = odontoscope.sample("incisor", slice_spacing=0.35, point_spacing=0.5)
        cls.model = odontoscope.reconstruct(cls.tooth)

    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)

    def by_the_program(self, *words):
        self.tooth.save(self.folder / "tooth.json")
        file = self.folder / "picture.png"
        size = [] if "--scene" in words else ["--size", "160x120"]
        subprocess.run([PROGRAM, "--quiet", "render", self.folder / "tooth.json", "-o", file, "--backend", "egl", *size, *words], check=True)
        return file.read_bytes()

    def test_are_those_of_the_program(self):
        (self.folder / "views").mkdir()
        scene = self.folder / "views" / "scene.json"
        self.model.render(size=(200, 100), samples=9, view="lingual", opacity={"enamel": 0.5}, save_scene=scene)
        for given, words in [({}, []),
                             ({"view": "buccal", "section": "buccal", "cap": "plain"}, ["--view", "buccal", "--section", "buccal", "--cap", "plain"]),
                             ({"hide": "enamel", "opacity": {"dentine": 0.3}, "colour": "pulp=#00ff00", "samples": 1},
                              ["--hide", "enamel", "--opacity", "dentine=0.3", "--colour", "pulp=#00ff00", "--samples", "1"]),
                             ({"overlay": ["contours", "tetrahedra=3"], "wire": True, "parallel": True, "zoom": 2},
                              ["--overlay", "contours", "--overlay", "tetrahedra=3", "--wire", "--parallel", "--zoom", "2"]),
                             ({"wall_depth": True, "hide": ["enamel", "dentine"], "background": "white", "occlusion": 0, "cull": "off"},
                              ["--wall-depth", "--hide", "enamel", "--hide", "dentine", "--background", "white", "--occlusion", "0", "--cull", "off"]),
                             ({"wall_thickness": True, "hide": "enamel"}, ["--wall-thickness", "--hide", "enamel"]),
                             ({"scene": scene, "size": None}, ["--scene", scene])]:   # of the scene's size
            made = self.model.render(**{"size": SMALL, "backend": "egl", **given})
            self.assertTrue(odontoscope.png(made) == self.by_the_program(*words), f"{given} draws something else than {words}")

    def pictures_by_the_program(self, *words):
        """By the names that it gave them."""
        before = set(self.folder.glob("made*.png"))
        subprocess.run([PROGRAM, "--quiet", "render", *words], check=True, cwd=self.folder)
        return [file.read_bytes() for file in sorted(set(self.folder.glob("made*.png")) - before)]

    def test_of_grey_values_are_those_of_the_program(self):
        image, file = volume_file(self.folder / "scan.nrrd")
        size = ["--size", "160x120", "--backend", "egl"]
        for given, words in [({"show": "volume"}, ["--show", "volume"]),
                             ({"show": "volume", "cast": "maximum", "transfer": "", "view": "buccal"}, ["--show", "volume", "--cast", "maximum", "--view", "buccal"]),
                             ({"show": "volume", "slopes": (20, 200), "view": "buccal"}, ["--show", "volume", "--slopes", "20,200", "--view", "buccal"]),
                             ({"show": "volume", "transfer": "enamel", "grey": (10, 120)}, ["--show", "volume", "--transfer", "enamel", "--grey", "10,120"]),
                             ({"iso": 100, "show": "both"}, ["--iso", "100", "--show", "both"]),
                             ({"iso": 100, "section": "buccal", "cap": "ct", "view": "buccal"}, ["--iso", "100", "--section", "buccal", "--cap", "ct", "--view", "buccal"]),
                             ({"iso": 100, "colour_by": "distance=0.1"}, ["--iso", "100", "--colour-by", "distance=0.1"]),
                             ({"iso": 100, "section": "buccal", "cap": "ct=20,180"}, ["--iso", "100", "--section", "buccal", "--cap", "ct=20,180"])]:
            theirs, = self.pictures_by_the_program(file.name, "-o", "made.png", *size, *words)
            (self.folder / "made.png").unlink()
            for source in (image, file):
                ours = odontoscope.png(odontoscope.render(source, size=SMALL, backend="egl", **given))
                self.assertTrue(ours == theirs, f"{given} draws something else than {words}")
        no_volume = odontoscope.reconstruct(root())
        for model, words in [(no_volume, {"show": "volume"}), (no_volume, {"section": "buccal", "cap": "ct"}), (image, {}), (image, {"cast": "loud", "show": "volume"}),
                             (image, {"show": "volume", "threads": 1}), (no_volume, {"grey": (1, 2)}), (no_volume, {"colour_by": "distance"}), (no_volume, {"colour_by": "mood"})]:
            with self.assertRaises(odontoscope.UsageError):
                odontoscope.render(model, **words)

    def test_of_x_rays_are_those_of_the_program(self):
        image, file = volume_file(self.folder / "scan.nrrd")
        self.tooth.save(self.folder / "tooth.json")
        for source, name, given, words in [(self.model, "tooth.json", {}, []), (image, "scan.nrrd", {}, []), (file, "scan.nrrd", {"grey": (10, 120)}, ["--grey", "10,120"]),
                                           (self.model, "tooth.json", {"tube": (20, -5), "film": (12, 25), "pixel": 0.1, "kv": 60, "beam": "cone", "focus": 300, "exposure": 2,
                                                                       "attenuation": {"enamel": 0.4, "pulp": "air"}, "hide": "dentine", "inverted": True, "view": "mesial"},
                                            ["--tube", "20,-5", "--film", "12x25", "--pixel", "0.1", "--kv", "60", "--beam", "cone", "--focus", "300", "--exposure", "2",
                                             "--attenuation", "enamel=0.4", "--attenuation", "pulp=air", "--hide", "dentine", "--inverted", "--view", "mesial"])]:
            theirs, = self.pictures_by_the_program(name, "-o", "made.png", "--radiograph", *words)
            (self.folder / "made.png").unlink()
            self.assertTrue(odontoscope.png(odontoscope.render(source, radiograph=True, **given)) == theirs, f"{name} {given}")
        turned = self.model.render(radiograph=True, turntable=2, pixel=0.2)
        self.assertEqual(len(turned), 2)
        self.assertGreater(np.abs(turned[0].astype(int) - turned[1]).max(), 30)
        for words in [{"kv": 10}, {"kv": 60}, {"beam": "flat"}, {"radiograph": True, "section": "buccal"}, {"radiograph": True, "tube": 3}, {"radiograph": True, "size": SMALL},
                      {"radiograph": True, "tour": "canal-1"}, {"radiograph": True, "grey": (1, 2)}, {"radiograph": True, "hide": "bone"}, {"radiograph": True, "film": "wide"}]:
            self.refused(odontoscope.UsageError, **words)

    def test_of_tours_and_turntables_are_those_of_the_program(self):
        self.tooth.save(self.folder / "tooth.json")
        size = ["--size", "160x120", "--backend", "egl"]
        (self.folder / "film").mkdir()
        subprocess.run([PROGRAM, "--quiet", "render", "tooth.json", "-o", "film", "--tour", "canal-1", "--frames", "3", *size], check=True, cwd=self.folder)
        theirs = [frame.read_bytes() for frame in sorted((self.folder / "film").iterdir())]
        ours = self.model.render(tour="canal-1", frames=3, size=SMALL, backend="egl")
        self.assertTrue([odontoscope.png(frame) for frame in ours] == theirs)
        theirs, = self.pictures_by_the_program("tooth.json", "-o", "made.png", "--tour", "canal-1", "--reverse", "--contact-sheet", "2x1", *size)
        self.assertTrue(odontoscope.png(self.model.render(tour="canal-1", reverse=True, contact_sheet=(2, 1), size=SMALL, backend="egl")) == theirs)
        (self.folder / "made.png").unlink()
        theirs = self.pictures_by_the_program("tooth.json", "-o", "made.png", "--turntable", "3", *size)
        self.assertTrue([odontoscope.png(one) for one in self.model.render(turntable=3, size=SMALL, backend="egl")] == theirs)
        for words in [{"tour": "canal-9"}, {"frames": 3}, {"reverse": True}, {"tour": "canal-1", "turntable": 2}, {"tour": "canal-1", "section": "buccal"}, {"turntable": 0},
                      {"tour": "canal-1", "void": 5}, {"tour": "canal-1", "contact_sheet": "9"}, {"frames": 4000, "tour": "canal-1"}]:
            self.refused(odontoscope.UsageError, **words)

    def test_of_mesh_files_are_those_of_the_program(self):
        self.model.save(self.folder / "tooth.stl")
        theirs, = self.pictures_by_the_program("tooth.stl", "-o", "made.png", "--size", "160x120", "--backend", "egl", "--cull", "tint")
        self.assertTrue(odontoscope.png(odontoscope.render(self.folder / "tooth.stl", size=SMALL, backend="egl", cull="tint")) == theirs)
        with self.assertRaises(odontoscope.UsageError):
            odontoscope.render(self.folder / "tooth.stl", between="blended")

    def test_show_a_tooth(self):
        pixels = self.model.render(size="200x150", background="transparent")
        self.assertEqual((pixels.shape, pixels.dtype), ((150, 200, 4), np.dtype("uint8")))
        seen = pixels[..., 3] > 0
        self.assertTrue(0.1 < seen.mean() < 0.9)
        self.assertGreater(len(np.unique(pixels[seen] // 8, axis=0)), 30)
        self.assertFalse(seen[0].any(), "the first row is above the tooth")
        pixels[:] = 0   # the caller's own

    def test_do_not_depend_on_what_draws(self):
        np.testing.assert_array_equal(self.model.render(size=SMALL, backend="egl"), self.model.render(size=SMALL, backend="osmesa"))

    def test_are_drawn_of_whatever_can_be_reconstructed(self):
        square = odontoscope.render([(0, SQUARE), (1, SQUARE)], size=SMALL, threads=1)
        self.assertGreater(np.ptp(square[..., :3].astype(int)), 60)
        by_db = odontoscope.reconstruct(root(), method="db", grid=24)
        self.assertGreater(np.ptp(by_db.render(size=SMALL)[..., :3].astype(int)), 60)
        joined = odontoscope.reconstruct(odontoscope.sample("incisor", slice_spacing=0.35, point_spacing=0.5, filled=True), partition=True)
        self.assertEqual(joined.render(size=SMALL).shape, (120, 160, 4))

    def refused(self, kind, **words):
        with self.assertRaises(kind) as caught:
            odontoscope.render(self.model, **words)
        self.assertTrue(caught.exception.remedy, str(caught.exception))
        return caught.exception

    def test_refuse_words_that_make_no_sense(self):
        for words in [{"view": "above"}, {"size": "0x5"}, {"size": (5,)}, {"size": 5}, {"samples": 5}, {"zoom": 0}, {"zoom": "near"}, {"occlusion": 5}, {"opacity": {"enamel": 2}},
                      {"opacity": 0.3}, {"hide": "bone"}, {"colour": {"pulp": "red"}}, {"section": "sideways"}, {"cap": "plain"}, {"cap": "ct"}, {"cull": "maybe"},
                      {"overlay": "tetrahedra=99"}, {"overlay": "nerves"}, {"backend": "window"}, {"backend": "vulkan"}, {"view": "buccal", "camera": "x.json"}, {"grid": 5}]:
            self.refused(odontoscope.UsageError, **words)
        self.refused(odontoscope.FileError, scene=self.folder / "none.json")
        self.refused(odontoscope.FileError, size=SMALL, save_scene=self.folder / "none" / "scene.json")
        self.assertEqual(self.refused(odontoscope.GraphicsError, size="16000x16000").cause, "picture-too-large")
        with self.assertRaises(odontoscope.UsageError):
            odontoscope.render(odontoscope.reconstruct(box()), wall_depth=True)   # no void inside

    def test_end_when_asked(self):
        def stop(stage, fraction):
            raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            self.model.render(size=SMALL, progress=stop)
        self.assertEqual(self.model.render(size=SMALL).shape, (120, 160, 4))

    def test_are_written_as_png(self):
        pixels = np.zeros((2, 3, 4), dtype=np.uint8)
        self.assertEqual(odontoscope.png(pixels)[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(odontoscope.png(pixels[::-1, ::-1]), odontoscope.png(pixels))
        for wrong in [pixels[..., :3], pixels.astype(float), pixels[:0], pixels[0]]:
            with self.assertRaises(odontoscope.InputError):
                odontoscope.png(wrong)


class Notebooks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.model = odontoscope.reconstruct(odontoscope.sample("incisor", slice_spacing=0.35, point_spacing=0.5))

    def test_show_a_picture(self):
        picture = self.model._repr_png_()
        self.assertEqual(picture, odontoscope.png(self.model.render(size="640x480")))

    def page(self):
        try:
            return self.model.page(title="An incisor")
        except odontoscope.UsageError as error:
            self.assertIn("built without the web page", str(error))
            self.assertIsNone(self.model._repr_html_())
            self.skipTest(str(error))

    def test_pages_are_those_of_the_program(self):
        page = self.page()
        with tempfile.TemporaryDirectory() as folder:
            odontoscope.sample("incisor", slice_spacing=0.35, point_spacing=0.5).save(f"{folder}/tooth.json")
            subprocess.run([PROGRAM, "--quiet", "web", f"{folder}/tooth.json", "-o", f"{folder}/page.html", "--title", "An incisor"], check=True)
            self.assertTrue(page.encode() == pathlib.Path(f"{folder}/page.html").read_bytes())
            subprocess.run([PROGRAM, "--quiet", "web", f"{folder}/tooth.json", "-o", f"{folder}/page.html", "--title", "Both", "--db", "--grid", "24", "--lesson", "Find your way"], check=True)
            by_db = odontoscope.reconstruct(odontoscope.sample("incisor", slice_spacing=0.35, point_spacing=0.5), method="db", grid=24)
            self.assertTrue(self.model.page("Both", db=by_db, lesson="Find your way").encode() == pathlib.Path(f"{folder}/page.html").read_bytes())
        with self.assertRaises(odontoscope.UsageError):
            self.model.page(db=self.model)
        with self.assertRaises(odontoscope.FileError):
            self.model.page(lesson="none.tour.json")

    def test_pages_carry_grey_values_and_a_language_as_those_of_the_program_do(self):
        self.page()
        k, j, i = np.indices((12, 24, 24))
        volume = odontoscope.Volume((np.clip(9 - np.hypot(i - 12, j - 11.5), 0, 4) * 60).astype("float32"), (0.2, 0.2, 0.4))
        with tempfile.TemporaryDirectory() as folder:
            self.write_nrrd(volume, f"{folder}/rod.nrrd")
            for words, made in [(["--iso", "100", "--show", "both", "--transfer", "enamel", "--slopes", "50,300", "--language", "de"],
                                 lambda read: odontoscope.reconstruct(read, iso=100).page("Rod", show="both", transfer="enamel", slopes=(50, 300), language="de")),
                                (["--show", "volume", "--cast", "maximum"], lambda read: read.page("Rod", cast="maximum"))]:
                subprocess.run([PROGRAM, "--quiet", "web", f"{folder}/rod.nrrd", "-o", f"{folder}/page.html", "--title", "Rod", *words], check=True)
                self.assertTrue(made(odontoscope.read_volume(f"{folder}/rod.nrrd")).encode() == pathlib.Path(f"{folder}/page.html").read_bytes(), words)
        for refused in [{"show": "both"}, {"cast": "maximum"}, {"show": "nothing"}, {"language": "none.json"}, {"grey": (3, 1)}, {"slopes": (50, 300)}]:
            with self.assertRaises(odontoscope.Error, msg=str(refused)):
                self.model.page(**refused)

    @staticmethod
    def write_nrrd(volume, file):
        slices, rows, columns = volume.values.shape
        x, y, z = volume.spacing
        head = (f"NRRD0004\ntype: float\ndimension: 3\nspace dimension: 3\nspace units: \"mm\" \"mm\" \"mm\"\nsizes: {columns} {rows} {slices}\n"
                f"space directions: ({x},0,0) (0,{y},0) (0,0,{z})\nspace origin: (0,0,0)\nencoding: raw\nendian: little\n\n")
        pathlib.Path(file).write_bytes(head.encode() + volume.values.astype("<f4").tobytes())

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg was not found (Debian: ffmpeg)")
    def test_films_are_those_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            odontoscope.sample("incisor", slice_spacing=0.35, point_spacing=0.5).save(f"{folder}/tooth.json")
            subprocess.run([PROGRAM, "--quiet", "render", f"{folder}/tooth.json", "--tour", "canal-1", "--reverse", "--frames", "6", "--size", "96x64", "-o", f"{folder}/theirs.webm"], check=True)
            seconds = self.model.film(f"{folder}/ours.webm", frames=6, size="96x64", reverse=True)
            self.assertAlmostEqual(seconds, 6 / 30)
            ours, theirs = (pathlib.Path(f"{folder}/{name}.webm").read_bytes() for name in ("ours", "theirs"))
            self.assertEqual((ours[:4], len(ours)), (theirs[:4], len(theirs)))   # the bytes hold a number drawn by lot

    def test_films_that_make_no_sense_are_refused(self):
        for file, words in [("x.gif", {}), ("x.mp4", {"turntable": 3}), ("x.mp4", {"section": "buccal"})]:
            with self.assertRaises(odontoscope.UsageError):
                self.model.film(file, **words)
        with self.assertRaises((odontoscope.UsageError, odontoscope.FileError)):
            self.model.film("x.mp4", size="95x64")

    def test_show_the_page_in_a_frame(self):
        page = self.page()
        frame = self.model._repr_html_()
        self.assertTrue(frame.startswith("<iframe "))
        self.assertNotIn("allow-same-origin", frame)
        within = html.unescape(frame.split('srcdoc="')[1].rsplit('"></iframe>')[0])
        self.assertEqual(within, page.replace("An incisor", "sample incisor"))
        limit = draw.PAGE_LIMIT
        self.addCleanup(setattr, draw, "PAGE_LIMIT", limit)
        draw.PAGE_LIMIT = 1000
        self.assertIsNone(self.model._repr_html_())

    def test_do_without_where_nothing_draws(self):
        module = draw._draw
        self.addCleanup(setattr, draw, "_draw", module)
        draw._draw, draw._missing = None, "libglfw.so.3: cannot open shared object file"
        self.assertIsNone(self.model._repr_png_())
        self.assertIsNone(self.model._repr_html_())
        with self.assertRaisesRegex(odontoscope.UsageError, "libglfw"):
            self.model.render()


if __name__ == "__main__":
    unittest.main()
