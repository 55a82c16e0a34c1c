"""The words of options, as the program understands them."""

from __future__ import annotations

import json
import math
import os
import re
from collections.abc import Iterable, Mapping
from typing import Any

from .errors import FileError, UsageError, refuse

__all__ = ["db_words", "dt_words", "levels", "names", "numbers", "path", "volume_words"]

_whole = re.compile(r"[+-]?\d+")


def path(given: Any) -> str:
    """A file's name as text; UsageError for what is none."""
    try:
        return os.fsdecode(given)
    except TypeError:
        raise refuse(UsageError, f"{given!r} is no file's name", "Give a str or a path") from None


def names(given: str | Iterable[str] | None) -> list[str]:
    """One name, or several."""
    if given is None:
        return []
    return [given] if isinstance(given, str) else [str(name) for name in given]


def _number(given: Any, option: str) -> float:
    try:
        value = float(given)
    except (TypeError, ValueError):
        value = math.nan
    if not math.isfinite(value):
        raise refuse(UsageError, f"{option}={given!r} is no number", f"For example {option}=0.25")
    return value


def optional_number(given: Any, option: str) -> float | None:
    return None if given is None else _number(given, option)


def least_zero(given: Any, option: str) -> float:
    """0 for None."""
    value = 0.0 if given is None else _number(given, option)
    if value < 0:
        raise refuse(UsageError, f"{option}={given!r} is less than 0", f"For example {option}=0.05")
    return value


def element_size(given: Any) -> float:
    least = 0.01
    value = _number(given, "elements")
    if value < least:
        raise refuse(UsageError, f"elements={given!r} is less than {least}", "Say how long edges may be, as elements=0.5, or \"quality\"")
    return value


def whole(given: Any, option: str, least: int) -> int:
    if isinstance(given, bool) or not hasattr(given, "__index__") or given.__index__() < least:
        raise refuse(UsageError, f"{option}={given!r} is no whole number of at least {least}", f"For example {option}={max(least, 8)}")
    return given.__index__()


def levels(given: Any) -> list[str]:
    """iso= and label= in the program's words.

    A number; "120", "120=dentine", "auto" or "auto:3/2" as the program has them; a mapping {"dentine": 120}; or several of these.

    >>> levels("120=dentine"), levels({"enamel": 195}), levels([120, "auto"])
    (['120=dentine'], ['195=enamel'], ['120', 'auto'])
    """
    if given is None:
        return []
    if isinstance(given, Mapping):
        return [f"{value}={name}" for name, value in given.items()]
    if isinstance(given, str):
        return [given]
    if isinstance(given, Iterable):
        return [word for one in given for word in levels(one)]
    return [str(given)]


def numbers(given: Any, option: str, count: int) -> str:
    """So many numbers as the program has them, "" for None.

    >>> numbers((0.1, 0.1, 0.2), "voxels", 3), numbers("31x41", "film", 2), numbers(None, "tube", 2)
    ('0.1,0.1,0.2', '31x41', '')
    """
    if given is None:
        return ""
    if isinstance(given, str):
        return given
    values = list(given) if isinstance(given, Iterable) else [given]
    if len(values) != count:
        raise refuse(UsageError, f"{option}={given!r} has not {count} numbers", f"Give {count}, in mm or as the program has them")
    return ",".join(repr(_number(value, option)) for value in values)


def volume_words(iso: Any, label: Any, label_names: Any, min_area: Any, smooth: Any, simplify: Any, crop: Any, resample: Any, upright: Any) -> dict[str, Any]:
    """How a volume becomes contours."""
    return {"iso": levels(iso), "label": levels(label), "label_names": "" if label_names is None else path(label_names),
            "min_area": "" if min_area is None else str(min_area).strip(), "smooth": optional_number(smooth, "smooth"), "simplify": optional_number(simplify, "simplify"),
            "crop": numbers(crop, "crop", 6), "resample": optional_number(resample, "resample"), "upright": bool(upright)}


def _link(text: str, connect: bool) -> dict[str, Any]:
    found = re.fullmatch(r"(.+):(\d+):(\d+)-(\d+)", text)
    if not found:
        raise refuse(UsageError, f"\"{text}\" is no link", "Write NAME:N:B-U, for example link=\"pulp:12:0-1\"")
    structure, number, lower, upper = found.groups()
    return {"structure": structure, "slice": int(number), "lower": int(lower), "upper": int(upper), "connect": connect}


def _text_of(file: str) -> str:
    try:
        with open(file, encoding="utf-8", errors="replace") as opened:
            return opened.read()
    except OSError as error:
        raise refuse(FileError, f"cannot be read: {error.strerror}", "Check the name and its permissions", name=file, file=file) from error


def _links(links: Any, link: Any, unlink: Any) -> str:
    """The text of a links file; "" for none."""
    chosen = [_link(text, True) for text in names(link)] + [_link(text, False) for text in names(unlink)]
    if links is not None and isinstance(links, (str, os.PathLike)):
        listed = _text_of(path(links))
        if not chosen:
            return listed
        try:
            links = json.loads(listed)["links"]
        except (ValueError, KeyError, TypeError):
            return listed  # the library's reader says what is wrong with it
    for one in links or []:
        if not isinstance(one, Mapping):
            raise refuse(UsageError, f"{one!r} is no link", "Give dicts, such as those of model.links")
        chosen.append(dict(one))
    return json.dumps({"format": "odontoscope.links", "version": 1, "links": chosen}) if chosen else ""


def dt_words(correspondence: str, between: str, links: Any, link: Any, unlink: Any, threads: int) -> dict[str, Any]:
    return {"correspondence": str(correspondence), "between": str(between), "links": _links(links, link, unlink), "threads": whole(threads, "threads", 0)}


def _grid(given: Any) -> tuple[int, int]:
    """
    >>> _grid(64), _grid("128x96"), _grid((32, 16))
    ((64, 64), (128, 96), (32, 16))
    """
    if isinstance(given, str):
        parts = given.split("x")
        if not (1 <= len(parts) <= 2 and all(_whole.fullmatch(part) for part in parts)):
            raise refuse(UsageError, f"grid={given!r} is no number of grid points", "Give N or \"NxM\", such as 128 or \"128x96\"")
        given = [int(part) for part in parts]
    if isinstance(given, Iterable):
        given = list(given)
        if len(given) not in (1, 2):
            raise refuse(UsageError, f"grid={given!r} is no number of grid points", "Give N or \"NxM\", such as 128 or \"128x96\"")
        return whole(given[0], "grid", 1), whole(given[-1], "grid", 1)
    return whole(given, "grid", 1), whole(given, "grid", 1)


def db_words(grid: Any, cases: str, field: str, split: Any, decimate: Any, threads: int) -> dict[str, Any]:
    heights = [] if split is None else [_number(z, "split") for z in (split if isinstance(split, Iterable) and not isinstance(split, str) else [split])]
    target = None if decimate is None else 0 if decimate == "max" else whole(decimate, "decimate", 1)
    return {"grid": _grid(grid), "split": heights, "cases": str(cases), "field": str(field), "decimate": target, "threads": whole(threads, "threads", 0)}
