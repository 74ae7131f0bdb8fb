"""Who uses a handle of the library, and when it may be destroyed."""

import threading
from contextlib import contextmanager
from typing import Any, Callable, Iterator, Optional

from ._errors import ArgumentError, BusyError


class OwnsHandle:
    """A copy would have the same handle, and both would destroy it."""

    def __reduce_ex__(self, _: Any) -> Any:
        raise TypeError(f"a {type(self).__name__} of roughcontact cannot be copied or pickled; make another one")


class Use:
    """A handle is in use by the call that was made, and by the thread that works for it (`interruptible`), which may
    outlive the call where a signal handler raises again and again. It is destroyed when neither uses it.

    A context manager over a call by the caller, which gives the handle. destroy: a weakref.finalize
    """

    def __init__(self, handle: Any, destroy: Any) -> None:
        self._handle = handle
        self._caller, self._worker = threading.Lock(), threading.Lock()
        self._alive = threading.RLock()  # a signal handler may ask while its own thread destroys
        self._destroy, self._closing = destroy, False
        self._answering: Optional[int] = None  # the thread on which a callback may ask about the call that made it

    def closed(self) -> bool:
        return self._closing or not self._destroy.alive

    def __enter__(self) -> Any:
        if not self._caller.acquire(False):
            raise BusyError(
                "the contact is in use by another thread, or by the call that this callback belongs to; make one contact "
                "per thread"
            )
        try:
            if self._worker.locked():
                raise BusyError("a call that was interrupted has not ended yet; wait a moment, or make another contact")
            if self.closed():
                raise ArgumentError("the contact is closed")
            return self._handle
        except BaseException:
            self.__exit__()
            raise

    def __exit__(self, *_: object) -> None:
        self._caller.release()
        self._close_if_free()

    @contextmanager
    def answering(self) -> Iterator[None]:
        """Over a callback of a call in progress, on the callback's thread: `by_caller_or_callback` is open to it."""
        self._answering = threading.get_ident()
        try:
            yield
        finally:
            self._answering = None

    @contextmanager
    def by_caller_or_callback(self) -> Iterator[Any]:
        if self._answering == threading.get_ident():
            yield self._handle
        else:
            with self as handle:
                yield handle

    def begin_work(self) -> bool:
        """Whether a thread may work with the handle; it then calls `end_work`."""
        return not self.closed() and self._worker.acquire(False)

    def end_work(self) -> None:
        self._worker.release()
        self._close_if_free()

    def close(self) -> None:
        """Destroys the handle, now or when its last user has ended."""
        self._closing = True
        self._close_if_free()

    def _close_if_free(self) -> None:
        """Where two try at the same time, both may fail: then it is destroyed with its object."""
        if self._closing and self._caller.acquire(False):
            try:
                if self._worker.acquire(False):
                    try:
                        with self._alive:
                            self._destroy()
                    finally:
                        self._worker.release()
            finally:
                self._caller.release()

    def while_alive(self, function: Callable[[], object]) -> None:
        with self._alive:
            if self._destroy.alive:
                function()
