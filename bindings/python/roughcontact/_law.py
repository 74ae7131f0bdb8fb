"""Contact laws: the pressure of a rough patch against its overclosure, with bounds between nodes that are solved once."""

from __future__ import annotations

import ctypes
import weakref
from typing import Any, Callable, Dict, Mapping, NamedTuple, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _constants, plot
from ._arrays import Doubles, array_in, array_out, as_doubles, given, pointer
from ._calls import Callbacks, check, conclude, interruptible
from ._errors import ArgumentError
from ._handle import Progress, progress_caller
from ._keywords import split_words
from ._library import contact_library
from ._paths import Path, as_path
from ._pressed import pressed
from ._slip import Slip
from ._status import Status
from ._structs import rc_law_export_spec, rc_law_info, rc_law_point, rc_law_spec, rc_progress_fn
from ._threads import with_threads
from ._use import OwnsHandle
from .context import Context, Options, OptionSet
from .system import System

BULK = {"auto": _constants.RC_LAW_BULK_AUTO, "none": _constants.RC_LAW_BULK_NONE, "mean": _constants.RC_LAW_BULK_MEAN}
FORMATS = {
    "csv": _constants.RC_LAW_CSV,
    "calculix": _constants.RC_LAW_CALCULIX,
    "abaqus": _constants.RC_LAW_ABAQUS,
    "moose": _constants.RC_LAW_MOOSE,
    "table": _constants.RC_LAW_TABLE,
}


class Bounds(NamedTuple):
    """Two arrays, between which the exact values lie."""

    lower: Doubles
    upper: Doubles


class Law(OwnsHandle):
    """A contact law, made by `law` or `Law.load`. Overclosures and pressures are numbers or arrays. Any number of threads.

    status: Status.OK if the tolerance is proven
    """

    def __init__(self, handle: ctypes.c_void_p, status: Status = Status.OK) -> None:
        self._handle, self.status = handle, status
        self._close = weakref.finalize(self, contact_library().rc_law_destroy, handle)
        self._close.atexit = False

    @classmethod
    def load(cls, path: Path) -> Law:
        """The law of a file, with the status that it was made with."""
        handle = ctypes.c_void_p()
        status = contact_library().rc_law_load(as_path(path), handle)
        check(status)
        return cls(handle, Status(status))

    def __repr__(self) -> str:
        info = self.info
        return f"Law({info['nodes']} nodes, p {info['p_lower']:.6g} .. {info['p_upper']:.6g}, {self.status.name})"

    @property
    def info(self) -> Mapping[str, Union[int, float]]:
        """The members of `rc_law_info`."""
        info = rc_law_info()
        check(contact_library().rc_law_describe(self._handle, info))
        return _members(info)

    @property
    def nodes(self) -> Dict[str, Doubles]:
        """The members of `rc_law_point`, each as an array over the nodes."""
        found = []
        for i in range(int(self.info["nodes"])):
            node = rc_law_point()
            check(contact_library().rc_law_describe_node(self._handle, i, node))
            found.append(_members(node))
        return {name: np.array([node[name] for node in found]) for name in found[0] if name != "reserved"}

    def __call__(self, x: ArrayLike) -> Any:
        """Nominal pressure [force/length^2]. Beyond the last node it continues on the last tangent."""
        return self._evaluated(x)[0]

    def slope(self, x: ArrayLike) -> Any:
        """dp/dx [force/length^3]"""
        return self._evaluated(x)[1]

    def energy(self, x: ArrayLike) -> Any:
        """The integral of the pressure over the overclosure, per nominal area [force/length]."""
        return self._evaluated(x)[2]

    def bounds(self, x: ArrayLike) -> Bounds:
        """Bounds of the exact pressure of the patch's grid."""
        points = self._points(x)
        return Bounds(points("p_lower"), points("p_upper"))

    def area_fraction(self, x: ArrayLike) -> Any:
        """Contact area over nominal area."""
        return self._points(x)("area_fraction")

    def overclosure(self, p: ArrayLike) -> Any:
        """The inverse."""
        library = contact_library()
        return self._each(p, "p", lambda value, out: library.rc_law_overclosure(self._handle, value, out))

    def conductance(self, p: ArrayLike, k: Tuple[float, float]) -> Any:
        """Thermal or electrical conductance per nominal area at nominal pressures. k: conductivities of both bodies."""
        library, (first, second) = contact_library(), (1 / float(each) for each in k)
        return self._each(p, "p", lambda value, out: library.rc_law_gap_conductance(self._handle, value, first, second, out))

    def slip(self, *, mu: float, nu: float) -> Slip:
        """The shear of this patch under friction, as a function of slip and pressure. mu: coefficient of friction; nu: Poisson's ratio
        of both bodies, 0 to 0.5"""
        return Slip(self, mu, nu)

    def plot(self, **how: Any) -> Any:
        """`roughcontact.plot.law` of this law."""
        return plot.law(self, **how)

    def save(self, path: Path) -> None:
        """A text file with every bit of the law."""
        check(contact_library().rc_law_save(self._handle, as_path(path)))

    def export(
        self,
        path: Path,
        format: str,
        *,
        rows: int = 0,
        k: Optional[Tuple[float, float]] = None,
        length: float = 1,
        force: float = 1,
        beyond: float = 0,
        mu: float = 0,
        nu: float = 0,
    ) -> float:
        """Writes a table for another program. Returns the largest distance of straight lines between its rows from the law, over p.

        format: "csv", "calculix", "abaqus", "moose" or "table"
        rows, length, force, beyond, mu, nu: as in `rc_law_export_spec`; k: conductivities, for a conductance in the table
        """
        if format not in FORMATS:
            raise ArgumentError(f"format is {format!r}: one of {', '.join(FORMATS)}")
        spec = rc_law_export_spec()
        spec.format, spec.rows, spec.length, spec.force, spec.beyond = FORMATS[format], rows, length, force, beyond
        spec.mu, spec.nu = mu, nu
        if k is not None:
            spec.rho1, spec.rho2 = (1 / float(each) for each in k)
        check(contact_library().rc_law_export(self._handle, as_path(path), spec))
        return float(spec.error)

    def _evaluated(self, x: ArrayLike) -> Tuple[Any, Any, Any]:
        xs = as_doubles(x, "x")
        outputs = tuple(np.empty_like(xs) for _ in range(3))
        check(contact_library().rc_law_pressures(self._handle, xs.size, array_in(xs), *map(array_out, outputs)))
        p, slope, energy = (output[()] for output in outputs)
        return p, slope, energy

    def _points(self, x: ArrayLike) -> Callable[[str], Any]:
        xs, points = as_doubles(x, "x"), []
        for value in xs.ravel():
            point = rc_law_point()
            check(contact_library().rc_law_evaluate(self._handle, value, point))
            points.append(point)
        return lambda name: np.array([getattr(point, name) for point in points]).reshape(xs.shape)[()]

    def _each(self, values: ArrayLike, name: str, call: Callable[[float, Any], int]) -> Any:
        array = as_doubles(values, name)
        out = np.empty_like(array)
        one = np.empty(1)
        for i, value in enumerate(array.flat):
            check(call(float(value), pointer(one)))
            out.flat[i] = one[0]
        return out[()]


