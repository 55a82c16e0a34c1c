"""Solid, certified models of teeth from planar contours or CT volumes.

    >>> import odontoscope
    >>> tooth = odontoscope.sample("incisor")
    >>> model = odontoscope.reconstruct(tooth)
    >>> model.verdict
    'green'
    >>> [solid.structure for solid in model.solids]
    ['dentine', 'pulp', 'enamel']
    >>> model.solids[0].tetrahedra.shape[1]
    4

Functions and options are called as in the program: ``odontoscope reconstruct molar.json --min-area 4`` is
``odontoscope.reconstruct("molar.json", min_area=4)``. Units are millimetres; z runs along the tooth, right-handed. Results depend on
nothing but the input, whatever ``threads`` is.

Arrays that come out are views of what the library holds: nothing is copied, they are read-only (what they show was certified as it is),
and they stay valid however long they are kept. Arrays that go in are copied at once.

``progress=`` takes a function ``progress(stage, fraction)``, called from the thread that waits; what it raises ends the work. So does
Ctrl-C (KeyboardInterrupt). While the library works, other Python threads run.
"""

from __future__ import annotations

import html as _html
import json
import os
import pathlib
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any, Optional, Union

import numpy as np

from . import _core
from . import arrays as _arrays
from . import draw as _draw
from . import options as _options
from .errors import Error, FileError, GraphicsError, InputError, InternalError, UsageError, refuse as _refuse

__version__: str = _core.__version__
__all__ = [
    "Complex", "Contours", "Error", "FileError", "GraphicsError", "InputError", "InternalError", "Model", "Solid", "UsageError", "Volume", "anatomy",
    "check", "compare", "contours", "png", "read_mesh", "read_volume", "reconstruct", "render", "sample",
]

Progress = Callable[[str, float], Any]
Level = Union[float, str, Mapping[str, float], Iterable[Any]]
Source = Union["Contours", "Volume", str, "os.PathLike[str]", Iterable[Any]]
File = Union[str, "os.PathLike[str]"]
Look = Union[str, Iterable[str], Mapping[str, Any], None]


class Contours(Sequence):
    """A valid stack of planar contours: slices, each a list of ``(structure, points)``.

    Args:
        contours: tuples ``(z, points)`` or ``(z, points, structure)``. z in mm; points of shape (n, 2), mm, n at least 3, the last
            joining the first, in either direction; structure is "tooth" where it is left out. A structure is what lies within an odd number of its contours.
            ``(z, None)`` is a slice without contours. Slices come in order of first appearance.
        source: a name for messages.
        repair: mend what breaks the rules, and tell in ``changes`` what was changed.

    Raises InputError for what breaks the rules (docs/formats.md lists the causes), naming slice, contour and point.

        >>> square = [(0, 0), (4, 0), (4, 4), (0, 4)]
        >>> box = Contours([(0, square), (1, square)])
        >>> len(box), box.heights, box.structures
        (2, (0.0, 1.0), ('tooth',))
        >>> structure, points = box[1][0]
        >>> points.shape, points.flags.writeable
        ((4, 2), False)
        >>> Contours([(0, [(0, 0), (4, 4), (4, 0), (0, 4)]), (1, square)])
        Traceback (most recent call last):
        ...
        odontoscope.errors.InputError: slice 0 (z = 0), contour 0, point 0 at (2, 2): ... [self-crossing]
    """

    def __init__(self, contours: Iterable[Any], source: str = "", repair: bool = False, progress: Optional[Progress] = None):
        self._core = _core.stack([_given_contour(one, n) for n, one in enumerate(contours)], str(source), bool(repair), progress)

    @classmethod
    def _of(cls, core: Any) -> "Contours":
        made = cls.__new__(cls)
        made._core = core
        return made

    def __len__(self) -> int:
        return len(self.heights)

    def __getitem__(self, number):  # type: ignore[override]
        """The contours of slice ``number``: a list of (structure, points), points a read-only view of shape (n, 2), mm."""
        if isinstance(number, slice):
            return [self[n] for n in range(*number.indices(len(self)))]
        number = number.__index__()
        return self._core.slice(number + len(self) if number < 0 else number) if -len(self) <= number < len(self) else _no_slice(number, len(self))

    def __iter__(self) -> Iterator[list[tuple[str, np.ndarray]]]:
        return (self[n] for n in range(len(self)))

    @property
    def heights(self) -> tuple[float, ...]:
        """z of each slice, mm, in the order of the slices."""
        if "_heights" not in self.__dict__:
            self._heights = tuple(self._core.heights())
        return self._heights

    @property
    def structures(self) -> tuple[str, ...]:
        """Names, in order of first appearance."""
        return tuple(self._core.structures())

    @property
    def source(self) -> str:
        """The file it came from, or ""."""
        return self._core.source()

    @property
    def changes(self) -> tuple[str, ...]:
        """What ``repair`` changed, in words."""
        return tuple(self._core.changes)

    @property
    def remarks(self) -> tuple[str, ...]:
        """What the file left open and was assumed, or was left out, in words."""
        return tuple(self._core.remarks)

    def simplify(self, tolerance: float, progress: Optional[Progress] = None) -> "Contours":
        """Fewer points: contours move by up to ``tolerance`` mm, and stay disjoint."""
        return self._of(_core.simplify_contours(self._core, _options.optional_number(tolerance, "tolerance"), progress))

    def together(self, *structures: str) -> "Contours":
        """These structures as one, "A+B": the inner becomes a cavity of the outer."""
        return self._of(_core.together(self._core, list(structures)))

    def save(self, file: Union[str, "os.PathLike[str]"]) -> None:
        """As a contour stack (docs/formats.md), whole or not at all."""
        self._core.write(_options.path(file))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Contours) and self._core.text() == other._core.text()

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self):
        rows = [(z, points, structure) for z, row in zip(self.heights, self) for structure, points in row or [("", None)]]
        return type(self), (rows, self.source)

    def __repr__(self) -> str:
        count = sum(len(row) for row in self)
        return f"<odontoscope.Contours: {len(self)} slices, {count} contours of {', '.join(self.structures)}>"


