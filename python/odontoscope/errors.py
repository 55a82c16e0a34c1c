"""What goes wrong, as exceptions with a cause, a place and a remedy.

``str(error)`` is the whole message, as the program says it.
"""

from __future__ import annotations

from typing import Any

__all__ = ["Error", "FileError", "GraphicsError", "InputError", "InternalError", "UsageError", "WantingError"]


class Error(Exception):
    """Base of all errors of this package.

    Attributes:
        cause: a stable name in kebab case, such as ``"self-crossing"`` (docs/formats.md lists them); ``""`` where there is none.
        place: what is known of where: ``file``, ``slice``, ``z`` (mm), ``contour``, ``point``, ``at`` (x, y in mm), ``line``,
            ``byte``. Slices, contours and points count from 0, lines from 1. What is not known is left out.
        wrong: what is wrong, without the place.
        remedy: what to do about it; ``""`` where nothing helps.
    """

    def __init__(self, message: str = "", cause: str = "", place: dict[str, Any] | None = None, wrong: str = "", remedy: str = ""):
        super().__init__(message)
        self.cause = cause
        self.place = dict(place or {})
        self.wrong = wrong or message
        self.remedy = remedy

    def __reduce__(self):
        return type(self), (str(self), self.cause, self.place, self.wrong, self.remedy)


class InputError(Error, ValueError):
    """Data that break a documented rule: contours that cross, a damaged file, an array of the wrong shape."""


class FileError(Error, OSError):
    """A file that cannot be opened, read, created or written."""

    def __str__(self) -> str:
        return str(self.args[0]) if self.args else ""


class UsageError(Error, ValueError):
    """A call that makes no sense: an option that is none, options that contradict each other."""


class WantingError(Error, ValueError):
    """``strict=True``, and the verdict is amber, or ``triangles`` was missed. ``places`` says where to look, one sentence each."""

    @property
    def places(self) -> list[str]:
        return list(self.place.get("look_here", ()))


class GraphicsError(Error, RuntimeError):
    """This machine cannot draw: ``cause`` is no-egl, no-osmesa, no-gl, gl-too-old, out-of-graphics-memory or picture-too-large."""


class InternalError(Error, RuntimeError):
    """A bug of Odontoscope. Please report it with the input."""


def refuse(kind: type[Error], wrong: str, remedy: str, cause: str = "", **place: Any) -> Error:
    """An error in the same form as those of the library. ``place`` is told by its ``name`` if it has one."""
    named = place.get("name")
    message = (f"{named}: " if named else "") + f"{wrong}. {remedy}." + (f" [{cause}]" if cause else "")
    return kind(message, cause, place, wrong, remedy)
