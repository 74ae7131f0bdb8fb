"""Ctrl-C during a call: it ends soon, what was done stays, and nothing is left running."""

import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc
from roughcontact import _calls
from roughcontact._calls import _wait

FREE = {"modulus": 1.0, "boundary": "free"}
LONG = {"modulus": 1.0, "options": {"solver": "gp", "tol": 1e-14, "max_iter": 10**9}}


@pytest.fixture
def large():
    return rc.surface.spectral((256, 256), hurst=0.8)


def press():
    """Ctrl-C, as it comes from a terminal."""
    os.kill(os.getpid(), signal.SIGINT)


@pytest.fixture(autouse=True)
def handler():
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def press_at(iteration):
    return lambda progress: press() if progress.iteration == iteration else None


def test_solve_ends_and_keeps_its_pressures(large):
    start, others = time.monotonic(), threading.active_count()
    caught = refused(KeyboardInterrupt, "", rc.solve, large, approach=2.0, progress=press_at(5), **LONG)
    assert time.monotonic() - start < 60
    assert isinstance(caught, rc.Interrupted)
    assert caught.result.status == rc.Status.STOP_CANCELLED and caught.result.pressure.max() > 0
    while threading.active_count() > others and time.monotonic() - start < 60:
        time.sleep(0.001)  # the thread that solved has said so and is about to end
    assert threading.active_count() == others


def test_it_ends_one_call_only(half_space, sphere_gap):
    """However late in the call, or just after it, the handler raises."""
    with rc.Contact(half_space) as contact:
        begun = time.monotonic()
        contact.solve(undeformed_gap=sphere_gap, approach=3e-7)
        length = time.monotonic() - begun
        before = signal.signal(signal.SIGALRM, signal.default_int_handler)
        for share in np.linspace(0.1, 1.5, 12):
            try:
                signal.setitimer(signal.ITIMER_REAL, share * length)
                contact.solve(undeformed_gap=sphere_gap, approach=3e-7, warm_start=False)
                while True:
                    time.sleep(1)
            except KeyboardInterrupt:
                pass
            assert contact.solve(approach=2e-7, warm_start=False).certified
        signal.signal(signal.SIGALRM, before)


def test_histories_and_batches_keep_what_was_done(large):
    targets = np.tile([1e3, 2e3], 5000)
    ended = refused(rc.Interrupted, "", rc.history, large, **FREE, load=targets, each=lambda k, _: press() if k == 2 else None)
    done = ended.result
    assert done.status == rc.Status.STOP_CANCELLED and 3 <= done.completed < 10000
    assert np.all(np.isfinite(done.load)) and np.allclose(done.load, done.targets[: done.completed], rtol=1e-6)
    gaps = np.stack([rc.surface.spectral((64, 64), seed=k).undeformed_gap() for k in range(4)])
    how = {**FREE, "undeformed_gap": gaps, "pitch": 1.0, "approach": np.tile([1.0, 2.0], 20000), "options": {"threads": 2}}
    done = refused(rc.Interrupted, "", rc.batch, **how, each=lambda i, k, _: press() if (i, k) == (0, 2) else None).result
    assert (done.statuses == rc.Status.STOP_CANCELLED).sum() > 4
    assert np.all(np.isfinite(done.load[done.statuses == rc.Status.OK]))


def test_a_handler_that_raises_nothing_does_not_end_the_call(large):
    """What another raises arrives: test_guest.py."""
    heard = []
    signal.signal(signal.SIGINT, lambda *_: heard.append(1))
    ended = rc.solve(large, approach=2.0, check=False, progress=press_at(3), **LONG)
    assert ended.status != rc.Status.STOP_CANCELLED and heard == [1]


def test_a_handler_that_raises_when_the_call_has_ended_is_not_waited_for():
    done = threading.Lock()
    done.acquire()
    _wait([0], done, lambda: pytest.fail("cancelled what had ended"))


def escape(monkeypatch):
    """Handlers raise at a place where nothing can hold the exception: the call is left while its thread still works."""

    def leave(found, done, stop):
        raise KeyboardInterrupt

    monkeypatch.setattr("roughcontact._calls._wait", leave)


def workers():
    """Threads that work for a call."""
    return [thread for thread in threading.enumerate() if thread.name == "roughcontact" and thread not in _calls.free]


