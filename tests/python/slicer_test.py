"""The scripted module of 3D Slicer against Slicer's file contract, with stand-ins for Slicer itself: the program, the files and VTK are real."""
import os
import pathlib
import sys
import tempfile
import types
import unittest

import numpy as np
from shapes import circle
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkMassProperties

sys.path[:0] = [str(pathlib.Path(__file__).parent / "slicer_stubs"), str(pathlib.Path(os.environ["ODONTOSCOPE_SOURCE"]) / "python/slicer")]
import slicer  # noqa: E402
from OdontoscopeReconstruct import Failed, OdontoscopeReconstruct, OdontoscopeReconstructLogic, OdontoscopeReconstructWidget  # noqa: E402
from odontoscope import vtk  # noqa: E402
import odontoscope  # noqa: E402

ORIGIN, SPACING = (-20.0, 30.0, 5.0), (0.5, 0.4, 1.0)   # right, anterior, superior


def tooth_labels():
    """A dentine ball with a pulp in it, off the middle, so that a mirrored model would be seen."""
    k, j, i = np.indices((17, 25, 21)).astype(float)
    labels = np.where(np.sqrt(((i - 9) * 0.5)**2 + ((j - 14) * 0.4)**2 + (k - 8)**2) < 3.9, 1, 0)
    labels[np.sqrt(((i - 11) * 0.5)**2 + ((j - 13) * 0.4)**2 + (k - 8)**2) < 1.6] = 2
    return labels


def centre(polydata):
    low_high = np.array(polydata.GetBounds())
    return (low_high[0::2] + low_high[1::2]) / 2


def volume(polydata):
    mass = vtkMassProperties()
    mass.SetInputData(polydata)
    mass.Update()
    return mass.GetVolume()


class Module(unittest.TestCase):
    def setUp(self):
        slicer.app.userSettings().clear()
        slicer.app.userSettings().setValue("Odontoscope/Program", os.environ["ODONTOSCOPE_PROGRAM"])
        slicer.mrmlScene.models.clear(), slicer.PROBLEMS.clear()
        self.logic = OdontoscopeReconstructLogic()
        self.segments = [slicer.Segment("dentine", (0.9, 0.8, 0.5), 1), slicer.Segment("dental pulp", (0.8, 0.2, 0.2), 2)]

    def sound(self, polydata):
        edges = vtkFeatureEdges()
        edges.SetInputData(polydata)
        edges.FeatureEdgesOff(), edges.ManifoldEdgesOff(), edges.BoundaryEdgesOn(), edges.NonManifoldEdgesOn()
        edges.Update()
        points = vtk_to_numpy(polydata.GetPoints().GetData())
        corners = points[vtk_to_numpy(polydata.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
        outward = np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
        return edges.GetOutput().GetNumberOfCells() == 0 and outward > 0

    def test_makes_models_of_a_segmentation_where_it_lies(self):
        node = slicer.Node("tooth", self.segments, tooth_labels(), SPACING, ORIGIN)
        models, report = self.logic.reconstruct(node)
        self.assertEqual([model.GetName() for model in models], ["dentine", "dental pulp"])
        self.assertEqual(models[1].colour, (0.8, 0.2, 0.2))
        self.assertTrue(report["certified"])
        for model in models:
            self.assertTrue(self.sound(model.polydata), model.GetName())
        for model, at, voxels in zip(models, [(9, 14, 8), (11, 13, 8)], [(tooth_labels() == 1).sum(), (tooth_labels() == 2).sum()]):
            np.testing.assert_allclose(centre(model.polydata), np.array(ORIGIN) + np.array(at) * SPACING, atol=0.3)
            self.assertAlmostEqual(volume(model.polydata), voxels * np.prod(SPACING), delta=0.12 * voxels * np.prod(SPACING))

    def test_makes_models_of_planar_contours(self):
        stack = odontoscope.Contours([(z, circle(3, -2, 1.5 if z < 4 else 1)) for z in range(6)])
        lines = vtk.to_polydata(stack)   # of right-anterior-superior points, as far as Slicer is concerned
        segment = slicer.Segment("root", (1, 1, 0), contours=lines)
        models, report = self.logic.reconstruct(slicer.Node("RTSS", [segment]), "--threads 1 --triangles 300")
        np.testing.assert_allclose(centre(models[0].polydata), (3, -2, 2.5), atol=1e-6)
        self.assertTrue(self.sound(models[0].polydata))
        self.assertEqual(report["input"]["slices"], 6)
        self.assertLessEqual(models[0].polydata.GetNumberOfCells(), 300)

    def test_makes_models_of_files(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "a tooth.json"
            odontoscope.Contours([(0, circle(5, 0)), (1, circle(5, 0))]).save(file)
            models, _ = self.logic.reconstruct(str(file))
            np.testing.assert_allclose(centre(models[0].polydata), (-5, 0, 0.5), atol=1e-6)   # the file's left is Slicer's minus right

    def test_tells_what_is_wrong_and_leaves_nothing(self):
        before = set(os.listdir(tempfile.gettempdir()))
        node = slicer.Node("tooth", self.segments, tooth_labels() * 0, SPACING, ORIGIN)
        for source, options, words in [(node, "", "label"), (slicer.Node("none", []), "", "no segments"), ("/nowhere.json", "", "nowhere.json"),
                                       (slicer.Node("tooth", self.segments, tooth_labels()), "--no-such-option", "no-such-option"), (node, "'", "cannot be understood"),
                                       (slicer.Node("twice", [self.segments[0]] * 2, tooth_labels()), "", "one name")]:
            with self.assertRaisesRegex(Failed, words):
                self.logic.reconstruct(source, options)
        slicer.app.userSettings().setValue("Odontoscope/Program", "/no/odontoscope")
        with self.assertRaisesRegex(Failed, "Install Odontoscope"):
            self.logic.reconstruct(node)
        self.assertEqual(slicer.mrmlScene.models, [])
        self.assertEqual({name for name in os.listdir(tempfile.gettempdir()) if name.startswith("odontoscope")} - before, set())

    def test_has_a_panel(self):
        parent = types.SimpleNamespace()
        OdontoscopeReconstruct(parent)
        self.assertIn("Odontoscope", parent.title)
        widget = OdontoscopeReconstructWidget()
        widget.setup()
        widget.apply.click()
        self.assertIn("Choose a segmentation", widget.verdict.text)
        widget.segmentation.node = slicer.Node("tooth", self.segments, tooth_labels(), SPACING, ORIGIN)
        widget.apply.click()
        self.assertRegex(widget.verdict.text, r"^(Green|Amber): dentine, dental pulp\.")
        self.assertEqual(slicer.PROBLEMS, [])
        widget.options.text = "--no-such-option"
        widget.apply.click()
        self.assertEqual(len(slicer.PROBLEMS), 1)


if __name__ == "__main__":
    unittest.main()