def _no_slice(number: int, count: int) -> Any:
    raise IndexError(f"slice {number} of {count}")


def _given_contour(given: Any, number: int) -> tuple[float, str, Optional[np.ndarray]]:
    name = f"contour {number} of those given"
    if not isinstance(given, (tuple, list)) or len(given) not in (2, 3):
        raise _refuse(UsageError, f"{name} is no tuple", "Give (z, points) or (z, points, structure)")
    z, points = given[:2]
    structure = given[2] if len(given) == 3 else "tooth"
    if not isinstance(structure, str):
        raise _refuse(UsageError, f"the structure of {name} is {structure!r}", "Give a str")
    try:
        height = float(z)
    except (TypeError, ValueError):
        raise _refuse(UsageError, f"the height of {name} is {z!r}", "Give z in mm") from None
    return height, structure, None if points is None else _arrays.finite(points, name, 2)


class Volume:
    """A scalar image: CT, or a label map.

    Args:
        values: shape (slices, rows, columns), as SimpleITK, nibabel (transposed) and pydicom stacks have it; real numbers, kept as float32.
        spacing: size of a voxel along x (columns), y (rows), z (slices), mm.
        origin: centre of voxel [0, 0, 0], (x, y, z), mm.
        direction: 3 x 3; column n is the unit vector along which axis n (x, y, z) of the image runs, as in ITK. None: the identity.

    Voxels are put where ``direction`` says, and are never mirrored; an oblique image keeps its own frame (``tilt_degrees`` tells by how
    much). So ``values`` may have other axes than what was given.

        >>> ball = np.fromfunction(lambda k, j, i: 6 - np.hypot(np.hypot(i - 8, j - 8), k - 8), (17, 17, 17))
        >>> image = Volume(ball, spacing=(0.1, 0.1, 0.2))
        >>> image.values.shape, image.values.dtype.name, image.spacing
        ((17, 17, 17), 'float32', (0.1, 0.1, 0.2))
        >>> reconstruct(image, iso=0).solids[0].closed
        True
    """

    def __init__(self, values: Any, spacing: Sequence[float] = (1, 1, 1), origin: Sequence[float] = (0, 0, 0), direction: Any = None,
                 source: str = "", progress: Optional[Progress] = None):
        array = _arrays.numbers(values, "values", dimensions=3, kinds="fiub")
        with np.errstate(over="ignore"):   # what a float32 cannot hold becomes infinite, and is refused below
            array = np.ascontiguousarray(array, dtype=np.float32)
        axes = np.eye(3) if direction is None else _arrays.finite(direction, "direction", 3)
        if axes.shape != (3, 3):
            raise _refuse(InputError, f"has the shape {axes.shape}, not (3, 3)", "Give the unit vectors of x, y and z as columns", "wrong-shape", name="direction")
        self._core = _core.volume(array, _triple(spacing, "spacing"), _triple(origin, "origin"), axes.T.tolist(), str(source), progress)

    @classmethod
    def _of(cls, core: Any) -> "Volume":
        made = cls.__new__(cls)
        made._core = core
        return made

    @property
    def values(self) -> np.ndarray:
        """Shape (slices, rows, columns), float32: a read-only view."""
        return self._core.values()

    @property
    def spacing(self) -> tuple[float, float, float]:
        """Along x, y, z, mm."""
        return tuple(self._core.spacing())

    @property
    def origin(self) -> tuple[float, float, float]:
        """Centre of ``values[0, 0, 0]``: x, y, z, mm."""
        return tuple(self._core.origin())

    @property
    def tilt_degrees(self) -> float:
        """How far the image's own axes were turned away from x, y and z."""
        return self._core.tilt_degrees()

    @property
    def source(self) -> str:
        """The file it came from, or ""."""
        return self._core.source()

    @property
    def remarks(self) -> tuple[str, ...]:
        """What the file left open and was assumed, in words."""
        return tuple(self._core.remarks())

    @property
    def labels(self) -> dict[str, int]:
        """What the file calls its labels."""
        return {name: value for value, name in self._core.names()}

    def thresholds(self, classes: int = 2) -> list[float]:
        """Where its values part, by Otsu's method: ``classes`` - 1 thresholds. ``iso="auto"`` takes the first of two classes."""
        if not 2 <= _options.whole(classes, "classes", 2) <= 5:
            raise _refuse(UsageError, f"classes={classes} is too many", "Give 2 to 5")
        return self._core.thresholds(classes)

    def __repr__(self) -> str:
        slices, rows, columns = self.values.shape
        return f"<odontoscope.Volume: {columns} x {rows} x {slices} voxels of {' x '.join(f'{s:g}' for s in self.spacing)} mm>"


