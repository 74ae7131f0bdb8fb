"""The paper's methods on a matrix of yours: minimise 1/2 p'Hp - u'p over p >= 0, one call, certified like every answer.

With influence coefficients per force, p are forces.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, Pitch, as_doubles, as_int, as_pitch, as_text, columns_and_rows, pointer, refuse_one_row
from ._brief import brief
from ._c import members_for
from ._calls import conclude, interruptible
from ._constants import RC_OPT_MAX_ITER, RC_OPT_TOL
from ._errors import ShapeError, as_status
from ._library import contact_library
from ._status import Status
from ._structs import rc_direct
from .context import default
from .system import row_stride, square

__all__ = ["greedy", "polonsky_keer", "nnls", "gp", "admm", "cmr", "DirectResult"]


def __dir__() -> Sequence[str]:
    return __all__


@dataclass(frozen=True, eq=False, repr=False)
class DirectResult:
    """Answer of a direct routine.

    p: [n] solution (`cmr`: [ny, nx] pressures [force/length^2])
    w: [n] Hp - u; None from `cmr`
    load: sum of p (`cmr`: normal force [force])
    energy: 1/2 p'Hp - u'p (`cmr`: [force length])
    kkt: the largest residual; the rest as in `Result`
    """

    p: Doubles
    w: Optional[Doubles]
    status: Status
    message: str
    iterations: int
    products: int
    contacts: int
    load: float
    energy: float
    kkt: float
    duality_gap: float
    load_lower: float
    load_upper: float
    note: str

    __repr__ = brief


def _call(function: Any, arguments: Tuple[Any, ...], p: Doubles, w: Optional[Doubles], check: bool) -> DirectResult:
    struct = rc_direct()
    status, message, interrupt = interruptible(lambda: int(function(*arguments, struct)), keep=(p, w, arguments))
    answer = None
    if status >= 0:
        answer = DirectResult(p=p, w=w, message=message, **{**members_for(DirectResult, struct), "status": as_status(status)})
    conclude(status, message, interrupt, answer, check)
    assert answer is not None
    return answer


class _Routine:
    """A method on a matrix.

    H: [n, n] symmetric positive definite; u: [n]; start: [n], None: zeros
    tol: largest residual relative to max(u); max_iter: iterations after which it stops; None: as the options of these names
    check: whether an answer that is not certified raises `NotCertifiedError`, which has it as its result
    """

    def __init__(self, name: str, summary: str) -> None:
        self.__name__, self.__doc__ = name, f"{summary}\n{type(self).__doc__}"

    def __call__(
        self,
        H: ArrayLike,
        u: ArrayLike,
        *,
        start: Optional[ArrayLike] = None,
        tol: Optional[float] = None,
        max_iter: Optional[int] = None,
        check: bool = True,
    ) -> DirectResult:
        matrix = square(H)
        n = matrix.shape[0]
        steps = int(default(RC_OPT_MAX_ITER)) if max_iter is None else as_int(max_iter, "max_iter")
        limit = default(RC_OPT_TOL) if tol is None else tol
        right = as_doubles(u, "u", (n,))
        p = np.zeros(n) if start is None else as_doubles(start, "start", (n,)).copy()
        w = np.zeros(n)
        arguments = n, pointer(matrix), row_stride(matrix), pointer(right), pointer(p), pointer(w), limit, steps
        return _call(getattr(contact_library(), f"rc_{self.__name__}"), arguments, p, w, check)


greedy = _Routine("greedy", "Greedy active set (Algorithm 1). It fails on some matrices: with an answer that is not certified.")
polonsky_keer = _Routine("polonsky_keer", "Constrained conjugate gradients (Algorithm 2).")
nnls = _Routine("nnls", "Non-negative least squares, finite and exact (Algorithm 3).")
gp = _Routine("gp", "Accelerated gradient projection (Algorithm 4).")
admm = _Routine("admm", "Alternating direction method of multipliers (Algorithm 5).")


def cmr(
    heights: ArrayLike,
    *,
    pitch: Pitch,
    modulus: float,
    approach: float,
    levels: int,
    radius: Optional[float] = None,
    inner: Optional[str] = None,
    check: bool = True,
) -> DirectResult:
    """Cascade multi-resolution (Algorithm 6) on a height map, free boundaries.

    heights: [ny, nx], the highest touches first [length]; approach: from there [length]
    pitch: one number or (hx, hy) [length]; modulus: E* [force/length^2]
    levels: grids of the cascade, the given one included
    radius: of influence in coarse cells, >= 1; None: as option cmr.radius
    inner: solver on every level, None: chosen by the library
    """
    z = as_doubles(heights, "heights")
    if z.ndim not in (1, 2):
        raise ShapeError(f"heights have {z.ndim} axes: [ny, nx] is needed")
    refuse_one_row(z, "heights", pitch)
    (hx, hy), (nx, ny), grids = as_pitch(pitch), columns_and_rows(z.shape), as_int(levels, "levels")
    reach = default("cmr.radius") if radius is None else radius
    p = np.zeros(z.shape)
    name = None if inner is None else as_text(inner, "inner")
    return _call(
        contact_library().rc_cmr,
        (nx, ny, hx, hy, modulus, pointer(z), approach, grids, reach, name, pointer(p)),
        p,
        None,
        check,
    )
