"""Every function that writes a file does so by rc_file_write, whose files tests/outside/tools/test_outputs.py looks at; names of files
that are not text."""

import ast
import inspect
import os
import pathlib
import warnings

import numpy as np
import pytest

import roughcontact as rc
from conftest import refused
from roughcontact import _paths

ODD = os.fsdecode(b"m\xfcll \xff'")  # bytes that are not text


@pytest.fixture(scope="module")
def rough_surface():
    return rc.surface.spectral((32, 32), pitch=1e-6, rms_height=5e-8, hurst=0.8, seed=3)


@pytest.fixture(scope="module")
def doors(rough_surface):
    """Calls that write to a path, by the function's public name and the path's ending."""
    steel = {"modulus": 1e9, "boundary": "periodic"}
    pressed = rc.solve(rough_surface, load=1e-5, **steel)
    path = rc.history(rough_surface, load=[1e-5, 2e-5], **steel)
    batch = rc.batch([rough_surface, rough_surface], load=[1e-5], **steel)
    law = rc.law(rough_surface, pressure=(1e3, 1e6), tolerance=0.1, **steel)
    return {
        **{("Surface.save", suffix): rough_surface.save for suffix in (".gsf", ".nc", ".npy")},
        ("Result.save", ".npz"): pressed.save,
        ("HistoryResult.save", ".npz"): path.save,
        ("BatchResult.save", ".npz"): batch.save,
        ("Law.save", ".law"): law.save,
        ("Law.export", ".csv"): lambda path: law.export(path, "csv"),
        ("Law.export", ".inp"): lambda path: law.export(path, "moose"),
        ("raw", ""): lambda path: _paths.write_file(path, b"these bytes"),
    }


def test_every_public_function_of_a_path_has_a_row(doors):
    found = set()
    for name, thing in vars(rc).items():
        members = {name: thing} if inspect.isfunction(thing) else {}
        if inspect.isclass(thing):
            members = {f"{name}.{each}": value for each, value in inspect.getmembers(thing) if not each.startswith("_")}
        for full, value in members.items():
            if (inspect.isfunction(value) or inspect.ismethod(value)) and not name.startswith("_"):
                if {"path", "file", "out", "filename"} & set(inspect.signature(value).parameters):
                    found.add(full)
    assert found == {"read", "load", "Law.load"} | {name for name, _ in doors} - {"raw"}


def test_no_module_opens_a_file_to_write():
    for file in pathlib.Path(rc.__file__).parent.rglob("*.py"):
        for call in (node for node in ast.walk(ast.parse(file.read_text())) if isinstance(node, ast.Call)):
            name = getattr(call.func, "attr", getattr(call.func, "id", ""))
            texts = [
                str(each.value)
                for each in [*call.args, *(word.value for word in call.keywords)]
                if isinstance(each, ast.Constant)
            ]
            opens = name in ("open", "fdopen") and any(
                set(text) <= set("rwxab+t") and set(text) & set("wxa+") for text in texts
            )
            assert not opens and name not in (
                "write_text",
                "write_bytes",
                "savefig",
                "to_netcdf",
                "tofile",
            ), f"{file}:{call.lineno}"


def test_exceptions_are_pythons(tmp_path, rough_surface):
    refused(FileNotFoundError, "absent", rough_surface.save, tmp_path / "absent" / "a.gsf")
    (tmp_path / "a.gsf").mkdir()
    refused(IsADirectoryError, "a.gsf", rough_surface.save, tmp_path / "a.gsf")


class Named:
    def __init__(self, name):
        self.name = os.fsencode(name)

    def __fspath__(self):
        return self.name


def test_names_that_are_not_text(doors, tmp_path):
    readers = {"Surface.save": rc.read, "Law.save": rc.Law.load, **dict.fromkeys(("Result.save", "HistoryResult.save", "BatchResult.save"), rc.load)}
    for (name, suffix), write in doors.items():
        path, pitch = tmp_path / (ODD + suffix), {"pitch": 1e-6} if suffix == ".npy" else {}
        for form in (str(path), path, os.fsencode(path), Named(path)):
            write(form)
            assert path.exists()
            if name in readers:
                assert repr(readers[name](path if isinstance(form, bytes) else form, **pitch))  # bytes are the contents of a file
            path.unlink()
        with pytest.raises((OSError, rc.ArgumentError)) as caught:
            write(tmp_path / ODD / ("a" + suffix))
        assert str(caught.value).encode(errors="backslashreplace")
    (tmp_path / (ODD + ".x")).write_text("nonsense")
    for call in (rc.Law.load, rc.load, rc.read):
        for damaged in (str(tmp_path / (ODD + ".x")), tmp_path / (ODD + ".x"), tmp_path / ODD):
            refused((OSError, ValueError), "", call, damaged)
    for folders in (str(tmp_path / ODD), tmp_path / ODD, os.fsencode(tmp_path / ODD), [str(tmp_path / ODD), tmp_path]):
        rc.Context(folders)
    refused(rc.ArgumentError, "NUL", rc.Law.load, "a\0b")
    assert _paths.shown(ODD) == "m\ufffdll \ufffd'"


@pytest.mark.parametrize("offset", [0.0, 1e-3, 1.0, -6371e3])
def test_single_precision_keeps_the_roughness(tmp_path, rough_surface, offset):
    heights = np.round(rough_surface.heights * 2**40) / 2**40 if offset < -1 else rough_surface.heights
    heights = np.where(heights > 1e-7, np.nan, heights) + offset
    for unit in ("m", "um", None):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            rc.Surface(heights, 1e-6, unit=unit).save(tmp_path / "a.gsf")
        found = rc.read(tmp_path / "a.gsf", unit=None if unit else "m").heights
        wrong = np.nanmax(np.abs(found / {"um": 1e-6}.get(unit, 1) - heights))
        assert wrong < 1e-4 * np.nanstd(heights) + 2 * np.spacing(abs(offset)), (unit, wrong)
        assert np.array_equal(np.isnan(found), np.isnan(heights))
    if offset == 0:
        assert b"ZOffset" not in (tmp_path / "a.gsf").read_bytes()


def test_roughness_that_single_precision_loses_is_told(tmp_path, rough_surface):
    y, x = np.mgrid[:32, :32]
    with pytest.warns(UserWarning, match="single precision.* of their roughness"):
        rc.Surface(rough_surface.heights + x * 1e-3, 1e-6, unit="m").save(tmp_path / "a.gsf")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for smooth in (x * 1e-3, x * 0.0, x * 0.0 + 7.3, x * 1e-3 + y + 5.0, np.full((2, 3), np.nan), [[1.0, 1.0 + 1e-9]]):
            rc.Surface(smooth, 1e-6, unit="m").save(tmp_path / "a.gsf")
            np.testing.assert_allclose(rc.read(tmp_path / "a.gsf").heights, smooth, rtol=1e-6)
