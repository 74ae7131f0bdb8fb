"""What bodies that yield or creep keep of earlier steps: in steps, histories, batches and restarts."""

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc

HARD = {"modulus": 1e9, "hardness": 2e7}


def test_histories_keep_the_indentation(rough):
    system = rc.HalfSpace.under(rough, **HARD)
    targets = [6e-8, 1e-7, 5e-8, 1.1e-7]
    history = rc.history(rough, **HARD, approach=targets)
    assert np.array_equal(rc.batch([rough, rough], **HARD, approach=targets).load, [history.load] * 2)
    with rc.Contact(system, options={"resumable": 1}) as contact, rc.Contact(system, options={"resumable": 1}) as other:
        steps = [contact.solve(rough, approach=target) for target in targets[:3]]
        assert steps[1].capped > 0 == steps[2].capped and contact.indentation().max() > 0
        last, before = ((step.pressure, step.approach, step.load) for step in (steps[2], steps[1]))
        other.restore(rough, last=last, before=before, indentation=contact.indentation())
        assert np.array_equal(other.indentation(), contact.indentation())
        end = contact.solve(approach=targets[3])
        assert np.array_equal(end.pressure, other.solve(approach=targets[3]).pressure)
        assert np.isclose(end.load, history.load[3], rtol=1e-7)
        contact.reset()
        assert not contact.indentation().any()


def test_a_virgin_history_keeps_none(rough):
    targets = [6e-8, 1.1e-7, 5e-8]
    history = rc.history(rough, **HARD, approach=targets, virgin=True)
    alone = [rc.solve(rough, **HARD, approach=target).load for target in targets]
    assert np.allclose(history.load, alone, rtol=1e-6) and history.capped[1] > 0
    assert rc.history(rough, **HARD, approach=targets).load[2] < 0.99 * alone[2]
    assert np.array_equal(rc.batch([rough] * 2, **HARD, approach=targets, virgin=True).load, [history.load] * 2)
    with rc.Contact(rc.HalfSpace.under(rough, **HARD)) as contact:
        contact.history(rough, approach=targets, virgin=True)
        assert not contact.indentation().any()


TERMS = [(0.5, 1.0), (1.5, 20.0)]
CREEPS = {"modulus": 1e9, "creep": TERMS}


def test_steps_restart_and_batches_are_the_history(rough):
    targets, times = [6e-8, 1e-7, 1e-7, 5e-8], [1, 2, 30, 30]
    history = rc.history(rough, **CREEPS, approach=targets, time=times)
    assert np.array_equal(rc.batch([rough, rough], **CREEPS, approach=targets, time=times).load, [history.load] * 2)
    every = rc.batch([rough, rough], **CREEPS, approach=targets, time=[times, [1, 2, 40, 50]])
    assert np.array_equal(every.load[0], history.load) and np.all(every.load[1, 2:] != history.load[2:])
    system = rc.HalfSpace.under(rough, **CREEPS)
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


@pytest.mark.parametrize(
    "message, words",
    [
        ("time is missing", {}),
        ("time has 2 values, approach 3", {"time": [0, 1]}),
        ("step 2 is at 1, before step 1 at 2", {"time": [2, 1, 3]}),
        ("the ratio -1 is negative", {"time": [0, 1, 2], "creep": [(-1, 1)]}),
        ("the time 0 is not positive", {"time": [0, 1, 2], "creep": [(1, 1), (1, 0)]}),
        (r"creep has shape \(2,\)", {"time": [0, 1, 2], "creep": [1, 2]}),
        ("give either creep or relaxation", {"time": [0, 1, 2], "relaxation": [(0.1, 1)]}),
    ],
)
def test_what_is_refused_of_creep(rough, message, words):
    refused(rc.ArgumentError, message, rc.history, rough, **{**CREEPS, "approach": [1e-7] * 3, **words})


def test_what_has_no_time_is_refused(rough):
    system = rc.HalfSpace.under(rough, **CREEPS)
    refused(rc.ArgumentError, "creep and system", rc.history, rough, system=system, creep=TERMS, approach=[1e-7], time=[0])
    refused(rc.IncompatibleError, "creep_terms", rc.law, rough, system=system, pressure=(1e5, 1e6))
    with rc.Contact(system) as contact:
        answer = contact.solve(rough, approach=1e-7, time=0)
        refused(rc.IncompatibleError, "creep_terms", contact.gradient)
        refused(rc.ArgumentError, "homogeneous", answer.conductance, 1e-7, 1e-7)
