"""Units of length by their names, as files and the command have them."""

from __future__ import annotations

import ctypes
import functools
import inspect
import os
import warnings
from typing import Optional, Type

from ._errors import ArgumentError
from ._library import formats_library

KNOWN = "m with an SI prefix (mm, um, nm, pm) or A (angstrom)"


class AssumedUnit(UserWarning):
    """A length has no unit, although others have one or it comes from a file: metres are assumed."""


def warn(message: str, category: Type[Warning]) -> None:
    """A warning that the caller of the package sees at its own line."""
    package = os.path.dirname(__file__)
    frame, level = inspect.currentframe(), 1
    while frame is not None and os.path.dirname(frame.f_code.co_filename).startswith(package):
        frame, level = frame.f_back, level + 1
    warnings.warn(message, category, stacklevel=level)


@functools.lru_cache(maxsize=None)
def metres_per(unit: str) -> Optional[float]:
    """None where the name is no length."""
    found = ctypes.c_double()
    name = unit.encode(errors="replace")
    return found.value if b"\0" not in name and formats_library().rc_surface_unit(name, found) == 0 else None


def metres_of(unit: str) -> float:
    found = metres_per(unit)
    if found is None:
        raise ArgumentError(f"unit {unit!r} is not a length: {KNOWN}")
    return found
