"""Odontoscope as VTK filters, for scripts with VTK 9 (Debian: python3-vtk9).

    ContoursToTetrahedra   closed polylines or polygons in planes of constant z -> vtkUnstructuredGrid of tetrahedra (DT)
    ContoursToSurface      the same -> vtkPolyData of triangles (DT or DB)
    ImageToContours        vtkImageData, an image or a label map -> vtkPolyData of closed polylines
    SampleContours         the contours of a made-up tooth -> vtkPolyData of closed polylines
    ContoursReader         a file of contours, or a mesh cut by planes -> vtkPolyData of closed polylines
    ContoursWriter         closed polylines or polygons -> a contour stack file
    ModelReader            a glTF, STL, PLY or OBJ file -> vtkPolyData of triangles

Every option of ``odontoscope.reconstruct`` is a property with VTK's Set and Get: ``SetCorrespondence("medial")``, ``GetTriangles()``.
Units are millimetres. Arrays are named as in the files that the program writes: cell data ``structure`` counts structures from 1, and field data
``structure NAME`` holds the number of NAME; ``label`` is a tetrahedron's material.

A contour's structure is told by its cell's ``structure``: names (vtkStringArray), or numbers that field data ``structure NAME`` names ("structure-N"
where nothing does). Without that array all contours are of "tooth".

Errors are printed by VTK's pipeline, which then gives an empty output: ``filter.GetError()`` is the exception (odontoscope.Error), or None.
"""

from __future__ import annotations

import sys
from typing import Any, Optional

import numpy as np
from vtkmodules.util import numpy_support
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkCellArray, vtkImageData, vtkPolyData, vtkUnstructuredGrid

from . import Contours, Model, Solid, Volume, contours as _contours, read_mesh as _read_mesh, reconstruct as _reconstruct, sample as _sample
from .errors import Error, InputError, UsageError, refuse as _refuse

__all__ = ["ContoursReader", "ContoursToSurface", "ContoursToTetrahedra", "ContoursWriter", "ImageToContours", "ModelReader", "SampleContours", "from_image",
           "from_polydata", "to_interfaces", "to_polydata", "to_surface", "to_tetrahedra"]

#: Points of a contour, and contours of a slice, count as in one plane where their z differ by no more than this share of the largest
#: coordinate: what single precision rounds.
PLANE_TOLERANCE = 1e-6


def _names(numbers: np.ndarray, field: Any) -> list[str]:
    called = {}
    for n in range(field.GetNumberOfArrays()):
        array = field.GetAbstractArray(n)
        if array.GetName() and array.GetName().startswith("structure ") and array.GetNumberOfValues() == 1:
            called[int(array.GetVariantValue(0).ToDouble())] = array.GetName()[len("structure "):]
    return [called.get(int(number), f"structure-{int(number)}") for number in numbers]


def _structures(data: vtkPolyData) -> list[str]:
    array = data.GetCellData().GetAbstractArray("structure")
    if array is None:
        return ["tooth"] * data.GetNumberOfCells()
    if isinstance(array, vtkStringArray):
        return [array.GetValue(n) for n in range(array.GetNumberOfValues())]
    return _names(numpy_support.vtk_to_numpy(array), data.GetFieldData())


def _rings(cells: vtkCellArray, closed: bool, first: int):
    """Cell number and point numbers of each contour."""
    offsets = numpy_support.vtk_to_numpy(cells.GetOffsetsArray())
    connectivity = numpy_support.vtk_to_numpy(cells.GetConnectivityArray())
    for n in range(len(offsets) - 1):
        ring = connectivity[offsets[n]:offsets[n + 1]]
        if not closed:
            if len(ring) < 4 or ring[0] != ring[-1]:
                raise _refuse(InputError, f"cell {first + n} is a line of {len(ring)} points that does not close", "Join segments with vtkStripper (JoinContiguousSegmentsOn) first",
                              "open-contour", name="input")
            ring = ring[:-1]
        yield first + n, ring


