"""What comes out: solids, their report, pictures of them."""

from __future__ import annotations

import html as _html
import json
import os
import pathlib
from collections.abc import Iterable, Mapping
from typing import Any, Optional, Union

import numpy as np

from . import _core
from . import arrays as _arrays
from . import draw as _draw
from . import options as _options
from .errors import GraphicsError, InputError, UsageError, refuse as _refuse
from .reading import File, Progress

__all__ = ["Complex", "Model", "Solid", "check", "png", "read_mesh"]

Look = Union[str, Iterable[str], Mapping[str, Any], None]


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


def told_anatomy(told: tuple[str, str], output: Union[File, Iterable[File]]) -> dict[str, Any]:
    """``told``: as JSON, as CSV."""
    files = [_options.path(file) for file in ([output] if isinstance(output, (str, os.PathLike)) else output)]
    for file in files:
        if not file.lower().endswith((".json", ".csv")):
            raise _refuse(UsageError, f"{file}: neither .json nor .csv", "Name a file of one of these", name=None)
    _core.write_texts([(file, told[file.lower().endswith(".csv")]) for file in files])
    return json.loads(told[0])


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

    def anatomy(self, *, output: Union[File, Iterable[File]] = (), progress: Optional[Progress] = None) -> dict[str, Any]:
        """Canals, roots and structures in numbers (docs/formats.md). ``output``: also written to these files, .json all and .csv a row a canal."""
        return told_anatomy(self._core.anatomy(self._source, progress), output)

    def save(self, *files: File, tours: bool = False, see_through: bool = False, variants: bool = False, hotspots: bool = False, compress: bool = False,
             voxels: Any = None, voxel_origin: Any = None, progress: Optional[Progress] = None) -> None:
        """In the formats that the files' endings name, all or none: .glb .gltf .stl .ply .obj .3mf .wrl .x3d .vtp; tetrahedra .vtu .msh .inp; and back to where images
        come from .dcm (RTSTRUCT), .seg.dcm, .nrrd and .seg.nrrd.

        Args:
            tours, see_through, variants, hotspots, compress: of .glb and .gltf: cameras along canals; enamel and dentine show the pulp; looks to choose from;
                places with names; smaller, for readers that know meshopt.
            voxels, voxel_origin: of files of voxels: their size (x, y, z), mm, where no volume says it; the centre of the first, mm.
        """
        extras = _draw.gltf_extras(self._core, tours, hotspots, progress) if tours or hotspots else _core.GltfExtras()
        words = {"see_through": bool(see_through), "variants": bool(variants), "compress": bool(compress), "voxels": _options.numbers(voxels, "voxels", 3),
                 "voxel_origin": _options.numbers(voxel_origin, "voxel_origin", 3)}
        self._core.write([_options.path(file) for file in files], words, extras, progress)

    def render(self, *, view: str = "", size: Union[str, tuple[int, int], None] = None, samples: Optional[int] = None,
               scene: Optional[File] = None, camera: Optional[File] = None, parallel: bool = False, zoom: float = 1, hide: Union[str, Iterable[str], None] = None,
               opacity: Look = None, colour: Look = None, section: str = "", cap: str = "", cull: str = "", wire: bool = False,
               wall_depth: bool = False, wall_thickness: bool = False, overlay: Union[str, Iterable[str], None] = None, occlusion: Optional[float] = None,
               background: str = "", show: str = "", cast: str = "", transfer: str = "", slopes: Any = None, colour_by: str = "", grey: Any = None, radiograph: bool = False, kv: float = 70, beam: str = "",
               focus: Optional[float] = None, tube: Any = None, film: Any = None, pixel: Optional[float] = None, exposure: Optional[float] = None, inverted: bool = False,
               attenuation: Look = None, turntable: Optional[int] = None, tour: str = "", reverse: bool = False, void: int = 1, frames: Optional[int] = None,
               contact_sheet: Any = None, backend: str = "auto", save_scene: Optional[File] = None, progress: Optional[Progress] = None) -> Any:
        """A picture: shape (rows, columns, 4), uint8; red, green, blue (sRGB), alpha (not premultiplied); the first row is the top. With ``turntable`` or ``tour`` a list
        of them.

        Drawn without a display, by EGL or OSMesa; the pixels are those of ``odontoscope render``, whose options these are. Raises GraphicsError
        where the machine cannot draw.

        Args:
            view: "three-quarter", "buccal", "lingual", "mesial", "distal", "occlusal", "apical".
            size: width and height, pixels: the scene's, or 1200x900. samples: a pixel, 1, 4, 9 or 16: the scene's, or 4.
            scene, camera: a scene file that the viewer or ``save_scene`` wrote: all of it, or its camera alone.
            parallel, zoom: parallel projection; so many times nearer, 0.01 to 100.
            hide: structures to leave out.
            opacity, colour: ``{"enamel": 0.3}``, ``{"pulp": "#c9332e"}``, or "enamel=0.3".
            section, cap: "buccal", "-x@2.5" (mm), "1,1,0@3": what is cut away; on the cut "material", "plain", "ct" or "ct=60,220": the CT values of the volume that the
                model was made from.
            cull: faces seen from behind: "on" (left out), "off" (shown), "tint".
            wire, wall_depth, wall_thickness: edges of triangles; canals' walls tell their depth, or how thick they are.
            overlay: "contours", "edges" (faulty ones), "tetrahedra", "tetrahedra=12" (of slab 12).
            occlusion: darkening of hollows, 0 to 4.
            background: "white", "black", "transparent", "#rrggbb", or two colours from top to bottom.
            show, cast, transfer: "surfaces", "volume" or "both", of a model made from a volume: its grey values as "shaded", "maximum", "average", "radiograph" or "surface=T";
                "tooth", "enamel", "dentine", "pulp", "soft" (docs/volume.md). slopes: ``(100, 400)`` shows borders: nothing flatter, all that is steeper, values a millimetre. grey: what values mean: of air, of
                dentine.
            colour_by: "distance", "distance=0.2" (mm), "slope": surfaces by how they lie to the values of the volume that they were taken from, with a legend.
            radiograph: an X-ray film instead, through the solids (of a Volume through its voxels), 0.05 mm a pixel. kv, beam, focus, tube, film, pixel, exposure,
                inverted, attenuation: docs/volume.md; ``tube=(20, 0)`` degrees, ``film=(31, 41)`` mm, ``attenuation={"crown": 0.4}`` 1/mm.
            turntable: so many pictures from all around.
            tour: pictures along a line: "canal-1", "horn-2". frames: how many, 120; reverse: from its end out; void: which, by size, from 1. contact_sheet: "4x3", all
                as one picture.
            backend: "auto", "egl" or "osmesa".

            >>> import odontoscope
            >>> model = odontoscope.reconstruct(odontoscope.sample("incisor"))
            >>> model.render(size=(80, 60), background="transparent").shape
            (60, 80, 4)
            >>> [frame.shape for frame in model.render(tour="canal-1", frames=2, size=(80, 60))]
            [(60, 80, 4), (60, 80, 4)]
        """
        given = {name: value for name, value in locals().items() if name not in ("self", "progress")}
        return _draw.pictures(self._core, progress, **given)

    def film(self, file: File, tour: str = "canal-1", *, frames: Optional[int] = None, size: Union[str, tuple[int, int], None] = None, progress: Optional[Progress] = None,
             **looks: Any) -> float:
        """A tour as a film, .mp4 or .webm, as ``odontoscope render --tour`` makes it; how long it lasts, seconds. Needs the program ffmpeg.

        Args:
            file: its ending says the format; written whole or not at all.
            tour: the line: "canal-1", "horn-2". frames: how many, 30 a second; as many as the tour lasts where it is left out.
            size: even width and height, pixels: the scene's, or 1200x900.
            looks: ``reverse``, ``void`` and the looks of ``render``; no ``turntable``, ``contact_sheet``, ``section`` or ``radiograph``.

            >>> import odontoscope
            >>> odontoscope.reconstruct(odontoscope.sample("incisor")).film("canal.gif")
            Traceback (most recent call last):
            ...
            odontoscope.errors.UsageError: canal.gif is no film by its name. Call it something.mp4 or something.webm.
        """
        _draw.check_film(looks)
        return _draw.film(self._core, file, progress, frames, tour=tour, size=size, **looks)

    def page(self, title: str = "", *, lesson: Optional[File] = None, db: Optional[Model] = None, language: Optional[File] = None, show: str = "", cast: str = "",
             transfer: str = "", slopes: Any = None, grey: Any = None, progress: Optional[Progress] = None) -> str:
        """The page of ``odontoscope web`` as text: one HTML file that opens from disk in any browser and asks the network for nothing.

        Args:
            title: the source's name without ending where it is left out.
            lesson: a file of notes, or the title of one that comes with the program.
            db: a model of the same contours by ``method="db"``, and a switch between both.
            language: "de", "en", or a file of another; the browser's where it is left out.
            show: "volume" or "both", of a model made from a volume: the page carries its grey values, too. cast, transfer, slopes, grey: as for ``render``.

            >>> import odontoscope
            >>> odontoscope.reconstruct(odontoscope.sample("incisor")).page(show="both")
            Traceback (most recent call last):
            ...
            odontoscope.errors.UsageError: only a model of a volume has grey values to show. Leave show out, or make it from the volume with iso.
        """
        return _draw.page(self._core, title or pathlib.PurePath(self._source).stem or "Model", lesson, None if db is None else db._core, language, show, cast, transfer,
                          slopes, grey, progress)

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


def png(pixels: Any) -> bytes:
    """A picture as the bytes of a PNG file; the same pixels give the same bytes.

    Args:
        pixels: shape (rows, columns, 4), uint8, as ``Model.render`` gives them.
    """
    array = _arrays.numbers(pixels, "pixels", dimensions=3, kinds="u")
    if array.dtype != np.uint8 or array.shape[2] != 4 or array.size == 0:
        raise _refuse(InputError, f"has the shape {array.shape} of {array.dtype}, not (rows, columns, 4) of uint8", "Give what render gives", "wrong-shape", name="pixels")
    return _draw.png(np.ascontiguousarray(array))


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
