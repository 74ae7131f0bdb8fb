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
