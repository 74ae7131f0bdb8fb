"""Products with the influence matrix, for programs that have a solver of their own."""

import ctypes
import weakref
from typing import Any, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, as_doubles, pointer
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

    p: an array of the system's shape, or its values in one row; the answer has the same shape and memory order. One thread at a
    time. `shape`, `dtype` and `matvec` are those that SciPy's `aslinearoperator` asks for.
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
        self._use = Use(self._close)

    @property
    def shape(self) -> Tuple[int, int]:
        """(n, n) for n points."""
        n = int(np.prod(self.system.shape))
        return n, n

    def __matmul__(self, p: ArrayLike) -> Doubles:
        return self.matvec(p)

    def matvec(self, p: ArrayLike) -> Doubles:
        array = p if isinstance(p, np.ndarray) and p.dtype == np.float64 and p.dtype.isnative else as_doubles(p, "p")
        if array.shape not in (self.system.shape, (self.shape[0],)):
            raise ShapeError(f"p has shape {array.shape}; {self.system.shape} or {(self.shape[0],)} is needed")
        if any(step % 8 for step in array.strides):
            array = array.copy(order="K")
        u = np.empty_like(array)
        here, there = (self._distances(each) for each in (array, u))
        with self._use.by_caller():
            status = contact_library().rc_product_apply(self._handle, pointer(array), *here, pointer(u), *there)
            self._product.raise_first()
            check(status)
        return u

    def _distances(self, array: Doubles) -> Tuple[int, int]:
        """Values between neighbours in x and in y."""
        steps = tuple(step // 8 for step in array.strides)
        if array.ndim == 2:
            return steps[1], steps[0]
        columns = self.system.shape[-1]
        return steps[0], steps[0] * columns

    def __repr__(self) -> str:
        return f"Influence({self.system!r})"
