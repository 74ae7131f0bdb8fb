"""Area, patches, histogram and crossing of pressures."""

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc

P = np.array([[2.0, 0, 0, 1], [3.0, 0, 4, 0], [0, 0, 0, 1.0]])


def test_what_python_adds_to_the_numbers_of_c():
    found = rc.analysis.histogram(P, 4, pitch=1.0)
    assert found.counts.tolist() == [2, 1, 1, 1] and found.edges.tolist() == [0, 1, 2, 3, 4]
    assert len(rc.analysis.patches(np.zeros((3, 3)), pitch=1.0)) == 0
    for bins in (0, -3):
        refused(rc.ArgumentError, "bins", rc.analysis.histogram, P, bins, pitch=1.0)
    wrapping = np.array([[c == "#" for c in row] for row in ("#.##", "#.##", "..##", "####", "#...")], float)
    assert str(rc.analysis.crossing(wrapping, periodic=True)) == (
        "the contact crosses along x (with y periodic) and along y (with x periodic), the gap along x (with y periodic)"
    )
    assert str(rc.analysis.crossing(wrapping)).endswith("the gap along no axis")


def test_results_have_them_and_what_the_command_prints(rough):
    mask = rough.heights < 1.5e-7
    result = rc.solve(rough, modulus=1e9, approach=8e-8, mask=mask, want_gap=True)
    found, area = result.find_patches(), result.measure_area()
    assert area.area == pytest.approx(result.contact_area) and found.load.sum() == pytest.approx(result.load)
    assert result.patches == len(found) == len(rc.analysis.patches(result.pressure, pitch=1e-6, periodic=True, mask=mask))
    assert result.largest_patch == found.area.max() and result.histogram(20).contacts == result.contacts
    assert result.area_fraction == result.contacts / result.points and result.max_pressure == result.pressure.max()
    assert result.mean_gap == pytest.approx(result.gap[mask].mean(), rel=1e-12)
    assert result.corrected_area == area.corrected_area < result.contact_area
    crossing = rc.analysis.crossing(result.pressure, periodic=True, mask=mask)
    assert (result.contact_crosses, result.gap_crosses) == (crossing.contact, crossing.gap)
    step = rc.history(rough, modulus=1e9, approach=[8e-8], mask=mask)
    for name in ("max_pressure", "mean_gap", "corrected_area", "patches", "largest_patch", "contact_crosses", "gap_crosses", "points"):
        assert getattr(step[0], name) == getattr(step, name)[0], name
    bare = rc.solve(rough, modulus=1e9, approach=8e-8, want_pressure=False)
    refused(ValueError, "want_pressure", bare.find_patches)
    refused(ValueError, "want_pressure", getattr, bare, "patches")


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
