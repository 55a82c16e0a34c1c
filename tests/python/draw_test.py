"""Pictures as arrays, and what a notebook shows: the same as the program's, to the pixel and the byte."""
import html
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np
import odontoscope
from odontoscope import draw
from shapes import SQUARE, box, root

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
                             ({"scene": scene, "size": None}, ["--scene", scene])]:   # of the scene's size
            made = self.model.render(**{"size": SMALL, "backend": "egl", **given})
            self.assertTrue(odontoscope.png(made) == self.by_the_program(*words), f"{given} draws something else than {words}")

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
