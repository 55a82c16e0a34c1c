"""Pictures and pages of models: the words of ``odontoscope render``, and what draws."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from . import options as _options
from .errors import UsageError, refuse

try:
    from . import _draw
except ImportError as error:   # built without the engine, or a library is missing
    _draw = None  # type: ignore[assignment]
    _missing = str(error)

__all__ = ["add_pictures", "anatomy_of_mesh", "check", "film", "gltf_extras", "page", "pictures", "png", "words"]

#: A page in a notebook has no more bytes than this (a notebook keeps all that it shows); 0: pictures alone.
PAGE_LIMIT = 8_000_000

_SAMPLES = (1, 4, 9, 16)


def _drawing() -> Any:
    if _draw is None:
        raise refuse(UsageError, f"this package cannot draw ({_missing})",
                     "Install what third_party/packages.debian lists under pictures and viewer, and build it again")
    return _draw


def _pairs(given: Any, option: str) -> list[str]:
    """"enamel=0.3" as the program has it, several of these, or a mapping.

    >>> _pairs({"enamel": 0.3}, "opacity"), _pairs("pulp=#c9332e", "colour")
    (['enamel=0.3'], ['pulp=#c9332e'])
    """
    if given is None:
        return []
    if isinstance(given, Mapping):
        return [f"{name}={value}" for name, value in given.items()]
    if isinstance(given, (str, Iterable)):
        return _options.names(given)
    raise refuse(UsageError, f"{option}={given!r} names no structure", f"For example {option}={{\"enamel\": VALUE}}")


def _size(given: Any) -> str:
    """
    >>> _size("640x480"), _size((640, 480))
    ('640x480', '640x480')
    """
    if isinstance(given, str):
        return given
    if isinstance(given, Iterable):
        sides = list(given)
        if len(sides) == 2:
            return "x".join(str(_options.whole(side, "size", 1)) for side in sides)
    raise refuse(UsageError, f"size={given!r} is no size of a picture", "Give width and height in pixels: size=\"1200x900\" or (1200, 900)")


def _within(given: Any, option: str, least: float, most: float) -> float:
    value = _options.optional_number(given, option)
    if value is None or not least <= value <= most:
        raise refuse(UsageError, f"{option}={given!r} is not from {least:g} to {most:g}", f"For example {option}=1")
    return value


def _film(given: Any) -> str:
    """
    >>> _film((31, 41)), _film("31x41")
    ('31.0x41.0', '31x41')
    """
    return _options.numbers(given, "film", 2).replace(",", "x")


def _radiograph_words(radiograph: bool, kv: float, beam: str, focus: Any, tube: Any, film: Any, pixel: Any, exposure: Any, inverted: bool, attenuation: Any, grey: Any) -> dict[str, Any]:
    if beam not in ("", "cone", "parallel"):
        raise refuse(UsageError, f"beam={beam!r} is no beam", "Say \"cone\" or \"parallel\"")
    longest = 1e6
    return {"radiograph": bool(radiograph), "kv": _within(kv, "kv", 30, 150), "beam": str(beam), "focus": None if focus is None else _within(focus, "focus", 1e-6, longest),
            "tube": _options.numbers(tube, "tube", 2), "film": _film(film), "pixel": None if pixel is None else _within(pixel, "pixel", 1e-6, longest),
            "exposure": None if exposure is None else _within(exposure, "exposure", 1e-3, 1e3), "inverted": bool(inverted), "attenuation": _pairs(attenuation, "attenuation"),
            "grey": _options.numbers(grey, "grey", 2)}


def _count(given: Any, option: str) -> int:
    """0 for None."""
    most = 3600
    if given is None:
        return 0
    if _options.whole(given, option, 1) > most:
        raise refuse(UsageError, f"{option}={given} is more than {most}", f"For example {option}=36")
    return int(given)


def words(*, view: str = "", size: Any = None, samples: int | None = None, scene: Any = None, camera: Any = None, parallel: bool = False,
          zoom: float = 1, hide: Any = None, opacity: Any = None, colour: Any = None, section: str = "", cap: str = "", cull: str = "",
          wire: bool = False, wall_depth: bool = False, wall_thickness: bool = False, overlay: Any = None, occlusion: float | None = None, background: str = "",
          show: str = "", cast: str = "", transfer: str = "", slopes: Any = None, colour_by: str = "", grey: Any = None, radiograph: bool = False, kv: float = 70, beam: str = "", focus: Any = None, tube: Any = None,
          film: Any = None, pixel: Any = None, exposure: Any = None, inverted: bool = False, attenuation: Any = None, turntable: Any = None, tour: str = "",
          reverse: bool = False, void: int = 1, frames: Any = None, contact_sheet: Any = None, backend: str = "auto", save_scene: Any = None) -> dict[str, Any]:
    """As the module wants them. UsageError for what makes no sense whatever the model."""
    if view and camera is not None:
        raise refuse(UsageError, "view and camera both say where to look from", "Choose one")
    if samples is not None and samples not in _SAMPLES:
        raise refuse(UsageError, f"samples={samples!r} is none of {', '.join(map(str, _SAMPLES))}", "Say how many samples a pixel has along both axes")
    sheet = "" if contact_sheet is None else contact_sheet if isinstance(contact_sheet, str) else "x".join(str(_options.whole(side, "contact_sheet", 1)) for side in contact_sheet)
    usual_frames = 120
    pictures = _count(frames, "frames") or (usual_frames if tour and not sheet else 0)
    return {"view": str(view), "size": "" if size is None else _size(size), "samples": samples, "scene": "" if scene is None else _options.path(scene),
            "camera": "" if camera is None else _options.path(camera), "parallel": bool(parallel), "zoom": _within(zoom, "zoom", 0.01, 100),
            "hide": _options.names(hide), "opacity": _pairs(opacity, "opacity"), "colour": _pairs(colour, "colour"), "section": str(section),
            "cap": str(cap), "cull": str(cull), "wire": bool(wire), "wall_depth": bool(wall_depth), "wall_thickness": bool(wall_thickness), "overlay": _options.names(overlay),
            "occlusion": None if occlusion is None else _within(occlusion, "occlusion", 0, 4), "background": str(background),
            "show": str(show), "cast": str(cast), "transfer": str(transfer), "slopes": _options.numbers(slopes, "slopes", 2), "colour_by": str(colour_by),
            **_radiograph_words(radiograph, kv, beam, focus, tube, film, pixel, exposure, inverted, attenuation, grey),
            "turntable": _count(turntable, "turntable"), "tour": str(tour), "reverse": bool(reverse), "void": _count(void, "void"), "frames": pictures,
            "contact_sheet": sheet, "backend": str(backend), "save_scene": "" if save_scene is None else _options.path(save_scene)}


def check(**given: Any) -> None:
    """Raises what ``picture`` would raise whatever the model is."""
    _drawing().check(words(**given))


def pictures(seen: Any, progress: Any, **given: Any) -> Any:
    """One picture of shape (rows, columns, 4), uint8, or a list of them where ``given`` asks for many. ``seen``: the compiled module's Model or Volume, or the file of a mesh."""
    asked = words(**given)
    made = _drawing().pictures(seen, asked, progress)
    return made if asked["turntable"] or asked["frames"] else made[0]


