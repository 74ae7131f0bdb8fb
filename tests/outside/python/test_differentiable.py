"""Contacts inside PyTorch and JAX: their own checks of gradients. Skipped where these are missing."""

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc

SHAPE, OPTIONS = (6, 7), {"tol": 1e-12}
CONTROLS = {"approach": 1.1, "load": 6.0}
GAP = np.random.default_rng(5).random(SHAPE) + 0.05 * (np.arange(7) - 3) ** 2
SYSTEM = rc.HalfSpace(SHAPE, pitch=(1.0, 0.8), modulus=1.5, boundary="free")


def expected(control, gap=GAP, target=None, modulus=1.5):
    system = rc.HalfSpace(SHAPE, pitch=SYSTEM.pitch, modulus=modulus, boundary="free")
    step = {control: CONTROLS[control] if target is None else target}
    return rc.solve(undeformed_gap=gap, system=system, options=OPTIONS, want_gap=True, **step)


@pytest.fixture(params=CONTROLS)
def control(request):
    return request.param


def test_torch(control):
    torch = pytest.importorskip("torch")
    import roughcontact.torch

    press = roughcontact.torch.Press(SYSTEM, control=control, options=OPTIONS)
    gap = torch.tensor(GAP, requires_grad=True)
    target = torch.tensor(CONTROLS[control], dtype=torch.float64, requires_grad=True)
    modulus = torch.tensor(1.5, dtype=torch.float64, requires_grad=True)
    answer = press(gap, target, modulus)
    for found, known in zip(answer, ("pressure", "gap", "load", "approach")):
        np.testing.assert_allclose(found.detach(), getattr(expected(control), known), rtol=1e-10, atol=1e-12)
    assert torch.autograd.gradcheck(press, (gap, target, modulus), eps=1e-5, atol=1e-6, rtol=1e-6)
    assert torch.autograd.gradcheck(lambda g: press(g, CONTROLS[control])[0], (gap,), eps=1e-5, atol=1e-6, rtol=1e-6)
    assert press(gap.float(), 1.0)[0].dtype == torch.float32


def test_torch_after_another_step():
    torch = pytest.importorskip("torch")
    import roughcontact.torch

    press = roughcontact.torch.Press(SYSTEM, control="approach", options=OPTIONS)
    gap = torch.tensor(GAP, requires_grad=True)
    first = press(gap, 1.1)[2]
    press(gap.detach() * 2, 1.7)
    first.backward()
    with rc.Contact(SYSTEM, options=OPTIONS) as contact:
        contact.solve(undeformed_gap=GAP, approach=1.1)
        np.testing.assert_allclose(gap.grad, contact.gradient().gap, atol=1e-9)


def test_jax(control):
    jax = pytest.importorskip("jax")
    jax.config.update("jax_enable_x64", True)
    from jax.test_util import check_grads

    import roughcontact.jax

    press = roughcontact.jax.Press(SYSTEM, control=control, options=OPTIONS)
    answer = jax.jit(press)(GAP, CONTROLS[control], 1.5)
    for found, known in zip(answer, ("pressure", "gap", "load", "approach")):
        np.testing.assert_allclose(found, getattr(expected(control), known), rtol=1e-10, atol=1e-12)
    check_grads(press, (GAP, CONTROLS[control], 1.5), order=1, modes=["rev"], eps=1e-5, atol=1e-6, rtol=1e-6)
    of_load = jax.jit(jax.grad(lambda gap, target: press(gap, target)[2]))
    slopes = jax.vmap(of_load, in_axes=(None, 0))(GAP, np.array([1.0, 1.2]) * CONTROLS[control])
    assert slopes.shape == (2, *SHAPE)
    if control == "load":
        np.testing.assert_allclose(slopes, 0, atol=1e-9)  # the load is given


def test_a_step_that_fails_raises():
    from roughcontact._press import Press

    refused(rc.ArgumentError, "control", Press, SYSTEM, control="force")
    refused(rc.InfeasibleError, "load", Press(SYSTEM, control="load").solve, GAP, -1.0)
    refused(rc.ArgumentError, "no HalfSpace", Press(rc.Matrix(np.eye(4), pitch=1), control="load").solve, np.zeros(4), 1.0, 2.0)
    refused(rc.ShapeError, "undeformed_gap has shape", Press(SYSTEM, control="load").solve, np.zeros((2, 2)), 1.0)


def test_a_hardness_leaves_no_trace(control):
    from roughcontact._press import Press

    hard = rc.HalfSpace(SHAPE, pitch=SYSTEM.pitch, modulus=1.5, hardness=0.6 * expected(control).pressure.max())
    press = Press(hard, control=control, options=OPTIONS)
    target = CONTROLS[control]
    first = press.solve(GAP, target, 1.5)
    press.solve(GAP, 1.3 * target, 1.5)
    again = press.solve(GAP, target, 1.5)
    assert np.count_nonzero(first[0] == hard.hardness) > 0
    np.testing.assert_allclose(again[0], first[0], rtol=1e-10, atol=1e-12)
    change = np.random.default_rng(2).standard_normal(SHAPE)
    ends = [press.solve(GAP + way * change, target, 1.5 + 0.3 * way) for way in (-1e-6, 1e-6)]
    by = np.random.default_rng(3).standard_normal((2, *SHAPE))
    slope = sum(np.sum(b * (high - low)) / 2e-6 for b, low, high in zip((*by, 0.5, -0.7), *ends))
    by_gap, _, by_modulus = press.pull_back(GAP, target, 1.5, first[0], (*by, 0.5, -0.7))
    assert np.sum(by_gap * change) + 0.3 * by_modulus == pytest.approx(slope, rel=1e-6)
    by_gap, by_target, by_modulus = press.pull_back(GAP, target, None, first[0], (*np.zeros((2, *SHAPE)), 0.0, 0.0))
    assert not by_gap.any() and by_target == by_modulus == 0  # no cotangents, no gradient
