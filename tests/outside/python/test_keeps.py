"""What bodies that yield and creep keep of earlier steps comes out of a contact, and goes into another one."""

import numpy as np
from conftest import refused

import roughcontact as rc

TERMS = [(0.5, 1.0), (1.5, 20.0)]
CREEPS = {"modulus": 1e9, "creep": TERMS}


def test_a_contact_goes_on_in_another(rough):
    targets, times = [6e-8, 1e-7, 1e-7, 9e-8], [1, 2, 30, 30]
    system = rc.HalfSpace.under(rough, **CREEPS, hardness=2e7)
    assert "creeps" in repr(system)
    with rc.Contact(system, options={"resumable": 1}) as contact, rc.Contact(system, options={"resumable": 1}) as other:
        assert contact.creep()[1] is None and not contact.creep()[0].any()
        steps = [contact.solve(rough, approach=target, time=time) for target, time in zip(targets[:3], times)]
        left, time = contact.creep()
        assert left.shape == (3, *rough.shape) and time == 30 and contact.indentation().max() > 0
        last, before = ((step.pressure, step.approach, step.load) for step in (steps[2], steps[1]))
        other.restore(rough, last=last, before=before, creep=(left, time), indentation=contact.indentation())
        assert np.array_equal(other.indentation(), contact.indentation())
        end = contact.solve(approach=targets[3], time=times[3])
        assert np.array_equal(end.pressure, other.solve(approach=targets[3], time=times[3]).pressure)
        refused(rc.ArgumentError, "rc_state.creep is null", other.restore, rough, last=last)
        refused(rc.ShapeError, r"creep\[0\] has shape", other.restore, rough, last=last, creep=(left[:2], time))
        refused(rc.ShapeError, r"before\[0\]", other.restore, rough, last=last, before=(left[0, 1:], 0.0, 0.0))
        contact.reset()
        assert contact.creep()[1] is None and not contact.indentation().any()
    history = rc.history(rough, **CREEPS, hardness=2e7, approach=targets, time=times)
    assert np.isclose(end.load, history.load[3], rtol=1e-7)
    every = rc.batch([rough, rough], **CREEPS, hardness=2e7, approach=targets, time=[times, [1, 2, 40, 50]])
    assert np.array_equal(every.load[0], history.load) and np.all(every.load[1, 2:] != history.load[2:])


def test_what_has_no_time_is_refused(rough):
    system = rc.HalfSpace.under(rough, **CREEPS)
    refused(
        rc.ArgumentError, r"creep has shape \(2,\)", rc.history, rough, modulus=1e9, creep=[1, 2], approach=[1e-7], time=[0]
    )
    refused(rc.ArgumentError, "creep and system", rc.history, rough, system=system, creep=TERMS, approach=[1e-7], time=[0])
    refused(rc.IncompatibleError, "creep_terms", rc.law, rough, system=system, pressure=(1e5, 1e6))
    with rc.Contact(system) as contact:
        answer = contact.solve(rough, approach=1e-7, time=0)
        refused(rc.ArgumentError, "time is missing", contact.solve, approach=1e-7)
        refused(rc.IncompatibleError, "creep_terms", contact.gradient)
        refused(rc.ArgumentError, "homogeneous", answer.conductance, 1e-7, 1e-7)
