"""Every failure is an exception with the library's message and status."""

import numpy as np
import pytest
from conftest import PITCH, refused

import roughcontact as rc
from roughcontact._errors import error_for

CASES = {
    "argument": (rc.ArgumentError, "modulus", {"modulus": -1.0}),
    "shape": (rc.ShapeError, "gap have 3 x 3 points", {"undeformed_gap": np.zeros((3, 3))}),
    "option": (rc.OptionError, 'did you mean "tol"', {"options": {"tool": 1e-6}}),
    "backend": (rc.NoBackendError, "nonesuch", {"options": {"backend": "nonesuch"}}),
    "solver": (rc.NoSolverError, "nonesuch", {"options": {"solver": "nonesuch"}}),
    "incompatible": (rc.IncompatibleError, "kernel", {"options": {"kernel": "spectral"}}),
    "infeasible": (rc.InfeasibleError, "load", {"approach": None, "load": -1.0}),
    "stopped": (rc.NotCertifiedError, "after 2 iterations", {"options": {"max_iter": 2, "solver": "gp"}}),
}


@pytest.mark.parametrize("case", CASES)
def test_statuses_are_exceptions(case, sphere_gap, half_space):
    kind, words, change = CASES[case]
    where = {"pitch": PITCH} if "modulus" in change else {"system": half_space}
    caught = refused(kind, words, rc.solve, **{"undeformed_gap": sphere_gap, "approach": 3e-7, **where, **change})
    assert type(caught) is kind and (caught.result is not None) == (kind is rc.NotCertifiedError)
    if caught.result is not None:  # it can be looked at
        result = rc.solve(undeformed_gap=sphere_gap, approach=3e-7, check=False, **where, **change)
        assert result.status == rc.Status.STOP_MAX_ITER and words in result.message and not result.certified
        assert np.array_equal(caught.result.pressure, result.pressure)


def test_plugin_that_is_refused(tmp_path, sphere_gap, half_space):
    (tmp_path / "rcb_broken.so").write_text("no plugin")
    said = []
    context = rc.Context(str(tmp_path), log=lambda level, message: said.append((level, message)))
    assert "broken" not in [each.name for each in rc.backends(context)]
    assert any(level == "warning" and "rcb_broken.so" in message for level, message in said)
    with pytest.raises(rc.PluginError, match="rcb_broken.so"):
        how = {"options": {"backend": "broken"}, "context": context}
        rc.solve(undeformed_gap=sphere_gap, system=half_space, approach=1e-7, **how)


def test_exceptions_are_also_those_of_python():
    for kind, python in (
        (rc.ArgumentError, ValueError),
        (rc.ShapeError, ValueError),
        (rc.OptionError, ValueError),
        (rc.NoBackendError, LookupError),
        (rc.OutOfMemoryError, MemoryError),
        (rc.LibraryNotFoundError, ImportError),
        (rc.Interrupted, KeyboardInterrupt),
        (rc.InfeasibleError, ValueError),
    ):
        assert issubclass(kind, python)


def test_every_status_has_its_exception():
    kinds = {status: type(error_for(status, "")) for status in rc.Status if status < 0}
    assert len(set(kinds.values())) == len(kinds) == 13 and all(kind("x").status == status for status, kind in kinds.items())
    assert rc.InternalError("x").status == rc.Status.ERR_INTERNAL and rc.NotCertifiedError("x").status == rc.Status.UNCERTIFIED
    assert all(type(error_for(s, "")) is rc.NotCertifiedError for s in rc.Status if s > 0)
    assert type(error_for(-57, "from a newer library")) is rc.InternalError


def test_direct_routines_that_stop(small_matrix):
    u = 1.5 - np.linspace(0, 2, 12)
    caught = refused(rc.NotCertifiedError, "", rc.direct.gp, small_matrix, u, tol=1e-14, max_iter=1)
    stopped = rc.direct.gp(small_matrix, u, tol=1e-14, max_iter=1, check=False)
    assert stopped.status == caught.status == rc.Status.STOP_MAX_ITER
    assert np.array_equal(stopped.p, caught.result.p) and stopped.message
    refused(rc.ShapeError, "u has shape", rc.direct.nnls, small_matrix, u[:5])
    refused(rc.OptionError, "tol", rc.direct.admm, small_matrix, u, tol=1.0)
