"""Products with the influence matrix."""

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc


@pytest.fixture(name="system")
def _system():
    return rc.HalfSpace((20, 33), pitch=(1e-6, 2e-6), modulus=1e11, boundary="free")


def test_deflections_are_those_of_a_contact(system):
    gap = np.hypot(*np.mgrid[-10:10, -16:17]) * 1e-8
    result = rc.solve(undeformed_gap=gap, system=system, approach=5e-8, want_gap=True)
    H = rc.Influence(system)
    u = H @ result.pressure
    assert np.allclose(u, result.gap - gap + result.approach, atol=1e-9 * u.max())
    assert np.array_equal(H @ -result.pressure, -u)


def test_every_memory_order_and_shape(system):
    p = np.random.default_rng(1).normal(size=system.shape)
    H = rc.Influence(system)
    u = H @ p
    assert np.array_equal(H @ np.asfortranarray(p), u) and (H @ np.asfortranarray(p)).flags.f_contiguous
    wide = np.zeros((40, 66))
    wide[::-2, ::2] = p
    assert np.array_equal(H @ wide[::-2, ::2], u)
    assert np.array_equal(H @ p.ravel(), u.ravel()) and np.array_equal(H @ p.tolist(), u)
    assert H.shape == (660, 660)


def test_bad_pressures_are_refused(system):
    H = rc.Influence(system)
    refused(rc.ShapeError, "p has shape", H.matvec, np.zeros((33, 20)))
    refused(rc.ArgumentError, "is not finite", H.matvec, np.full(system.shape, np.nan))
    refused(rc.OptionError, "tolerance", rc.Influence, system, options={"tolerance": 1})


def test_exceptions_of_a_product(small_matrix):
    def apply(x):
        if np.any(x < -1):
            raise LookupError("too low")
        return (small_matrix @ x.ravel()).reshape(x.shape)

    H = rc.Influence(rc.Product(apply, (12,), pitch=1.0))
    p = np.linspace(-1, 1, 12)
    assert np.allclose(H @ p, small_matrix @ p)
    with pytest.raises(LookupError):
        H.matvec(p - 1)
