"""Certified normal contact of rough surfaces on an elastic half-space: a checked solution, not a calibrated instrument.

    import roughcontact as rc
    result = rc.solve(heights, pitch=1e-6, modulus=100e9, approach=1e-6)

Arrays are [ny, nx], x along the last axis; `pitch` is one number or (hx, hy). Any consistent set of units does.

A call that fails raises a `RoughContactError`. A call that stops before its answer is certified raises `NotCertifiedError`,
whose `result` holds the answer, or with check=False returns it with its `status`; Status.WITHIN_GOAL is returned in either
case. Ctrl-C ends a running call and raises `Interrupted`, a KeyboardInterrupt whose `result` is what was complete by then.
"""

from typing import List

from . import analysis as analysis, direct as direct, plot as plot, raw as raw, surface as surface
from ._errors import (
    ArgumentError as ArgumentError,
    BusyError as BusyError,
    ExternalError as ExternalError,
    IncompatibleError as IncompatibleError,
    InfeasibleError as InfeasibleError,
    InternalError as InternalError,
    Interrupted as Interrupted,
    LibraryNotFoundError as LibraryNotFoundError,
    NoBackendError as NoBackendError,
    NoSolverError as NoSolverError,
    NotCertifiedError as NotCertifiedError,
    NumericError as NumericError,
    OptionError as OptionError,
    OutOfMemoryError as OutOfMemoryError,
    PluginError as PluginError,
    RoughContactError as RoughContactError,
    ShapeError as ShapeError,
)
from ._files import Format as Format, formats as formats, read as read
from ._height_map import Surface as Surface
from ._library import library_file as library_file
from ._status import Status as Status
from .analysis import Area as Area, Conductance as Conductance, Crossing as Crossing, Histogram as Histogram, Patches as Patches
from ._answers import load as load
from ._batch import batch as batch
from ._budget import Budget as Budget, Contribution as Contribution, Uncertain as Uncertain, budget as budget
from .contact import Contact as Contact
from ._flow import ClosingPressure as ClosingPressure, FlowFactors as FlowFactors, Leak as Leak
from ._flow import closing_pressure as closing_pressure, flow as flow, flow_factors as flow_factors
from ._derivatives import Gradient as Gradient, Tangent as Tangent
from ._handle import Progress as Progress
from .context import (
    Component as Component,
    Context as Context,
    OptionSpec as OptionSpec,
    backends as backends,
    effective_options as effective_options,
    kernel_coefficients as kernel_coefficients,
    kernels as kernels,
    options as options,
    solvers as solvers,
    version as version,
)
from ._influence import Influence as Influence
from ._history_result import HistoryResult as HistoryResult
from ._law import Law as Law, law as law
from ._slip import Slip as Slip, SlipState as SlipState
from .result import (
    Accuracy as Accuracy,
    BatchResult as BatchResult,
    Grid as Grid,
    Level as Level,
    Result as Result,
    Smooth as Smooth,
)
from ._prepare import prepare as prepare
from ._solve import history as history, solve as solve
from ._units import AssumedUnit as AssumedUnit
from .surface import example as example
from .system import (
    AssumedBoundary as AssumedBoundary,
    HalfSpace as HalfSpace,
    Matrix as Matrix,
    Product as Product,
    System as System,
    supported as supported,
)

__version__ = "0.1.0"
# All imported names, without the modules that define them.
__all__ = sorted(name for name in set(dir()) - {"List", "contact", "context", "result", "system"} if not name.startswith("_"))


def __dir__() -> List[str]:
    return [*__all__, "__version__"]
