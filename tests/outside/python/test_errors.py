"""Every failure is an exception with the library's message and status."""

import numpy as np
import pytest
from conftest import MODULUS, PITCH, refused

import roughcontact as rc
from roughcontact._errors import error_for

CASES = {
    "argument": (rc.ArgumentError, rc.Status.ERR_ARGUMENT, "modulus", {"modulus": -1.0}),
    "not finite": (rc.ArgumentError, rc.Status.ERR_ARGUMENT, "not finite", {"approach": np.inf}),
    "shape": (rc.ShapeError, rc.Status.ERR_SHAPE, "gap have 3 x 3 points", {"undeformed_gap": np.zeros((3, 3))}),
    "option": (rc.OptionError, rc.Status.ERR_OPTION, 'did you mean "tol"', {"options": {"tool": 1e-6}}),
    "option's range": (rc.OptionError, rc.Status.ERR_OPTION, "0.1", {"options": {"tol": 1.0}}),
    "option's type": (rc.OptionError, rc.Status.ERR_OPTION, "max_iter", {"options": {"max_iter": 1.5}}),
    "backend": (rc.NoBackendError, rc.Status.ERR_NO_BACKEND, "nonesuch", {"options": {"backend": "nonesuch"}}),
    "solver": (rc.NoSolverError, rc.Status.ERR_NO_SOLVER, "nonesuch", {"options": {"solver": "nonesuch"}}),
    "incompatible": (rc.IncompatibleError, rc.Status.ERR_INCOMPATIBLE, "kernel", {"options": {"kernel": "spectral"}}),
    "infeasible": (rc.InfeasibleError, rc.Status.ERR_INFEASIBLE, "load", {"approach": None, "load": -1.0}),
    "stopped": (
        rc.NotCertifiedError,
        rc.Status.STOP_MAX_ITER,
        "after 2 iterations",
        {"options": {"max_iter": 2, "solver": "gp"}},
    ),
    "time": (rc.NotCertifiedError, rc.Status.STOP_TIME, "time_limit", {"options": {"time_limit": 1e-9, "solver": "gp"}}),
}


@pytest.mark.parametrize("case", CASES)
def test_statuses_are_exceptions(case, sphere_gap, half_space):
    kind, status, words, change = CASES[case]
    arguments = {"undeformed_gap": sphere_gap, "approach": 3e-7, **change}
    if "modulus" not in change:
        arguments["system"] = half_space
    else:
        arguments["pitch"] = PITCH
    caught = refused(kind, words, rc.solve, **arguments)
    assert type(caught) is kind and caught.status == status
    assert isinstance(caught, rc.RoughContactError)
    assert (caught.result is not None) == (status > 0)


def test_a_product_that_is_not_positive_is_an_arithmetic_error():
    with pytest.raises(rc.NumericError) as caught:
        rc.solve(undeformed_gap=np.zeros(8), approach=1.0, system=rc.Product(lambda x: -x, 8, pitch=1))
    assert isinstance(caught.value, ArithmeticError)


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
    assert len(set(kinds.values())) == len(kinds) == 13
    assert all(type(error_for(s, "")) is rc.NotCertifiedError for s in rc.Status if s > 0)
    assert type(error_for(-57, "from a newer library")) is rc.InternalError


def test_stopped_answers_can_be_looked_at(sphere_gap, half_space):
    how = {"undeformed_gap": sphere_gap, "system": half_space, "approach": 3e-7, "options": {"max_iter": 2, "solver": "gp"}}
    result = rc.solve(**how, check=False)
    assert result.status == rc.Status.STOP_MAX_ITER and "after 2 iterations" in result.message and not result.certified
    assert result.load == pytest.approx(4 / 3 * MODULUS * np.sqrt(1e-3) * 3e-7**1.5, rel=0.5)
    caught = refused(rc.NotCertifiedError, "", rc.solve, **how)
    assert np.array_equal(caught.result.pressure, result.pressure)


def test_failures_leave_the_contact_as_it_was(sphere_gap, half_space):
    with rc.Contact(half_space) as contact:
        first = contact.solve(undeformed_gap=sphere_gap, approach=3e-7)
        for _ in range(3):
            refused(rc.ArgumentError, "", contact.solve, approach=float("nan"))
        assert np.array_equal(contact.solve(approach=3e-7, warm_start=False).pressure, first.pressure)


@pytest.mark.parametrize("value", [None, [1], 1j])
def test_options_of_no_known_type(value, half_space):
    refused(TypeError, "int, float or str", rc.Contact, half_space, options={"tol": value})


def test_names_that_are_not_choices(half_space, sphere_gap):
    refused(rc.ArgumentError, "'free', 'periodic', 'periodic-x' or 'periodic-y'", rc.HalfSpace, (4, 4), pitch=1, modulus=1, boundary="open")
    with pytest.raises(rc.ArgumentError, match="pitch and system are both given"):
        rc.solve(undeformed_gap=sphere_gap, system=half_space, pitch=1.0, load=1)
    refused(rc.ShapeError, "3 axes", rc.HalfSpace, (4, 4, 4), pitch=1, modulus=1)
    refused(rc.ShapeError, "pitch has 3 values", rc.HalfSpace, (4, 4), pitch=(1, 2, 3), modulus=1)


def test_every_exception_has_its_status():
    from roughcontact._errors import _BY_STATUS

    assert rc.InternalError("x").status == rc.Status.ERR_INTERNAL and rc.NotCertifiedError("x").status == rc.Status.UNCERTIFIED
    failures = {status for status in rc.Status if status < 0}
    assert set(_BY_STATUS) == failures and all(kind("x").status == status for status, kind in _BY_STATUS.items())
