"""Products with the influence matrix, for programs that have a solver of their own."""

from __future__ import annotations

import ctypes
import weakref
from typing import Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, array_in, array_out, as_doubles
from ._calls import check
from ._errors import ShapeError
from ._library import contact_library
from ._threads import with_threads
from ._use import OwnsHandle, Use
from .context import Context, Options, OptionSet
from .system import System


class Influence(OwnsHandle):
    """The influence matrix H of a system: `H @ p` are the deflections [length] under pressures of any sign [force/length^2].

    system: `HalfSpace`, `Matrix` or `Product`. Periodic: the mean pressure deflects nothing, so deflections have mean 0
    options: of backends and products, see `roughcontact.options()`

    p: an array of the system's shape, its n values in one row or as a column (n, 1), or k such columns (n, k); the answer has the
    same shape and memory order. One thread at a time. H is symmetric. It serves SciPy: `aslinearoperator(H)` goes to `cg`, `eigsh`,
    `svds` and the like.
    """

    dtype = np.dtype(np.float64)

    def __init__(self, system: System, *, options: Options = None, context: Optional[Context] = None) -> None:
        library, self.system, self._handle = contact_library(), system, ctypes.c_void_p()
        struct, self._product = system.struct()
        with OptionSet(with_threads(options, system), context) as chosen:
            status = library.rc_product_create(struct, chosen, self._handle)
            if status < 0:
                self._product.raise_first()
            check(status)
        self._close = weakref.finalize(self, library.rc_product_destroy, self._handle)
        self._close.atexit = False
        self._use = Use(self._handle, self._close)

    @property
    def shape(self) -> Tuple[int, int]:
        """(n, n) for n points."""
        n = int(np.prod(self.system.shape))
        return n, n

    def __matmul__(self, p: ArrayLike) -> Doubles:
        array = p if isinstance(p, np.ndarray) and p.dtype == np.float64 and p.dtype.isnative else as_doubles(p, "p")
        n = self.shape[0]
        columns = array.ndim == 2 and array.shape[0] == n and array.shape != self.system.shape
        if not columns and array.shape not in (self.system.shape, (n,)):
            raise ShapeError(f"p has shape {array.shape}; {self.system.shape}, {(n,)} or ({n}, k) is needed")
        u = np.empty_like(array)
        for one, answer in zip(array.T, u.T) if columns else [(array, u)]:
            self._apply(one, answer)
        return u

    matvec = matmat = rmatvec = rmatmat = __matmul__

    @property
    def T(self) -> Influence:
        """The same: H is symmetric and real."""
        return self

    H = T

    def _apply(self, p: Doubles, u: Doubles) -> None:
        one = np.ascontiguousarray(p)
        answer = u if u.flags.c_contiguous else np.empty_like(one)
        with self._use:
            status = contact_library().rc_product_apply(self._handle, array_in(one), array_out(answer))
            self._product.raise_first()
            check(status)
        if answer is not u:
            u[...] = answer

    def __repr__(self) -> str:
        return f"Influence({self.system!r})"
