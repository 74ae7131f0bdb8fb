"""Surfaces from files: paths, open files, bytes; what is assumed, what is missing; the help of another package."""

import importlib.util
import io
import pathlib
import sys
import types

import numpy as np
import pytest

import roughcontact as rc
from conftest import refused

TEXT = "# Width: 6 um\n# Height: 4 um\n# Value units: nm\n1 2 3\n4 nan 6\n"


@pytest.fixture
def map_file(tmp_path):
    path = tmp_path / "map.txt"
    path.write_text(TEXT)
    return path


def test_a_path(map_file):
    for given in (map_file, str(map_file)):
        surface = rc.read(given)
        assert np.allclose(surface.heights, [[1e-9, 2e-9, 3e-9], [4e-9, np.nan, 6e-9]], equal_nan=True, rtol=1e-12, atol=0)
        assert surface.pitch == pytest.approx((2e-6, 2e-6)) and surface.unit == "m" and surface.assumed == ""
        assert surface.missing.tolist() == [[False] * 3, [False, True, False]] and surface.periodic is None
    assert "3 x 2 points, pitch 2e-06, 2e-06 m, 1 missing" in repr(surface)


def test_open_files_and_bytes(map_file, tmp_path):
    expected = rc.read(map_file).heights
    with open(map_file, "rb") as file:
        assert np.array_equal(rc.read(file).heights, expected, equal_nan=True)
    with open(map_file, encoding="ascii") as file:
        refused(rc.ArgumentError, "open as text", rc.read, file)
    assert np.array_equal(rc.read(TEXT.encode(), format="text").heights, expected, equal_nan=True)
    refused(rc.ArgumentError, "unknown format", rc.read, TEXT.encode())
    z = np.arange(12.0).reshape(3, 4)
    data = io.BytesIO()
    np.save(data, z)
    data.seek(0)
    surface = rc.read(data, pitch=(1, 2), unit="um")
    assert np.allclose(surface.heights, z * 1e-6) and surface.pitch == pytest.approx((1e-6, 2e-6))
    assert surface.assumed == "lengths without a unit are in um, as asked for"


def test_the_pitch_comes_from_the_file_or_the_caller(tmp_path, map_file):
    np.save(tmp_path / "a.npy", np.zeros((3, 4)))
    refused(rc.ArgumentError, "a.npy: the file does not say its pitch; give pitch=", rc.read, tmp_path / "a.npy")
    assert rc.read(map_file, pitch=2e-6 * (1 + 1e-7)).pitch == pytest.approx((2e-6, 2e-6))
    refused(rc.ArgumentError, "1e-06 m, but .*map.txt has its own, 2e-06 m", rc.read, map_file, pitch=1e-6)


def test_what_is_refused(tmp_path, map_file):
    refused(FileNotFoundError, "absent", rc.read, tmp_path / "absent.txt")
    refused(IsADirectoryError, "directory", rc.read, tmp_path)
    refused(rc.ArgumentError, "V", rc.read, map_file, unit="V")
    refused(rc.ArgumentError, 'did you mean "x3p"', rc.read, map_file, format="x3")
    (tmp_path / "cut.txt").write_text("1 2\n3\n")
    refused(rc.ArgumentError, "cut.txt: row 2 has 1 values", rc.read, tmp_path / "cut.txt")


def test_formats_are_listed():
    found = {each.name: each for each in rc.formats()}
    assert found["sdf"].suffixes == (".sdf", ".bcr") and "gsf" in found and found["xyz"].says == "pitch"