def _triple(given: Any, name: str) -> list[float]:
    array = _arrays.finite(given, name, dimensions=1)
    if array.shape != (3,):
        raise _refuse(InputError, f"has the shape {array.shape}, not (3,)", "Give x, y and z", "wrong-shape", name=name)
    return array.tolist()


def read_volume(file: Union[str, "os.PathLike[str]"], *, spacing: Optional[Sequence[float]] = None, series: str = "", allow_outside: bool = False,
                progress: Optional[Progress] = None) -> Volume:
    """NRRD, NIfTI, MetaImage, or a DICOM file or folder.

    ``spacing`` (x, y, z, mm) stands instead of the file's; ``series`` chooses among several DICOM series; ``allow_outside`` lets a header
    name pixels outside its own folder.
    """
    return Volume._of(_core.read_volume(_options.path(file), None if spacing is None else _triple(spacing, "spacing"), str(series), bool(allow_outside), progress))


def _iso_pairs(volume: Volume, iso: Any) -> list[tuple[float, str]]:
    pairs = []
    for value, name in _options.levels(iso):
        threshold = volume.thresholds()[0] if value == "auto" else _options.optional_number(value, "iso")
        pairs.append((threshold, name or "tooth"))
    return pairs


def _label_pairs(volume: Volume, label: Any) -> list[tuple[int, str]]:
    pairs = []
    known = volume.labels
    for value, name in _options.levels(label):
        if value in known:
            pairs.append((known[value], name or value))
            continue
        try:
            number = int(value)
        except ValueError:
            raise _refuse(InputError, f"no label is called \"{value}\"", "There are " + (", ".join(known) or "no names in this file; give a number"), "label-not-found") from None
        called = [title for title, its in known.items() if its == number]
        pairs.append((number, name or (called[0] if called else f"label-{number}")))
    return pairs


def _of_volume(volume: Volume, iso: Any, label: Any, area: Any, smooth: Any, simplify: Any, progress: Optional[Progress]) -> Contours:
    isos, labels = _iso_pairs(volume, iso), _label_pairs(volume, label)
    if not isos and not labels:
        raise _refuse(UsageError, "nothing says where in the volume the surface lies", "Give iso for an image (or iso=\"auto\"), label for a label map")
    return Contours._of(volume._core.contours(isos, labels, _options.min_area(area, volume.spacing), _options.optional_number(smooth, "smooth"),
                                              _options.optional_number(simplify, "simplify"), progress))