def from_polydata(data: vtkPolyData, source: str = "VTK", repair: bool = False) -> Contours:
    """Contours of closed polylines (first point named again as last) and polygons, each in a plane of constant z."""
    if data.GetNumberOfStrips() or data.GetNumberOfPoints() == 0:
        raise _refuse(InputError, "holds no contours" if data.GetNumberOfPoints() == 0 else "holds triangle strips", "Give closed polylines or polygons", "unsupported", name="input")
    points = np.asarray(numpy_support.vtk_to_numpy(data.GetPoints().GetData()), dtype=np.float64)
    structures = _structures(data)
    verts = data.GetNumberOfVerts()
    rings = list(_rings(data.GetLines(), False, verts)) + list(_rings(data.GetPolys(), True, verts + data.GetNumberOfLines()))
    tolerance = PLANE_TOLERANCE * float(np.abs(points).max(initial=0, where=np.isfinite(points)))
    given = []
    for cell, ring in rings:
        heights = points[ring, 2]
        if not np.ptp(heights) <= tolerance:   # NaN too
            raise _refuse(InputError, f"cell {cell} has z from {heights.min():g} to {heights.max():g}", "Contours lie in planes of constant z: turn the model first", "not-planar",
                          name="input")
        given.append((float(heights[0]), points[ring, :2], structures[cell]))
    planes: list[float] = []
    for z in sorted({z for z, _, _ in given}):
        if not planes or z - planes[-1] > tolerance:
            planes.append(z)
    nearest = np.searchsorted(planes, [z for z, _, _ in given], side="right") - 1
    return Contours(sorted(((planes[n], xy, name) for n, (_, xy, name) in zip(nearest, given)), key=lambda row: row[0]), source, repair)


def from_image(image: vtkImageData, source: str = "VTK") -> Volume:
    """The active point scalars of an image, of one component, with its spacing, origin and direction (mm)."""
    scalars = image.GetPointData().GetScalars()
    if scalars is None or scalars.GetNumberOfComponents() != 1:
        raise _refuse(InputError, "has no scalars" if scalars is None else f"has {scalars.GetNumberOfComponents()} components", "Give an image of one number a voxel", "unsupported", name="input")
    columns, rows, slices = image.GetDimensions()
    low = image.GetExtent()[0::2]
    direction = np.array([[image.GetDirectionMatrix().GetElement(row, column) for column in range(3)] for row in range(3)])
    origin = np.array(image.GetOrigin()) + direction @ (np.array(low) * image.GetSpacing())   # of the first voxel that there is
    return Volume(numpy_support.vtk_to_numpy(scalars).reshape(slices, rows, columns), image.GetSpacing(), origin, direction, source)


def _name_structures(data: Any, names: list[str]) -> None:
    for number, name in enumerate(names, 1):
        array = vtkIntArray()
        array.SetName(f"structure {name}")
        array.InsertNextValue(number)
        data.GetFieldData().AddArray(array)


def _cell_array(cells: np.ndarray) -> vtkCellArray:
    offsets = np.arange(0, cells.size + 1, cells.shape[1], dtype=np.int64)
    array = vtkCellArray()
    array.SetData(numpy_support.numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_support.numpy_to_vtkIdTypeArray(np.ascontiguousarray(cells, dtype=np.int64).ravel(), deep=True))
    return array


def _points(blocks: list[np.ndarray]) -> vtkPoints:
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_support.numpy_to_vtk(np.concatenate(blocks) if blocks else np.zeros((0, 3)), deep=True))   # VTK may change what it holds
    return points


def _cell_data(data: Any, name: str, values: np.ndarray) -> None:
    array = numpy_support.numpy_to_vtk(values, deep=True)
    array.SetName(name)
    data.GetCellData().AddArray(array)


def _together(parts: list[tuple[np.ndarray, np.ndarray]]) -> tuple[list[np.ndarray], np.ndarray, np.ndarray]:
    """Points, cells that count them in a row, and each cell's part from 1."""
    starts = np.cumsum([0] + [len(points) for points, _ in parts])
    cells = [cells.astype(np.int64) + start for (_, cells), start in zip(parts, starts)]
    numbers = np.repeat(np.arange(1, len(parts) + 1, dtype=np.int32), [len(cells) for _, cells in parts])
    return [points for points, _ in parts], np.concatenate(cells), numbers


def to_tetrahedra(model: Model) -> vtkUnstructuredGrid:
    """All structures' tetrahedra in one grid; those of a partition share their points."""
    shared, solids = model.complex, model.solids
    if shared is not None:
        names, blocks, cells, labels = list(shared.structures), [shared.points], shared.tetrahedra, shared.labels
        numbers = labels.astype(np.int32)
    else:
        names = [solid.structure for solid in solids]
        blocks, cells, numbers = _together([(solid.tetrahedron_points, solid.tetrahedra) for solid in solids])
        labels = np.concatenate([solid.labels for solid in solids])
    grid = vtkUnstructuredGrid()
    grid.SetPoints(_points(blocks))
    grid.SetCells(VTK_TETRA, _cell_array(cells))
    _cell_data(grid, "structure", numbers)
    _cell_data(grid, "label", labels.astype(np.int32))
    _name_structures(grid, names)
    return grid