def test_other_formats_are_left_to_surface_topography(tmp_path, monkeypatch):
    path = tmp_path / "a.opd"
    path.write_bytes(b"something")
    monkeypatch.setitem(sys.modules, "SurfaceTopography", None)
    refused(rc.ArgumentError, "unknown format.*SurfaceTopography, which is not installed", rc.read, path)

    class Reader:
        unit, physical_sizes, nb_grid_pts, is_periodic = "um", (4.0, 9.0), (2, 3), True
        default_channel = property(lambda self: self)

        def format(self):
            return "opd"

        def topography(self, **missing):
            assert missing == ({} if self.physical_sizes else {"physical_sizes": (2.0, 3.0)})
            return self

        def heights(self):
            return np.ma.array(np.arange(6.0).reshape(2, 3), mask=[[1, 0, 0], [0, 0, 0]])

    asked = []
    other = types.SimpleNamespace(open_topography=lambda file, format: asked.append((file, format)) or Reader())
    monkeypatch.setitem(sys.modules, "SurfaceTopography", other)
    surface = rc.read(path)
    assert np.isnan(surface.heights[0, 0]) and surface.heights[2, 1] == pytest.approx(5e-6)
    assert surface.pitch == pytest.approx((2e-6, 3e-6)) and surface.periodic
    assert surface.assumed == "read by the package SurfaceTopography, as opd"
    assert rc.read(path, pitch=(2, 3), unit="um").pitch == pytest.approx((2e-6, 3e-6))
    refused(rc.ArgumentError, "has its own", rc.read, path, pitch=1e-6)
    refused(rc.ArgumentError, "is um in the file, but the unit given is nm", rc.read, path, unit="nm")
    assert rc.read(b"something").pitch == surface.pitch and asked[-1][0].read() == b"something"
    assert rc.read(path, format="opd").shape == (3, 2) and asked[-1] == (str(path), "opd")
    monkeypatch.setattr(Reader, "physical_sizes", None)
    monkeypatch.setattr(Reader, "unit", None)
    refused(rc.ArgumentError, "does not say its pitch", rc.read, path)
    assert rc.solve(path, pitch=2e-6, modulus=1e9, missing="fill", approach=1.0).grid.pitch == (2e-6, 2e-6)
    assert rc.read(path, pitch=1, unit="nm").assumed.endswith("lengths without a unit are in nm")
    monkeypatch.setattr(Reader, "nb_grid_pts", (2,))
    refused(rc.ArgumentError, "it holds a profile", rc.read, path, pitch=1)

    def fails(file, format):
        raise RuntimeError("no reader")

    other.open_topography = fails
    refused(rc.ArgumentError, "nor does SurfaceTopography: RuntimeError: no reader", rc.read, path)
    refused(rc.ArgumentError, "a.opd", rc.read, path, format="sur")


def test_a_file_that_says_that_its_surface_repeats(tmp_path):
    writers_file = pathlib.Path(__file__).resolve().parents[3] / "tests/behaviour/formats/writers.py"
    if not writers_file.is_file():
        pytest.skip("the writers of surface files are not beside these tests")
    spec = importlib.util.spec_from_file_location("writers", writers_file)
    writers = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(writers)
    heights = np.arange(12.0).reshape(3, 4)
    for periodic in (0, 1):
        path = tmp_path / f"{periodic}.nc"
        path.write_bytes(writers.contact_engineering(heights, 1e-6, 1e-6, periodic=periodic))
        assert rc.read(path).periodic is bool(periodic)
        assert rc.read(path.read_bytes()).periodic is bool(periodic)


def test_files_of_other_instruments_with_a_suffix_of_ours_are_handed_over(tmp_path, monkeypatch):
    path = tmp_path / "a.dat"
    path.write_bytes(b"\x88\x1b\x03\x6f" + bytes(60))
    monkeypatch.setitem(sys.modules, "SurfaceTopography", None)
    refused(rc.ArgumentError, "a MetroPro file.*SurfaceTopography is not installed", rc.read, path)
    asked = []

    def refuses(file, format):
        asked.append(file)
        raise RuntimeError("no heights")

    monkeypatch.setitem(sys.modules, "SurfaceTopography", types.SimpleNamespace(open_topography=refuses))
    refused(rc.ArgumentError, "a MetroPro file.*nor does SurfaceTopography: RuntimeError: no heights", rc.read, path)
    (tmp_path / "b.dat").write_text("1 2\n3\n")
    refused(rc.ArgumentError, "row 2 has 1 values", rc.read, tmp_path / "b.dat")
    assert asked == [str(path)]  # our own formats are not
    for name in ("c.sur", "c.opd", "SurfaceTopography.opd"):  # whatever they are called
        (tmp_path / name).write_bytes(b"DIGITAL SURF" + bytes(20))
        refused(rc.ArgumentError, "the header of 512 bytes", rc.read, tmp_path / name)
    refused(rc.ArgumentError, "the header of 512 bytes", rc.read, b"DIGITAL SURF" + bytes(20))
    assert asked == [str(path)]
