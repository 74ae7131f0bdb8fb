"""Arrays that know which of their axes is x and how far their points are apart: those of xarray, by what they look like."""

from dataclasses import dataclass
from typing import Any, Dict, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from ._errors import ArgumentError
from ._units import KNOWN, metres_of, metres_per

_AXES = {"x": "x", "column": "x", "columns": "x", "col": "x", "y": "y", "row": "y", "rows": "y"}
_REGULAR = 1e-2  # how far a coordinate may be off its place, in pitches


@dataclass(frozen=True)
class Described:
    """What such an array says, None where it does not: the pitch along x and y, in `unit`; whether it repeats."""

    hx: Optional[float]
    hy: Optional[float]
    unit: Optional[str]
    periodic: Optional[bool]


def _names_axes(thing: Any) -> bool:
    return not isinstance(thing, np.ndarray) and isinstance(getattr(thing, "dims", None), tuple) and hasattr(thing, "coords")


def _axis_names(thing: Any) -> Tuple[str, ...]:
    """"x" and "y" for the axes that are these, by name or by place; the others come before them."""
    dims = tuple(str(dim) for dim in thing.dims)
    known = [_AXES.get(dim.lower(), "") for dim in dims]
    if not any(known) and all(dim.startswith("dim_") for dim in dims):  # xarray's names where there are none
        return ("y", "x")[-len(dims) :] if len(dims) < 3 else ("",) * (len(dims) - 2) + ("y", "x")
    if known.count("x") > 1 or known.count("y") > 1 or "x" not in known or ("y" not in known and len(dims) > 1):
        raise ArgumentError(f"the array's axes are named {', '.join(dims)}; name them y and x, as rename() of xarray does")
    return tuple(known)


def in_order(thing: Any) -> Any:
    """thing, or each of a list, with x along its last axis and y along the one before; what does not name its axes as it is."""
    if isinstance(thing, (list, tuple)) and any(_names_axes(each) for each in thing):
        return [in_order(each) for each in thing]
    if not _names_axes(thing):
        return thing
    names = _axis_names(thing)
    rank = {"": 0, "y": 1, "x": 2}
    order = sorted(range(len(names)), key=lambda axis: rank[names[axis]])
    return np.transpose(np.asarray(thing), order)


def _attribute(thing: Any, *names: str) -> Any:
    attributes = getattr(thing, "attrs", None) or {}
    return next((attributes[name] for name in names if attributes.get(name) is not None), None)


def _unit(thing: Any, what: str) -> Optional[str]:
    unit = _attribute(thing, "units", "unit")
    if unit is None or str(unit) == "":
        return None
    if metres_per(str(unit)) is None:
        raise ArgumentError(f"the unit of {what} is {unit!r}, not a length: {KNOWN}")
    return str(unit)


def _pitch(values: NDArray[Any], name: str) -> Optional[float]:
    if values.ndim != 1 or values.size < 2 or values.dtype.kind not in "fiu":
        return None
    places = values.astype(np.float64)
    pitch = (places[-1] - places[0]) / (places.size - 1)
    off = np.abs(places - (places[0] + pitch * np.arange(places.size)))
    if not (np.isfinite(pitch) and pitch != 0 and off.max() <= _REGULAR * abs(pitch)):
        raise ArgumentError(f"the coordinates along {name} are not evenly spaced; interpolate the heights onto a regular grid")
    return float(abs(pitch))


def _flag(value: Any) -> Optional[bool]:
    return None if value is None else bool(value)


def described(thing: Any) -> Optional[Described]:
    """None where the array does not name its axes; of a list what all its arrays agree on."""
    if isinstance(thing, (list, tuple)) and thing and all(_names_axes(each) for each in thing):
        each_says = [described(each) for each in thing]
        if any(says != each_says[0] for says in each_says):
            raise ArgumentError("the arrays differ in pitch, unit or whether they repeat; all need one grid")
        return each_says[0]
    if not _names_axes(thing):
        return None
    unit = _unit(thing, "the heights")
    found: Dict[str, Optional[float]] = {"x": None, "y": None}
    repeats = [_flag(_attribute(thing, "periodic", "is_periodic"))]
    lateral: Dict[str, Optional[str]] = {"x": None, "y": None}
    for dim, axis in zip(thing.dims, _axis_names(thing)):
        coordinate = thing.coords[dim] if axis and dim in thing.coords else None
        if coordinate is not None:
            found[axis], lateral[axis] = _pitch(np.asarray(coordinate), str(dim)), _unit(coordinate, str(dim))
            repeats.append(_flag(_attribute(coordinate, "periodic", "is_periodic")))
    unit = unit or lateral["x"] or lateral["y"]
    for axis, own in lateral.items():
        pitch = found[axis]
        if own is not None and unit is not None and pitch is not None:
            found[axis] = pitch * metres_of(own) / metres_of(unit) if own != unit else pitch
    stated = [each for each in repeats if each is not None]
    return Described(found["x"], found["y"], unit, all(stated) if stated else None)