def contours(source: Source, *, iso: Optional[Level] = None, label: Optional[Level] = None, min_area: Union[float, str, None] = None,
             smooth: Optional[float] = None, simplify: Optional[float] = None, spacing: Optional[Sequence[float]] = None, series: str = "",
             allow_outside: bool = False, spacing_z: Optional[float] = None, at: Iterable[float] = (), structure: Union[str, Iterable[str], None] = None,
             repair: bool = False, widest_gap: Optional[float] = None, progress: Optional[Progress] = None) -> Contours:
    """Contours from whatever the program reads.

    Args:
        source: Contours; a Volume; tuples as Contours takes them; or a file: a contour stack, a series of Reconstruct or
            PyReconstruct, CSL, RTSTRUCT, a mesh (glTF, STL, PLY, OBJ) or, with ``iso`` or ``label``, a volume.
        iso: surface of a volume at a value: ``120``, ``"auto"``, ``"120=dentine"``, ``{"dentine": 120, "enamel": 195}``.
        label: surface of a label: ``2``, ``"2=pulp"``, ``{"pulp": 2}``, or a name that the file gives.
        min_area: leave out contours that enclose less: pixels of a slice, or ``"0.5mm2"``.
        smooth: smooth the borders of labels, by so many mm and half a voxel at most.
        simplify: fewer points: contours may move by so many mm, and stay disjoint.
        spacing, series, allow_outside: see read_volume.
        spacing_z, at: where to cut a mesh: every so many mm, or at these heights, mm.
        structure: keep these structures alone.
        repair, widest_gap: mend what breaks the rules; the widest gap of a mesh that is closed, mm.
    """
    of_volume = iso is not None or label is not None
    if isinstance(source, Contours):
        made = source
    elif isinstance(source, Volume):
        return _of_volume(source, iso, label, min_area, smooth, simplify, progress)
    elif isinstance(source, (str, bytes, os.PathLike)):
        if of_volume:
            volume = read_volume(source, spacing=spacing, series=series, allow_outside=allow_outside, progress=progress)  # type: ignore[arg-type]
            return _of_volume(volume, iso, label, min_area, smooth, simplify, progress)
        heights = [_options.optional_number(z, "at") for z in at]
        made = Contours._of(_core.read_contours(_options.path(source), _options.names(structure), _options.optional_number(spacing_z, "spacing_z"),
                                                heights, bool(repair), _options.optional_number(widest_gap, "widest_gap"), progress))
    else:
        made = Contours(source, repair=repair, progress=progress)
    if of_volume or min_area is not None or smooth is not None:
        raise _refuse(UsageError, "iso, label, min_area and smooth are about volumes, and these are contours", "Leave them out")
    return made if simplify is None else made.simplify(simplify, progress)


def _neighbours(tetrahedra: np.ndarray) -> np.ndarray:
    """Per face, opposite to each corner, the tetrahedron on its other side."""
    faces = np.sort(tetrahedra[:, [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]]].reshape(-1, 3), axis=1)
    order = np.lexsort(faces.T[::-1])
    twice = np.flatnonzero((faces[order[1:]] == faces[order[:-1]]).all(axis=1))
    found = np.full(len(faces), -1, dtype=np.int64)
    one, other = order[twice], order[twice + 1]
    found[one], found[other] = other // 4, one // 4
    return found.reshape(-1, 4)


class Solid:
    """One structure of a model, as arrays: read-only views without copies, that stay valid however long they are kept."""

    def __init__(self, part: Any):
        self._part = part

    @property
    def structure(self) -> str:
        """Its name."""
        return self._part.structure()

    @property
    def points(self) -> np.ndarray:
        """Of the surface: shape (n, 3), float64, mm."""
        return self._part.points()

    @property
    def triangles(self) -> np.ndarray:
        """Shape (n, 3), uint32, indices into ``points``; counter-clockwise seen from outside the material."""
        return self._part.triangles()

    @property
    def tetrahedron_points(self) -> Optional[np.ndarray]:
        """Of the tetrahedra: shape (n, 3), float64, mm. None where there are no tetrahedra: DB, and meshes from files."""
        return self._part.tetrahedron_points()

    @property
    def tetrahedra(self) -> Optional[np.ndarray]:
        """Shape (n, 4), uint32, indices into ``tetrahedron_points``; positive: det(b-a, c-a, d-a) > 0."""
        return self._part.tetrahedra()

    @property
    def labels(self) -> Optional[np.ndarray]:
        """Material of each tetrahedron: shape (n,), uint16."""
        return self._part.labels()

    @property
    def neighbours(self) -> Optional[np.ndarray]:
        """Behind the face opposite to each corner: shape (n, 4), int64, indices into ``tetrahedra``, -1 for outside. Worked out when asked for."""
        return None if self.tetrahedra is None else _neighbours(self.tetrahedra)

    @property
    def volume(self) -> float:
        """What the surface encloses, cavities taken off, mm^3."""
        return self._part.volume()

    @property
    def closed(self) -> bool:
        """The surface is a closed, oriented manifold."""
        return self._part.closed()

    def __repr__(self) -> str:
        solids = "" if self.tetrahedra is None else f", {len(self.tetrahedra)} tetrahedra"
        return f"<odontoscope.Solid {self.structure}: {len(self.triangles)} triangles{solids}, {self.volume:.4g} mm^3>"


