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
    lower, upper = law.bounds(x)
    assert np.all(lower <= p) and np.all(p <= upper) and np.any(lower < upper)
    assert len(law.nodes["x"]) == law.info["nodes"] and law.status == rc.Status.OK


def test_what_python_says_of_laws(law, gap, tmp_path):
    law.save(tmp_path / "a.law")
    assert np.array_equal(rc.Law.load(tmp_path / "a.law").nodes["p"], law.nodes["p"])
    refused(rc.ArgumentError, "format is", law.export, tmp_path / "a", "ansys")
    given = {"undeformed_gap": gap, "pitch": 1, "modulus": 1, "boundary": "periodic", "pressure": (1e-4, 2e-2)}
    refused(rc.ArgumentError, "bulk is", rc.law, bulk="much", **given)
    refused(TypeError, "did you mean 'conductance_tolerance'", rc.law, conductance_tol=1, **given)
    refused(rc.NotCertifiedError, "max_nodes", rc.law, max_nodes=5, **given)
    assert rc.law(max_nodes=5, check_status=False, **given).status == rc.Status.STOP_MAX_ITER
    refused(rc.ArgumentError, "nu = 0.6", law.slip, mu=1, nu=0.6)
    refused(rc.ArgumentError, "slip before contact", law.slip(mu=1, nu=0), 0.1, 0)
    refused(rc.ArgumentError, "two components", law.slip(mu=1, nu=0).rest.step, 0.5, (1, 2, 3))


def test_slips_take_arrays(law):
    slip, p = law.slip(mu=0.4, nu=0.3), 1.5e-2
    most = slip.sliding_slip(p)
    slips = np.linspace(0, 1.2 * most, 7)
    shear, (lower, upper) = slip(slips, p), slip.bounds(slips, p)
    assert np.allclose(shear, 0.4 * (p - law(np.maximum(0, law.overclosure(p) * (1 - slips / most)))), rtol=1e-9)
    assert np.all(lower <= shear) and np.all(shear <= upper) and slip(np.zeros((2, 1)), [p, p / 2]).shape == (2, 2)
    assert slip.stiffness(0, p) == pytest.approx(law.slope(law.overclosure(p)) * 1.4 / 1.7)


def test_loops_dissipate_their_area(law):
    slip, p = law.slip(mu=0.4, nu=0.3), 1.5e-2
    amplitude = 0.6 * slip.sliding_slip(p)
    slips, shears = slip.loop(amplitude, p, points=400)
    area = np.trapezoid if hasattr(np, "trapezoid") else np.trapz
    assert area(shears[400:], slips[400:]) == pytest.approx(slip.dissipated(amplitude, p), rel=1e-3)
    assert shears[-1] == pytest.approx(shears[399]) and slips[799] == -amplitude


def test_a_slip_can_be_drawn(law):
    pytest.importorskip("matplotlib").use("Agg")
    axes = law.slip(mu=0.4, nu=0.3).plot(si=False)
    assert len(axes.lines) == 3 and axes.get_ylabel() == "shear"
