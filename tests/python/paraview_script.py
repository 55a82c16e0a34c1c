"""Run by pvbatch: the plugin in ParaView, from loading it to a picture. Prints PASSED, or dies of what was wrong."""
import inspect
import os
import sys
import tempfile

import odontoscope
from paraview import simple
from paraview.simple import (Clip, ColorBy, FindSource, GetActiveViewOrCreate, GetColorTransferFunction, LoadPlugin, LoadState, Render, ResetSession, SaveData, SaveScreenshot,
                             SaveState, Show, servermanager)
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkMassProperties

folder = sys.argv[1]
plugin = os.path.join(os.path.dirname(odontoscope.__file__), "paraview", "OdontoscopePlugin.py")
LoadPlugin(plugin, ns=globals())


def fetched(source):
    source.UpdatePipeline()
    return servermanager.Fetch(source)


def called(option):
    return "".join(part.capitalize() for part in option.split("_"))


# Every option of the package is a property, and as it stands means the same.
tooth = OdontoscopeSampleContours(Kind="incisor", SliceSpacing=0.35, PointSpacing=0.5)   # noqa: F821 (of the plugin)
surface = OdontoscopeContoursToSurface(Input=tooth)   # noqa: F821
for option in set(inspect.signature(odontoscope.reconstruct).parameters) - {"source", "progress", "reading", "as_given"}:
    assert hasattr(surface, called(option)), f"the filter has no {called(option)}"
reader_options = set(inspect.signature(odontoscope.contours).parameters) - {"source", "progress", "widest_gap", "allow_outside"}

# Closed, oriented, and the package's own volume.
made = fetched(surface)
edges = vtkFeatureEdges()
edges.SetInputData(made)
edges.FeatureEdgesOff(), edges.ManifoldEdgesOff(), edges.BoundaryEdgesOn(), edges.NonManifoldEdgesOn()
edges.Update()
assert made.GetNumberOfCells() > 1000 and edges.GetOutput().GetNumberOfCells() == 0
mass = vtkMassProperties()
mass.SetInputData(made)
mass.Update()
model = odontoscope.reconstruct(odontoscope.sample("incisor", slice_spacing=0.35, point_spacing=0.5))
wanted = sum(solid.volume for solid in model.solids)
assert abs(mass.GetVolume() - wanted) < 1e-5 * wanted, (mass.GetVolume(), wanted)
assert made.GetNumberOfCells() == sum(len(solid.triangles) for solid in model.solids)

# Properties reach the engine.
surface.Triangles = 800
assert fetched(surface).GetNumberOfCells() <= 800
surface.Triangles = 0
surface.Method, surface.Grid, surface.Cases = "db", "24x20", "consistent"
by_db = odontoscope.reconstruct(odontoscope.sample("incisor", slice_spacing=0.35, point_spacing=0.5), method="db", grid=(24, 20), cases="consistent")
assert fetched(surface).GetNumberOfCells() == sum(len(solid.triangles) for solid in by_db.solids)
surface.Grid = "many"   # told, and left as it was
assert fetched(surface).GetNumberOfCells() == sum(len(solid.triangles) for solid in by_db.solids)
tooth.Filled = 1
solid = OdontoscopeContoursToTetrahedra(Input=tooth, Partition="on", Priority="pulp,dentine,enamel", Gap=0.01, Threads=1)   # noqa: F821
grid = fetched(solid)
joined = odontoscope.reconstruct(odontoscope.sample("incisor", slice_spacing=0.35, point_spacing=0.5, filled=True), partition=True, priority="pulp,dentine,enamel", gap=0.01)
assert grid.GetNumberOfPoints() == len(joined.complex.points) and grid.GetNumberOfCells() == len(joined.complex.tetrahedra)

# Files: written, read again, and found by their endings.
contours = os.path.join(folder, "tooth.json")
SaveData(contours, proxy=tooth)
again = OdontoscopeContoursReader(FileName=contours)   # noqa: F821
for option in reader_options:
    assert hasattr(again, called(option)), f"the reader has no {called(option)}"
assert fetched(again).GetNumberOfCells() == fetched(tooth).GetNumberOfCells()
again.Structure = "dentine"
assert 0 < fetched(again).GetNumberOfCells() < fetched(tooth).GetNumberOfCells()
model.save(os.path.join(folder, "tooth.glb"))
assert fetched(OdontoscopeModelReader(FileName=os.path.join(folder, "tooth.glb"))).GetNumberOfCells() == made.GetNumberOfCells()   # noqa: F821

# An image of ParaView's own.
ball = simple.Wavelet(WholeExtent=[-8, 8, -8, 8, -8, 8])
outline = OdontoscopeImageToContours(Input=ball, Iso="150=ball")   # noqa: F821
assert fetched(outline).GetNumberOfCells() >= 8

# A state and a picture.
half = Clip(Input=solid, ClipType="Plane")
half.ClipType.Normal = [0, 1, 0]
half.Crinkleclip = 1
view = GetActiveViewOrCreate("RenderView")
view.ViewSize = [320, 240]
shown = Show(half, view)
ColorBy(shown, ("CELLS", "structure"))
view.ResetActiveCameraToNegativeY()
Render(view)
SaveScreenshot(os.path.join(folder, "tooth.png"), view, ImageResolution=[320, 240])
SaveState(os.path.join(folder, "tooth.pvsm"))
print("PASSED")
