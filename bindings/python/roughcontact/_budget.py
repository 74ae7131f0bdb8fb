"""How sure the numbers of a contact are, source by source: libroughcontact-request solves the contact again for each."""

from __future__ import annotations

import ctypes
from contextlib import nullcontext
from dataclasses import dataclass
from typing import Any, Callable, Dict, Mapping, Optional, Sequence, Tuple, Union

from numpy.typing import ArrayLike

from . import _constants
from ._answers import Stored, needed
from ._c import members_for
from ._calls import Callbacks, Library, check, conclude, interruptible, short_traceback
from ._errors import ArgumentError
from ._keywords import documented, split_words
from ._library import contact_library, request_library
from ._progress import Bars
from ._pressed import pressed
from ._request import message_of_request
from ._flow import leak_values
from ._structs import rc_budget_contribution, rc_budget_progress_fn, rc_budget_quantity, rc_budget_spec, rc_budget_value_fn
from .context import Context, Options, OptionSet

Sources = Union[str, Mapping[str, Any]]


@dataclass(frozen=True)
class Contribution(Stored):
    """What one source adds to one quantity, in its unit; see rc_budget_contribution in <roughcontact/budget.h>.

    source, given: as "noise", "20nm"
    standard: standard uncertainty from this source; shift: mean change by one more noise, 0 for other sources
    first_order, sampled: the standard uncertainty by derivatives and by samples; NaN where there are none
    share: of the combined variance
    """

    source: str
    given: str
    standard: float
    shift: float
    first_order: float
    sampled: float
    share: float
    solves: int


@dataclass(frozen=True)
class Uncertain(Stored):
    """A quantity with its combined uncertainty, as rc_budget_quantity has it.

    standard: combined standard uncertainty, in the unit of value; coverage: factor of 95 %, by `freedom` degrees of freedom
    dominant: the source with the largest share; "" if none changes the quantity
    sentence: all of it for people
    """

    name: str
    unit: str
    value: float
    standard: float
    freedom: float
    coverage: float
    dominant: str
    sentence: str
    contributions: Tuple[Contribution, ...]

    @property
    def expanded(self) -> float:
        """coverage * standard: with 95 % the quantity is within this of value."""
        return self.coverage * self.standard

    def __getitem__(self, source: str) -> Contribution:
        for each in self.contributions:
            if each.source == source:
                return each
        raise KeyError(f"{source!r} is none of the sources {', '.join(each.source for each in self.contributions)}")

    def __str__(self) -> str:
        return self.sentence


@dataclass(frozen=True)
class Budget(Stored):
    """The quantities of a step, each with its contributions: load, approach, area (a share), mean_pressure, stiffness, mean_gap,
    conductance, which divided by the sum of both resistivities is the conductance, and with the word leak the leak. `solves` were
    made."""

    quantities: Tuple[Uncertain, ...]
    solves: int

    def __getitem__(self, name: str) -> Uncertain:
        for each in self.quantities:
            if each.name == name:
                return each
        raise KeyError(f"{name!r} is none of {', '.join(each.name for each in self.quantities)}")

    def __str__(self) -> str:
        """A sentence for each quantity."""
        return "\n".join(each.sentence for each in self.quantities)

    def to_dataframe(self) -> Any:
        """A pandas DataFrame: one row for each quantity and source."""
        pandas = needed("pandas", "to_dataframe")
        rows = [
            {"quantity": each.name, "value": each.value, "unit": each.unit, **vars(part)}
            for each in self.quantities
            for part in each.contributions
        ]
        return pandas.DataFrame(rows)


def _text_of(sources: Sources) -> str:
    if isinstance(sources, str):
        return sources
    return ",".join(
        name if value is None or value is True else f"{name}={value!r}" if isinstance(value, float) else f"{name}={value}"
        for name, value in sources.items()
    )