def anatomy_of_mesh(file: str, progress: Any) -> tuple[str, str]:
    """JSON and CSV."""
    return _drawing().anatomy_of_mesh(file, progress)


def gltf_extras(model: Any, tours: bool, hotspots: bool, progress: Any) -> Any:
    """Cameras and places with names, for ``Model.write`` of the compiled module."""
    return _drawing().gltf_extras(model, tours, hotspots, progress)


def add_pictures(comparison: Any, progress: Any) -> None:
    """What each method's model looks like, drawn into a comparison."""
    _drawing().add_pictures(comparison, progress)


def png(pixels: Any) -> bytes:
    """The bytes of a PNG file. Precondition: as ``picture`` gives them."""
    return _drawing().png(pixels)


def page(shown: Any, title: str, lesson: Any, db: Any, language: Any, show: str, cast: str, transfer: str, slopes: Any, grey: Any,
         progress: Any) -> str:
    """One HTML file. ``shown``: the compiled module's Model or Volume; ``db``: its Model, or None."""
    asked = {"title": title, "lesson": "" if lesson is None else _options.path(lesson), "language": "" if language is None else _options.path(language),
             "show": str(show), "cast": str(cast), "transfer": str(transfer), "slopes": _options.numbers(slopes, "slopes", 2),
             "grey": _options.numbers(grey, "grey", 2)}
    return _drawing().page(shown, asked, db, progress).decode("utf-8")


_NOT_FILMED = ("turntable", "contact_sheet", "section", "radiograph", "save_scene", "frames", "tour", "size")


def check_film(looks: Mapping[str, Any]) -> None:
    """UsageError for what a film has not."""
    for word in _NOT_FILMED:
        if word in looks:
            raise refuse(UsageError, f"{word}: a film has none", "Leave it out")


def film(seen: Any, file: Any, progress: Any, frames: Any, **given: Any) -> float:
    """Seconds that it lasts."""
    asked = {**words(**given), "frames": _count(frames, "frames")}
    return _drawing().film(seen, _options.path(file), asked, progress)
