"""The package SurfaceTopography itself: files that it reads and this package does not, and its topographies as surfaces."""

import numpy as np
import pytest

import roughcontact as rc

topographies = pytest.importorskip("SurfaceTopography")


@pytest.fixture
def stored(tmp_path, rough):
    """A file of a format that is not ours; it says neither pitch nor unit."""
    matlab = pytest.importorskip("scipy.io")
    matlab.savemat(tmp_path / "map.mat", {"surface": rough.heights.T})  # the package's x is the first axis
    return tmp_path / "map.mat"


def test_a_file_that_only_the_other_package_reads(stored, rough):
    surface = rc.read(stored, pitch=1e-6)
    assert np.array_equal(surface.heights, rough.heights) and surface.pitch == (1e-6, 1e-6) and surface.unit == "m"
    assert surface.assumed.startswith("read by the package SurfaceTopography, as mat; lengths without a unit are in m")
    assert np.array_equal(rc.read(stored.read_bytes(), pitch=1e-6).heights, rough.heights)
    assert np.array_equal(rc.read(stored, pitch=1e-6, format="mat").heights, rough.heights)
    with pytest.raises(rc.ArgumentError, match="map.mat: the file does not say its pitch"):
        rc.read(stored)
    press = {"modulus": 1e9, "load": 1e-4}
    expected = rc.solve(rough.heights, pitch=1e-6, **press)
    assert np.array_equal(rc.solve(stored, pitch=1e-6, **press).pressure, expected.pressure)


def test_a_topography_is_a_surface(rough):
    sizes = (rough.shape[0] * 1.0, rough.shape[1] * 1.0)
    own = topographies.Topography(rough.heights * 1e6, physical_sizes=sizes, unit="um", periodic=True)
    found = rc.solve(own, modulus=1e9, load=1e-4, unit="m")
    expected = rc.solve(rough, modulus=1e9, load=1e-4)
    assert found.grid.periodic and found.approach == pytest.approx(expected.approach, rel=1e-6)
