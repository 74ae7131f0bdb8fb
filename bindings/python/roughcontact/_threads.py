"""How many threads a call uses where option threads is not given. The bits of answers do not depend on it."""

import os
from typing import Any, Dict

import numpy as np

from . import _constants
from .system import HalfSpace, Product, System

POINTS_EACH = 16384  # of a half-space: with fewer a thread waits more than it works


def usable_cores() -> int:
    """Processor cores that this process may use; OMP_THREAD_LIMIT and OMP_NUM_THREADS bound them."""
    found = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    for name in ("OMP_THREAD_LIMIT", "OMP_NUM_THREADS"):
        limit = os.environ.get(name, "")
        if limit.isdigit() and int(limit) > 0:
            found = min(found, int(limit))
    return min(found, 1024)


def with_threads(options: Any, system: System, contacts: int = 0) -> Dict[str, Any]:
    """options and threads: every core that pays, for one contact, or for so many at the same time."""
    if contacts:
        useful = contacts
    else:
        points = int(np.prod(system.shape))
        useful = points // POINTS_EACH if isinstance(system, HalfSpace) else points * points // (16 * POINTS_EACH)
    alone = isinstance(system, Product)  # the caller's function, which several threads might not call
    return {_constants.RC_OPT_THREADS: 1 if alone else max(1, min(usable_cores(), useful)), **dict(options or {})}
