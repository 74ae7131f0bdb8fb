"""Surfaces made by hand: arrays of every kind are converted, two are added, files are written and read back."""

import traceback

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc


@pytest.fixture
def whole():
    """[7, 9] heights in whole numbers, exact in every type."""
    return np.random.default_rng(3).integers(-90, 90, (7, 9)).astype(float)


def test_masked_heights_are_missing_points(whole):
    holes = np.random.default_rng(4).random(whole.shape) < 0.2
    garbage = np.where(holes, 1e9, whole)
    expected = rc.Surface(np.where(holes, np.nan, whole), (1.0, 2.0))
    for masked in (np.ma.array(garbage, mask=holes), np.ma.array(np.asfortranarray(garbage), mask=holes, dtype=np.float32)):
        surface = rc.Surface(masked, (1.0, 2.0))
        assert np.array_equal(surface.missing, holes) and "missing" in repr(surface)
        assert np.array_equal(surface.filled().heights, expected.filled().heights) and not surface.filled().missing.any()
        assert np.array_equal(surface.without("plane").heights, expected.without("plane").heights, equal_nan=True)
        by_hand = rc.solve(garbage, pitch=(1.0, 2.0), modulus=1.0, approach=9.0, mask=~holes)
        assert np.array_equal(rc.solve(surface, modulus=1.0, approach=9.0).pressure, by_hand.pressure)
        halves = [rc.surface.downsample(each, "mean").heights for each in (surface, expected)]
        assert np.array_equal(*halves, equal_nan=True)
        refused(rc.ArgumentError, "missing points", rc.surface.analyze, surface)
        refused(rc.ArgumentError, "missing points", rc.surface.analyze, masked, pitch=1.0)
    left_out = rc.Surface(np.ma.array(garbage, mask=holes), (1.0, 2.0), mask=np.arange(9) != 4 * np.ones((7, 1)))
    assert np.array_equal(left_out.missing, holes | (np.arange(9) == 4))
    two = rc.batch([np.ma.array(garbage, mask=holes), whole], pitch=(1.0, 2.0), modulus=1.0, approach=9.0, missing="exclude")
    assert np.ravel(two.load)[0] == by_hand.load  # a list forgets no masks


def test_surfaces_are_added(whole):
    one, other = rc.Surface(whole, 1e-6, True, unit="m"), rc.Surface(2e6 * whole, 1.0, None, unit="um")
    both = one + other
    assert np.allclose(both.heights, 3 * whole) and both.pitch == (1e-6, 1e-6) and both.unit == "m" and both.periodic is None
    flags = {(True, True): True, (True, False): False, (False, None): False, (None, None): None}
    for (first, second), expected in flags.items():
        assert (rc.Surface(whole, 1.0, first) + rc.Surface(whole, 1.0, second)).periodic is expected
    holed = rc.Surface(whole, 1.0, mask=whole > -80) + rc.Surface(np.where(whole > 80, np.nan, whole), 1.0)
    assert np.array_equal(holed.missing, (whole <= -80) | (whole > 80))
    refused(rc.ShapeError, "same grid", one.__add__, rc.Surface(whole[:, :4], 1e-6))
    refused(rc.ArgumentError, "same grid", one.__add__, rc.Surface(whole, 2e-6))
    refused(rc.ArgumentError, "same grid", one.__add__, rc.Surface(whole, 1.0, unit="mm"))
    with pytest.raises(TypeError):
        one + whole


@pytest.mark.parametrize("periodic", [True, False, None])
def test_files_keep_what_a_surface_is(tmp_path, whole, periodic):
    holed = np.where(whole > 80, np.nan, whole)
    thirds = holed / 3  # which single precision rounds
    for name, heights, unit, within in (
        ("a.gsf", holed, "m", 0), ("b.gsf", holed, "um", 1e-6), ("c.nc", thirds, "m", 0), ("d.NC", thirds, "m", 0), ("e.nc", thirds, "um", 1e-14)
    ):  # fmt: skip
        rc.Surface(heights, (0.1, 2.0), periodic, unit=unit).save(str(tmp_path / name))
        found = rc.read(tmp_path / name)
        again = found.in_unit(unit)
        assert np.allclose(again.heights, heights, equal_nan=True, rtol=within, atol=0) and found.unit == "m"
        assert again.pitch == pytest.approx((0.1, 2.0), rel=1e-14) and found.periodic is periodic and found.assumed == ""
    for name in ("f.gsf", "g.nc"):
        rc.Surface(whole, (0.5, 2.0), mask=whole > -80).save(tmp_path / name)
        assert (
            np.array_equal(rc.read(tmp_path / name).missing, whole <= -80)
            and "without a unit" in rc.read(tmp_path / name).assumed
        )
    rc.Surface(holed, (0.5, 2.0), periodic).save(tmp_path / "a.npy")
    array = rc.read(tmp_path / "a.npy", pitch=(0.5, 2.0))
    assert np.array_equal(array.heights, holed, equal_nan=True) and array.periodic is None
    rc.Surface([1.0, 2.0], (0.5, 2.0)).save(tmp_path / "a.gsf")
    assert rc.read(tmp_path / "a.gsf").shape == (1, 2) and rc.read(tmp_path / "a.gsf").pitch == (0.5, 2.0)


def test_files_are_whole_or_not_there(tmp_path, whole):
    path = tmp_path / "a.gsf"
    surface = rc.Surface(whole, 1.0)
    surface.save(path)
    refused(rc.ArgumentError, "unit 'furlong'", rc.Surface(whole, 1.0, unit="furlong").save, path)
    before = path.read_bytes()
    refused(rc.ArgumentError, "single precision", rc.Surface(whole * 1e300, 1.0).save, path)
    refused(rc.ArgumentError, "must end in .gsf, .nc or .npy", surface.save, tmp_path / "a.txt")
    refused(FileNotFoundError, "absent", surface.save, tmp_path / "absent" / "a.gsf")
    assert path.read_bytes() == before and [each.name for each in tmp_path.iterdir()] == ["a.gsf"]


def test_the_example_is_a_surface_that_can_be_made():
    example, wave = rc.example(), 2 * np.pi / 2.5e-6
    made = rc.surface.spectral((256, 256), pitch=4e-8, rms_height=3e-8, hurst=0.8, q_rolloff=wave, seed=1)
    assert example.unit == "m" and example.periodic is True and not example.missing.any() and example.pitch == made.pitch
    assert abs(example.heights - made.heights).max() < 1e-7 * made.heights.max()  # single precision


@pytest.mark.parametrize("call", [rc.read, lambda path: rc.solve(path, modulus=1.0, load=1.0), rc.surface.analyze])
def test_a_missing_file_has_a_short_traceback(call):
    error = refused(FileNotFoundError, "absent.gsf", call, "absent.gsf")
    assert len(traceback.extract_tb(error.__traceback__)) <= 4  # two of them in this file and in conftest
    assert error.__cause__ is None and error.__suppress_context__
