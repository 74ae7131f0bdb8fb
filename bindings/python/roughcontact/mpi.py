"""One contact shared by the ranks of an MPI communicator, each with some rows of the grid. Needs mpi4py and libroughcontact-mpi.

    from mpi4py import MPI
    import roughcontact as rc, roughcontact.mpi
    system = rc.HalfSpace((ny, nx), pitch=1e-6, modulus=100e9)
    rows = rc.mpi.rows(system)  # of this rank
    gap = rc.mpi.gap_from_heights(heights[rows])
    with rc.mpi.Contact(system) as contact:
        result = contact.solve(undeformed_gap=gap, load=1.0)  # result.pressure: of these rows; all else is of the whole grid

Every rank calls these functions, with its own rows in the arrays and the same values in all else. An exception is raised on all ranks
or on none. Answers have the same bits for every number of ranks and threads.
"""

import contextlib
import ctypes
import weakref
from dataclasses import dataclass
from typing import Any, Callable, Dict, Optional, TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike

from . import _constants
from ._answers import needed
from ._arrays import Doubles, Mask, as_doubles, as_mask, as_switch, given
from ._c import members_for
from ._calls import check as check_status, conclude, last_message
from ._creep import time_for
from ._errors import ArgumentError
from ._keywords import options_of
from ._pressed import Prescribed, prescribed
from ._library import contact_library, mpi_library
from ._structs import rc_exchange, rc_ranks_counts, rc_result, rc_step
from ._use import OwnsHandle
from .context import Context, Options, OptionSet
from .result import Grid, Result, result_from
from .system import HalfSpace

Made = TypeVar("Made")


@dataclass(frozen=True)
class Counts:
    """Numbers of exchanges for a contact since it was created, and bytes of this rank."""

    products: int  # with H, of which each transposes twice
    transpositions: int
    transposed: int  # bytes sent to other ranks in them
    reductions: int  # sums over all ranks
    reduced: int  # bytes given to them
    gathers: int  # of coarse levels and coarse grids
    gathered: int
    shifts: int  # exchanges with a neighbour
    shifted: int
    iterations: int


def _world(comm: Any) -> Any:
    """The communicator, by default all ranks. Initialises MPI."""
    mpi = needed("mpi4py.MPI", "roughcontact.mpi")
    return mpi.COMM_WORLD if comm is None else comm


def _together(world: Any, make: Callable[[], Made]) -> Made:
    """What `make` returns. Where it raises on a rank, every rank raises the same, so that none waits for the others."""
    made, mine = None, None
    try:
        made = make()
    except Exception as error:  # whatever a rank's own arguments lead to
        mine = type(error), str(error)
    for rank, failure in enumerate(world.allgather(mine)):
        if failure:
            raise failure[0](f"rank {rank}: {failure[1]}")
    return cast(Made, made)


def rows(system: HalfSpace, comm: Any = None) -> slice:
    """The rows of the grid, along the first axis, that this rank has; it may have none. comm: an mpi4py communicator; None: all ranks."""
    world, exchange = _world(comm), rc_exchange()
    exchange.rank, exchange.ranks = world.Get_rank(), world.Get_size()
    struct, _ = system.struct()
    first, count = ctypes.c_int64(), ctypes.c_int64()
    check_status(mpi_library().rc_ranks_rows(exchange, struct, first, count))
    return slice(first.value, first.value + count.value)


def _freed(handle: ctypes.c_void_p, exchange: rc_exchange) -> None:
    contact_library().rc_contact_destroy(handle)
    mpi_library().rc_mpi_exchange_destroy(exchange)


def gap_from_heights(heights: ArrayLike, comm: Any = None) -> Doubles:
    """The undeformed gap of this rank's rows, of which the highest point of all ranks touches first [length]."""
    world = _world(comm)
    mine = _together(world, lambda: as_doubles(heights, "heights"))
    bad = world.allreduce(int(np.isnan(mine).sum()))
    if bad:
        raise ArgumentError(f"heights have {bad} values that are NaN; make the gap yourself and give a mask")
    highest = world.allreduce(float(mine.max()) if mine.size else -np.inf, needed("mpi4py.MPI", "roughcontact.mpi").MAX)
    gap: Doubles = highest - mine
    return gap


