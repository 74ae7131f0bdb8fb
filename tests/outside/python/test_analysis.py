"""Area, patches, histogram and crossing of pressures."""

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
    assert result.measure_area().area == pytest.approx(result.contact_area)
    assert result.find_patches().load.sum() == pytest.approx(result.load)
    joined = rc.analysis.patches(result.pressure, pitch=1e-6, periodic=True, mask=mask)
    assert len(result.find_patches()) == len(joined) == result.patches
    assert result.histogram(20).contacts == result.contacts
    bare = rc.solve(rough, modulus=1e9, approach=8e-8, want_pressure=False)
    refused(ValueError, "want_pressure", bare.find_patches)
    refused(ValueError, "want_pressure", getattr, bare, "patches")


def test_crossing():
    ridge = np.zeros((4, 5))
    ridge[1] = 1
    assert rc.analysis.crossing(ridge) == rc.Crossing("x", "x") == rc.analysis.crossing(ridge, periodic=True)
    assert rc.analysis.crossing(ridge.T) == rc.Crossing("y", "y")
    assert rc.analysis.crossing(np.zeros((4, 5))) == rc.Crossing("none", "xy")
    assert rc.analysis.crossing(np.ones((4, 5))) == rc.Crossing("xy", "none")
    mask = np.ones((4, 5), bool)
    mask[:, 2] = False
    assert rc.analysis.crossing(ridge, mask=mask) == rc.Crossing("none", "none")
    refused(rc.ArgumentError, "p\\[0\\]", rc.analysis.crossing, -np.ones((2, 2)))
    # A channel that goes around along y: the sides at the ends of x stay apart in any case.
    wrapping = np.array([[c == "#" for c in row] for row in ("#.##", "#.##", "..##", "####", "#...")], float)
    gaps = {periodic: rc.analysis.crossing(wrapping, periodic=periodic).gap for periodic in (False, True, "x", "y")}
    assert gaps == {False: "none", True: "x", "x": "none", "y": "x"}
    assert str(rc.analysis.crossing(wrapping, periodic=True)) == (
        "the contact crosses along x (with y periodic) and along y (with x periodic), the gap along x (with y periodic)"
    )
    assert str(rc.analysis.crossing(wrapping)).endswith("the gap along no axis")


def test_results_have_what_the_command_prints(rough):
    mask = rough.heights < 1.5e-7
    result = rc.solve(rough, modulus=1e9, approach=8e-8, mask=mask, want_gap=True)
    assert result.area_fraction == result.contacts / result.points and result.max_pressure == result.pressure.max()
    assert result.mean_gap == pytest.approx(result.gap[mask].mean(), rel=1e-12)
    assert result.corrected_area == result.measure_area().corrected_area < result.contact_area
    found = result.find_patches()
    assert result.patches == len(found) and result.largest_patch == found.area.max()
    crossing = rc.analysis.crossing(result.pressure, periodic=True, mask=mask)
    assert (result.contact_crosses, result.gap_crosses) == (crossing.contact, crossing.gap)


def test_the_mean_gap_is_known_with_the_gap():
    """The certificate of sparse contact needs the gap at few points."""
    surface = rc.surface.spectral((512, 512), pitch=1e-6, rms_height=1e-7, hurst=0.8, seed=3)
    for boundary in ("free", "periodic"):
        how = {"modulus": 1e9, "approach": 3e-8, "boundary": boundary}
        assert np.isnan(rc.solve(surface, **how).mean_gap)
        with_gap = rc.solve(surface, **how, want_gap=True)
        assert with_gap.mean_gap == pytest.approx(with_gap.gap.mean(), rel=1e-12)
        assert rc.history(surface, **how, want_gap=True).mean_gap[0] == with_gap.mean_gap


def test_arrays_are_shown_by_their_shapes(rough):
    result = rc.solve(rough, modulus=1e9, approach=8e-8)
    patches = result.find_patches()
    shown = [patches, result.histogram(20), result, result.grid, rc.history(rough, modulus=1e9, load=[1e-4])[0]]
    with rc.Contact(rc.HalfSpace.under(rough, modulus=1e9)) as contact:
        contact.solve(rough, approach=8e-8)
        shown += [contact, contact.system, contact.gradient(), contact.tangent(target=1.0), *contact.levels()]
    shown.append(contact)
    for each in shown:
        text = repr(each)
        assert len(text) < 320 and "array(" not in text and "np.float64" not in text and "object at" not in text, text
    assert repr(patches) == f"Patches({len(patches)}, the largest of {patches.cells.max()} points)"
    assert "HalfSpace(64 x 48 points" in repr(contact) and "closed" in repr(contact)
