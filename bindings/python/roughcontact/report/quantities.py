"""Physical quantities as people read them: "39 nm"."""

import math
from typing import Tuple

LABELS = [
    (1e12, "T"),
    (1e9, "G"),
    (1e6, "M"),
    (1e3, "k"),
    (1.0, ""),
    (1e-3, "m"),
    (1e-6, "\u00b5"),
    (1e-9, "n"),
    (1e-12, "p"),
    (1e-15, "f"),
    (1e-18, "a"),
]


def prefix_for(magnitude: float) -> Tuple[float, str]:
    """The SI prefix under which a value of this magnitude has one to three digits before the point."""
    if not (abs(magnitude) > 0 and math.isfinite(magnitude)):
        return 1.0, ""
    return next((each for each in LABELS if abs(magnitude) >= 0.9995 * each[0]), LABELS[-1])


def with_prefix(value: float, unit: str, digits: int = 3) -> str:
    """ "39 nm" """
    if not math.isfinite(value):
        return "unknown"
    factor, name = prefix_for(value)
    number = f"{value / factor + 0.0:.{digits}g}"  # never -0
    if "e+" in number:  # more digits before the point than asked for
        number = f"{float(number):.0f}"
    return f"{number} {name}{unit}"
