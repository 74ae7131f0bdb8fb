"""Arrays that name their axes and have coordinates, as xarray's do: order, pitch, unit and periodicity come from them."""

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc

KEYS = {"modulus": 1.0, "approach": 1.0}


class Labelled:
    """The part of xarray.DataArray's interface that is used."""

    def __init__(self, values, dims, coords=None, attrs=None):
        self.values, self.dims, self.attrs = np.asarray(values), tuple(dims), attrs or {}
        each = (coords or {}).items()
        self.coords = {name: value if isinstance(value, Labelled) else Labelled(value, (name,)) for name, value in each}

    def __array__(self, dtype=None, copy=None):
        return np.asarray(self.values, dtype)


def real(values, dims, coords=None, attrs=None):
    xarray = pytest.importorskip("xarray")
    known = Labelled(values, dims, coords).coords.items()
    coords = {name: (value.dims, value.values, value.attrs) for name, value in known}
    return xarray.DataArray(values, dims=dims, coords=coords, attrs=attrs)


@pytest.fixture(params=[Labelled, real], ids=["labelled", "xarray"])
def labelled(request):
    return request.param


@pytest.fixture
def heights():
    return np.random.default_rng(1).standard_normal((12, 17))


COORDS = {"y": np.arange(12) * 2.0, "x": np.arange(17) * 1.0}


def test_axes_and_pitch_are_those_of_the_coordinates(labelled, heights):
    want = rc.solve(heights, pitch=(1.0, 2.0), **KEYS)
    for thing in (labelled(heights, ("y", "x"), COORDS), labelled(heights.T, ("x", "y"), COORDS)):
        for pitch in (None, (1.0, 2.0)):
            found = rc.solve(thing, pitch=pitch, **KEYS)
            assert np.array_equal(found.pressure, want.pressure) and found.grid.pitch == (1.0, 2.0)
        refused(rc.ArgumentError, "has its own", rc.solve, thing, pitch=(5.0, 7.0), **KEYS)
        surface = rc.Surface(thing, (1.0, 2.0))
        assert np.array_equal(surface.heights, heights)
        assert rc.surface.analyze(thing) == rc.surface.analyze(heights, pitch=(1.0, 2.0))
    assert rc.HalfSpace.under(labelled(heights.T, ("x", "y"), COORDS), modulus=1.0).shape == (12, 17)


def test_gaps_masks_and_starts_are_put_in_order(labelled, heights):
    gap, mask = heights.max() - heights, heights > -1
    want = rc.solve(undeformed_gap=gap, mask=mask, pitch=(1.0, 2.0), **KEYS)
    turned, start = labelled(gap.T, ("x", "y"), COORDS), labelled(want.pressure.T, ("x", "y"))
    found = rc.solve(undeformed_gap=turned, mask=labelled(mask.T, ("x", "y")), start=start, **KEYS)
    assert found.load == pytest.approx(want.load, rel=1e-6) and found.grid.pitch == (1.0, 2.0)


def test_coordinates_that_make_no_grid(labelled, heights):
    for y in (np.arange(12.0) ** 2, np.zeros(12), np.full(12, np.nan)):
        refused(rc.ArgumentError, "not evenly spaced", rc.solve, labelled(heights, ("y", "x"), {**COORDS, "y": y}), **KEYS)
    rounded = labelled(heights, ("y", "x"), {"y": np.round(np.arange(12) / 3, 3).astype("f4"), "x": COORDS["x"][::-1]})
    assert rc.solve(rounded, **KEYS).grid.pitch == pytest.approx((1.0, 1 / 3), rel=1e-3)
    assert rc.solve(rounded, pitch=(1.0, 1 / 3), **KEYS).grid.pitch == (1.0, 1 / 3)
    refused(rc.ArgumentError, "pitch is missing", rc.solve, labelled(heights, ("y", "x"), {"x": COORDS["x"]}), **KEYS)
    refused(rc.ArgumentError, "pitch is missing", rc.solve, labelled(heights, ("y", "x")), **KEYS)
    for dims in (("a", "b"), ("time", "x")):
        refused(rc.ArgumentError, "axes are named .*; name them y and x", rc.solve, labelled(heights, dims), pitch=1.0, **KEYS)
    by_place = rc.solve(labelled(heights, ("dim_0", "dim_1")), pitch=(1.0, 2.0), **KEYS)
    assert by_place.load == rc.solve(heights, pitch=(1.0, 2.0), **KEYS).load


def test_units_and_periodicity(labelled, heights):
    metres = {name: Labelled(value * 1e-6, (name,), attrs={"units": "m"}) for name, value in COORDS.items()}
    surface = rc.Surface(heights, (1.0, 2.0), unit="um")
    thing = labelled(heights, ("y", "x"), metres, {"units": "micrometers", "periodic": True})
    found = rc.solve(thing, modulus=1.0, load=1e-12)
    assert found.grid.pitch == pytest.approx((1e-6, 2e-6)) and found.grid.periodic
    in_metres = [rc.solve(each, boundary="free", modulus=1.0, load=1e-12).approach for each in (thing, surface)]
    assert in_metres[0] == pytest.approx(in_metres[1])
    volts = labelled(heights, ("y", "x"), COORDS, {"units": "V"})
    refused(rc.ArgumentError, "the unit of the heights is 'V'", rc.solve, volts, **KEYS)
    flags = {name: Labelled(value, (name,), attrs={"periodic": int(name == "x")}) for name, value in COORDS.items()}
    assert not rc.solve(labelled(heights, ("y", "x"), flags), boundary="free", **KEYS).grid.periodic
    holes = np.where(heights > 1, np.nan, heights)
    refused(rc.ArgumentError, "missing value", rc.solve, labelled(holes.T, ("x", "y"), COORDS), **KEYS)
    excluded = rc.solve(labelled(holes.T, ("x", "y"), COORDS), missing="exclude", **KEYS)
    assert np.array_equal(excluded.grid.mask == 0, heights > 1)


def test_lists_of_arrays_and_contacts(labelled, heights):
    turned = labelled(heights.T, ("x", "y"), COORDS)
    want = rc.solve(heights, pitch=(1.0, 2.0), boundary="free", **KEYS)
    for pitch in (None, (1.0, 2.0)):
        both = rc.batch([turned, labelled(heights, ("y", "x"), COORDS)], pitch=pitch, boundary="free", **KEYS)
        assert np.allclose(np.ravel(both.load), want.load, rtol=1e-9)
    refused(rc.ArgumentError, "has its own", rc.batch, [turned, turned], pitch=1.0, boundary="free", **KEYS)
    other = labelled(heights, ("y", "x"), {**COORDS, "x": COORDS["x"] * 3})
    refused(rc.ArgumentError, "differ in pitch", rc.batch, [turned, other], boundary="free", **KEYS)
    with rc.Contact(rc.HalfSpace((12, 17), pitch=(1.0, 2.0), modulus=1.0, boundary="free")) as contact:
        assert contact.solve(turned, approach=1.0).load == pytest.approx(want.load, rel=1e-9)
        refused(rc.ArgumentError, "pitch", contact.solve, other, approach=1.0)
