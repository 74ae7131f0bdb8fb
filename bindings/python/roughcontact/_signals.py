"""Signals on the threads that this package starts: blocked, as on the library's own threads, but not in callbacks."""

import ctypes
import signal
import threading
from typing import Any, Optional

_RAISED_BY_INSTRUCTIONS = ("SIGSEGV", "SIGBUS", "SIGFPE", "SIGILL", "SIGABRT", "SIGTRAP", "SIGSYS", "SIGPROF")


class _Set(ctypes.Structure):
    """At least as large as the system's set of signals."""

    _fields_ = [("bits", ctypes.c_uint64 * 16)]


_local = threading.local()  # before: what the thread that made the call blocks
_all = _Set()
_mask: Any = None  # pthread_sigmask, of which module signal's form takes a hundred times as long
if hasattr(signal, "pthread_sigmask"):
    _c = ctypes.PyDLL(None)
    _mask = _c.pthread_sigmask
    _c.sigfillset(ctypes.byref(_all))
    for _name in _RAISED_BY_INSTRUCTIONS:
        _c.sigdelset(ctypes.byref(_all), int(getattr(signal, _name)))

    _replace, _add = int(signal.SIG_SETMASK), int(signal.SIG_BLOCK)


def _set(blocked: _Set) -> None:
    _mask(_replace, ctypes.byref(blocked), None)


def blocked() -> Optional[_Set]:
    """What this thread blocks; None where signals cannot be blocked."""
    if _mask is None:
        return None
    now = _Set()
    _mask(_add, None, ctypes.byref(now))
    return now


def block(caller: Optional[_Set]) -> None:
    """All signals on this thread, from here on. caller: what the thread that made the call blocks."""
    if caller is not None:
        if not hasattr(_local, "before"):
            _set(_all)
        _local.before = caller


class AsCaller:
    """The time of a callback: a process that it starts blocks what the caller's thread does."""

    def __enter__(self) -> None:
        if hasattr(_local, "before"):
            _set(_local.before)

    def __exit__(self, *_: object) -> None:
        if hasattr(_local, "before"):
            _set(_all)