def _read(handle: ctypes.c_void_p) -> Budget:
    library = request_library()
    sources = range(library.rc_budget_source_count(handle))
    quantities = []
    solves = 1
    for q in range(library.rc_budget_quantity_count(handle)):
        struct, parts = rc_budget_quantity(), []
        check(library.rc_budget_get_quantity(handle, q, struct), message_of_request)
        for k in sources:
            part = rc_budget_contribution()
            check(library.rc_budget_get_contribution(handle, q, k, part), message_of_request)
            parts.append(Contribution(**members_for(Contribution, part)))
        own: Dict[str, Any] = {name: getattr(struct, name).decode() for name in ("name", "unit", "sentence")}
        own["dominant"] = parts[struct.dominant].source if struct.dominant >= 0 else ""
        numbers = {name: getattr(struct, name) for name in ("value", "standard", "freedom", "coverage")}
        quantities.append(Uncertain(**own, **numbers, contributions=tuple(parts)))
        solves = 1 + sum(part.solves for part in parts)
    return Budget(tuple(quantities), solves)


@documented
@short_traceback
def budget(
    heights: Any = None,
    sources: Sources = "",
    *,
    undeformed_gap: Optional[ArrayLike] = None,
    mask: Optional[ArrayLike] = None,
    leak: Optional[str] = None,
    options: Options = None,
    progress: Union[bool, Callable[[int, int], object]] = False,
    context: Optional[Context] = None,
    **words: Any,
) -> Budget:
    """How sure the numbers of a contact are: a budget of uncertainties in the manner of the GUM.

    heights, undeformed_gap, mask, options: as in `solve`
    sources: what is uncertain, as "noise=20nm,pitch=1%,E=5%,grid" or a dictionary; the uncertainties are standard ones, shares or
        lengths, pressures and so on. noise (with correlation), pitch, height, modulus, E, nu, E2, nu2, hardness, approach, load,
        pressure, area; bandwidth, remove, missing, shift, window, maps (a list of files or surfaces), grid; samples (16) and seed
        (1). docs/how-to/uncertainty.md and <roughcontact/budget.h> say what each does. The solver's own proven intervals are always
        among them
    leak: "viscosity=1mPas,drop=1bar", and ",along=y": the flow through the gap is one more quantity, see `Result.leak`
    progress: True: a bar of the package tqdm; or a function, called with the solves that have ended and all of them, which ends the
        budget by returning True

    Words as in `solve`:
    """
    given, options = split_words(budget, options, words, context)
    given = given if leak is None else {**given, "leak": leak}
    others: Sequence[Any] = ()
    if not isinstance(sources, str):
        maps = sources.get("maps")
        if maps is not None and not isinstance(maps, str):
            others, sources = maps if isinstance(maps, (list, tuple)) else [maps], {**sources, "maps": None}
    text = _text_of(sources)
    if mask is not None and "maps" in text:
        raise ArgumentError("source maps: mask is of the first map alone; give NaN in each map and missing='exclude'")
    problem = pressed(_constants.RC_CALL_SOLVE, heights, undeformed_gap, mask, None, given, others=others)
    problem.needed()
    if not text:
        raise ArgumentError("sources is empty: what is uncertain, as in 'noise=20nm,pitch=1%,E=5%,grid'?")
    callbacks, bars, spec = Callbacks(), Bars(), rc_budget_spec()

    def so_far(done: int, all_solves: int, _: Any) -> object:
        bars.show(done)
        return progress(done, all_solves) if callable(progress) else False

    spec.sources, spec.progress = text.encode(), rc_budget_progress_fn(callbacks.guarded(so_far))
    handle = ctypes.c_void_p()
    chosen = problem.options(options)
    view = problem.request.view
    if view.viscosity > 0:

        def value_of(system: Any, result: Any, points: Any, _: Any, value: Any, lower: Any, upper: Any) -> object:
            fluid = {"viscosity": view.viscosity, "pressure_drop": view.pressure_drop, "along": view.along}
            value[0], lower[0], upper[0] = leak_values(system, spec.options, result, points, **fluid)
            return False

        spec.value, spec.value_name = rc_budget_value_fn(callbacks.guarded(value_of)), b"leak"
        spec.value_unit = b"m^3/s" if view.si else None

    def call() -> int:
        with OptionSet(chosen, context) as own:
            spec.options = own
            return int(request_library().rc_budget_create(problem.request.spec, spec, handle))

    def library() -> Library:
        return Library(contact_library().rc_stop_when, message_of_request)

    with bars.over("solves") if progress is True else nullcontext():
        status, message, interrupt = interruptible(call, keep=(problem, spec, callbacks), of=library)
    try:
        conclude(status, message, interrupt, None, True, callbacks)
        return _read(handle)
    finally:
        request_library().rc_budget_destroy(handle)
