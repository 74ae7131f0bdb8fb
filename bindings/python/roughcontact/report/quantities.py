"""Physical quantities as the command takes them: "39nm", "210 GPa", or a number alone; lists and ranges of them."""

import math
import re
from typing import List, Tuple

import numpy as np

from .._errors import ArgumentError
from .._units import metres_per

UNITS = {"length": "m", "pressure": "Pa", "force": "N"}
PREFIXES = {
    **{"T": 1e12, "G": 1e9, "M": 1e6, "k": 1e3, "h": 1e2, "da": 1e1, "": 1.0, "d": 1e-1, "c": 1e-2, "m": 1e-3, "u": 1e-6},
    **{"\u00b5": 1e-6, "\u03bc": 1e-6, "n": 1e-9, "p": 1e-12, "f": 1e-15, "a": 1e-18},
}
LABELS = [(PREFIXES[name], name) for name in ("T", "G", "M", "k", "", "m", "\u00b5", "n", "p", "f", "a")]
MOST_POINTS = 100000


def _quantity(option: str, text: str, kind: str, alone: float) -> Tuple[float, str]:
    """(value in SI units, unit as written)"""
    match = re.fullmatch(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*", text, re.S)
    if match is None:
        raise ArgumentError(f"{option}: {text!r} is not a number, alone or with a unit")
    value, unit = float(match[1]), match[2]
    if not unit:
        return value * alone, unit
    metres = metres_per(unit)
    if kind == "length" and metres is not None:
        return value * metres, unit
    symbol = UNITS[kind]
    prefix = unit[: -len(symbol)]
    if not unit.endswith(symbol) or prefix not in PREFIXES:
        raise ArgumentError(f"{option}: {text!r} has not the unit of a {kind}, {symbol} with an SI prefix")
    return value * PREFIXES[prefix], unit


def quantity(option: str, text: str, kind: str, alone: float = 1.0) -> float:
    """A positive quantity in SI units. alone: what a number without a unit counts"""
    value, _ = _quantity(option, text, kind, alone)
    if not (value > 0 and math.isfinite(value)):
        raise ArgumentError(f"{option}: {text!r} must be positive and finite")
    return value


def quantities(option: str, texts: List[str], kind: str, alone: float = 1.0) -> List[float]:
    """Several, none of them negative. With and without a unit in one list is refused, because either reading may be meant."""
    found = [_quantity(option, text, kind, alone) for text in texts]
    for text, (value, _) in zip(texts, found):
        if not (value >= 0 and math.isfinite(value)):
            raise ArgumentError(f"{option}: {text!r} must be 0 or more and finite")
    if len({bool(unit) for value, unit in found if value != 0}) > 1:
        raise ArgumentError(f"{option}: some numbers have a unit and some have none, give every number its unit")
    return [value for value, _ in found]


def targets(option: str, text: str, kind: str, alone: float = 1.0) -> List[float]:
    """The steps that a number, a list a,b,c or a range a:b:n or a:b:nlog stands for, in SI units."""
    if ":" not in text:
        return quantities(option, text.split(","), kind, alone)
    parts = text.split(":")
    count = re.fullmatch(r"\s*(\d+)(log)?\s*", parts[-1])
    if len(parts) != 3 or count is None or not 1 <= int(count[1]) <= MOST_POINTS:
        raise ArgumentError(f"{option}: {text!r} is not a range a:b:n or a:b:nlog with 1 <= n <= {MOST_POINTS}")
    first, last = quantities(option, parts[:2], kind, alone)
    if count[2] and not (first > 0 and last > 0):
        raise ArgumentError(f"{option}: {text!r} has equal ratios, give two ends above 0")
    spaced = np.geomspace if count[2] else np.linspace
    return [float(value) for value in spaced(first, last, int(count[1]))]


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
