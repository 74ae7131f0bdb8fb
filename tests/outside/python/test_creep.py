"""Bodies that creep."""

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc

TERMS = [(0.5, 1.0), (1.5, 20.0)]
HOW = {"modulus": 1e9, "creep": TERMS}


def compliance(time):
    return 1 + sum(ratio * (1 - np.exp(-time / tau)) for ratio, tau in TERMS)


def test_a_ball_spreads_as_the_compliance():
    x = (np.arange(96) + 0.5) / 24 - 2
    gap = (x[:, None] ** 2 + x**2) / 16
    times = np.array([0, 0.5, 2, 10, 100])
    history = rc.history(undeformed_gap=gap, pitch=1 / 24, boundary="free", modulus=1, creep=TERMS, load=[0.02] * 5, time=times)
    radius = np.sqrt(history.contact_area / np.pi)
    assert np.allclose(radius, np.cbrt(6 * 0.02 * compliance(times)), rtol=0.02)  # cells are counted
    assert np.array_equal(history.time, times) and "time" in history.to_dict()


def test_moduli_relax_the_load(rough):
    terms = [(0.4, 1.0), (0.3, 5.0)]
    times = np.linspace(0, 4, 65)
    load = rc.history(rough, modulus=1e9, relaxation=terms, approach=[1e-7] * 65, time=times).load
    modulus = 1 - sum(ratio * (1 - np.exp(-times / tau)) for ratio, tau in terms)
    assert np.allclose(load / load[0], modulus, atol=2e-4)


def test_steps_restart_and_batches_are_the_history(rough):
    targets, times = [6e-8, 1e-7, 1e-7, 5e-8], [1, 2, 30, 30]
    history = rc.history(rough, **HOW, approach=targets, time=times)
    assert np.array_equal(rc.batch([rough, rough], **HOW, approach=targets, time=times).load, [history.load] * 2)
    every = rc.batch([rough, rough], **HOW, approach=targets, time=[times, [1, 2, 40, 50]])
    assert np.array_equal(every.load[0], history.load) and np.all(every.load[1, 2:] != history.load[2:])
    system = rc.HalfSpace.under(rough, **HOW)
    assert "creeps" in repr(system)
    with rc.Contact(system, options={"resumable": 1}) as contact, rc.Contact(system, options={"resumable": 1}) as other:
        assert contact.creep()[1] is None and not contact.creep()[0].any()
        steps = [contact.solve(rough, approach=target, time=time) for target, time in zip(targets[:3], times)]
        left, time = contact.creep()
        assert left.shape == (3, *rough.shape) and time == 30
        last, before = ((step.pressure, step.approach, step.load) for step in (steps[2], steps[1]))
        other.restore(rough, last=last, before=before, creep=(left, time))
        end = contact.solve(approach=targets[3], time=times[3])
        assert np.array_equal(end.pressure, other.solve(approach=targets[3], time=times[3]).pressure)
        assert np.isclose(end.load, history.load[3], rtol=1e-7)
        assert contact.certify(end.pressure, approach=targets[3], time=30).certified
        refused(rc.ArgumentError, "rc_state.creep is null", other.restore, rough, last=last)
        refused(rc.ShapeError, r"creep\[0\] has shape", other.restore, rough, last=last, creep=(left[:2], time))
        refused(rc.ArgumentError, "time is missing", contact.solve, approach=1e-7)
        refused(rc.ArgumentError, "is before", contact.solve, approach=1e-7, time=29)
        contact.reset()
        assert contact.creep()[1] is None


def test_a_virgin_history_keeps_none(rough):
    with rc.Contact(rc.HalfSpace.under(rough, **HOW)) as contact:
        contact.history(rough, approach=[1e-7] * 2, time=[0, 1], virgin=True)
        assert contact.creep()[1] is None


def test_own_operators(small_matrix):
    gap, how = np.linspace(0, 1, 12), {"pitch": 1.0, "creep": TERMS}
    steps = {"approach": [1, 1, 0.7], "time": [0, 1, 3]}
    matrix = rc.history(undeformed_gap=gap, system=rc.Matrix(small_matrix, **how), **steps)
    product = rc.history(undeformed_gap=gap, system=rc.Product(small_matrix.dot, 12, **how), **steps)
    assert matrix.load[1] < matrix.load[0] and np.allclose(matrix.load, product.load, rtol=1e-6)


@pytest.mark.parametrize(
    "message, words",
    [
        ("time is missing", {}),
        (r"time has shape \(2,\)", {"time": [0, 1]}),
        (r"times\[1\] = 1", {"time": [2, 1, 3]}),
        (r"creep_ratio\[0\] = -1", {"time": [0, 1, 2], "creep": [(-1, 1)]}),
        (r"creep_time\[1\] = 0", {"time": [0, 1, 2], "creep": [(1, 1), (1, 0)]}),
        (r"creep has shape \(2,\)", {"time": [0, 1, 2], "creep": [1, 2]}),
        ("both given", {"time": [0, 1, 2], "relaxation": [(0.1, 1)]}),
    ],
)
def test_what_is_refused(rough, message, words):
    refused(rc.ArgumentError, message, rc.history, rough, **{**HOW, "approach": [1e-7] * 3, **words})


def test_what_has_no_time_is_refused(rough):
    system = rc.HalfSpace.under(rough, **HOW)
    refused(rc.ArgumentError, "creep and system", rc.history, rough, system=system, creep=TERMS, approach=[1e-7], time=[0])
    refused(rc.IncompatibleError, "creep_terms", rc.law, rough, system=system, pressure=(1e5, 1e6))
    with rc.Contact(system) as contact:
        answer = contact.solve(rough, approach=1e-7, time=0)
        refused(rc.IncompatibleError, "creep_terms", contact.gradient)
        refused(rc.ArgumentError, "homogeneous", answer.conductance, 1e-7, 1e-7)
