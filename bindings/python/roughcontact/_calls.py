"""Calls of the library: statuses into exceptions, callbacks whose exceptions arrive, Ctrl-C that arrives during a long call."""

import ctypes
import functools
import os
import threading
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Tuple, TypeVar, cast

from ._errors import BusyError, Interrupted, error_for
from ._library import contact_library, flow_library, formats_library, surface_library
from ._signals import AsCaller, block, blocked
from ._status import Status
from ._use import Use


def last_message() -> str:
    """The message of the last call of this thread."""
    return str(contact_library().rc_last_error().decode(errors="replace"))


def check(status: int, message: Callable[[], str] = last_message) -> None:
    """Raises what the last call of this thread returned, if it failed."""
    if status < 0:
        raise error_for(status, message())


def check_formats(status: int) -> None:
    """The same for libroughcontact-formats."""
    check(status, lambda: str(formats_library().rc_surface_read_last_error().decode(errors="replace")))


class Library(NamedTuple):
    """How the calls of a library are ended, and what its last one said."""

    stop_when: Callable[[Any], None]
    last_message: Callable[[], str]


@functools.lru_cache(maxsize=None)
def contact_calls() -> Library:
    return Library(contact_library().rc_stop_when, last_message)


@functools.lru_cache(maxsize=None)
def surface_calls() -> Library:
    library = surface_library()
    return Library(library.rc_surface_stop_when, lambda: str(library.rc_surface_last_error().decode(errors="replace")))


@functools.lru_cache(maxsize=None)
def flow_calls() -> Library:
    library = flow_library()
    return Library(library.rc_flow_stop_when, lambda: str(library.rc_flow_last_error().decode(errors="replace")))


F = TypeVar("F", bound=Callable[..., Any])


def of_a_file(error: OSError) -> OSError:
    """error, marked as that of a file that a caller named."""
    error.of_a_file = True  # type: ignore[attr-defined]
    return error


def short_traceback(function: F) -> F:
    """function, whose traceback does not lead through the package if a file that was named cannot be opened."""

    @functools.wraps(function)
    def call(*arguments: Any, **keywords: Any) -> Any:
        try:
            return function(*arguments, **keywords)
        except OSError as error:
            if not getattr(error, "of_a_file", False):
                raise
            raise error.with_traceback(None) from None

    return cast(F, call)


class Callbacks:
    """Python functions called from C: the first exception is kept until the call is over, and ends it."""

    def __init__(self) -> None:
        self._raised: List[BaseException] = []
        self.kept: Any = None  # what C calls, as long as this lives

    def guarded(self, function: Callable[..., Any]) -> Callable[..., int]:
        """function, returning 1 where it raised and 0 where what it returned is false."""

        def call(*arguments: Any) -> int:
            try:
                with AsCaller():
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


def conclude(
    status: int, message: str, interrupt: Optional[BaseException], answer: Any, must_be_certified: bool, *called: Callbacks
) -> None:
    """Raises what there is to be raised after a call that used these callbacks."""
    for each in called:
        each.raise_first()
    if isinstance(interrupt, KeyboardInterrupt):
        raise Interrupted(answer) from interrupt
    if interrupt is not None:
        raise interrupt
    if status < 0 or must_be_certified and status not in (Status.OK, Status.WITHIN_GOAL):
        raise error_for(status, message, answer)


def _refused(error: BaseException) -> bool:
    """Whether the system or the interpreter gave no second thread; not what a signal handler raised meanwhile."""
    at = error.__traceback__
    while at is not None and at.tb_next is not None:
        at = at.tb_next
    raised_by = at.tb_frame.f_globals.get("__name__") if at is not None else None
    says_so = "new thread" in str(error) or raised_by in (__name__, threading.__name__)
    return isinstance(error, RuntimeError) and error.__context__ is None and says_so


