"""VTK's own ways from contours to surfaces, and ours, on teeth with known truth: a table in Markdown.

    PYTHONPATH=build/release/python /usr/bin/python3 tests/truth/compare_with_vtk.py build/release/tests/truth/odontoscope_truth [--seeds 1..4] [--spacing 0.25]

Every way gets the same contours, one structure at a time:
    voxel contours   vtkVoxelContoursToSurfaceFilter: a field of distances to the contours' lines, contoured at 0
    stencil          contours filled by vtkPolyDataToImageStencil, vtkDiscreteFlyingEdges3D of the labels
    shape-based      distances to each slice's border (vtkImageEuclideanDistance), linear in between (vtkImageResample), vtkFlyingEdges3D at 0
    DT               odontoscope.vtk.ContoursToSurface
vtkContourTriangulator fills contours in their own planes, and makes nothing between them: it is none of these ways.
In-plane pixels are PIXEL mm wide. Times are of one thread, by the clock; what makes the input is not counted.
"""
import argparse
import collections
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np
import odontoscope
from odontoscope import vtk
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkDiscreteFlyingEdges3D, vtkTransformPolyDataFilter, vtkVoxelContoursToSurfaceFilter
from vtkmodules.vtkImagingCore import vtkImageResample
from vtkmodules.vtkImagingGeneral import vtkImageEuclideanDistance
from vtkmodules.vtkImagingStencil import vtkImageStencil, vtkPolyDataToImageStencil
from vtkmodules.vtkIOPLY import vtkPLYWriter

PIXEL, MARGIN, UPSAMPLE = 0.05, 3, 5   # mm, pixels, layers a slab


class Grid:
    """Pixels that hold all contours with a margin, one layer a slice and an empty one at either end."""

    def __init__(self, stack):
        points = np.concatenate([points for row in stack for _, points in row])
        self.low = points.min(axis=0) - MARGIN * PIXEL
        self.columns, self.rows = (int(n) for n in np.ceil((points.max(axis=0) - self.low) / PIXEL) + MARGIN)
        self.spacing = stack.heights[1] - stack.heights[0]
        self.layers = len(stack) + 2
        self.bottom = stack.heights[0] - self.spacing

    def image(self, values, upsample=1):
        made = vtkImageData()
        made.SetDimensions(self.columns, self.rows, values.shape[0])
        made.SetSpacing(PIXEL, PIXEL, self.spacing / upsample)
        made.SetOrigin(*self.low, self.bottom)
        made.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))
        return made


def layer(rings, z, grid):
    """1 within the contours of one slice, 0 elsewhere."""
    if not rings:
        return np.zeros((grid.rows, grid.columns), dtype=np.uint8)
    flat = vtk.to_polydata(odontoscope.Contours([(0, ring) for ring in rings] + [(1, None)]))
    stencil = vtkPolyDataToImageStencil()
    stencil.SetOutputOrigin(*grid.low, 0)
    stencil.SetOutputSpacing(PIXEL, PIXEL, 1)
    stencil.SetOutputWholeExtent(0, grid.columns - 1, 0, grid.rows - 1, 0, 0)
    stencil.SetInputData(flat)   # of lines in its plane
    blank = vtkImageData()
    blank.SetDimensions(grid.columns, grid.rows, 1)
    blank.SetSpacing(PIXEL, PIXEL, 1)
    blank.SetOrigin(*grid.low, 0)
    blank.AllocateScalars(VTK_UNSIGNED_CHAR, 1)
    blank.GetPointData().GetScalars().Fill(1)
    drawn = vtkImageStencil()
    drawn.SetInputData(blank)
    drawn.SetStencilConnection(stencil.GetOutputPort())
    drawn.SetBackgroundValue(0)
    drawn.Update()
    return vtk_to_numpy(drawn.GetOutput().GetPointData().GetScalars()).reshape(grid.rows, grid.columns).copy()


def layers(stack, grid):
    empty = np.zeros((grid.rows, grid.columns), dtype=np.uint8)
    return np.stack([empty, *(layer([points for _, points in row], z, grid) for z, row in zip(stack.heights, stack)), empty])


def voxel_contours(stack):
    """The filter wants polygons, pixels of 1, and slices at whole numbers to the last bit, the lowest at 1; it gives z in its spacing."""
    grid = Grid(stack)
    lowest = next(number for number, row in enumerate(stack) if row)
    points, polygons = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for number, row in enumerate(stack, 1 - lowest):
        for _, ring in row:
            polygons.InsertNextCell(len(ring))
            for x, y in (ring - grid.low) / PIXEL:
                polygons.InsertCellPoint(points.InsertNextPoint(x, y, number))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(polygons)
    surface = vtkVoxelContoursToSurfaceFilter()
    surface.SetInputData(data)
    surface.SetSpacing(1, 1, grid.spacing / PIXEL)
    back, to_mm = vtkTransformPolyDataFilter(), vtkTransform()
    to_mm.PostMultiply()
    to_mm.Scale(PIXEL, PIXEL, PIXEL)
    to_mm.Translate(*grid.low, grid.bottom + lowest * grid.spacing)
    back.SetInputConnection(surface.GetOutputPort())
    back.SetTransform(to_mm)
    back.Update()
    return back.GetOutput()


