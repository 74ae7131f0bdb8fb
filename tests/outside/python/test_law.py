"""Contact laws."""

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc


@pytest.fixture(name="gap", scope="module")
def _gap():
    y, x = np.mgrid[:24, :24]
    heights = np.cos(2 * np.pi * x / 24) + np.cos(2 * np.pi * (x + 2 * y) / 24) + 0.3 * np.cos(2 * np.pi * (3 * x - y) / 24)
    return 0.2 * (heights.max() - heights)


@pytest.fixture(name="law", scope="module")
def _law(gap):
    return rc.law(undeformed_gap=gap, pitch=1, modulus=1, boundary="periodic", pressure=(1e-4, 2e-2))


def test_arrays_slopes_and_inverses(law):
    x = np.linspace(0, law.info["x_upper"], 12).reshape(3, 4)
    p = law(x)
    assert p.shape == x.shape and isinstance(float(law(0.1)), float)
    assert np.allclose(law.overclosure(p), x, rtol=1e-9)
    assert np.allclose((law(x + 1e-9) - p)[x > 0], 1e-9 * law.slope(x)[x > 0], rtol=1e-2)  # it jumps at first touch
    assert np.allclose(law.conductance(p, k=(50, 200)), 2 * law.slope(x) / (1 / 50 + 1 / 200), rtol=1e-6)
    assert np.all(np.diff(law.energy(x).ravel()) >= 0) and np.all(law.area_fraction(x) <= 1)
    assert len(law.nodes["x"]) == law.info["nodes"] and law.status == rc.Status.OK


def test_a_saved_law_has_the_same_bits(law, tmp_path):
    law.save(tmp_path / "a.law")
    x = np.linspace(0, 2 * law.info["x_upper"], 100)
    assert np.array_equal(rc.Law.load(tmp_path / "a.law")(x), law(x))
    assert 0 < law.export(tmp_path / "a.inp", "calculix", k=(1, 1)) < 0.1
    assert "*GAP CONDUCTANCE" in (tmp_path / "a.inp").read_text()
    (tmp_path / "b.law").write_text("hello")
    refused(rc.ArgumentError, "does not begin with", rc.Law.load, tmp_path / "b.law")
    refused(rc.ArgumentError, "format is", law.export, tmp_path / "a", "ansys")


def test_what_cannot_be_is_refused(gap, tmp_path):
    given = {"undeformed_gap": gap, "pitch": 1, "modulus": 1, "boundary": "periodic"}
    refused(rc.ArgumentError, "is not a range that rises", rc.law, pressure=(1, 1), **given)
    refused(rc.InfeasibleError, "is closed", rc.law, pressure=(1, 1e4), **given)
    refused(rc.ArgumentError, "bulk is", rc.law, pressure=(1e-4, 2e-2), bulk="much", **given)
    refused(TypeError, "did you mean 'conductance_tolerance'", rc.law, pressure=(1e-4, 2e-2), conductance_tol=1, **given)
    refused(rc.NotCertifiedError, "max_nodes", rc.law, pressure=(1e-4, 2e-2), max_nodes=5, **given)
    stopped = rc.law(pressure=(1e-4, 2e-2), max_nodes=5, check_status=False, **given)
    assert stopped.status == rc.Status.STOP_MAX_ITER and stopped.info["nodes"] <= 5
    stopped.save(tmp_path / "stopped.law")
    assert rc.Law.load(tmp_path / "stopped.law").status == stopped.status


def test_slip_follows_from_the_law(law):
    p, mu, nu = 1.5e-2, 0.4, 0.3
    slip = law.slip(mu=mu, nu=nu)
    most = slip.sliding_slip(p)
    slips = np.linspace(0, 1.2 * most, 7)
    shear, left = slip(slips, p), np.maximum(0, law.overclosure(p) * (1 - slips / most))
    assert np.allclose(shear, mu * (p - law(left)), rtol=1e-9) and shear[-1] == pytest.approx(mu * p)
    assert slip.stiffness(0, p) == pytest.approx(law.slope(law.overclosure(p)) * 1.4 / 1.7)
    lower, upper = slip.bounds(slips, p)
    assert np.all(lower <= shear) and np.all(shear <= upper) and np.all(upper - lower <= 5e-3 * mu * p)
    assert slip(np.zeros((2, 1)), [p, p / 2]).shape == (2, 2)


def test_loops_dissipate_their_area(law):
    slip, p = law.slip(mu=0.4, nu=0.3), 1.5e-2
    amplitude = 0.6 * slip.sliding_slip(p)
    slips, shears = slip.loop(amplitude, p, points=400)
    area = np.trapezoid if hasattr(np, "trapezoid") else np.trapz
    assert area(shears[400:], slips[400:]) == pytest.approx(slip.dissipated(amplitude, p), rel=1e-3)
    assert shears[-1] == pytest.approx(shears[399]) and slips[799] == -amplitude


def test_states_step_like_a_host(law):
    rest = law.slip(mu=0.4, nu=0.1).rest
    pressed = rest.step(0.5)
    turned = pressed.step(0.6, (0.05, -0.02))
    assert pressed.p == law(0.5) and not pressed.shear.any() and turned.p == law(0.6)
    moved = pressed.step(0.6, (0.05, -0.02 + 1e-7))
    assert np.allclose((moved.shear - turned.shear) / 1e-7, turned.shear_by_slip[:, 1], rtol=1e-4, atol=1e-6)
    assert np.all(turned.bounds().lower <= turned.shear) and turned.step(-1).p == 0
    assert np.hypot(*turned.step(0.6, (9, 9)).shear) == pytest.approx(0.4 * turned.p)


def test_friction_that_cannot_be_is_refused(law, gap, tmp_path):
    refused(rc.ArgumentError, "mu = -1", law.slip, mu=-1, nu=0.3)
    refused(rc.ArgumentError, "nu = 0.6", law.slip, mu=1, nu=0.6)
    refused(rc.ArgumentError, "slip before contact", law.slip(mu=1, nu=0), 0.1, 0)
    refused(rc.ArgumentError, "finite", law.slip(mu=1, nu=0), float("nan"), 1e-3)
    refused(rc.ArgumentError, "two components", law.slip(mu=1, nu=0).rest.step, 0.5, (1, 2, 3))
    given = {"undeformed_gap": gap, "pitch": 1, "modulus": 1, "boundary": "periodic"}
    hard = rc.law(pressure=(1e-4, 1e-2), hardness=0.5, check_status=False, **given)
    refused(rc.IncompatibleError, "has a hardness", hard.slip, mu=0.3, nu=0.3)
    law.export(tmp_path / "a.inp", "abaqus", mu=0.4, nu=0.3)
    assert "*FRICTION, ELASTIC SLIP=" in (tmp_path / "a.inp").read_text()


def test_a_slip_can_be_drawn(law):
    pytest.importorskip("matplotlib").use("Agg")
    axes = law.slip(mu=0.4, nu=0.3).plot(si=False)
    assert len(axes.lines) == 3 and axes.get_ylabel() == "shear"
