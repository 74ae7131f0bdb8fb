"""Direct routines."""

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc
from roughcontact import direct


@pytest.mark.parametrize("name", ["greedy", "polonsky_keer", "nnls", "gp", "admm"])
def test_methods_agree(name, small_matrix):
    u = 1.5 - np.linspace(0, 2, 12)
    exact = direct.nnls(small_matrix, u, tol=1e-14)
    found = getattr(direct, name)(np.asfortranarray(small_matrix), u.tolist(), tol=1e-10)
    assert found.status == rc.Status.OK and np.allclose(found.p, exact.p, atol=1e-7)
    assert np.allclose(found.w, small_matrix @ found.p - u, atol=1e-12) and found.contacts == np.count_nonzero(exact.p)
    again = getattr(direct, name)(small_matrix, u, tol=1e-8, start=exact.p)
    assert again.iterations <= found.iterations
    refused(rc.OptionError, "tol", getattr(direct, name), small_matrix, u, tol=1.0)


def test_stops_are_exceptions_or_answers(small_matrix):
    u = 1.5 - np.linspace(0, 2, 12)
    caught = refused(rc.NotCertifiedError, "", direct.gp, small_matrix, u, tol=1e-14, max_iter=1)
    stopped = direct.gp(small_matrix, u, tol=1e-14, max_iter=1, check=False)
    assert stopped.status == caught.status == rc.Status.STOP_MAX_ITER
    assert np.array_equal(stopped.p, caught.result.p) and stopped.message
    refused(rc.ShapeError, "u has shape", direct.nnls, small_matrix, u[:5])


def test_defaults_are_the_options(small_matrix, sphere_gap):
    u = 1.5 - np.linspace(0, 2, 12)
    options = rc.effective_options()
    explicit = direct.gp(small_matrix, u, tol=options["tol"], max_iter=options["max_iter"])
    assert np.array_equal(direct.gp(small_matrix, u).p, explicit.p)
    how = {"pitch": 1e-6, "modulus": 1e11, "approach": 3e-7, "levels": 3}
    assert np.array_equal(direct.cmr(-sphere_gap, **how).p, direct.cmr(-sphere_gap, **how, radius=options["cmr.radius"]).p)
