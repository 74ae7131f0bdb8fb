"""How many threads a call uses where option threads is not given. The bits of answers do not depend on it."""

import os
from typing import Any, Dict

import numpy as np

from . import _constants
from ._library import contact_library
from .system import HalfSpace, Product, System

POINTS_EACH = 16384  # of a half-space: with fewer a thread waits more than it works


def usable_cores() -> int:
    """Cores that this process may keep busy, see `rc_usable_cores`."""
    allowed = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else 0
    return contact_library().rc_usable_cores(allowed)


def with_threads(options: Any, system: System, contacts: int = 0) -> Dict[str, Any]:
    """options and threads: every core that pays, for one contact, or for so many at the same time."""
    if contacts:
        useful = contacts
    else:
        points = int(np.prod(system.shape))
        useful = points // POINTS_EACH if isinstance(system, HalfSpace) else points * points // (16 * POINTS_EACH)
    alone = useful < 2 or isinstance(system, Product)  # the caller's function, which several threads might not call
    return {_constants.RC_OPT_THREADS: 1 if alone else min(usable_cores(), useful), **dict(options or {})}
