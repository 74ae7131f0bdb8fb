"""Pressures that a hardness caps, and the plastic indentation that steps leave."""

import numpy as np
from conftest import refused

import roughcontact as rc

HOW = {"modulus": 1e9, "hardness": 2e7}


def test_solve_keeps_the_hardness(rough):
    soft = rc.solve(rough, **HOW, approach=1e-7, want_gap=True)
    stiff = rc.solve(rough, modulus=1e9, approach=1e-7)
    at_hardness = soft.pressure == HOW["hardness"]
    assert soft.certified and soft.pressure.max() == HOW["hardness"] < stiff.pressure.max() and soft.load < stiff.load
    assert soft.capped == at_hardness.sum() >= soft.proven_capped > 0 and stiff.capped == 0 == stiff.plastic_volume
    assert np.isclose(soft.plastic_volume, -soft.gap[at_hardness].sum() * 1e-12, rtol=1e-9)


def test_histories_keep_the_indentation(rough):
    system = rc.HalfSpace.under(rough, **HOW)
    targets = [6e-8, 1e-7, 5e-8, 1.1e-7]
    history = rc.history(rough, **HOW, approach=targets)
    assert np.array_equal(rc.batch([rough, rough], **HOW, approach=targets).load, [history.load] * 2)
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
    history = rc.history(rough, **HOW, approach=targets, virgin=True)
    alone = [rc.solve(rough, **HOW, approach=target).load for target in targets]
    assert np.allclose(history.load, alone, rtol=1e-6) and history.capped[1] > 0
    assert rc.history(rough, **HOW, approach=targets).load[2] < 0.99 * alone[2]
    assert np.array_equal(rc.batch([rough] * 2, **HOW, approach=targets, virgin=True).load, [history.load] * 2)
    with rc.Contact(rc.HalfSpace.under(rough, **HOW)) as contact:
        contact.history(rough, approach=targets, virgin=True)
        assert not contact.indentation().any()


def test_own_operators(small_matrix):
    gap, how = np.linspace(0, 1, 12), {"pitch": 1.0, "hardness": 0.1}
    matrix = rc.solve(undeformed_gap=gap, system=rc.Matrix(small_matrix, **how), approach=1)
    product = rc.solve(undeformed_gap=gap, system=rc.Product(small_matrix.dot, 12, **how), approach=1)
    assert matrix.pressure.max() == 0.1 and matrix.capped > 0 and np.allclose(matrix.pressure, product.pressure, rtol=1e-6)


def test_a_load_beyond_the_hardness_is_refused(rough):
    refused(rc.InfeasibleError, "hardness times the area", rc.solve, rough, **HOW, load=1)
