"""Certified normal contact of rough surfaces on an elastic half-space.

    import roughcontact as rc
    result = rc.solve(heights, pitch=1e-6, modulus=100e9, displacement=1e-6)

Arrays are [ny, nx], x along the last axis; `pitch` is one number or (hx, hy). Any consistent set of units does.

A call that fails raises a `RoughContactError`. A call that stops before its answer is certified raises `NotCertifiedError`,
whose `result` holds the answer, or with check=False returns it with its `status`; Status.WITHIN_GOAL is returned in either
case. Ctrl-C ends a running call and raises `Interrupted`, a KeyboardInterrupt whose `result` is what was finished.
"""

from . import analysis, direct, plot, raw, surface
from ._errors import (
    ArgumentError,
    BusyError,
    ExternalError,
    IncompatibleError,
    InfeasibleError,
    InternalError,
    Interrupted,
    LibraryNotFoundError,
    NoBackendError,
    NoSolverError,
    NotCertifiedError,
    NumericError,
    OptionError,
    OutOfMemoryError,
    PluginError,
    RoughContactError,
    ShapeError,
)
from ._library import library_file
from ._maps import Surface
from ._status import Status
from .analysis import Area, Histogram, Patches
from ._batch import batch
from .contact import Contact
from ._handle import Progress
from .context import (
    Component,
    Context,
    OptionSpec,
    backends,
    effective_options,
    kernel_coefficients,
    kernels,
    options,
    solvers,
    version,
)
from .result import Accuracy, BatchResult, Grid, Level, PathResult, Result
from ._solve import path, solve
from .system import HalfSpace, Matrix, Product, System, supported

__version__ = "0.1.0"

__all__ = [
    "Accuracy",
    "Area",
    "ArgumentError",
    "BatchResult",
    "BusyError",
    "Component",
    "Contact",
    "Context",
    "ExternalError",
    "Grid",
    "HalfSpace",
    "Histogram",
    "IncompatibleError",
    "InfeasibleError",
    "InternalError",
    "Interrupted",
    "Level",
    "LibraryNotFoundError",
    "Matrix",
    "NoBackendError",
    "NoSolverError",
    "NotCertifiedError",
    "NumericError",
    "OptionError",
    "OptionSpec",
    "OutOfMemoryError",
    "Patches",
    "PathResult",
    "PluginError",
    "Product",
    "Progress",
    "Result",
    "RoughContactError",
    "ShapeError",
    "Status",
    "Surface",
    "System",
    "analysis",
    "backends",
    "batch",
    "direct",
    "effective_options",
    "kernel_coefficients",
    "kernels",
    "library_file",
    "options",
    "path",
    "plot",
    "raw",
    "solve",
    "solvers",
    "supported",
    "surface",
    "version",
]
