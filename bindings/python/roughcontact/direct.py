"""The paper's methods on a matrix of yours: minimise 1/2 p'Hp - u'p over p >= 0, one call, certified like every answer.

With influence coefficients per force, p are forces.
"""

import ctypes
from dataclasses import dataclass
from typing import Any, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, Pitch, as_doubles, as_int, as_pitch, as_text, columns_and_rows, pointer
from ._calls import interruptible
from ._errors import Interrupted, ShapeError, Status, as_status, error_for
from ._library import contact_library
from ._structs import rc_direct
from .system import row_stride, square


@dataclass(frozen=True, eq=False)
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
    applications: int
    contacts: int
    load: float
    energy: float
    kkt: float
    duality_gap: float
    load_lower: float
    load_upper: float
    note: str


def _call(function: str, arguments: Tuple[Any, ...], p: Doubles, w: Optional[Doubles], check: bool) -> DirectResult:
    struct = rc_direct()
    library = contact_library()
    # These routines cannot be cancelled: Ctrl-C arrives when they return.
    status, message, interrupt = interruptible(
        lambda: int(getattr(library, function)(*arguments, ctypes.byref(struct))), lambda: None, keep=(p, w)
    )
    answer = None
    if status >= 0:
        answer = DirectResult(
            p,
            w,
            as_status(status),
            message,
            struct.iterations,
            struct.applications,
            struct.contacts,
            struct.load,
            struct.energy,
            struct.kkt,
            struct.duality_gap,
            struct.load_lower,
            struct.load_upper,
            struct.note.decode(errors="replace"),
        )
    if interrupt is not None:
        raise Interrupted(answer) if isinstance(interrupt, KeyboardInterrupt) else interrupt
    if answer is None or check and status != Status.OK:
        raise error_for(status, message, answer)
    return answer


def _on_matrix(
    name: str, H: ArrayLike, u: ArrayLike, start: Optional[ArrayLike], tol: float, max_iter: int, check: bool
) -> DirectResult:
    matrix = square(H)
    n, steps = matrix.shape[0], as_int(max_iter, "max_iter")
    right = as_doubles(u, "u", (n,))
    p = np.zeros(n) if start is None else as_doubles(start, "start", (n,)).copy()
    w = np.zeros(n)
    return _call(
        f"rc_{name}", (n, pointer(matrix), row_stride(matrix), pointer(right), pointer(p), pointer(w), tol, steps), p, w, check
    )


def greedy(
    H: ArrayLike,
    u: ArrayLike,
    *,
    start: Optional[ArrayLike] = None,
    tol: float = 1e-8,
    max_iter: int = 10000,
    check: bool = True,
) -> DirectResult:
    """Greedy active set (Algorithm 1). It fails on some matrices: with an answer that is not certified.

    H: [n, n] symmetric positive definite; u: [n]; start: [n], None: zeros; tol: largest residual relative to max(u);
    check: whether an answer that is not certified raises `NotCertifiedError`, which has it as its result
    """
    return _on_matrix("greedy", H, u, start, tol, max_iter, check)


def polonsky_keer(
    H: ArrayLike,
    u: ArrayLike,
    *,
    start: Optional[ArrayLike] = None,
    tol: float = 1e-8,
    max_iter: int = 10000,
    check: bool = True,
) -> DirectResult:
    """Constrained conjugate gradients (Algorithm 2). Arguments as in `greedy`."""
    return _on_matrix("polonsky_keer", H, u, start, tol, max_iter, check)


def nnls(
    H: ArrayLike,
    u: ArrayLike,
    *,
    start: Optional[ArrayLike] = None,
    tol: float = 1e-8,
    max_iter: int = 10000,
    check: bool = True,
) -> DirectResult:
    """Non-negative least squares, finite and exact (Algorithm 3). Arguments as in `greedy`."""
    return _on_matrix("nnls", H, u, start, tol, max_iter, check)


def gp(
    H: ArrayLike,
    u: ArrayLike,
    *,
    start: Optional[ArrayLike] = None,
    tol: float = 1e-8,
    max_iter: int = 10000,
    check: bool = True,
) -> DirectResult:
    """Accelerated gradient projection (Algorithm 4). Arguments as in `greedy`."""
    return _on_matrix("gp", H, u, start, tol, max_iter, check)


def admm(
    H: ArrayLike,
    u: ArrayLike,
    *,
    start: Optional[ArrayLike] = None,
    tol: float = 1e-8,
    max_iter: int = 10000,
    check: bool = True,
) -> DirectResult:
    """Alternating direction method of multipliers (Algorithm 5). Arguments as in `greedy`."""
    return _on_matrix("admm", H, u, start, tol, max_iter, check)


def cmr(
    heights: ArrayLike,
    *,
    pitch: Pitch,
    modulus: float,
    delta: float,
    levels: int = 3,
    h: float = 1.5,
    inner: Optional[str] = None,
    check: bool = True,
) -> DirectResult:
    """Cascade multi-resolution (Algorithm 6) on a height map, free boundaries, tolerance 1e-8.

    heights: [ny, nx], the highest touches first [length]; delta: compression below it [length]
    pitch: one number or (hx, hy) [length]; modulus: E* [force/length^2]
    levels: grids of the cascade, the given one included; h: radius of influence in coarse cells, >= 1
    inner: solver on every level, None: chosen by the library
    """
    z = as_doubles(heights, "heights")
    if z.ndim not in (1, 2):
        raise ShapeError(f"heights have {z.ndim} axes: [ny, nx] is needed")
    (hx, hy), (nx, ny), grids = as_pitch(pitch), columns_and_rows(z.shape), as_int(levels, "levels")
    p = np.zeros(z.shape)
    return _call(
        "rc_cmr",
        (nx, ny, hx, hy, modulus, pointer(z), delta, grids, h, None if inner is None else as_text(inner, "inner"), pointer(p)),
        p,
        None,
        check,
    )
