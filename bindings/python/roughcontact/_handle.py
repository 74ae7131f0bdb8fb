"""A contact of the library: made, used by one caller at a time, interrupted and destroyed."""

import ctypes
import weakref
from contextlib import nullcontext
from dataclasses import dataclass
from typing import Any, Callable, ContextManager, Dict, List, Optional, Tuple, TypeVar, Union

from ._arrays import Mask, Reals, as_int
from ._c import members_for
from ._calls import Callbacks, check, conclude, interruptible
from ._errors import ArgumentError, InfeasibleError, ShapeError
from ._keywords import options_of
from ._library import contact_library
from ._progress import Bars
from ._status import Status
from ._structs import rc_progress_fn
from ._threads import with_threads
from ._use import OwnsHandle, Use
from .context import Context, Options, OptionSet
from .result import Grid
from .system import System


@dataclass(frozen=True)
class Progress:
    """How far a step is: iterations of the solver, products with H, its own estimate of the residual, seconds since the step
    began."""

    iteration: int
    products: int
    kkt: float
    seconds: float


Watch = Union[None, bool, Callable[[Progress], object]]  # True: a bar
H = TypeVar("H", bound="Handle")


class Handle(OwnsHandle):
    """What all calls of a `Contact` share."""

    def __init__(
        self,
        system: System,
        *,
        options: Options = None,
        progress: Watch = None,
        every: int = 1,
        context: Optional[Context] = None,
        **keywords: Any,
    ) -> None:
        options = with_threads(options_of(type(self), options, keywords, context), system)
        library = contact_library()
        interval = as_int(every, "every")
        self.system = system
        self._context = context
        self._options: Dict[str, Any] = {}
        self._borrowed: List[Any] = []  # arrays that the library may still look at
        self._mask: Optional[Mask] = None
        self._grid: Optional[Grid] = None
        struct, self._product = system.struct()
        self._handle = ctypes.c_void_p()
        with OptionSet(options, context) as handle:
            status = library.rc_contact_create(struct, handle, self._handle)
            if status < 0:
                self._product.raise_first()
            check(status)
        self._close = weakref.finalize(self, library.rc_contact_destroy, self._handle)
        self._close.atexit = False  # another thread might be solving then
        self._use = Use(self._handle, self._close)
        self._options.update(options or {})
        self._callbacks = Callbacks()
        self._bars = Bars() if progress is True else None
        if progress is not None and progress is not False:
            watch = _shown_on(self._bars) if self._bars else progress
            self._progress = rc_progress_fn(self._callbacks.guarded(progress_caller(watch)))
            check(library.rc_contact_on_progress(self._handle, self._progress, None, interval))

    def close(self) -> None:
        """Frees what the contact holds; it cannot be used afterwards. Again: nothing happens."""
        if not self._use.closed():
            with self._holding():
                self._use.close()

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.system!r}{', closed' if self._use.closed() else ''})"

    def __enter__(self: H) -> H:
        return self

    def __exit__(self, kind: Any, *_: object) -> None:
        if kind is None:
            self.close()
        else:
            self._use.close()  # a call that a signal handler's exceptions got out of closes it when it ends

    def _holding(self) -> ContextManager[ctypes.c_void_p]:
        return self._use

    def _holding_or_inside(self) -> ContextManager[ctypes.c_void_p]:
        """As `_holding`, also inside a function that sees the steps of this contact's history."""
        return self._use.by_caller_or_callback()

    def _bar(self, unit: str, total: Optional[int] = None, done: Optional[Callable[[], int]] = None) -> ContextManager[None]:
        """Over a call, where bars are asked for."""
        return self._bars.over(unit, total, done) if self._bars else nullcontext()

    def grid(self) -> Grid:
        """Shape, pitch, mask and modulus of what was pressed last."""
        if self._grid is None or self._grid.mask is not self._mask:
            system = self.system
            self._grid = Grid(system.shape, system.pitch, system.periodic, self._mask, system.modulus, system.hardness)
        return self._grid

    def _pressing(self, undeformed_gap: Optional[Reals], mask: Optional[Mask]) -> ContextManager[None]:
        """Over a call with these."""
        return _Pressing(self, mask) if undeformed_gap is not None or mask is not None else nullcontext()

    def _run(self, call: Callable[[], int], keep: Any) -> Tuple[int, str, Optional[BaseException]]:
        """(status, message, interrupt) of a call that uses this contact."""
        return interruptible(call, self._use, (self, keep))

    def _conclude(self, *ended: Any) -> None:
        """As `conclude`, of a call of this contact."""
        conclude(*ended, self._product, self._callbacks)

    def cancel(self) -> None:
        """Stops the running step soon, or the next one if none runs. Any thread."""
        self._use.while_alive(lambda: contact_library().rc_contact_cancel(self._handle))


class _Pressing:
    """Follows which mask the library has: a step that it refuses changes nothing."""

    def __init__(self, contact: Handle, mask: Optional[Mask]) -> None:
        self._contact, self._before = contact, contact._mask
        contact._mask = mask

    def __enter__(self) -> None:
        pass

    def __exit__(self, _: Any, error: Any, __: Any) -> None:
        if isinstance(error, (ArgumentError, ShapeError, InfeasibleError)):
            if error.result is None or error.result.completed == 0:
                self._contact._mask = self._before


def _shown_on(bars: Bars) -> Callable[[Progress], object]:
    return lambda report: bars.show(report.iteration, report.kkt)


def progress_caller(progress: Any) -> Callable[[Any, Any], object]:
    def call(report: Any, _: Any) -> object:
        return progress(Progress(**members_for(Progress, report.contents)))

    return call