def to_surface(solids: list[Solid]) -> vtkPolyData:
    """All surfaces in one vtkPolyData, each with points of its own; triangles counter-clockwise seen from outside."""
    data = vtkPolyData()
    if not solids:
        return data
    blocks, cells, numbers = _together([(solid.points, solid.triangles) for solid in solids])
    data.SetPoints(_points(blocks))
    data.SetPolys(_cell_array(cells))
    _cell_data(data, "structure", numbers)
    _name_structures(data, [solid.structure for solid in solids])
    return data


def to_interfaces(model: Model) -> vtkPolyData:
    """Of a partition every face between two labels, once: cell data "inside" and "outside" are the labels, 0 for void; counter-clockwise seen from outside."""
    shared = model.complex
    if shared is None:
        raise _refuse(UsageError, "the model's structures share no faces", "Make it with partition=True")
    data = vtkPolyData()
    data.SetPoints(_points([shared.points]))
    data.SetPolys(_cell_array(shared.interfaces))
    for column, name in enumerate(("inside", "outside")):
        _cell_data(data, name, np.ascontiguousarray(shared.interface_labels[:, column], dtype=np.int32))
    _name_structures(data, list(shared.structures))
    return data


def to_polydata(stack: Contours) -> vtkPolyData:
    """Closed polylines, slice by slice."""
    names = list(stack.structures)
    blocks, rings, numbers = [], [], []
    start = 0
    for z, row in zip(stack.heights, stack):
        for structure, points in row:
            blocks.append(np.column_stack([points, np.full(len(points), z)]))
            rings.append(np.append(np.arange(start, start + len(points), dtype=np.int64), start))
            numbers.append(names.index(structure) + 1)
            start += len(points)
    offsets = np.cumsum([0] + [len(ring) for ring in rings], dtype=np.int64)
    lines = vtkCellArray()
    lines.SetData(numpy_support.numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_support.numpy_to_vtkIdTypeArray(np.concatenate(rings), deep=True))
    data = vtkPolyData()
    data.SetPoints(_points(blocks))
    data.SetLines(lines)
    _cell_data(data, "structure", np.array(numbers, dtype=np.int32))
    _name_structures(data, names)
    return data


class _Aborted(Exception):
    """VTK's own way to end a filter: AbortExecuteOn."""


class _Options:
    """Set and Get for each of ``_options``, in VTK's way: what changes makes the filter run again."""

    _options: dict[str, Any] = {}

    def _begin(self) -> None:
        self._values = dict(self._options)
        self._error: Optional[Exception] = None

    def __init_subclass__(cls, **words: Any):
        super().__init_subclass__(**words)
        for option in cls.__dict__.get("_options", {}):   # not again in a subclass, which may have setters of its own
            name = "".join(part.capitalize() for part in option.split("_"))

            def put(self, value, option=option):
                if self._values[option] is not value and self._values[option] != value:
                    self._values[option] = value
                    self.Modified()

            def get(self, option=option):
                return self._values[option]

            put.__doc__ = f"odontoscope.reconstruct's {option}; default {cls._options[option]!r}."
            setattr(cls, f"Set{name}", put)
            setattr(cls, f"Get{name}", get)

    def GetError(self) -> Optional[Exception]:
        """What went wrong when this last ran, or None."""
        return self._error

    def GetOutput(self, port: int = 0) -> Any:
        return self.GetOutputDataObject(port)

    def _guarded(self, work, output) -> int:
        self._error = None
        try:
            work()
            return 1
        except _Aborted:
            output.Initialize()
            return 1
        except Error as error:
            self._error = error
            output.Initialize()
            print(f"{type(self).__name__}: {error}", file=sys.stderr)
            return 0


_dt = {"correspondence": "tracked", "between": "blended", "links": None, "link": (), "unlink": (), "together": (), "partition": None, "priority": None, "gap": None, "elements": None, "strict": False, "threads": 0}
_db = {"grid": 128, "cases": "classic", "field": "hybrid", "split": (), "decimate": None}


