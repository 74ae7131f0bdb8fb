"""Contacts that are kept: warm starts, control, options, systems of the caller's, and what their callbacks do."""

import gc
import weakref

import numpy as np
import pytest
from conftest import PITCH, refused

import roughcontact as rc


def test_surface_stays_until_another_comes(rough):
    half_space = rc.HalfSpace.under(rough, modulus=1e9)
    with rc.Contact(half_space) as contact:
        mask = rough.heights < 1e-7
        first = contact.solve(rough, mask=mask, approach=5e-8)
        second = contact.solve(approach=6e-8)
        assert np.array_equal(second.grid.mask, mask) and second.pressure[~mask].max() == 0
        assert contact.solve(rough, approach=5e-8).grid.mask is None
        contact.reset()
        refused(rc.ArgumentError, "gap", contact.solve, approach=5e-8)
    assert first.contacts < second.contacts


def test_borrowed_arrays_live_as_long_as_they_are_used(rough):
    half_space = rc.HalfSpace.under(rough, modulus=1e9)
    with rc.Contact(half_space) as contact:
        gap = rough.undeformed_gap()
        first = contact.solve(undeformed_gap=gap, approach=5e-8, borrow=True)
        seen = weakref.ref(gap)
        del gap
        gc.collect()
        assert seen() is not None
        assert np.array_equal(contact.solve(approach=5e-8, warm_start=False).pressure, first.pressure)
        contact.solve(rough, approach=5e-8)
        assert seen() is None
        contact.solve(undeformed_gap=rough.undeformed_gap(), approach=5e-8, borrow=True)
        for _ in range(5):
            contact.solve(mask=np.ones(rough.shape, bool), approach=5e-8, borrow=True)
        assert len(contact._borrowed) <= 2


def test_certify_judges_pressures(rough):
    with rc.Contact(rc.HalfSpace.under(rough, modulus=1e9)) as contact:
        off = 1.01 * contact.solve(rough, approach=5e-8).pressure
        caught = refused(rc.NotCertifiedError, "", contact.certify, off, rough, approach=5e-8)
        assert caught.status == rc.Status.UNCERTIFIED and caught.result.residual > 1e-4
        judged = contact.certify(off, rough, approach=5e-8, check=False, want_gap=True)
    assert np.array_equal(judged.pressure, off) and judged.gap is not None


def test_levels_of_the_cascade(sphere_gap, half_space):
    with rc.Contact(half_space, options={"solver": "cmr", "cmr.levels": 3}) as contact:
        assert contact.explain() == ""
        answer = contact.solve(undeformed_gap=sphere_gap, approach=3e-7)
        levels = contact.levels()
        assert f"{answer.solver} on {answer.backend}: " in contact.explain()
    assert answer.levels == len(levels) == 2
    assert [level.pressure.shape for level in levels] == [(16, 16), (32, 32)]
    assert levels[1].pitch == (2 * PITCH, 2 * PITCH)


def test_options_can_change(sphere_gap, half_space):
    with rc.Contact(half_space, options={"tol": 1e-4}) as contact:
        assert contact.solve(undeformed_gap=sphere_gap, approach=3e-7).tolerance == 1e-4
        contact.set_options({"stiffness": 1})
        answer = contact.solve(approach=3e-7)
        assert answer.tolerance == 1e-4 and answer.stiffness > 0
        refused(rc.OptionError, "kernel", contact.set_options, {"kernel": "disc"})
        assert contact.solve(approach=3e-7).stiffness > 0


def test_closed_contacts_say_so(half_space, sphere_gap):
    contact = rc.Contact(half_space)
    contact.close()
    contact.close()
    contact.cancel()
    for call in (lambda: contact.solve(undeformed_gap=sphere_gap, approach=1e-7), contact.reset, contact.points):
        refused(rc.ArgumentError, "closed", call)


def test_progress_sees_and_stops(rough):
    seen, fewer = [], []
    how = {"modulus": 1e9, "approach": 1e-7, "options": {"solver": "gp"}}
    rc.solve(rough, **how, progress=seen.append)
    assert seen[-1].kkt < seen[1].kkt and seen[-1].products > 5 and seen[-1].iteration > seen[0].iteration
    rc.solve(rough, **how, progress=fewer.append, every=5)
    assert 0 < len(fewer) < len(seen)
    caught = refused(rc.NotCertifiedError, "", rc.solve, rough, **how, progress=lambda p: p.iteration >= 3)
    assert caught.status == rc.Status.STOP_CANCELLED and caught.result.iterations <= 4
    assert rc.solve(rough, **how, progress=lambda p: p.iteration >= 3, check=False).status == rc.Status.STOP_CANCELLED


def test_own_matrix_in_every_layout(small_matrix):
    gap = np.linspace(0, 2, 12)
    expected = rc.solve(undeformed_gap=gap, approach=1.5, system=rc.Matrix(small_matrix, pitch=1))
    assert expected.certified and 0 < expected.contacts < 12
    wide = np.zeros((12, 20))
    wide[:, :12] = small_matrix
    doubled = np.repeat(np.repeat(small_matrix, 2, 0), 2, 1)[::2, ::2]
    for H, kept in ((np.asfortranarray(small_matrix), 1), (wide[:, :12], 1), (wide[:, :12].T, 1), (small_matrix.tolist(), 0), (doubled, 0)):
        system = rc.Matrix(H, pitch=1)
        assert np.shares_memory(system.H, H) == kept
        found = rc.solve(undeformed_gap=gap, approach=1.5, system=system)
        assert np.allclose(found.pressure, expected.pressure, rtol=1e-6)


