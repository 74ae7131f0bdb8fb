"""Ctrl-C during a call: it ends soon, what was done stays, and nothing is left running."""

import os
import signal
import threading
import time

import numpy as np
import pytest

import roughcontact as rc

LONG = {"modulus": 1.0, "options": {"solver": "gp", "tol": 1e-14, "max_iter": 10**9}}


@pytest.fixture
def large():
    return rc.surface.spectral((256, 256), hurst=0.8)


@pytest.fixture
def ctrl_c():
    """ctrl_c(seconds): as if pressed then, by a signal to the process."""
    timers = []
    before = signal.signal(signal.SIGINT, signal.default_int_handler)

    def press(after):
        timers.append(threading.Timer(after, os.kill, (os.getpid(), signal.SIGINT)))
        timers[-1].start()

    yield press
    for timer in timers:
        timer.join()
    signal.signal(signal.SIGINT, before)


def test_solve_ends_and_keeps_its_pressures(large, ctrl_c):
    ctrl_c(0.15)
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt) as caught:
        rc.solve(large, displacement=2.0, **LONG)
    assert time.monotonic() - start < 10
    assert isinstance(caught.value, rc.Interrupted)
    assert caught.value.result.status == rc.Status.STOP_CANCELLED and caught.value.result.pressure.max() > 0
    assert threading.active_count() <= 2  # the timer


def test_contact_can_be_used_afterwards(large, ctrl_c):
    with rc.Contact(rc.HalfSpace.under(large, modulus=1.0), options=LONG["options"]) as contact:
        ctrl_c(0.15)
        with pytest.raises(rc.Interrupted):
            contact.solve(large, displacement=2.0)
        contact.set_options({"tol": 1e-4, "solver": "auto"})
        assert contact.solve(displacement=1.0).certified


def test_path_keeps_its_steps(large, ctrl_c):
    ctrl_c(0.5)
    with pytest.raises(rc.Interrupted) as caught:
        rc.path(large, modulus=1.0, load=np.tile([1e3, 2e3], 5000))
    done = caught.value.result
    assert done.status == rc.Status.STOP_CANCELLED and 0 < done.completed < 10000
    assert np.all(np.isfinite(done.load)) and np.allclose(done.load, done.targets[: done.completed], rtol=1e-6)


def test_batch_keeps_its_contacts(ctrl_c):
    gaps = np.stack([rc.surface.spectral((64, 64), seed=k).gap() for k in range(4)])
    ctrl_c(0.4)
    with pytest.raises(rc.Interrupted) as caught:
        rc.batch(gap=gaps, pitch=1.0, modulus=1.0, displacement=np.tile([1.0, 2.0], 20000), options={"threads": 2})
    done = caught.value.result
    assert np.isfinite(done.load).sum() > 4 and (done.statuses == rc.Status.STOP_CANCELLED).sum() > 4


def test_products_in_python_end(ctrl_c):
    n = 400
    i = np.arange(n)
    H = 1.0 / (1.0 + np.abs(i[:, None] - i)) + np.eye(n)

    def slow(x):
        time.sleep(0.01)
        return H @ x

    ctrl_c(0.2)
    with pytest.raises(rc.Interrupted):
        rc.solve(gap=np.linspace(0, 1, n), displacement=0.9, system=rc.Product(slow, n), options=LONG["options"])


def test_handlers_of_the_caller_are_respected(large):
    """One that raises nothing does not end the call; what another raises arrives."""
    heard = []

    class Mine(Exception):
        pass

    def raising(*_):
        raise Mine

    before = signal.signal(signal.SIGINT, lambda *_: heard.append(1))
    try:
        timer = threading.Timer(0.05, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        limited = {**LONG, "options": {**LONG["options"], "time_limit": 0.4}}
        assert rc.solve(large, displacement=2.0, check=False, **limited).status == rc.Status.STOP_TIME
        timer.join()
        assert heard == [1]
        signal.signal(signal.SIGINT, raising)
        timer = threading.Timer(0.05, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with pytest.raises(Mine):
            rc.solve(large, displacement=2.0, **LONG)
        timer.join()
    finally:
        signal.signal(signal.SIGINT, before)


def test_pressing_it_often_does_no_harm(large, ctrl_c):
    for after in (0.1, 0.1005, 0.101, 0.102, 0.104, 0.3):
        ctrl_c(after)
    interrupted, deadline = 0, time.monotonic() + 0.6
    while time.monotonic() < deadline:
        try:
            rc.solve(large, displacement=2.0, check=False, modulus=1.0, options={**LONG["options"], "time_limit": 0.2})
        except KeyboardInterrupt:
            interrupted += 1
    assert interrupted >= 2
    assert rc.solve(large, displacement=1.0, modulus=1.0).certified
