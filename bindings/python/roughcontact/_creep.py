"""Bodies that creep: the terms of their compliance or of their modulus, and the times of steps."""

from __future__ import annotations

from typing import Any, Dict, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _constants
from ._arrays import Doubles, Shape, as_doubles, given
from ._errors import ArgumentError
from ._structs import rc_system

Terms = Sequence[Tuple[float, float]]  # pairs (ratio, time)
Series = Union[str, Terms]  # or as the words creep and relaxation are written


def give_creep(system: rc_system, creep: Optional[Terms], relaxation: Optional[Terms]) -> None:
    """Completes the C struct, which keeps the arrays."""
    if creep is not None and relaxation is not None:
        raise ArgumentError("creep and relaxation are both given; they say the same in two ways, give one")
    name, terms = ("creep", creep) if relaxation is None else ("relaxation", relaxation)
    if terms is None:
        return
    pairs = as_doubles(terms, name)
    if pairs.ndim != 2 or pairs.shape[1] != 2:
        raise ArgumentError(f"{name} has shape {pairs.shape}; pairs are needed: [(ratio, time), ...]")
    ratio, time = np.ascontiguousarray(pairs.T)
    by = _constants.RC_CREEP_COMPLIANCES if relaxation is None else _constants.RC_CREEP_MODULI
    given(system, creep_by=by, creep_terms=len(pairs), creep_ratio=ratio, creep_time=time)


def series_words(**series: Any) -> Dict[str, Any]:
    """Series of a call as words: pairs (ratio, time), or texts."""
    found: Dict[str, Any] = {}
    for name, terms in series.items():
        if terms is None:
            continue
        if isinstance(terms, str):
            found[name] = terms
            continue
        pairs = as_doubles(terms, name)
        if pairs.ndim != 2 or pairs.shape[1] != 2:
            raise ArgumentError(f"{name} has shape {pairs.shape}; pairs are needed: [(ratio, time), ...]")
        found[name] = pairs
    return found


def time_for(system: Any, time: Optional[float]) -> Optional[float]:
    """The time of one step; None: none is needed."""
    times = times_for(system, None if time is None else [time], (1,))
    return None if times is None else float(times[0])


def times_for(system: Any, time: Optional[ArrayLike], shape: Shape) -> Optional[Doubles]:
    """The times of steps; None: none are needed. shape: of the targets, to which times of one history are repeated."""
    if time is None:
        if system.creep is not None or system.relaxation is not None:
            raise ArgumentError("time is missing: the bodies creep, so that each step needs its time")
        return None
    times = as_doubles(time, "time")
    if times.shape != shape and times.shape != shape[-1:]:
        raise ArgumentError(f"time has shape {times.shape}, the steps {shape}: one time for each step is needed")
    return np.ascontiguousarray(np.broadcast_to(times, shape))