def test_own_matrix_with_a_shape(small_matrix):
    gap = np.linspace(0, 2, 12).reshape(3, 4)
    result = rc.solve(undeformed_gap=gap, approach=1.5, system=rc.Matrix(small_matrix, shape=(3, 4), pitch=(2.0, 3.0)))
    assert result.pressure.shape == (3, 4) and result.load == pytest.approx(6 * result.pressure.sum())
    refused(rc.ShapeError, "12 x 12.*has 10 points", rc.Matrix, small_matrix, shape=(2, 5), pitch=1)
    refused(rc.ShapeError, "square", rc.Matrix, small_matrix[:5], pitch=1)
    refused(rc.ArgumentError, "symmetric", rc.Contact, rc.Matrix(small_matrix + np.triu(np.ones((12, 12))), pitch=1))


def test_a_matrix_has_no_modulus(small_matrix):
    with rc.Contact(rc.Matrix(small_matrix, pitch=1.0)) as contact:
        result = contact.solve(undeformed_gap=np.linspace(0, 1, 12), approach=0.5)
        assert np.isnan(contact.gradient().modulus) and contact.gradient().target > 0
        refused(rc.ShapeError, "pressure has shape", contact.gradient, np.zeros((2, 2)))
    refused(rc.ArgumentError, "HalfSpace", result.conductance, 1.0, 1.0)


def test_own_product(small_matrix):
    gap, seen = np.linspace(0, 2, 12), []
    expected = rc.solve(undeformed_gap=gap, approach=1.5, system=rc.Matrix(small_matrix, pitch=1))

    def flat(x):
        seen.append((x.shape, x.flags.writeable))
        return small_matrix.dot(x.ravel()).reshape(3, 4).tolist()

    shaped = rc.solve(undeformed_gap=gap.reshape(3, 4), approach=1.5, system=rc.Product(flat, (3, 4), pitch=1))
    assert shaped.backend == "callback" and np.allclose(shaped.pressure.ravel(), expected.pressure, rtol=1e-6) and set(seen) == {((3, 4), False)}


def raising(*_):
    raise LookupError("from inside")


WAVES = np.cos(np.arange(12.0).reshape(3, 4))
RUN = {"undeformed_gap": 1 + WAVES, "pitch": 1.0, "modulus": 1.0, "boundary": "free"}


def late(x, calls=[]):  # noqa: B006
    """A product that raises when it has been tried."""
    calls.append(1)
    return raising() if len(calls) % 4 == 0 else 2.0 * x


@pytest.mark.parametrize(
    "call",
    [
        lambda: rc.solve(**RUN, approach=1.0, solver="gp", progress=raising),
        lambda: rc.history(**RUN, approach=[0.5, 1.0], each=raising),
        lambda: rc.batch(**RUN, approach=[0.5, 1.0], each=raising),
        lambda: [rc.solve(undeformed_gap=np.linspace(0, 1, 12), approach=0.9, system=rc.Product(late, 12, pitch=1)) for _ in range(4)],
        lambda: [rc.analysis.punch_stiffness(rc.Product(late, 12, pitch=1.0)) for _ in range(4)],
        lambda: [rc.Influence(rc.Product(late, 12, pitch=1.0)).matvec(np.ones(12)) for _ in range(4)],
    ],
    ids=["progress", "history", "batch", "product", "punch", "influence"],
)
def test_exceptions_of_the_callers_functions_arrive(call):
    refused(LookupError, "from inside", call)


def test_a_contact_is_usable_after_an_exception(rough):
    with rc.Contact(rc.HalfSpace.under(rough, modulus=1e9), options={"solver": "gp"}, progress=raising) as contact:
        for _ in range(2):
            refused(LookupError, "from inside", contact.solve, rough, approach=1e-7)
    refused(rc.ShapeError, "the product has shape", rc.Contact, rc.Product(lambda x: x[:3], 12, pitch=1))
    refused(TypeError, "real numbers", rc.Contact, rc.Product(lambda x: None, 12, pitch=1))


def test_contacts_are_freed(half_space, sphere_gap):
    contact = rc.Contact(half_space, progress=lambda p: None)
    contact.solve(undeformed_gap=sphere_gap, approach=1e-7)
    seen = weakref.ref(contact)
    del contact
    gc.collect()
    assert seen() is None


def test_a_refused_step_keeps_the_mask(rough):
    with rc.Contact(rc.HalfSpace.under(rough, modulus=1e9)) as contact:
        mask = rough.heights < 1e-7
        contact.solve(rough, mask=mask, approach=5e-8)
        refused(rc.ArgumentError, "", contact.solve, rough, approach=np.nan)
        refused(rc.InfeasibleError, "", contact.history, rough, approach=[1.0, 2.0])
        assert np.array_equal(contact.solve(approach=5e-8).grid.mask, mask)