class Complex:
    """One conforming complex of all structures (``partition=True``), which share their faces: read-only views without copies."""

    def __init__(self, core: Any):
        self._core = core

    @property
    def structures(self) -> tuple[str, ...]:
        """Names; label n is ``structures[n - 1]``."""
        return tuple(self._core.structures())

    @property
    def points(self) -> np.ndarray:
        """Shape (n, 3), float64, mm."""
        return self._core.points()

    @property
    def tetrahedra(self) -> np.ndarray:
        """Shape (n, 4), uint32, indices into ``points``; positive: det(b-a, c-a, d-a) > 0."""
        return self._core.tetrahedra()

    @property
    def labels(self) -> np.ndarray:
        """Structure of each tetrahedron, from 1: shape (n,), uint16."""
        return self._core.labels()

    @property
    def neighbours(self) -> np.ndarray:
        """Behind the face opposite to each corner: shape (n, 4), int64, indices into ``tetrahedra``, -1 for outside. Worked out when asked for."""
        return _neighbours(self.tetrahedra)

    @property
    def interfaces(self) -> np.ndarray:
        """Every face between two labels, once: shape (n, 3), uint32, indices into ``points``; counter-clockwise seen from the outer side."""
        return self._core.interfaces()

    @property
    def interface_labels(self) -> np.ndarray:
        """Of each interface the labels inside and outside, 0 for void: shape (n, 2), uint16."""
        return self._core.interface_labels()

    def __repr__(self) -> str:
        return f"<odontoscope.Complex of {', '.join(self.structures)}: {len(self.tetrahedra)} tetrahedra, {len(self.interfaces)} interfaces>"