def _members(struct: Any) -> Dict[str, Any]:
    return {name: getattr(struct, name) for name, *_ in struct._fields_ if name != "struct_size"}


def law(
    heights: Any = None,
    *,
    pressure: Union[str, Tuple[float, float]],
    tolerance: float = 1e-3,
    conductance_tolerance: float = 0,
    bulk: Union[str, float] = "auto",
    undeformed_gap: Optional[ArrayLike] = None,
    system: Optional[System] = None,
    mask: Optional[ArrayLike] = None,
    nominal_area: float = 0,
    max_nodes: int = 0,
    check_status: bool = True,
    progress: Optional[Callable[[Progress], object]] = None,
    options: Options = None,
    context: Optional[Context] = None,
    **words: Any,
) -> Law:
    """The contact law of a rough patch.

    pressure: nominal pressures (lower, upper) between which the tolerance holds [force/length^2]; or "1MPa..500MPa"
    tolerance, conductance_tolerance: half the distance between the bounds, relative; conductance_tolerance=0: no limit
    bulk: "auto", "none", "mean", or a stiffness [force/length], see `rc_law_spec`
    check_status: False: a law whose tolerance is not proven is returned, with its status, instead of a `NotCertifiedError`
    progress: called with a `Progress` once an iteration of each node's solve, on the thread that solves; True ends the call with a
        `NotCertifiedError`
    nominal_area: as `rc_law_spec.area`
    Other arguments and words as in `solve` and `rc_law_spec`.
    """
    given_words, options = split_words(law, options, words, context)
    what = pressed(_constants.RC_CALL_LAW, heights, undeformed_gap, mask, system, {**given_words, "pressure": pressure})
    found, gap, points = what.system, what.gap, what.mask
    spec = rc_law_spec()
    given(spec, undeformed_gap=gap, mask=points)
    spec.p_lower, spec.p_upper = what.needed().given.tolist()
    spec.tolerance, spec.tolerance_conductance, spec.area, spec.max_nodes = (
        tolerance,
        conductance_tolerance,
        nominal_area,
        max_nodes,
    )
    if isinstance(bulk, str):
        if bulk not in BULK:
            raise ArgumentError(f"bulk is {bulk!r}: 'auto', 'none', 'mean' or a stiffness")
        spec.bulk = BULK[bulk]
    else:
        spec.bulk, spec.bulk_stiffness = _constants.RC_LAW_BULK_GIVEN, float(bulk)
    callbacks = Callbacks()
    if progress is not None:
        spec.progress = rc_progress_fn(callbacks.guarded(progress_caller(progress)))
    handle = ctypes.c_void_p()
    struct, product = found.struct()
    chosen = with_threads(what.options(options), found)

    def call() -> int:
        with OptionSet(chosen, context) as given:
            return int(contact_library().rc_law_create(struct, given, spec, handle))

    status, message, interrupt = interruptible(call, keep=(found, product, callbacks, gap, points))
    made = Law(handle, Status(status)) if handle else None
    conclude(status, message, interrupt, made, check_status or made is None, product, callbacks)
    assert made is not None
    return made
