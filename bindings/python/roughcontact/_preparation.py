"""What is done to heights before they are pressed: another body's heights, a form taken off, a shape put on."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace
from typing import Any, Dict, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, Pitch
from ._errors import ArgumentError, ShapeError
from ._files import is_file, other_surface_in
from ._height_map import Surface, same_pitch
from ._maps import as_surface, unit_of
from ._units import KNOWN, AssumedUnit, metres_of, metres_per, warn

_FORMS = "give sphere:R=1mm, cylinder:R=1mm,axis=x or wedge:angle=5deg,axis=x"
_KEYS = {"sphere": ("R",), "cylinder": ("R", "axis"), "wedge": ("angle", "axis")}
_ANGLES = {"deg": math.pi / 180, "rad": 1.0}


def own_unit(heights: Any) -> Optional[str]:
    """What heights in memory say, before they are converted to metres."""
    return None if is_file(heights) else unit_of(heights)


def prepared(
    heights: Any,
    *,
    pitch: Optional[Pitch],
    mask: Optional[ArrayLike],
    missing: str,
    unit: Optional[str],
    otherwise: Optional[Pitch],
    against: Any,
    shape: Union[None, str, Surface],
    remove: Optional[str],
) -> Surface:
    """The surface that is pressed, whose missing points its mask leaves out.

    against: heights of the other body, which are added; remove: a form that is then taken off; shape: one that is then put on
    """
    first = "exclude" if missing == "fill" else missing
    own = own_unit(heights)
    found = as_surface(heights, pitch, None, mask, first, unit, otherwise=otherwise)
    if against is not None:
        found = _together(found, against, first, "against", unit)
    if remove is not None and remove != "none":
        found = found.without(remove)
    if missing == "fill":
        found = found.filled()
    if isinstance(shape, str):
        found = replace(found, heights=found.heights - _depth_of(shape, found, unit, own))
    elif shape is not None:
        found = _together(found, shape, "reject", "shape", unit)
    if shape is not None:
        found = replace(found, periodic=False)  # a ball ends somewhere
    return found


def _together(surface: Surface, thing: Any, missing: str, name: str, unit: Optional[str]) -> Surface:
    """unit: of what has none."""
    if is_file(thing):
        thing = other_surface_in(thing, unit, surface.pitch)
    other = as_surface(thing, missing=missing, unit=unit if unit_of(thing) is None else None, otherwise=surface.pitch)
    if (other.unit is None) != (surface.unit is None):
        warn(
            f"{name if other.unit is None else 'the surface'} has no unit, beside one in metres: metres are taken; pass unit='m' if "
            "that is right, else its unit",
            AssumedUnit,
        )
        surface, other = replace(surface, unit="m"), replace(other, unit="m")
    if other.shape != surface.shape or not same_pitch(other.pitch, surface.pitch):
        raise ShapeError(
            f"{name} has shape {other.shape} and pitch {other.pitch}, the surface {surface.shape} and {surface.pitch}; "
            "both are needed on the same grid"
        )
    return surface + other


@dataclass(frozen=True)
class Body:
    """A nominal shape: its name, radius [length] or slope of the flanks, and the axis of a cylinder or wedge."""

    name: str
    size: float
    axis: str

    def width(self, load: float, modulus: float, length: float) -> float:
        """The width of the contact of a smooth body with a half-space: Hertz, and for a wedge Johnson (1985), equation 5.5.
        length: along the axis."""
        if self.name == "sphere":
            return 2 * (3 * load * self.size / (4 * modulus)) ** (1 / 3)
        if self.name == "wedge":
            return 2 * load / (length * modulus * self.size)
        return 2 * math.sqrt(4 * load * self.size / (math.pi * length * modulus))

    def too_wide(self, load: float, modulus: float, sides: Tuple[float, float]) -> str:
        """That this contact does not fit on a map with these sides (x, y), which then presses as a punch; "" if it does."""
        along, across = sides if self.axis == "x" else sides[::-1]
        side = min(sides) if self.name == "sphere" else across
        width = self.width(load, modulus, along)
        if not width > side:
            return ""
        return f"Hertz' contact of this shape and load is {width:.2g} wide, the map {side:.2g}: press a larger map"


def body_of(text: str, surface: Surface, unit: Optional[str], own: Optional[str]) -> Body:
    """A shape as `prepared` takes it. unit, own: as `_length` has them"""
    name, settings = _parsed(text)
    size = math.tan(_angle(settings["angle"])) if name == "wedge" else _length(settings["R"], surface.unit, unit, own)
    return Body(name, size, settings.get("axis", "y"))


def _depth_of(text: str, surface: Surface, unit: Optional[str], own: Optional[str]) -> Doubles:
    """How far below its highest point, which is in the middle of the grid, a shape lies at every point."""
    body = body_of(text, surface, unit, own)
    y, x = ((np.arange(n) - (n - 1) / 2) * h for n, h in zip((1, *surface.shape)[-2:], surface.pitch[::-1]))  # of one axis: x
    across = y[:, None] + 0 * x if body.axis == "x" else x + 0 * y[:, None]
    if body.name == "wedge":
        depth = np.abs(across) * body.size
    else:
        radius = body.size
        square = x**2 + y[:, None] ** 2 if body.name == "sphere" else across**2
        if square.max() > radius**2:
            raise ArgumentError(
                f"shape {text!r}: the surface reaches {math.sqrt(square.max()):g} from its middle, beyond R = {radius:g}"
            )
        depth = square / (radius + np.sqrt(radius**2 - square))
    found: Doubles = depth.reshape(surface.shape)
    return found


def _parsed(text: str) -> Tuple[str, Dict[str, str]]:
    name, colon, rest = text.partition(":")
    if name not in _KEYS or not colon:
        raise ArgumentError(f"shape is {text!r}: {_FORMS}")
    pairs = [setting.partition("=") for setting in rest.split(",")]
    settings = {key: value for key, _, value in pairs}
    sized = _KEYS[name][0] in settings
    if not sized or not set(settings) <= set(_KEYS[name]) or settings.get("axis", "x") not in ("x", "y"):
        raise ArgumentError(f"shape is {text!r}: {_FORMS}")
    return name, settings


def _number(text: str, units: Dict[str, float]) -> Tuple[float, Optional[str]]:
    """(number, unit) of a text; the longest unit that fits."""
    unit = max((each for each in units if text.endswith(each)), key=len, default="")
    try:
        number = float(text[: len(text) - len(unit)])
    except ValueError:
        number = math.nan
    if not (math.isfinite(number) and number > 0):
        raise ArgumentError(f"shape: {text!r} is no positive number with a unit of {', '.join(units)}")
    return number, unit or None


def _length(text: str, surface_unit: Optional[str], unit: Optional[str], own: Optional[str]) -> float:
    """unit: of lengths without one; own: what the surface said before it was converted to metres"""
    match = re.fullmatch(r"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*)", text.strip())
    number, name = (float(match[1]), match[2]) if match else (math.nan, "")
    metres = metres_per(name) if name else 1.0
    if not (math.isfinite(number) and number > 0) or metres is None:
        raise ArgumentError(f"shape: {text!r} is no positive number, alone or with a unit of {KNOWN}")
    if not name:
        if own is not None and metres_of(own) != 1:
            raise ArgumentError(f"shape: R={text} has no unit, but the surface is in {own!r}: write R={text}{own} or R={text}m")
        return number * (1.0 if unit is None else metres_of(unit))
    if surface_unit is None:
        raise ArgumentError(
            f"shape: R={text} has a unit, but the surface does not say its own; give R as a number in the unit of pitch and "
            "heights, or give unit="
        )
    return number * metres


def _angle(text: str) -> float:
    number, unit = _number(text, _ANGLES)
    if unit is None:
        raise ArgumentError(f"shape: angle {text!r} has no unit, give deg or rad")
    if not number * _ANGLES[unit] < math.pi / 2:
        raise ArgumentError(f"shape: angle {text!r} is not below 90deg")
    return number * _ANGLES[unit]