def wait_for_workers():
    deadline = time.monotonic() + 60
    while workers() and time.monotonic() < deadline:
        time.sleep(0.01)
    assert not workers()


def test_a_call_that_is_left_too_early_keeps_what_it_uses(large, monkeypatch):
    begun, leave = threading.Event(), threading.Event()

    def progress(at):
        if at.iteration == 2:
            press()
            begun.set()
            leave.wait(60)

    contact = rc.Contact(rc.HalfSpace.under(large, modulus=1.0), options={**LONG["options"], "max_iter": 20}, progress=progress)
    escape(monkeypatch)
    refused(KeyboardInterrupt, "", contact.solve, large, approach=2.0)
    assert begun.wait(60) and len(workers()) == 1
    for call in (lambda: contact.solve(approach=1.0), contact.points, contact.close):
        refused(rc.BusyError, "", call)
    with pytest.raises(ZeroDivisionError):
        with contact:
            raise ZeroDivisionError
    assert contact._close.alive  # not destroyed below the thread that works
    leave.set()
    wait_for_workers()
    assert not contact._close.alive
    refused(rc.ArgumentError, "closed", contact.points)


@pytest.mark.parametrize("kind", ["solve", "path", "batch", "certify"])
def test_calls_that_are_left_too_early_end_by_themselves(large, monkeypatch, kind):
    inside = []

    def product(x):
        inside.append(1)
        if len(inside) == 4:
            press()
            time.sleep(0.05)
        return 2.0 * x

    escape(monkeypatch)
    gap, how = np.linspace(0, 1, 1000), {"approach": 0.9, "system": rc.Product(product, 1000, pitch=1)}
    calls = {
        "solve": lambda: rc.solve(undeformed_gap=gap.copy(), options=LONG["options"], **how),
        "path": lambda: rc.history(undeformed_gap=gap.copy(), **{**how, "approach": [0.5, 0.7, 0.9] * 9}),
        "batch": lambda: rc.batch(undeformed_gap=np.tile(gap, (9, 1)), **how),
        "certify": lambda: [
            rc.Contact(how["system"]).certify(gap, undeformed_gap=gap, approach=0.9, check=False) for _ in range(9)
        ],
    }
    refused(KeyboardInterrupt, "", calls[kind])
    monkeypatch.undo()
    wait_for_workers()
    assert rc.solve(large, approach=1.0, modulus=1.0, boundary="free").certified


def test_two_signals_at_the_same_time():
    """In a Python of its own: what handlers raise may arrive anywhere. The callback waits for them, so none is late."""
    code = """
import os, signal, threading, time, roughcontact as rc
from roughcontact import _calls
heard = []
def term(number, _):
    heard.append(number)
    raise SystemExit(3) if number == signal.SIGTERM else KeyboardInterrupt
signal.signal(signal.SIGINT, term)
signal.signal(signal.SIGTERM, term)
large = rc.surface.spectral((128, 128))
def both(progress):
    if progress.iteration > 3 and not heard:
        os.kill(os.getpid(), signal.SIGINT)
        os.kill(os.getpid(), signal.SIGTERM)
        while len(heard) < 2:
            time.sleep(0.001)
for _ in range(10):
    heard.clear()
    try:
        rc.solve(large, approach=2.0, modulus=1.0, boundary="free", progress=both, options={"solver": "gp", "tol": 1e-14, "max_iter": 10**9})
    except (KeyboardInterrupt, SystemExit):
        assert len(heard) == 2
    while [thread for thread in threading.enumerate() if thread.name == "roughcontact" and thread not in _calls.free]:
        time.sleep(0.01)
assert rc.solve(large, approach=1.0, modulus=1.0, boundary="free").certified
print("sound")
"""
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=300)
    assert ran.stdout == "sound\n" and ran.returncode == 0, ran.stderr


def test_a_handler_may_cancel_while_its_thread_closes(half_space, sphere_gap):
    contact = rc.Contact(half_space)
    with contact._use._alive:  # as in close()
        contact.cancel()
    contact.close()


def test_a_kept_thread_has_no_flag_of_an_earlier_call():
    """Which another library, called on it later, would look at."""
    flags = []
    library = _calls.Library(flags.append, lambda: "")
    assert _calls.interruptible(lambda: 0, of=lambda: library) == (0, "", None)
    assert len(flags) == 2 and flags[0] is not None and flags[1] is None