class _Filter(_Options, VTKPythonAlgorithmBase):
    def __init__(self, output: str):
        VTKPythonAlgorithmBase.__init__(self, nInputPorts=1, nOutputPorts=1, inputType="vtkPolyData", outputType=output)
        self._begin()
        self._model: Optional[Model] = None

    def GetModel(self) -> Optional[Model]:
        """The odontoscope.Model behind the output: report, links, verdict; None before the first run, or if that failed."""
        return self._model

    def _made(self, inputs: Any, **more: Any) -> Model:
        self._model = None
        words = {name: value for name, value in self._values.items() if name != "repair"}
        self._model = _reconstruct(from_polydata(vtkPolyData.GetData(inputs[0]), repair=self._values["repair"]), progress=self._told, **words, **more)
        return self._model

    def _told(self, stage: str, fraction: float) -> None:
        self.UpdateProgress(fraction)
        if self.GetAbortExecute():
            raise _Aborted


class ContoursToTetrahedra(_Filter):
    """Contours to a certified solid of tetrahedra, by DT."""

    _options = {**_dt, "repair": False}

    def __init__(self):
        super().__init__("vtkUnstructuredGrid")

    def RequestData(self, request, inputs, outputs):
        output = vtkUnstructuredGrid.GetData(outputs)
        return self._guarded(lambda: output.ShallowCopy(to_tetrahedra(self._made(inputs))), output)


class ContoursToSurface(_Filter):
    """Contours to surfaces: certified by DT (``SetMethod("dt")``, the default), or as marching cubes makes them ("db")."""

    _options = {"method": "dt", **_dt, "triangles": None, **_db, "repair": False}

    def __init__(self):
        super().__init__("vtkPolyData")

    def RequestData(self, request, inputs, outputs):
        output = vtkPolyData.GetData(outputs)
        return self._guarded(lambda: output.ShallowCopy(to_surface(self._made(inputs).solids)), output)


class ImageToContours(_Options, VTKPythonAlgorithmBase):
    """An image (``SetIso``) or a label map (``SetLabel``) to contours: closed polylines, slice by slice."""

    _options = {"iso": None, "label": None, "label_names": None, "min_area": None, "smooth": None, "simplify": None, "crop": None, "resample": None, "upright": False}

    def __init__(self):
        VTKPythonAlgorithmBase.__init__(self, nInputPorts=1, nOutputPorts=1, inputType="vtkImageData", outputType="vtkPolyData")
        self._begin()

    def RequestData(self, request, inputs, outputs):
        image, output = vtkImageData.GetData(inputs[0]), vtkPolyData.GetData(outputs)
        return self._guarded(lambda: output.ShallowCopy(to_polydata(_contours(from_image(image), **self._values))), output)


class _Reader(_Options, VTKPythonAlgorithmBase):
    def __init__(self):
        VTKPythonAlgorithmBase.__init__(self, nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")
        self._begin()

    def RequestData(self, request, inputs, outputs):
        output = vtkPolyData.GetData(outputs)
        return self._guarded(lambda: output.ShallowCopy(self._read()), output)


class SampleContours(_Reader):
    """Contours of a made-up tooth, as ``odontoscope.sample`` gives them."""

    _options = {"kind": "molar", "slice_spacing": None, "point_spacing": 0.22, "apart": False, "filled_dentine": False, "filled": False, "open_apex": False}

    def _read(self) -> vtkPolyData:
        return to_polydata(_sample(**self._values))


class ContoursReader(_Reader):
    """Contours from whatever ``odontoscope.contours`` reads: its words are properties."""

    _options = {"file_name": "", **ImageToContours._options, "spacing": None, "series": "", "spacing_z": None, "at": (),
                "structure": None, "repair": False}

    def _read(self) -> vtkPolyData:
        words = {name: value for name, value in self._values.items() if name != "file_name"}
        return to_polydata(_contours(self._values["file_name"], **words))


class ModelReader(_Reader):
    """Surfaces of a glTF, STL, PLY or OBJ file, millimetres, z up."""

    _options = {"file_name": ""}

    def _read(self) -> vtkPolyData:
        return to_surface(_read_mesh(self._values["file_name"]))


class ContoursWriter(_Options, VTKPythonAlgorithmBase):
    """Closed polylines or polygons to a contour stack file, whole or not at all: SetFileName, SetInputConnection, Write."""

    _options = {"file_name": "", "repair": False}

    def __init__(self):
        VTKPythonAlgorithmBase.__init__(self, nInputPorts=1, nOutputPorts=0, inputType="vtkPolyData")
        self._begin()

    def RequestData(self, request, inputs, outputs):
        data = vtkPolyData.GetData(inputs[0])
        return self._guarded(lambda: from_polydata(data, repair=self._values["repair"]).save(self._values["file_name"]), vtkPolyData())

    def Write(self) -> None:
        """Raises what went wrong."""
        self.Modified()
        self.Update()
        if self._error is not None:
            raise self._error
