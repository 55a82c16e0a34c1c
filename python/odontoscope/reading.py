"""What goes in: contours and volumes, from arrays or from files."""

from __future__ import annotations

import os
import pathlib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any, Optional, Union

import numpy as np

from . import _core
from . import arrays as _arrays
from . import draw as _draw
from . import options as _options
from .errors import InputError, UsageError, refuse as _refuse

__all__ = ["Contours", "Volume", "contours", "read_volume", "sample"]

Progress = Callable[[str, float], Any]
Level = Union[float, str, Mapping[str, float], Iterable[Any]]
Source = Union["Contours", "Volume", str, "os.PathLike[str]", Iterable[Any]]
File = Union[str, "os.PathLike[str]"]


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

    def save(self, file: File, *, voxels: Any = None, voxel_origin: Any = None) -> None:
        """As the file's ending asks, whole or not at all: .json, a contour stack; .dcm, a DICOM structure set; .seg.dcm and .seg.nrrd, voxels.

        ``voxels``: their size (x, y, z), mm, where no volume says it; ``voxel_origin``: the centre of the first, mm.
        """
        self._core.write(_options.path(file), _options.numbers(voxels, "voxels", 3), _options.numbers(voxel_origin, "voxel_origin", 3))

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
        >>> len(contours(image, iso=0)) > 10
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

    def page(self, title: str = "", *, lesson: Optional[File] = None, language: Optional[File] = None, show: str = "volume", cast: str = "", transfer: str = "", slopes: Any = None,
             grey: Any = None, progress: Optional[Progress] = None) -> str:
        """The page of ``odontoscope web --show volume`` as text: grey values alone, to be turned and cut open in any browser. Its words are those of ``Model.page``.

            >>> ball = Volume(np.fromfunction(lambda k, j, i: 6 - np.hypot(np.hypot(i - 8, j - 8), k - 8), (17, 17, 17)))
            >>> ball.page(show="both")
            Traceback (most recent call last):
            ...
            odontoscope.errors.UsageError: nothing says where in the volume the surface lies. Say show="volume", or make a model of it with iso or label.
        """
        return _draw.page(self._core, title or pathlib.PurePath(self.source).stem or "Volume", lesson, None, language, show, cast, transfer, slopes, grey, progress)

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

    def _contours(self, words: dict[str, Any], progress: Optional[Progress]) -> Contours:
        if not words["iso"] and not words["label"]:
            raise _refuse(UsageError, "nothing says where in the volume the surface lies", "Give iso for an image (or iso=\"auto\"), label for a label map")
        return Contours._of(self._core.contours(words, progress))

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


def contours(source: Source, *, iso: Optional[Level] = None, label: Optional[Level] = None, min_area: Union[float, str, None] = None,
             smooth: Optional[float] = None, simplify: Optional[float] = None, label_names: Optional[File] = None, crop: Any = None,
             resample: Optional[float] = None, upright: bool = False, spacing: Optional[Sequence[float]] = None, series: str = "",
             allow_outside: bool = False, spacing_z: Optional[float] = None, at: Iterable[float] = (), structure: Union[str, Iterable[str], None] = None,
             repair: bool = False, widest_gap: Optional[float] = None, progress: Optional[Progress] = None) -> Contours:
    """Contours from whatever the program reads.

    Args:
        source: Contours; a Volume; tuples as Contours takes them; or a file: a contour stack, a series of Reconstruct or
            PyReconstruct, CSL, RTSTRUCT, a mesh (glTF, STL, PLY, OBJ) or, with ``iso`` or ``label``, a volume.
        iso: surface of a volume at a value: ``120``, ``"auto"``, ``"auto:3/2"``, ``"120=dentine"``, ``{"dentine": 120, "enamel": 195}``.
        label: surface of a label: ``2``, ``"2=pulp"``, ``{"pulp": 2}``, or a name that the file gives.
        min_area: leave out contours that enclose less: pixels of a slice, or ``"0.5mm2"``.
        smooth: smooth the borders of labels, by so many mm and half a voxel at most.
        simplify: fewer points: contours may move by so many mm, and stay disjoint.
        label_names: a file of names of labels, as ITK-SNAP writes it.
        crop: take this box of a volume alone: x from and to, y, z, mm. resample: voxels of so many mm along all axes. upright: turn what the levels
            bound so that its longest axis is z (``reconstruct`` can put the model back: ``as_given``).
        spacing, series, allow_outside: see read_volume.
        spacing_z, at: where to cut a mesh: every so many mm, or at these heights, mm.
        structure: keep these structures alone.
        repair, widest_gap: mend what breaks the rules; the widest gap of a mesh that is closed, mm.
    """
    of_volume = iso is not None or label is not None
    words = _options.volume_words(iso, label, label_names, min_area, smooth, simplify, crop, resample, upright)
    if isinstance(source, Contours):
        made = source
    elif isinstance(source, Volume):
        return source._contours(words, progress)
    elif isinstance(source, (str, bytes, os.PathLike)):
        if of_volume:
            return read_volume(source, spacing=spacing, series=series, allow_outside=allow_outside, progress=progress)._contours(words, progress)  # type: ignore[arg-type]
        heights = [_options.optional_number(z, "at") for z in at]
        made = Contours._of(_core.read_contours(_options.path(source), _options.names(structure), _options.optional_number(spacing_z, "spacing_z"),
                                                heights, bool(repair), _options.optional_number(widest_gap, "widest_gap"), progress))
    else:
        made = Contours(source, repair=repair, progress=progress)
    if of_volume or any(words[name] for name in ("label_names", "min_area", "crop", "upright")) or smooth is not None or resample is not None:
        raise _refuse(UsageError, "iso, label, label_names, min_area, smooth, crop, resample and upright are about volumes, and these are contours", "Leave them out")
    return made if simplify is None else made.simplify(simplify, progress)


def sample(kind: str = "molar", *, slice_spacing: float | None = None, point_spacing: float = 0.22, apart: bool = False,
           filled_dentine: bool = False, filled: bool = False, open_apex: bool = False) -> Contours:
    """Contours of a made-up tooth with known truth: "molar", "premolar" or "incisor" (docs/sample-teeth.md). Spacings in mm; without
    ``slice_spacing`` slices are closer where the tooth changes fast along z.

    Neighbours share their walls, unless ``apart``: then a gap of 0.03 mm parts them. ``filled_dentine``: apart, and the pulp is no hole of it, for
    ``together="dentine,pulp"``. ``filled``: every structure overlaps those within it. ``open_apex``: canals leave the roots.

    >>> sample("molar").structures
    ('dentine', 'pulp', 'enamel')
    """
    return Contours._of(_core.sample(str(kind), _options.optional_number(slice_spacing, "slice_spacing"), _options.optional_number(point_spacing, "point_spacing"),
                                     bool(apart), bool(filled_dentine), bool(filled), bool(open_apex)))
