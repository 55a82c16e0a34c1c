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

import json
import os
import warnings
from collections.abc import Iterable
from typing import Any, Optional, Union

import numpy as np

from . import _core
from . import draw as _draw
from . import options as _options
from .errors import Error, FileError, GraphicsError, InputError, InternalError, UsageError, WantingError, refuse as _refuse
from .model import Complex, Model, Solid, check, png, read_mesh, told_anatomy as _told_anatomy
from .reading import Contours, File, Progress, Source, Volume, contours, read_volume, sample

__version__: str = _core.__version__
__all__ = [
    "Complex", "Contours", "Error", "FileError", "GraphicsError", "InputError", "InternalError", "Model", "Solid", "UsageError", "Volume", "WantingError", "anatomy",
    "check", "compare", "contours", "png", "read_mesh", "read_volume", "reconstruct", "render", "sample",
]


def reconstruct(source: Source, *, method: str = "dt", correspondence: str = "tracked", between: str = "blended", links: Any = None,
                link: Union[str, Iterable[str]] = (), unlink: Union[str, Iterable[str]] = (), together: Union[str, Iterable[str]] = (),
                partition: Optional[bool] = None, priority: Union[str, Iterable[str], None] = None, gap: Optional[float] = None, triangles: Optional[int] = None,
                elements: Union[float, str, None] = None, grid: Any = 128, cases: str = "classic", field: str = "hybrid", split: Iterable[float] = (),
                decimate: Union[int, str, None] = None, threads: int = 0,
                strict: bool = False, as_given: bool = False, progress: Optional[Progress] = None, **reading: Any) -> Model:
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
        strict: WantingError if the verdict is amber or ``triangles`` is missed.
        as_given: after ``upright=True``: put the finished model back to where the file has it.

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
    if as_given and not reading.get("upright"):
        raise _refuse(UsageError, "as_given is about upright", "Add upright=True, or leave it out")
    stack = contours(source, progress=progress, **reading)
    for names in _options.names(together):
        stack = stack.together(*names.split(","))
    if elements is not None and triangles is not None:
        raise _refuse(UsageError, "elements and triangles both make the surfaces anew", "Use one of the two")
    size = None if elements in (None, "quality") else _options.element_size(elements)
    if method == "db":
        if triangles is not None or elements is not None or strict or as_given or dt["links"] or partition or priority is not None or gap is not None:
            raise _refuse(UsageError, "triangles, elements, strict, as_given, partition, priority, gap, links, link and unlink are about the DT method", "Use decimate and split with method=\"db\"")
        return Model(_core.by_db(stack._core, db, progress), stack.source)
    target = None if triangles is None else _options.whole(triangles, "triangles", 1)

    def made(model: Any) -> Model:
        if elements is not None:
            model = _core.meshed(model, size, progress)
        if as_given:
            model = _core.put_back(model, progress)
        wanting = model.wanting() if strict else []
        if wanting:
            raise _refuse(WantingError, "; ".join(place.rstrip(".") for place in wanting), "Decide as it says, or leave out strict", look_here=wanting)
        return Model(model, stack.source)

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
            decimate: Union[int, str, None] = None, threads: int = 0, report: Optional[File] = None, html: Optional[File] = None,
            progress: Optional[Progress] = None, **reading: Any) -> dict[str, Any]:
    """DT, DB and decimated DB of the same contours side by side (docs/distance.md): the program's report.

    With ``report`` or ``html`` it is written to these files, too, and holds what is seen through each model, as far as this machine can draw (a warning tells if not).
    """
    dt = _options.dt_words(correspondence, between, links, link, unlink, threads)
    db = _options.db_words(grid, cases, field, split, decimate, threads)
    compared = _core.compare(contours(source, progress=progress, **reading)._core, dt, db, progress)
    if report is not None or html is not None:
        try:
            _draw.add_pictures(compared, progress)
        except (GraphicsError, UsageError) as error:
            warnings.warn(f"no pictures, and nothing about what is seen through: {error}", stacklevel=2)
        _core.write_texts([(_options.path(file), text()) for file, text in ((report, compared.json), (html, compared.page)) if file is not None])
    return json.loads(compared.json())


def _is_mesh(source: Any, words: dict[str, Any]) -> bool:
    """A file that is taken as it is: nobody says where to cut it."""
    if not isinstance(source, (str, bytes, os.PathLike)) or words.get("spacing_z") is not None or words.get("at"):
        return False
    return _core.kind_of(_options.path(source)) == "mesh"


def _refuse_words(words: dict[str, Any], of: str) -> None:
    if words:
        raise _refuse(UsageError, f"{', '.join(words)}: {of}", "Leave them out, or give what it was made from")


def anatomy(source: Union[Source, Model], *, output: Union[File, Iterable[File]] = (), progress: Optional[Progress] = None, **options: Any) -> dict[str, Any]:
    """A tooth in numbers: canals, roots, structures (docs/formats.md). Of a Model, of a mesh file, or of what ``reconstruct`` takes.

    ``output``: also written to these files, .json all and .csv a row a canal.
    """
    if _is_mesh(source, options):
        _refuse_words(options, "a mesh is taken as it is")
        return _told_anatomy(_draw.anatomy_of_mesh(_options.path(source), progress), output)
    model = source if isinstance(source, Model) else reconstruct(source, progress=progress, **options)
    return model.anatomy(output=output, progress=progress)


_render_words = frozenset(Model.render.__kwdefaults__) - {"progress"}
_of_volumes = ("spacing", "series", "allow_outside")


def _voxels_alone(source: Any, looks: dict[str, Any], options: dict[str, Any], progress: Optional[Progress]) -> Optional[Volume]:
    """The volume of which grey values alone are seen, if it is that."""
    if options.get("iso") is not None or options.get("label") is not None:
        return None
    if isinstance(source, Volume):
        _refuse_words(options, "the volume is there already, and nothing says where in it the surface lies")
        return source
    wanted = looks.get("show") == "volume" or looks.get("radiograph")
    if not wanted or not isinstance(source, (str, bytes, os.PathLike)) or _core.kind_of(_options.path(source)) != "volume":
        return None
    _refuse_words({name: value for name, value in options.items() if name not in _of_volumes}, "nothing says where in the volume the surface lies")
    return read_volume(source, progress=progress, **options)


def render(source: Union[Source, Model], *, progress: Optional[Progress] = None, **options: Any) -> Any:
    """A picture, as ``Model.render`` draws it, or a list of pictures. Of a Model; of a mesh file; with ``show="volume"`` or ``radiograph=True`` of a volume; or of what
    ``reconstruct`` takes, with the options of both.

        >>> render(sample("incisor"), view="from above")
        Traceback (most recent call last):
        ...
        odontoscope.errors.UsageError: there is no view ...
        >>> ball = np.fromfunction(lambda k, j, i: 6 - np.hypot(np.hypot(i - 8, j - 8), k - 8), (17, 17, 17))
        >>> render(Volume(ball), show="volume", size=(80, 60)).shape
        (60, 80, 4)
    """
    looks = {name: options.pop(name) for name in list(options) if name in _render_words}
    _draw.check(**looks)   # before any long work
    if isinstance(source, Model):
        _refuse_words(options, "a model is made already")
        return source.render(progress=progress, **looks)
    volume = _voxels_alone(source, looks, options, progress)
    if volume is not None:
        return _draw.pictures(volume._core, progress, **looks)
    if _is_mesh(source, options):
        _refuse_words(options, "a mesh is taken as it is")
        return _draw.pictures(_options.path(source), progress, **looks)
    return reconstruct(source, progress=progress, **options).render(progress=progress, **looks)
