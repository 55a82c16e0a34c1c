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

__all__ = ["check", "page", "picture", "png", "words"]

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


def words(*, view: str = "", size: Any = None, samples: int | None = None, scene: Any = None, camera: Any = None, parallel: bool = False,
          zoom: float = 1, hide: Any = None, opacity: Any = None, colour: Any = None, section: str = "", cap: str = "", cull: str = "",
          wire: bool = False, wall_depth: bool = False, overlay: Any = None, occlusion: float | None = None, background: str = "",
          backend: str = "auto", save_scene: Any = None) -> dict[str, Any]:
    """As the module wants them. UsageError for what makes no sense whatever the model."""
    if view and camera is not None:
        raise refuse(UsageError, "view and camera both say where to look from", "Choose one")
    if samples is not None and samples not in _SAMPLES:
        raise refuse(UsageError, f"samples={samples!r} is none of {', '.join(map(str, _SAMPLES))}", "Say how many samples a pixel has along both axes")
    return {"view": str(view), "size": "" if size is None else _size(size), "samples": samples, "scene": "" if scene is None else _options.path(scene),
            "camera": "" if camera is None else _options.path(camera), "parallel": bool(parallel), "zoom": _within(zoom, "zoom", 0.01, 100),
            "hide": _options.names(hide), "opacity": _pairs(opacity, "opacity"), "colour": _pairs(colour, "colour"), "section": str(section),
            "cap": str(cap), "cull": str(cull), "wire": bool(wire), "wall_depth": bool(wall_depth), "overlay": _options.names(overlay),
            "occlusion": None if occlusion is None else _within(occlusion, "occlusion", 0, 4), "background": str(background),
            "backend": str(backend), "save_scene": "" if save_scene is None else _options.path(save_scene)}


def check(**given: Any) -> None:
    """Raises what ``picture`` would raise whatever the model is."""
    _drawing().check(words(**given))


def picture(model: Any, progress: Any, **given: Any) -> Any:
    """Shape (rows, columns, 4), uint8. ``model`` is the compiled module's."""
    return _drawing().picture(model, words(**given), progress)


def png(pixels: Any) -> bytes:
    """The bytes of a PNG file. Precondition: as ``picture`` gives them."""
    return _drawing().png(pixels)


def page(model: Any, title: str, progress: Any) -> str:
    """One HTML file."""
    return _drawing().page(model, title, progress).decode("utf-8")
