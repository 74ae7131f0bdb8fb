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


def test_a_law_has_the_pressures_of_solves(gap, law):
    for p in (2e-4, 3e-3, 1.5e-2):
        result = rc.solve(undeformed_gap=gap, pitch=1, modulus=1, boundary="periodic", load=p * gap.size)
        lower, upper = law.bounds(result.approach)
        assert lower * (1 - 1e-9) <= p <= upper * (1 + 1e-9)
        assert law(result.approach) == pytest.approx(p, rel=2e-3)


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
