"""One line that shows an object whose arrays are long."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np


def _shown(value: Any) -> str:
    if isinstance(value, (float, np.floating)):
        return f"{value:.6g}"
    shape = getattr(value, "shape", None)
    if isinstance(shape, tuple) and shape:
        return "[" + " x ".join(map(str, shape)) + "]"
    return repr(value.item() if isinstance(value, np.generic) else value)


def brief(thing: Any) -> str:
    """The __repr__ of a dataclass: numbers by six digits, arrays by their shapes."""
    members = (f"{field.name}={_shown(getattr(thing, field.name))}" for field in dataclasses.fields(thing))
    return f"{type(thing).__name__}({', '.join(members)})"
