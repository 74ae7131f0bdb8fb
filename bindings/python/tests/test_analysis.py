"""Area, patches and histogram of pressures."""

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc

P = np.array([[2.0, 0, 0, 1], [3.0, 0, 4, 0], [0, 0, 0, 1.0]])


def test_area():
    found = rc.analysis.area(P, pitch=(2.0, 1.0))
    assert (found.contacts, found.area) == (5, 10.0)
    assert found.corrected_area < found.area
    assert rc.analysis.area(P, pitch=1.0, mask=P < 3.5).contacts == 4
    assert rc.analysis.area(P, pitch=1.0, periodic=True).perimeter > 0
    refused(rc.ArgumentError, "p", rc.analysis.area, -P, pitch=1.0)


@pytest.mark.parametrize(
    "how, count", [({}, 4), ({"corners": True}, 2), ({"periodic": True}, 2), ({"periodic": True, "corners": True}, 1)]
)
def test_patches(how, count):
    found = rc.analysis.patches(P, pitch=(2.0, 1.0), **how)
    assert len(found) == count == len(found.area) and found.cells.sum() == 5
    assert found.label.shape == P.shape and np.array_equal(found.label >= 0, P > 0)
    for k in range(count):
        own = P[found.label == k]
        assert found.load[k] == pytest.approx(2 * own.sum()) and found.max_pressure[k] == own.max()
        assert P.ravel()[found.peak[k]] == own.max() and found.mean_pressure[k] == pytest.approx(own.mean())


def test_no_contact():
    assert len(rc.analysis.patches(np.zeros((3, 3)), pitch=1.0)) == 0
    assert rc.analysis.histogram(np.zeros((3, 3)), 4, pitch=1.0).contacts == 0


def test_histogram():
    found = rc.analysis.histogram(P, 4, pitch=1.0)
    assert found.counts.tolist() == [2, 1, 1, 1] and found.edges.tolist() == [0, 1, 2, 3, 4]
    assert found.density.sum() == pytest.approx(1.0) and found.mean_pressure == pytest.approx(11 / 5)
    cut = rc.analysis.histogram(P, 2, upper=2.0, pitch=1.0)
    assert cut.above == 2 and cut.counts.tolist() == [2, 1]
    for bins in (0, -3):
        refused(rc.ArgumentError, "bins", rc.analysis.histogram, P, bins, pitch=1.0)


def test_results_have_them_as_methods(rough):
    mask = rough.heights < 1.5e-7
    result = rc.solve(rough, modulus=1e9, approach=8e-8, mask=mask)
    assert result.area().area == pytest.approx(result.contact_area)
    assert result.patches().load.sum() == pytest.approx(result.load)
    joined = rc.analysis.patches(result.pressure, pitch=1e-6, periodic=True, mask=mask)
    assert len(result.patches()) == len(joined)
    assert result.histogram(20).contacts == result.contacts
    bare = rc.solve(rough, modulus=1e9, approach=8e-8, want_pressure=False)
    refused(ValueError, "want_pressure", bare.patches)
