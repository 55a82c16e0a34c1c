"""Arrays of callers, looked at before anything is made of them."""

from __future__ import annotations

from typing import Any

import numpy as np

from .errors import InputError, refuse

__all__ = ["finite", "numbers"]


def numbers(given: Any, name: str, columns: int | None = None, dimensions: int = 2, kinds: str = "fiu") -> np.ndarray:
    """``given`` as an array of real numbers.

    Any strides and byte order will do, and arrays that cannot be written. Refused, as InputError, are other shapes (cause wrong-shape) and
    types (wrong-type: complex, text, objects, ragged lists, masked arrays that hide something).
    """
    if isinstance(given, np.ma.MaskedArray) and np.ma.is_masked(given):
        raise refuse(InputError, "is a masked array, some of it hidden", "Fill it, or leave the hidden rows out", "wrong-type", name=name)
    try:
        if isinstance(given, memoryview):
            given.nbytes  # ValueError for one that was released, of which numpy would make an object
        array = np.asarray(given)
    except (ValueError, TypeError) as error:  # ragged, or gone (a released memoryview)
        raise refuse(InputError, f"is no array of numbers ({error})", "Give a numpy array", "wrong-type", name=name) from error
    if array.size == 0 and array.dtype.kind not in kinds:
        array = array.astype(np.float64)
    if array.dtype.kind not in kinds:
        wanted = "real numbers" if "f" in kinds else "whole numbers"
        raise refuse(InputError, f"holds {array.dtype}, not {wanted}", "Convert it first, with astype", "wrong-type", name=name)
    if array.ndim != dimensions or (columns is not None and array.shape[1] != columns):
        wanted = {1: "(n,)", 2: f"(n, {columns})", 3: "(slices, rows, columns)"}[dimensions]
        raise refuse(InputError, f"has the shape {array.shape}, not {wanted}", "Reshape or transpose it", "wrong-shape", name=name)
    return array


def finite(given: Any, name: str, columns: int | None = None, dimensions: int = 2) -> np.ndarray:
    """The same as C-contiguous float64, none of it NaN or infinite (InputError not-finite)."""
    array = numbers(given, name, columns, dimensions)
    array = np.ascontiguousarray(array, dtype=np.float64)
    wrong = ~np.isfinite(array)
    if wrong.any():
        at = tuple(int(i) for i in np.argwhere(wrong)[0])
        raise refuse(InputError, f"{array[at]} at index {at} is no finite number", "Correct or remove it", "not-finite", name=name, index=at)
    return array
