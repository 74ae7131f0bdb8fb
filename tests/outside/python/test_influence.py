"""Products with the influence matrix."""

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc


@pytest.fixture(name="system")
def _system():
    return rc.HalfSpace((20, 33), pitch=(1e-6, 2e-6), modulus=1e11, boundary="free")


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


def test_columns_and_the_transpose(system):
    H, n = rc.Influence(system), 660
    X = np.random.default_rng(2).normal(size=(n, 3))
    U = np.stack([H @ x for x in X.T], 1)
    assert np.array_equal(H @ X, U) and np.array_equal(H.matmat(np.asfortranarray(X)), U) and np.array_equal(H.T @ X, U)
    assert np.array_equal(H @ X[:, :1], U[:, :1]) and np.array_equal(H.rmatvec(X[:, 0]), U[:, 0])
    assert np.array_equal(H.H.rmatmat(X[::, ::-1]), U[:, ::-1]) and (H @ X[:, :0]).shape == (n, 0) and H.dtype == np.float64
    refused(rc.ShapeError, "p has shape", H.matvec, np.zeros((3, n)))
    row = rc.Influence(rc.HalfSpace((9,), pitch=(1.0, 2.0), modulus=1.0, boundary="periodic"))
    assert np.array_equal(row @ np.eye(9)[:, :4], np.stack([row @ e for e in np.eye(9)[:4]], 1))


@pytest.mark.parametrize("boundary", ["free", "periodic"])
def test_scipy_solves_with_it(boundary):
    sla = pytest.importorskip("scipy.sparse.linalg")
    H = rc.Influence(rc.HalfSpace((12, 9), pitch=1.0, modulus=1.0, boundary=boundary))
    A, n = sla.aslinearoperator(H), H.shape[0]
    D, b = H @ np.eye(n), H @ np.random.default_rng(4).normal(size=n)
    X, most = np.random.default_rng(5).normal(size=(n, 3)), np.linalg.eigvalsh(D)[-1]
    assert np.allclose(A @ X, D @ X) and np.allclose(A.T @ b, D @ b) and np.allclose(A.H @ X, D @ X)
    assert np.allclose(A.matvec(b[:, None]), (D @ b)[:, None])
    assert np.linalg.norm(D @ sla.lsqr(A, b, atol=1e-10, btol=1e-10, iter_lim=5000)[0] - b) < 1e-6 * np.linalg.norm(b)
    assert np.isclose(sla.eigsh(A, 2, return_eigenvectors=False).max(), most)
