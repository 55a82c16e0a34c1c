"""The filters, in pipelines of VTK's own; VTK judges what comes out."""
import contextlib
import inspect
import io
import pathlib
import tempfile
import unittest

import odontoscope
from odontoscope import vtk
from shapes import box, circle, root
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkObject, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkCutter, vtkFeatureEdges, vtkMassProperties, vtkStripper
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality


def faulty_edges(port):
    """Borders and edges of more than two triangles, by vtkFeatureEdges."""
    edges = vtkFeatureEdges()
    edges.SetInputConnection(port)
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.BoundaryEdgesOn()
    edges.NonManifoldEdgesOn()
    edges.Update()
    return edges.GetOutput().GetNumberOfCells()


def volume(port):
    mass = vtkMassProperties()
    mass.SetInputConnection(port)
    mass.Update()
    return mass.GetVolume()


def fed(kind, rows, **options):
    made = kind()
    made.SetInputDataObject(vtk.to_polydata(odontoscope.Contours(rows)))
    for name, value in options.items():
        getattr(made, "Set" + name)(value)
    return made


def polydata(rings, closed=True):
    points, lines = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for ring in rings:
        numbers = [points.InsertNextPoint(*point) for point in ring]
        lines.InsertNextCell(len(numbers) + closed)
        for n in numbers + numbers[:1] * closed:
            lines.InsertCellPoint(n)
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    return data


