"""The exceptions that statuses become."""

from typing import Any, Dict, Optional, Type

from ._status import Status

_BY_STATUS: Dict[int, "Type[RoughContactError]"] = {}


class RoughContactError(Exception):
    """A call that failed, or with `NotCertifiedError` one that stopped early.

    status: the library's. result: what was complete before (a `Result`, `HistoryResult` or `BatchResult`), or None.
    """

    default_status = Status.ERR_INTERNAL

    def __init_subclass__(cls, status: Optional[Status] = None) -> None:
        if status is not None:
            cls.default_status = status
            _BY_STATUS[int(status)] = cls

    def __init__(self, message: str, status: Optional[Status] = None, result: Any = None) -> None:
        super().__init__(message)
        self.status = self.default_status if status is None else status
        self.result = result


class ArgumentError(RoughContactError, ValueError, status=Status.ERR_ARGUMENT):
    """A value that is not finite, out of range or missing."""


class ShapeError(RoughContactError, ValueError, status=Status.ERR_SHAPE):
    """Arrays whose shapes do not fit, or too many points."""


class OptionError(RoughContactError, ValueError, status=Status.ERR_OPTION):
    """An option's key, type or value that is not in the schema."""


class NoBackendError(RoughContactError, LookupError, status=Status.ERR_NO_BACKEND):
    """No backend of that name, or none that can do this."""


class NoSolverError(RoughContactError, LookupError, status=Status.ERR_NO_SOLVER):
    """No solver of that name."""


class IncompatibleError(RoughContactError, ValueError, status=Status.ERR_INCOMPATIBLE):
    """Solver, backend, kernel, boundary and control that do not go together."""


class PluginError(RoughContactError, status=Status.ERR_PLUGIN):
    """A plugin was found but is refused."""


class OutOfMemoryError(RoughContactError, MemoryError, status=Status.ERR_MEMORY):
    """Out of memory, or a request that cannot fit."""


class InfeasibleError(RoughContactError, ValueError, status=Status.ERR_INFEASIBLE):
    """The problem has no solution."""


class NumericError(RoughContactError, ArithmeticError, status=Status.ERR_NUMERIC):
    """The operator is not positive definite or returned values that are not finite."""


class ExternalError(RoughContactError, status=Status.ERR_EXTERNAL):
    """The caller's product reported failure. An exception that it raised is raised again instead."""


class BusyError(RoughContactError, status=Status.ERR_BUSY):
    """The contact is in use, by another thread or by the call that a callback belongs to."""


class InternalError(RoughContactError, status=Status.ERR_INTERNAL):
    """A defect in the library or a plugin."""


class NotCertifiedError(RoughContactError):
    """The call stopped before its answer was certified; `result` holds it all the same. check=False returns it instead."""

    default_status = Status.UNCERTIFIED


class LibraryNotFoundError(RoughContactError, ImportError):
    """A library that is needed cannot be loaded."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C during a call. result: what was complete before it, or None."""

    def __init__(self, result: Any = None) -> None:
        super().__init__()
        self.result = result


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