class Model:
    """What ``reconstruct`` made: solids, links, and the report on both."""

    def __init__(self, core: Any, source: str):
        self._core = core
        self._source = source

    @property
    def solids(self) -> list[Solid]:
        """One for each structure, in order of first appearance."""
        return [Solid(part) for part in self._core.parts()]

    @property
    def complex(self) -> Optional[Complex]:
        """What the solids share, of a model made with ``partition=True``; else None."""
        core = self._core.complex()
        return None if core is None else Complex(core)

    def __getitem__(self, structure: str) -> Solid:
        """The solid of that name; KeyError if there is none."""
        for solid in self.solids:
            if solid.structure == structure:
                return solid
        raise KeyError(structure)

    @property
    def certified(self) -> bool:
        """Proven, by exact predicates, to be what docs/reconstruction.md promises; of DB: inspected, and found closed."""
        return self._core.certified()

    @property
    def verdict(self) -> str:
        """"green"; "amber": certified, but look at ``report["attention"]``; "" of a DB model, which has none."""
        return self._core.verdict()

    @property
    def links(self) -> list[dict[str, Any]]:
        """Every connection that was made, in the form that ``links=`` takes."""
        return json.loads(self._core.links())["links"]

    @property
    def report(self) -> dict[str, Any]:
        """The program's report, key by key (docs/formats.md)."""
        return json.loads(self._core.report())

    def anatomy(self, progress: Optional[Progress] = None) -> dict[str, Any]:
        """Canals, roots and structures in numbers (docs/formats.md)."""
        return json.loads(self._core.anatomy(self._source, progress))

    def save(self, *files: Union[str, "os.PathLike[str]"], progress: Optional[Progress] = None) -> None:
        """In the formats that the files' endings name, all or none: .glb .gltf .stl .ply .obj .wrl .x3d .vtp; tetrahedra .vtu .msh .inp."""
        self._core.write([_options.path(file) for file in files], progress)

    def render(self, *, view: str = "", size: Union[str, tuple[int, int], None] = None, samples: Optional[int] = None,
               scene: Optional[File] = None, camera: Optional[File] = None, parallel: bool = False, zoom: float = 1, hide: Union[str, Iterable[str], None] = None,
               opacity: Look = None, colour: Look = None, section: str = "", cap: str = "", cull: str = "", wire: bool = False,
               wall_depth: bool = False, overlay: Union[str, Iterable[str], None] = None, occlusion: Optional[float] = None,
               background: str = "", backend: str = "auto", save_scene: Optional[File] = None, progress: Optional[Progress] = None) -> np.ndarray:
        """A picture: shape (rows, columns, 4), uint8; red, green, blue (sRGB), alpha (not premultiplied); the first row is the top.

        Drawn without a display, by EGL or OSMesa; the pixels are those of ``odontoscope render``, whose options these are. Raises GraphicsError
        where the machine cannot draw.

        Args:
            view: "three-quarter", "buccal", "lingual", "mesial", "distal", "occlusal", "apical".
            size: width and height, pixels: the scene's, or 1200x900. samples: a pixel, 1, 4, 9 or 16: the scene's, or 4.
            scene, camera: a scene file that the viewer or ``save_scene`` wrote: all of it, or its camera alone.
            parallel, zoom: parallel projection; so many times nearer, 0.01 to 100.
            hide: structures to leave out.
            opacity, colour: ``{"enamel": 0.3}``, ``{"pulp": "#c9332e"}``, or "enamel=0.3".
            section, cap: "buccal", "-x@2.5" (mm), "1,1,0@3": what is cut away; "material" or "plain" on the cut.
            cull: faces seen from behind: "on" (left out), "off" (shown), "tint".
            wire, wall_depth: edges of triangles; canals' walls tell their depth.
            overlay: "contours", "edges" (faulty ones), "tetrahedra", "tetrahedra=12" (of slab 12).
            occlusion: darkening of hollows, 0 to 4.
            background: "white", "black", "transparent", "#rrggbb", or two colours from top to bottom.
            backend: "auto", "egl" or "osmesa".

            >>> model = reconstruct(sample("incisor"))
            >>> model.render(size=(80, 60), background="transparent").shape
            (60, 80, 4)
        """
        given = {name: value for name, value in locals().items() if name not in ("self", "progress")}
        return _draw.picture(self._core, progress, **given)

    def page(self, title: str = "", progress: Optional[Progress] = None) -> str:
        """The page of ``odontoscope web`` as text: one HTML file that opens from disk in any browser and asks the network for nothing.

        ``title``: the source's name without ending where it is left out.
        """
        return _draw.page(self._core, title or pathlib.PurePath(self._source).stem or "Model", progress)

    def _repr_png_(self) -> Optional[bytes]:
        """For notebooks; None where the machine cannot draw."""
        try:
            return png(self.render(size="640x480"))
        except (GraphicsError, UsageError):
            return None

    def _repr_html_(self) -> Optional[str]:
        """The page in a frame, for notebooks; None where it is not built or has more than ``draw.PAGE_LIMIT`` bytes."""
        try:
            page = self.page()
        except UsageError:
            return None
        if len(page) > _draw.PAGE_LIMIT:
            return None
        return (f'<iframe title="{_html.escape(repr(self))}" style="width: 100%; height: 540px; border: 0" allow="fullscreen; xr-spatial-tracking" '
                f'sandbox="allow-scripts allow-downloads allow-modals allow-pointer-lock" srcdoc="{_html.escape(page)}"></iframe>')

    def __repr__(self) -> str:
        told = self._core.headline() or ("closed surfaces" if self.certified else "not certified")
        return f"<odontoscope.Model of {', '.join(solid.structure for solid in self.solids)}: {told}>"