def stencil(stack):
    grid = Grid(stack)
    surface = vtkDiscreteFlyingEdges3D()
    surface.SetInputData(grid.image(layers(stack, grid)))
    surface.SetValue(0, 1)
    surface.Update()
    return surface.GetOutput()


def distances(mask, grid):
    def from_zero(values):
        one = grid.image(values[None].astype(np.float32))
        measured = vtkImageEuclideanDistance()
        measured.SetInputData(one)
        measured.SetAlgorithmToSaito()
        measured.ConsiderAnisotropyOff()
        measured.Update()
        return np.sqrt(vtk_to_numpy(measured.GetOutput().GetPointData().GetScalars()).reshape(mask.shape))
    inside = from_zero(mask) if mask.any() else np.zeros(mask.shape)
    outside = from_zero(1 - mask) if mask.any() else np.full(mask.shape, np.hypot(*mask.shape))
    return np.where(mask > 0, inside - 0.5, 0.5 - outside).astype(np.float32)


def shape_based(stack):
    grid = Grid(stack)
    fields = np.stack([distances(mask, grid) for mask in layers(stack, grid)])
    # Beyond the first and the last slice nothing is known: half a slice on, as far as a label map's voxels go.
    fields[0], fields[-1] = -np.abs(fields[1]), -np.abs(fields[-2])
    finer = vtkImageResample()
    finer.SetInputData(grid.image(fields))
    finer.SetAxisMagnificationFactor(2, UPSAMPLE)
    finer.SetInterpolationModeToLinear()
    surface = vtkFlyingEdges3D()
    surface.SetInputConnection(finer.GetOutputPort())
    surface.SetValue(0, 0)
    surface.ComputeNormalsOff(), surface.ComputeGradientsOff(), surface.ComputeScalarsOff()
    surface.Update()
    return surface.GetOutput()


def ours(stack):
    surface = vtk.ContoursToSurface()
    surface.SetInputDataObject(vtk.to_polydata(stack))
    surface.SetThreads(1)
    surface.Update()
    if surface.GetError():
        raise surface.GetError()
    return surface.GetOutput()


WAYS = {"voxel contours": voxel_contours, "stencil": stencil, "shape-based": shape_based, "DT": ours}


def written(surface, file):
    triangles = vtkTriangleFilter()
    triangles.SetInputData(surface)
    writer = vtkPLYWriter()
    writer.SetInputConnection(triangles.GetOutputPort())
    writer.SetFileName(str(file))
    writer.Write()


def seeds(text):
    first, _, last = text.partition("..")
    return range(int(first), int(last or first) + 1)


def main():
    asked = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    asked.add_argument("truth", type=pathlib.Path, help="the program odontoscope_truth")
    asked.add_argument("--seeds", type=seeds, default=seeds("1..4"))
    asked.add_argument("--spacing", default="0.25", help="of slices, mm")
    asked = asked.parse_args()
    cells = collections.defaultdict(list)
    with tempfile.TemporaryDirectory() as kept:
        folder = pathlib.Path(kept)
        for seed in asked.seeds:
            subprocess.run([asked.truth, "tooth", "--seed", str(seed), "--spacing", asked.spacing, "-o", folder / "tooth.json"], check=True, stdout=subprocess.DEVNULL)
            whole = odontoscope.contours(folder / "tooth.json")
            meshes = []
            for structure in whole.structures:
                stack = odontoscope.contours(folder / "tooth.json", structure=structure)
                for way, make in WAYS.items():
                    start = time.perf_counter()
                    surface = make(stack)
                    took = time.perf_counter() - start
                    file = folder / f"{structure}-{way.replace(' ', '-')}.ply"
                    written(surface, file)
                    meshes.append((structure, way, took, file))
            held = subprocess.run([asked.truth, "mesh", "--seed", str(seed), *(f"{structure}={file}" for structure, _, _, file in meshes)], capture_output=True, text=True)
            if held.returncode:
                print(f"seed {seed} left out: {held.stderr.strip()}", file=sys.stderr)
                continue
            for (structure, way, took, _), line in zip(meshes, held.stdout.splitlines()):
                cells[structure, way].append({**json.loads(line), "seconds": took})
                print(f"seed {seed} {structure} {way}: {line}", file=sys.stderr)
    print(f"| {asked.spacing} mm | " + " | ".join(WAYS) + " |")
    print("|---" * (len(WAYS) + 1) + "|")
    rows = [("closed, oriented, manifold", lambda found: f"{sum(one['closed'] for one in found)} of {len(found)}"),
            ("right topology", lambda found: f"{sum(one['found'] == one['true'] for one in found)} of {len(found)}"),
            ("mean distance, mm", lambda found: f"{statistics.mean(one['mean'] for one in found):.4f}"),
            ("largest distance, mm", lambda found: f"{statistics.mean(one['largest'] for one in found):.2f}"),
            ("triangles", lambda found: f"{statistics.mean(one['triangles'] for one in found):,.0f}"),
            ("seconds", lambda found: f"{statistics.mean(one['seconds'] for one in found):.2f}")]
    for structure in dict.fromkeys(name for name, _ in cells):
        for title, tell in rows:
            print(f"| {structure}, {title} | " + " | ".join(tell(cells[structure, way]) for way in WAYS) + " |")


if __name__ == "__main__":
    main()