class Filters(unittest.TestCase):
    def failed(self, made):
        said = io.StringIO()
        vtkObject.GlobalWarningDisplayOff()   # the pipeline's own lines
        self.addCleanup(vtkObject.GlobalWarningDisplayOn)
        with contextlib.redirect_stderr(said):
            made.Update()
        self.assertIsNotNone(made.GetError())
        self.assertIn(str(made.GetError()), said.getvalue())
        return made.GetError()

    def test_surfaces_are_closed_manifolds_of_our_volume(self):
        made = fed(vtk.ContoursToSurface, root())
        made.Update()
        self.assertEqual(faulty_edges(made.GetOutputPort()), 0)
        self.assertGreater(made.GetOutput().GetNumberOfCells(), 0)
        self.assertAlmostEqual(volume(made.GetOutputPort()), made.GetModel()["tooth"].volume, delta=1e-6 * made.GetModel()["tooth"].volume)

    def test_an_open_surface_is_found_by_the_same_judge(self):
        made = fed(vtk.ContoursToSurface, root(), Method="db", Grid=24, Cases="classic")
        made.Update()
        self.assertEqual(faulty_edges(made.GetOutputPort()) == 0, made.GetModel().certified)
        data = vtkPolyData()
        data.DeepCopy(vtk.to_surface(odontoscope.reconstruct(box()).solids))
        data.BuildCells()
        data.DeleteCell(0)
        data.RemoveDeletedCells()
        edges = vtkFeatureEdges()
        edges.SetInputData(data)
        edges.FeatureEdgesOff(), edges.ManifoldEdgesOff(), edges.BoundaryEdgesOn()
        edges.Update()
        self.assertEqual(edges.GetOutput().GetNumberOfCells(), 3)

    def test_sample_tooth(self):
        made = vtk.ContoursToSurface()
        made.SetInputDataObject(vtk.to_polydata(odontoscope.sample("incisor")))
        made.Update()
        self.assertEqual(faulty_edges(made.GetOutputPort()), 0)
        data = made.GetOutput()
        numbers = vtk_to_numpy(data.GetCellData().GetArray("structure"))
        self.assertEqual(set(numbers), {1, 2, 3})
        self.assertEqual(data.GetFieldData().GetArray("structure pulp").GetValue(0), 2)
        total = sum(solid.volume for solid in made.GetModel().solids)
        self.assertAlmostEqual(volume(made.GetOutputPort()), total, delta=1e-5 * total)

    def test_tetrahedra_are_positive_and_bounded_by_the_surface(self):
        made = fed(vtk.ContoursToTetrahedra, root())
        made.Update()
        grid = made.GetOutput()
        self.assertEqual({grid.GetCellType(n) for n in range(grid.GetNumberOfCells())}, {10})
        quality = vtkMeshQuality()
        quality.SetInputConnection(made.GetOutputPort())
        quality.SetTetQualityMeasureToVolume()
        quality.Update()
        volumes = vtk_to_numpy(quality.GetOutput().GetCellData().GetArray("Quality"))
        self.assertGreater(volumes.min(), 0)
        self.assertAlmostEqual(volumes.sum(), made.GetModel()["tooth"].volume, delta=1e-9)
        skin = vtkDataSetSurfaceFilter()
        skin.SetInputConnection(made.GetOutputPort())
        skin.Update()
        self.assertEqual(skin.GetOutput().GetNumberOfCells(), len(made.GetModel()["tooth"].triangles))
        self.assertEqual(faulty_edges(skin.GetOutputPort()), 0)
        self.assertEqual(grid.GetCellData().GetArray("label").GetNumberOfTuples(), grid.GetNumberOfCells())

    def test_partitions_share_their_points(self):
        rows = [(z, circle(radius=r), name) for z in (0, 1, 2) for r, name in ((2, "dentine"), (1, "pulp"))]
        made = fed(vtk.ContoursToTetrahedra, rows, Partition=True)
        made.Update()
        self.assertIsNone(made.GetError())
        self.assertEqual(made.GetOutput().GetNumberOfPoints(), len(made.GetModel().complex.points))
        skin = vtkDataSetSurfaceFilter()
        skin.SetInputConnection(made.GetOutputPort())
        skin.Update()
        self.assertEqual(skin.GetOutput().GetNumberOfCells(), int((made.GetModel().complex.interface_labels[:, 1] == 0).sum()), "inside, nothing is a boundary")
        self.assertEqual(faulty_edges(skin.GetOutputPort()), 0)

    def test_run_again_when_an_option_changes_and_only_then(self):
        made = fed(vtk.ContoursToSurface, root())
        made.Update()
        first = made.GetModel()
        made.SetCorrespondence("tracked")
        made.Update()
        self.assertIs(made.GetModel(), first)
        made.SetTriangles(200)
        made.Update()
        self.assertIsNot(made.GetModel(), first)
        self.assertLessEqual(made.GetOutput().GetNumberOfCells(), 200)
        self.assertEqual(made.GetTriangles(), 200)

    def test_have_every_option_of_reconstruct(self):
        options = set(inspect.signature(odontoscope.reconstruct).parameters) - {"source", "progress", "reading", "as_given"}   # of volumes
        self.assertLessEqual(options, set(vtk.ContoursToSurface._options))
        defaults = {name: parameter.default for name, parameter in inspect.signature(odontoscope.reconstruct).parameters.items()}
        for name in options:
            self.assertEqual(vtk.ContoursToSurface._options[name], defaults[name], name)

    def test_take_what_vtk_cuts(self):
        """A sphere of VTK's, cut by planes of VTK's, in single precision."""
        sphere, cut, strips = vtkSphereSource(), vtkCutter(), vtkStripper()
        sphere.SetRadius(5), sphere.SetThetaResolution(40), sphere.SetPhiResolution(40)
        plane = vtkPlane()
        plane.SetNormal(0, 0, 1)
        cut.SetCutFunction(plane)
        cut.SetInputConnection(sphere.GetOutputPort())
        cut.GenerateValues(20, -4.83, 4.71)
        strips.SetInputConnection(cut.GetOutputPort())
        strips.JoinContiguousSegmentsOn()
        made = vtk.ContoursToSurface()
        made.SetInputConnection(strips.GetOutputPort())
        made.Update()
        self.assertIsNone(made.GetError())
        self.assertEqual(made.GetModel().report["input"]["slices"], 20)
        self.assertEqual(faulty_edges(made.GetOutputPort()), 0)
        self.assertGreater(volume(made.GetOutputPort()), 0.9 * volume(sphere.GetOutputPort()))
        made.SetInputConnection(cut.GetOutputPort())   # single segments
        self.assertEqual(self.failed(made).cause, "open-contour")
        self.assertEqual(made.GetOutput().GetNumberOfCells(), 0)

    def test_images_become_contours_where_they_lie(self):
        image = vtkImageData()
        image.SetExtent(3, 19, -2, 14, 5, 21)   # not from 0
        image.SetSpacing(0.5, 0.25, 1)
        image.SetOrigin(10, 20, 30)
        image.AllocateScalars(VTK_FLOAT, 1)
        for k in range(17):
            for j in range(17):
                for i in range(17):
                    image.SetScalarComponentFromFloat(i + 3, j - 2, k + 5, 0, 6 - ((i - 8)**2 + (j - 8)**2 + (k - 8)**2)**0.5)
        outline = vtk.ImageToContours()
        outline.SetInputDataObject(image)
        outline.SetIso("0=ball")
        made = vtk.ContoursToSurface()
        made.SetInputConnection(outline.GetOutputPort())
        made.Update()
        self.assertIsNone(outline.GetError())
        self.assertEqual(faulty_edges(made.GetOutputPort()), 0)
        solid = made.GetModel()["ball"]
        for got, wanted in zip(solid.points.mean(axis=0), (10 + 0.5 * 11, 20 + 0.25 * 6, 30 + 13)):
            self.assertAlmostEqual(got, wanted, delta=0.1)
        contour = vtkContourFilter()
        contour.SetInputData(image)
        contour.SetValue(0, 0)
        contour.Update()
        for ours, theirs in zip(made.GetOutput().GetBounds(), contour.GetOutput().GetBounds()):
            self.assertAlmostEqual(ours, theirs, delta=0.6)   # ours ends flat in its first and last slice
        self.assertAlmostEqual(volume(made.GetOutputPort()), 4 / 3 * 3.14159 * 216 * 0.125, delta=8)
        empty = vtk.ImageToContours()
        empty.SetInputDataObject(vtkImageData())
        empty.SetIso("0")
        self.assertIn("no scalars", str(self.failed(empty)))

    def test_made_up_teeth_are_a_source(self):
        tooth = vtk.SampleContours()
        tooth.SetKind("incisor"), tooth.SetSliceSpacing(0.35)
        tooth.Update()
        self.assertEqual(vtk.from_polydata(tooth.GetOutput()), odontoscope.sample("incisor", slice_spacing=0.35))

    def test_interfaces_of_a_partition_are_shared_by_two_labels(self):
        rows = [(z, circle(radius=r), name) for z in (0, 1, 2) for r, name in ((2, "dentine"), (1, "pulp"))]
        model = odontoscope.reconstruct(rows, partition=True)
        data = vtk.to_interfaces(model)
        inside, outside = (vtk_to_numpy(data.GetCellData().GetArray(name)) for name in ("inside", "outside"))
        self.assertEqual(data.GetNumberOfCells(), len(model.complex.interfaces))
        self.assertTrue(((inside == 2) ^ (outside == 2)).sum() > 0 and (inside > 0).all() and (inside != outside).all())
        with self.assertRaises(odontoscope.UsageError):
            vtk.to_interfaces(odontoscope.reconstruct(box()))

    def test_name_structures_by_cells(self):
        data = polydata([[(x, y, z) for x, y in circle(radius=radius)] for z in (0, 1) for radius in (2, 1)])
        names = vtkStringArray()
        names.SetName("structure")
        for _ in range(2):
            names.InsertNextValue("dentine"), names.InsertNextValue("pulp")
        data.GetCellData().AddArray(names)
        self.assertEqual(vtk.from_polydata(data).structures, ("dentine", "pulp"))

    def test_refuse_what_is_no_stack(self):
        slanted = polydata([[(0, 0, 0), (1, 0, 0.5), (1, 1, 0)], [(0, 0, 2), (1, 0, 2), (1, 1, 2)]])
        nan = polydata([[(0, 0, float("nan")), (1, 0, 0), (1, 1, 0)]])
        crossed = polydata([[(x, y, z) for x, y in [(0, 0), (4, 4), (4, 0), (0, 4)]] for z in (0, 1)])
        for data, cause in [(slanted, "not-planar"), (nan, "not-planar"), (crossed, "self-crossing"), (vtkPolyData(), "unsupported"), (polydata([[(0, 0, 0), (1, 0, 0)]], False), "open-contour")]:
            made = vtk.ContoursToTetrahedra()
            made.SetInputDataObject(data)
            self.assertEqual(self.failed(made).cause, cause)
            self.assertEqual(made.GetOutput().GetNumberOfCells(), 0)
        made = vtk.ContoursToTetrahedra()
        made.SetRepair(True)
        made.SetInputDataObject(crossed)
        made.Update()
        self.assertIsNone(made.GetError())


class Files(unittest.TestCase):
    def test_contours_go_through_files(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "root.json"
            writer = vtk.ContoursWriter()
            writer.SetInputDataObject(vtk.to_polydata(odontoscope.Contours(root())))
            writer.SetFileName(file)
            writer.Write()
            reader = vtk.ContoursReader()
            reader.SetFileName(file)
            reader.Update()
            self.assertEqual(vtk.from_polydata(reader.GetOutput()), odontoscope.contours(file))
            odontoscope.reconstruct(root()).save(pathlib.Path(folder) / "root.ply")
            mesh = vtk.ModelReader()
            mesh.SetFileName(pathlib.Path(folder) / "root.ply")
            mesh.Update()
            self.assertEqual(faulty_edges(mesh.GetOutputPort()), 0)
            writer.SetFileName(pathlib.Path(folder) / "none" / "x.json")
            vtkObject.GlobalWarningDisplayOff()
            self.addCleanup(vtkObject.GlobalWarningDisplayOn)
            with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(odontoscope.FileError):
                writer.Write()


if __name__ == "__main__":
    unittest.main()