def reconstruct(source: Source, *, method: str = "dt", correspondence: str = "tracked", between: str = "blended", links: Any = None,
                link: Union[str, Iterable[str]] = (), unlink: Union[str, Iterable[str]] = (), together: Union[str, Iterable[str]] = (),
                partition: Optional[bool] = None, priority: Union[str, Iterable[str], None] = None, gap: Optional[float] = None, triangles: Optional[int] = None, elements: Union[float, str, None] = None, grid: Any = 128, cases: str = "classic", field: str = "hybrid", split: Iterable[float] = (),
                decimate: Union[int, str, None] = None, threads: int = 0, progress: Optional[Progress] = None, **reading: Any) -> Model:
    """Contours or a volume to a solid, certified model.

    Args:
        source, **reading: as ``contours`` takes them.
        method: "dt" (Delaunay) or "db" (distance field and marching cubes, to compare).
        correspondence: when regions connect: "tracked", "reverse", "medial" or "overlap".
        between: "blended" or "delaunay".
        links: your own choices of what connects: dicts as in ``Model.links``, or a file of them. They win.
        link, unlink: single ones, "NAME:N:B-U": contour B of slice N and U of N + 1.
        together: "A,B": make structures one solid, the inner a cavity of the outer.
        partition: True: one complex of all structures, which share their faces without gap or overlap (``Model.complex``). False: each by
            itself. None: a partition where structures share walls or overlap, unless links, correspondence or together are chosen.
        priority, gap: with ``partition``: who keeps the place where structures overlap ("A,B"); void narrower than so many mm between two
            structures is closed.
        triangles: simplify the surfaces to at most so many in all; topology is kept, and ``report["simplification_aim"]`` says whether
            that was reached.
        elements: mesh anew for simulation, with edges of about so many mm, or "quality": a size that fits (docs/elements.md).
        grid, cases, field, split, decimate: about "db", as in the program.
        threads: 0 for as many as the machine has.

        >>> square = [(0, 0), (4, 0), (4, 4), (0, 4)]
        >>> model = reconstruct([(0, square), (1, square)])
        >>> model.solids[0].volume, model.certified
        (16.0, True)
        >>> reconstruct([(0, square), (1, square)], correspondence="near")
        Traceback (most recent call last):
        ...
        odontoscope.errors.UsageError: correspondence="near" is none of its choices. Say one of tracked, reverse, medial, overlap.
    """
    if method not in ("dt", "db"):
        raise _refuse(UsageError, f"method={method!r} is no method", "Say \"dt\" or \"db\"")
    dt = _options.dt_words(correspondence, between, links, link, unlink, threads)
    db = _options.db_words(grid, cases, field, split, decimate, threads)
    stack = contours(source, progress=progress, **reading)
    for names in _options.names(together):
        stack = stack.together(*names.split(","))
    if elements is not None and triangles is not None:
        raise _refuse(UsageError, "elements and triangles both make the surfaces anew", "Use one of the two")
    size = None if elements in (None, "quality") else _options.element_size(elements)
    if method == "db":
        if triangles is not None or elements is not None or dt["links"] or partition or priority is not None or gap is not None:
            raise _refuse(UsageError, "triangles, elements, partition, priority, gap, links, link and unlink are about the DT method", "Use decimate and split with method=\"db\"")
        return Model(_core.by_db(stack._core, db, progress), stack.source)
    target = None if triangles is None else _options.whole(triangles, "triangles", 1)

    def made(model: Any) -> Model:
        return Model(model if elements is None else _core.meshed(model, size, progress), stack.source)

    if partition:
        if dt["links"] or dt["correspondence"] != "tracked" or dt["between"] != "blended" or _options.names(together):
            raise _refuse(UsageError, "together, correspondence, between, links, link and unlink do not work with partition", "Leave them out, or leave out partition")
        order = [name for names in _options.names(priority) for name in names.split(",")]
        return made(_core.as_partition(stack._core, order, _options.least_zero(gap, "gap"), dt["threads"], target, progress))
    if priority is not None or gap is not None:
        raise _refuse(UsageError, "priority and gap are about partition", "Give partition=True, or leave them out")
    if partition is None and not (dt["links"] or dt["correspondence"] != "tracked" or _options.names(together)):
        model, no_partition = _core.of_structures(stack._core, dt, target, progress)
        if no_partition:
            warnings.warn(f"no partition came of it, so each structure was made by itself, and neighbours may gape or overlap. {no_partition}", stacklevel=2)
        return made(model)
    return made(_core.by_dt(stack._core, dt, target, progress))


def compare(source: Source, *, correspondence: str = "tracked", between: str = "blended", links: Any = None, link: Union[str, Iterable[str]] = (),
            unlink: Union[str, Iterable[str]] = (), grid: Any = 128, cases: str = "classic", field: str = "hybrid", split: Iterable[float] = (),
            decimate: Union[int, str, None] = None, threads: int = 0, progress: Optional[Progress] = None, **reading: Any) -> dict[str, Any]:
    """DT, DB and decimated DB of the same contours side by side: the program's report, without pictures (docs/distance.md)."""
    dt = _options.dt_words(correspondence, between, links, link, unlink, threads)
    db = _options.db_words(grid, cases, field, split, decimate, threads)
    stack = contours(source, progress=progress, **reading)
    return json.loads(_core.compare(stack._core, dt, db, progress))


