"""Gradients, tangents and conductance against differences of answers."""

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc

SHAPE, OPTIONS = (10, 12), {"tol": 1e-12}


@pytest.fixture(params=["approach", "load"])
def pressed(request):
    """(system, undeformed gap, {control: target})"""
    rng = np.random.default_rng(3)
    gap = rng.random(SHAPE) + 0.05 * (np.arange(12) - 5.5) ** 2
    system = rc.HalfSpace(SHAPE, pitch=(1.0, 0.7), modulus=2.0, boundary="free")
    target = 1.5 if request.param == "approach" else 8.0
    return system, gap, request.param, target


def answer(system, gap, control, target):
    return rc.solve(undeformed_gap=gap, system=system, options=OPTIONS, want_gap=True, **{control: target})


def slopes(pressed, change, step=1e-5):
    system, gap, control, target = pressed
    ends = []
    for way in (-step, step):
        moved = rc.HalfSpace(SHAPE, pitch=system.pitch, boundary="free", modulus=system.modulus + way * change["modulus"])
        ends.append(answer(moved, gap + way * change["gap"], control, target + way * change["target"]))
    return {
        name: (getattr(ends[1], name) - getattr(ends[0], name)) / (2 * step) for name in ("pressure", "gap", "load", "approach")
    }


def test_gradient_and_tangent_are_differences(pressed):
    system, gap, control, target = pressed
    rng = np.random.default_rng(4)
    change = {"gap": rng.standard_normal(SHAPE), "target": 0.3, "modulus": -0.2}
    slope = slopes(pressed, change)
    by = {"pressure": rng.standard_normal(SHAPE), "gap": rng.standard_normal(SHAPE), "load": 0.5, "approach": -0.7}
    with rc.Contact(system, options=OPTIONS) as contact:
        contact.solve(undeformed_gap=gap, **{control: target})
        tangent = contact.tangent(change["gap"], target=change["target"], modulus=change["modulus"])
        gradient = contact.gradient(by["pressure"], by["gap"], load=by["load"], approach=by["approach"])
    for name, value in slope.items():
        np.testing.assert_allclose(getattr(tangent, name), value, rtol=1e-6, atol=1e-6 * np.abs(value).max())
    along = sum(np.sum(by[name] * slope[name]) for name in by)
    found = np.sum(gradient.gap * change["gap"]) + gradient.target * change["target"] + gradient.modulus * change["modulus"]
    assert found == pytest.approx(along, rel=1e-6)
    assert gradient.undecided == tangent.undecided == 0 and gradient.products > 0
    assert 0 <= gradient.error < 1e-8 * np.linalg.norm(gradient.gap)


def test_without_cotangents_it_is_of_load_or_approach(pressed):
    system, gap, control, target = pressed
    change = {"gap": np.random.default_rng(1).standard_normal(SHAPE), "target": 0.0, "modulus": 0.0}
    slope = slopes(pressed, change)["load" if control == "approach" else "approach"]
    with rc.Contact(system, options=OPTIONS) as contact:
        contact.solve(undeformed_gap=gap, **{control: target})
        assert np.sum(contact.gradient().gap * change["gap"]) == pytest.approx(slope, rel=1e-6)


def test_refusals(pressed):
    system, gap, control, target = pressed
    with rc.Contact(system, options=OPTIONS) as contact:
        refused(rc.ArgumentError, "only a certified step", contact.gradient)
        contact.solve(undeformed_gap=gap, **{control: target})
        refused(rc.ShapeError, "pressure has shape", contact.gradient, np.zeros((2, 2)))
        refused(rc.ArgumentError, "is not finite", contact.gradient, np.full(SHAPE, np.nan))
        refused(rc.ArgumentError, "is not finite", contact.tangent, target=np.inf)


def test_a_matrix_has_no_modulus(small_matrix):
    with rc.Contact(rc.Matrix(small_matrix, pitch=1.0)) as contact:
        result = contact.solve(undeformed_gap=np.linspace(0, 1, 12), approach=0.5)
        assert np.isnan(contact.gradient().modulus) and contact.gradient().target > 0
        refused(rc.ArgumentError, "modulus", contact.tangent, modulus=1.0)
    refused(rc.ArgumentError, "HalfSpace", result.conductance, 1.0, 1.0)


def test_conductance_and_its_interval(pressed):
    system, gap, control, target = pressed
    result = rc.solve(undeformed_gap=gap, system=system, options={"stiffness": 2}, **{control: target})
    found = result.conductance(1.0, 3.0)
    assert found.value == pytest.approx(2 / (2.0 * 4.0) * result.stiffness, rel=1e-15)
    assert found.lower <= found.value * (1 + 1e-9) and found.value <= found.upper * (1 + 1e-9)
    assert found.upper - found.lower < 0.01 * found.value
    refused(rc.ArgumentError, "rho1", result.conductance, -1.0, 1.0)
    refused(rc.ArgumentError, "stiffness", answer(system, gap, control, target).conductance, 1.0, 1.0)


def test_punch_on_given_points(pressed):
    system, gap, control, target = pressed
    result = rc.solve(undeformed_gap=gap, system=system, options={"stiffness": 1}, **{control: target})
    found = rc.analysis.punch_stiffness(system, result.pressure > 0, options=OPTIONS)
    assert found.value == pytest.approx(result.stiffness, rel=1e-7) and found.lower <= found.value <= found.upper
    nowhere = rc.analysis.punch_stiffness(system, np.zeros(SHAPE, bool))
    assert rc.analysis.punch_stiffness(system).value > found.value > nowhere.value == 0
    periodic = rc.HalfSpace(SHAPE, pitch=1.0, modulus=2.0, boundary="periodic")
    assert rc.analysis.punch_stiffness(periodic).value == np.inf
    refused(rc.ShapeError, "mask has shape", rc.analysis.punch_stiffness, system, np.ones((2, 2), bool))


def test_punch_of_an_own_product(small_matrix):
    exact = np.linalg.inv(small_matrix[:5, :5]).sum()
    mask = np.arange(12) < 5
    matrix, product = rc.Matrix(small_matrix, pitch=1.0), rc.Product(small_matrix.dot, 12, pitch=1.0)
    assert rc.analysis.punch_stiffness(matrix, mask).value == pytest.approx(exact, rel=1e-12)
    assert rc.analysis.punch_stiffness(product, mask).value == pytest.approx(exact, rel=1e-8)

    def fails(x):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        rc.analysis.punch_stiffness(rc.Product(fails, 12, pitch=1.0), mask)
