# What binding/drawing.cpp offers to the package. Not for users: names and arguments may change.
from collections.abc import Callable
from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from ._core import Model

_Listener = Optional[Callable[[str, float], Any]]

def check(words: dict[str, Any]) -> None: ...
def page(model: Model, title: str, listener: _Listener) -> bytes: ...
def picture(model: Model, words: dict[str, Any], listener: _Listener) -> npt.NDArray[np.uint8]: ...
def png(pixels: npt.NDArray[np.uint8]) -> bytes: ...