def anatomy(source: Union[Source, Model], progress: Optional[Progress] = None, **options: Any) -> dict[str, Any]:
    """A tooth in numbers: canals, roots, structures (docs/formats.md). Of a Model, or of what ``reconstruct`` takes."""
    model = source if isinstance(source, Model) else reconstruct(source, progress=progress, **options)
    return model.anatomy(progress)


_render_words = frozenset(Model.render.__kwdefaults__) - {"progress"}


def render(source: Union[Source, Model], *, progress: Optional[Progress] = None, **options: Any) -> np.ndarray:
    """A picture, as ``Model.render`` draws it. Of a Model, or of what ``reconstruct`` takes, with the options of both.

        >>> render(sample("incisor"), view="from above")
        Traceback (most recent call last):
        ...
        odontoscope.errors.UsageError: there is no view ...
    """
    looks = {name: options.pop(name) for name in list(options) if name in _render_words}
    _draw.check(**looks)   # before any long work
    if isinstance(source, Model) and options:
        raise _refuse(UsageError, f"{', '.join(options)}: a model is made already", "Leave them out, or give what it was made from")
    model = source if isinstance(source, Model) else reconstruct(source, progress=progress, **options)
    return model.render(progress=progress, **looks)


def png(pixels: Any) -> bytes:
    """A picture as the bytes of a PNG file; the same pixels give the same bytes.

    Args:
        pixels: shape (rows, columns, 4), uint8, as ``Model.render`` gives them.
    """
    array = _arrays.numbers(pixels, "pixels", dimensions=3, kinds="u")
    if array.dtype != np.uint8 or array.shape[2] != 4 or array.size == 0:
        raise _refuse(InputError, f"has the shape {array.shape} of {array.dtype}, not (rows, columns, 4) of uint8", "Give what render gives", "wrong-shape", name="pixels")
    return _draw.png(np.ascontiguousarray(array))


def sample(kind: str = "molar", *, slice_spacing: float = 0.25, point_spacing: float = 0.22, filled_dentine: bool = False,
           filled: bool = False) -> Contours:
    """Contours of a made-up tooth with known truth: "molar", "premolar" or "incisor" (docs/sample-teeth.md). Spacings in mm.

    ``filled_dentine``: the pulp is no hole of it, for ``together="dentine,pulp"``. ``filled``: every structure overlaps those within it, for
    ``partition=True``.

    >>> sample("molar").structures
    ('dentine', 'pulp', 'enamel')
    """
    return Contours._of(_core.sample(str(kind), _options.optional_number(slice_spacing, "slice_spacing"), _options.optional_number(point_spacing, "point_spacing"),
                                     bool(filled_dentine), bool(filled)))


def read_mesh(file: Union[str, "os.PathLike[str]"]) -> list[Solid]:
    """The surfaces in a glTF, STL, PLY or OBJ file, mm, z up; they have no tetrahedra."""
    return [Solid(part) for part in _core.read_mesh(_options.path(file))]


def check(mesh: Any) -> dict[str, Any]:
    """Is a surface a closed, oriented manifold, and what is wrong with it? Of a mesh file, or of ``(points, triangles)``.

        >>> points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
        >>> check((points, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]))["closed_oriented_manifold"]
        True
        >>> check((points, [(0, 2, 1), (0, 1, 3), (1, 2, 3)]))["surface"]["boundary_edges"]
        3
    """
    if isinstance(mesh, (str, bytes, os.PathLike)):
        return json.loads(_core.check_file(_options.path(mesh)))
    if not isinstance(mesh, (tuple, list)) or len(mesh) != 2:
        raise _refuse(UsageError, "that is neither a file nor (points, triangles)", "Give a file's name, or two arrays")
    points = _arrays.finite(mesh[0], "points", 3)
    triangles = _arrays.numbers(mesh[1], "triangles", 3, kinds="iu")
    if triangles.size and (int(triangles.min()) < 0 or int(triangles.max()) >= len(points)):
        raise _refuse(InputError, f"name points from {triangles.min()} to {triangles.max()}, and there are {len(points)}", "Count from 0", "index-out-of-range",
                      name="triangles")
    return json.loads(_core.check_arrays(points, np.ascontiguousarray(triangles, dtype=np.uint32)))