class Worker(threading.Thread):
    """A thread for one call after the other, because starting one takes as long as a small contact."""

    def __init__(self) -> None:
        super().__init__(name="roughcontact", daemon=True)
        self._work = threading.Lock()
        self._work.acquire()
        self._given: Optional[Callable[["Worker"], None]] = None
        self.start()

    def run(self) -> None:
        while True:
            self._work.acquire()
            work, self._given = self._given, None
            assert work is not None
            work(self)
            del work

    def give(self, work: Callable[["Worker"], None]) -> None:
        """work: ends with this worker among those that are free."""
        self._given = work
        self._work.release()


free: List[Worker] = []
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=free.clear)


def interruptible(
    call: Callable[[], int], use: Optional[Use] = None, keep: Any = None, of: Callable[[], Library] = contact_calls
) -> Tuple[int, str, Optional[BaseException]]:
    """(status, message, interrupt) of call(), which makes calls of one library.

    On the main thread call() runs on a thread of its own: Python delivers signals to the main thread only, which waits here.
    What a signal handler raises, KeyboardInterrupt as a rule, ends the call and is returned when that has ended. Without a
    second thread the call runs on this one, and handlers run when it has ended. Threads are kept for later calls.

    A handler may raise at any place, so it can get out of this function before the call has ended. The thread therefore holds
    all that the call uses: call itself, keep (what call knows by its address alone), and the use of a handle.
    """
    found: List[Any] = []
    library = of()

    def with_message() -> Tuple[int, str]:
        status = call()
        return status, library.last_message() if status else ""

    if threading.current_thread() is not threading.main_thread():
        return (*with_message(), None)

    flag = ctypes.c_int32(0)
    ticket: Dict[str, str] = {}  # who decided first whether the call takes place
    done = threading.Lock()
    done.acquire()

    caller = blocked()

    def body(worker: Worker, _: Any = keep) -> None:
        block(caller)
        working = use is None or use.begin_work()
        answer: Any = None
        try:
            if ticket.setdefault("by", "worker") == "worker":
                library.stop_when(flag)
                answer = with_message() if working else BusyError("the contact is in use by a call that was interrupted")
        except BaseException as error:
            answer = error
        finally:
            if use is not None and working:
                use.end_work()
            library.stop_when(None)  # the flag goes with this call, the thread does not
            free.append(worker)
            if answer is not None:
                found.append(answer)
                done.release()

    interrupt: Optional[BaseException] = None

    def stop() -> None:
        if ticket.setdefault("by", "caller") == "caller":
            found.append(interrupt)
        else:
            flag.value = 1

    try:
        (free.pop() if free else Worker()).give(body)
        while not done.acquire(timeout=0.1):
            pass  # a signal that the system gave to another thread does not wake this one
    except BaseException as error:  # from a signal handler, or there is no second thread
        if _refused(error) and ticket.setdefault("by", "caller") == "caller":
            return (*with_message(), None)
        interrupt = error
        try:  # a second handler raises where the next function begins
            _wait(found, done, stop)
        except BaseException:
            _wait(found, done, stop)
        while type(interrupt) is RuntimeError and interrupt.__cause__ is None and interrupt.__context__ is not None:
            interrupt = interrupt.__context__  # where two handlers raise, Thread.start() complains about its own lock
    if isinstance(found[0], BaseException):
        raise found[0]
    return (*found[0], interrupt)


def finish(call: Callable[[], int], *called: Callbacks, keep: Any = None, of: Callable[[], Library] = contact_calls) -> None:
    """Runs a call that has no answer unless it succeeds."""
    conclude(*interruptible(call, keep=keep, of=of), None, True, *called)


def _wait(found: List[Any], done: Any, stop: Callable[[], None]) -> None:
    """However often Ctrl-C is pressed. A handler may also raise just after `done` was taken, which nobody gives back, or
    between two turns of a loop: hence the outer one."""
    while not found:
        try:
            while not found:
                try:
                    stop()
                    if not found:
                        done.acquire()
                except BaseException:
                    continue
        except BaseException:
            continue
