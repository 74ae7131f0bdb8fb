"""The exceptions that statuses become."""

from typing import Any, Dict, Optional, Type

from ._status import Status


class RoughContactError(Exception):
    """A call that failed, or with `NotCertifiedError` one that stopped early.

    status: the library's. result: what was finished before (a `Result`, `PathResult` or `BatchResult`), or None.
    """

    default_status = Status.ERR_INTERNAL

    def __init__(self, message: str, status: Optional[Status] = None, result: Any = None) -> None:
        super().__init__(message)
        self.status = self.default_status if status is None else status
        self.result = result


class ArgumentError(RoughContactError, ValueError):
    """A value that is not finite, out of range or missing."""

    default_status = Status.ERR_ARGUMENT


class ShapeError(RoughContactError, ValueError):
    """Arrays whose shapes do not fit, or too many points."""

    default_status = Status.ERR_SHAPE


class OptionError(RoughContactError, ValueError):
    """An option's key, type or value that is not in the schema."""

    default_status = Status.ERR_OPTION


class NoBackendError(RoughContactError, LookupError):
    """No backend of that name, or none that can do this."""

    default_status = Status.ERR_NO_BACKEND


class NoSolverError(RoughContactError, LookupError):
    """No solver of that name."""

    default_status = Status.ERR_NO_SOLVER


class IncompatibleError(RoughContactError, ValueError):
    """Solver, backend, kernel, boundary and control that do not go together."""

    default_status = Status.ERR_INCOMPATIBLE


class PluginError(RoughContactError):
    """A plugin was found but is refused."""

    default_status = Status.ERR_PLUGIN


class OutOfMemoryError(RoughContactError, MemoryError):
    """Out of memory, or a request that cannot fit."""

    default_status = Status.ERR_MEMORY


class InfeasibleError(RoughContactError, ValueError):
    """The problem has no solution."""

    default_status = Status.ERR_INFEASIBLE


class NumericError(RoughContactError, ArithmeticError):
    """The operator is not positive definite or returned values that are not finite."""

    default_status = Status.ERR_NUMERIC


class ExternalError(RoughContactError):
    """The caller's product reported failure. An exception that it raised is raised again instead."""

    default_status = Status.ERR_EXTERNAL


class BusyError(RoughContactError):
    """The contact is in use, by another thread or by the call that a callback belongs to."""

    default_status = Status.ERR_BUSY


class InternalError(RoughContactError):
    """A defect in the library or a plugin."""


class NotCertifiedError(RoughContactError):
    """The call stopped before its answer was certified; `result` holds it all the same. check=False returns it instead."""

    default_status = Status.UNCERTIFIED


class LibraryNotFoundError(RoughContactError, ImportError):
    """libroughcontact or libroughcontact-surface cannot be loaded."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C during a call. result: what was finished before it, or None."""

    def __init__(self, result: Any = None) -> None:
        super().__init__()
        self.result = result


_BY_STATUS: Dict[int, Type[RoughContactError]] = {
    int(kind.default_status): kind for kind in RoughContactError.__subclasses__() if "default_status" in vars(kind)
}


def as_status(number: int) -> Status:
    try:
        return Status(number)
    except ValueError:
        return Status.ERR_INTERNAL if number < 0 else Status.UNCERTIFIED


def error_for(number: int, message: str, result: Any = None) -> RoughContactError:
    """The exception for a status that is not OK."""
    status = as_status(number)
    if status > 0:
        return NotCertifiedError(message, status, result)
    return _BY_STATUS.get(number, InternalError)(message, status, result)
