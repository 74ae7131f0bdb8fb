"""Calls of the library: statuses into exceptions, callbacks whose exceptions arrive, Ctrl-C that arrives during a long call."""

import signal
import threading
from typing import Any, Callable, List, Optional, Tuple

from ._errors import error_for
from ._library import contact_library, surface_library


def check(status: int) -> None:
    """Raises what the last call of this thread returned, if it failed."""
    if status < 0:
        raise error_for(status, contact_library().rc_last_error().decode(errors="replace"))


def check_surface(status: int) -> None:
    """The same for libroughcontact-surface."""
    if status < 0:
        raise error_for(status, surface_library().rc_surface_last_error().decode(errors="replace"))


class Callbacks:
    """Python functions called from C: the first exception is kept until the call is over, and ends it."""

    def __init__(self) -> None:
        self._raised: List[BaseException] = []
        self.kept: Any = None  # what C calls, as long as this lives

    def guarded(self, function: Callable[..., Any]) -> Callable[..., int]:
        """function, returning 1 where it raised and 0 where what it returned is false."""

        def call(*arguments: Any) -> int:
            try:
                return 1 if function(*arguments) else 0
            except BaseException as error:  # nothing may pass through C
                self._raised.append(error)
                return 1

        return call

    def raise_first(self) -> None:
        if self._raised:
            first = self._raised[0]
            self._raised.clear()
            raise first


def _takes_ctrl_c() -> bool:
    return threading.current_thread() is threading.main_thread() and callable(signal.getsignal(signal.SIGINT))


def interruptible(call: Callable[[], int], cancel: Callable[[], None]) -> Tuple[int, str, Optional[BaseException]]:
    """(status, message, interrupt) of call().

    On the main thread call() runs on a thread of its own: Python delivers signals to the main thread only, which waits here. What
    a signal handler raises, KeyboardInterrupt as a rule, cancels the call and is returned when that has ended: the call's arrays
    and handles are in use until then.
    """
    found: List[Any] = []

    def with_message() -> None:
        status = call()
        found.append((status, contact_library().rc_last_error().decode(errors="replace") if status else ""))

    if not _takes_ctrl_c():
        with_message()
        return (*found[0], None)

    ticket, done = threading.Lock(), threading.Lock()  # the ticket is for whoever decides first whether the call takes place
    done.acquire()

    def body() -> None:
        if not ticket.acquire(False):
            return
        try:
            with_message()
        except BaseException as error:
            found.append(error)
        finally:
            done.release()

    interrupt: Optional[BaseException] = None
    try:
        threading.Thread(target=body, name="roughcontact", daemon=True).start()
        done.acquire()
    except BaseException as error:  # from a signal handler, or the system refused a thread
        if ticket.acquire(False):
            raise
        interrupt = error
        _wait(found, done, cancel)
    if isinstance(found[0], BaseException):
        raise found[0]
    return (*found[0], interrupt)


def _wait(found: List[Any], done: Any, cancel: Callable[[], None]) -> None:
    """However often Ctrl-C is pressed. A handler may also raise just after `done` was taken, which nobody gives back."""
    while not found:
        try:
            cancel()
            done.acquire()
        except BaseException:
            continue