class Contact(OwnsHandle):
    """A contact kept over a loading sequence, as `roughcontact.Contact`, of which this rank has the rows `rows`.

    system: `HalfSpace` with the shape of the whole grid
    comm: an mpi4py communicator; None: all ranks. options, context, keywords: as in `roughcontact.Contact`; threads: of each rank, 1 if
        not given

    A context manager; `close` frees what it holds, on all ranks at the same time, before MPI is finalised.
    """

    def __init__(
        self,
        system: HalfSpace,
        comm: Any = None,
        *,
        options: Options = None,
        context: Optional[Context] = None,
        **keywords: Any,
    ) -> None:
        self._world = world = _world(comm)
        self._handle = ctypes.c_void_p()
        self._mask: Optional[Mask] = None
        with contextlib.ExitStack() as stack:

            def made() -> Any:
                found: Dict[str, Any] = {_constants.RC_OPT_THREADS: 1}
                found.update(options_of(type(self), options, keywords, context) or {})
                return rows(system, comm), system.struct()[0], stack.enter_context(OptionSet(found, context))

            self.rows, struct, handle = _together(world, made)
            self.system = system
            exchange = rc_exchange()
            self._close = weakref.finalize(self, _freed, self._handle, exchange)
            self._close.atexit = False  # MPI is finalised by then
            try:
                check_status(mpi_library().rc_mpi_exchange_create_f(world.py2f(), exchange))
                check_status(mpi_library().rc_ranks_contact_create(exchange, struct, handle, self._handle))
            except BaseException:
                self._close()
                raise
        self._context = context

    @property
    def shape(self) -> Any:
        """The shape of this rank's arrays."""
        return (self.rows.stop - self.rows.start, *self.system.shape[1:])

    def close(self) -> None:
        """Frees what the contact holds; it cannot be used afterwards. Again: nothing happens."""
        self._close()

    def __enter__(self) -> "Contact":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def solve(
        self,
        *,
        approach: Optional[float] = None,
        load: Optional[float] = None,
        pressure: Optional[float] = None,
        area: Optional[float] = None,
        time: Optional[float] = None,
        undeformed_gap: Optional[ArrayLike] = None,
        mask: Optional[ArrayLike] = None,
        start: Optional[ArrayLike] = None,
        warm_start: Optional[bool] = None,
        want_pressure: bool = True,
        want_gap: bool = False,
        check: bool = True,
    ) -> Result:
        """Solves one step and certifies the answer. Arguments as in `roughcontact.Contact.solve`, arrays of this rank's rows; pressure:
        mean pressure over the whole grid. The answer's arrays and its grid are of this rank's rows, all numbers of the whole grid.
        """

        def prepared() -> Any:
            what = prescribed(self.system, approach=approach, load=load, pressure=pressure, area=area)
            step = self._step(what, undeformed_gap, mask, time)
            given(step, p0=None if start is None else as_doubles(start, "start", self.shape), warm_start=as_switch(warm_start))
            return step, np.zeros(self.shape) if want_pressure else None

        return self._run(contact_library().rc_contact_solve, prepared, want_gap, check)

    def certify(
        self,
        pressure: ArrayLike,
        *,
        approach: Optional[float] = None,
        load: Optional[float] = None,
        time: Optional[float] = None,
        undeformed_gap: Optional[ArrayLike] = None,
        mask: Optional[ArrayLike] = None,
        want_gap: bool = False,
        check: bool = True,
    ) -> Result:
        """Certifies given pressures [force/length^2] for this step; nothing is solved."""

        def prepared() -> Any:
            judged = as_doubles(pressure, "pressure", self.shape).copy()
            return self._step(prescribed(self.system, approach=approach, load=load), undeformed_gap, mask, time), judged

        return self._run(contact_library().rc_contact_certify, prepared, want_gap, check)

    def counts(self) -> Counts:
        """Numbers and bytes of this rank's exchanges."""
        self._refuse_closed()
        struct = rc_ranks_counts()
        check_status(mpi_library().rc_ranks_contact_counts(self._handle, struct))
        return Counts(**members_for(Counts, struct))

    def _refuse_closed(self) -> None:
        if not self._close.alive:
            raise ArgumentError("the contact is closed")

    def _step(
        self, what: Prescribed, undeformed_gap: Optional[ArrayLike], mask: Optional[ArrayLike], time: Optional[float]
    ) -> rc_step:
        self._refuse_closed()
        gap = None if undeformed_gap is None else as_doubles(undeformed_gap, "undeformed_gap", self.shape)
        chosen = as_mask(mask, "mask", self.shape)
        self._keep = gap, chosen
        if gap is not None or chosen is not None:
            self._mask = chosen
        step = given(rc_step(), control=what.control, target=what.target(), time=time_for(self.system, time))
        return given(step, undeformed_gap=gap, mask=chosen)

    def _run(self, function: Any, prepared: Callable[[], Any], want_gap: bool, must_be_certified: bool) -> Result:
        step, pressure = _together(self._world, prepared)
        deformed = np.zeros(self.shape) if want_gap else None
        struct = given(rc_result(), p=pressure, gap=deformed)
        status = int(function(self._handle, step, struct))
        message = last_message() if status else ""
        grid = Grid(self.shape, self.system.pitch, self.system.periodic, self._mask, self.system.modulus, self.system.hardness)
        answer = result_from(struct, message, grid, pressure, deformed) if status >= 0 else None
        conclude(status, message, None, answer, must_be_certified)
        assert answer is not None
        return answer
