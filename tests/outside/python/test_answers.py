"""Answers as dictionaries, tables, data sets, files and pages of notebooks; histories as sequences."""

import base64
import dataclasses
import re
import sys

import numpy as np
import pytest

import roughcontact as rc
from conftest import refused


@pytest.fixture
def answers(rough):
    holes = np.ones(rough.shape, bool)
    holes[:3, :5] = False
    return (
        rc.solve(rough, modulus=1e9, load=1e-4, mask=holes, want_gap=True),
        rc.history(rough, modulus=1e9, load=[1e-4, 2e-4, 1e-4], stiffness=True, keep_pressure=True),
        rc.batch([rough, rough], modulus=1e9, load=[1e-4, 2e-4], keep_pressure=True),
    )


def same(a, b):
    if isinstance(a, np.ndarray):
        return isinstance(b, np.ndarray) and a.dtype == b.dtype and np.array_equal(a, b, equal_nan=a.dtype.kind == "f")
    if dataclasses.is_dataclass(a):
        return type(a) is type(b) and all(same(getattr(a, f.name), getattr(b, f.name)) for f in dataclasses.fields(a))
    if isinstance(a, tuple):
        return len(a) == len(b) and all(map(same, a, b))
    return type(a) is type(b) and (a == b or a != a and b != b)


def test_files_bring_the_same_answer_back(answers, tmp_path):
    for answer in answers:
        answer.save(tmp_path / "answer.npz")
        assert same(rc.load(tmp_path / "answer.npz"), answer)
    np.savez(tmp_path / "other.npz", a=1)
    refused(rc.ArgumentError, "other.npz holds no answer", rc.load, tmp_path / "other.npz")
    np.savez(tmp_path / "newer.npz", answer='{"class": "Result", "members": {"colour": 1}}')
    refused(rc.ArgumentError, "another version", rc.load, tmp_path / "newer.npz")


def test_dictionaries(answers):
    result, path, _ = answers
    found = result.to_dict()
    assert found["status"] == "OK" and found["load"] == result.load and found["pressure"] is result.pressure
    assert found["grid"]["shape"] == (48, 64) and set(found) == {f.name for f in dataclasses.fields(result)}
    assert path.to_dict()["results"][0]["load"] == path.load[0]


def test_a_history_is_a_sequence_of_steps(answers):
    path = answers[1]
    assert len(path) == 3 and [step.load for step in path] == path.load.tolist()
    last = path[-1]
    assert isinstance(last, rc.Result) and last.stiffness == path.stiffness[2] > 0
    assert np.array_equal(last.pressure, path.pressure[2]) and last.patches == last.find_patches().__len__()
    assert [step.load for step in path[1:]] == path.load[1:].tolist() and path[5:] == []
    with pytest.raises(IndexError):
        path[3]
    with pytest.raises(AttributeError, match="no attribute 'colour'"):
        path.colour  # noqa: B018


def test_tables(answers, rough):
    pytest.importorskip("pandas")
    result, path, batch = (answer.to_dataframe() for answer in answers)
    assert len(result) == 1 and result.load[0] == answers[0].load and "pressure" not in result and result.status[0] == "OK"
    assert path.index.name == "step" and path.load.tolist() == answers[1].load.tolist()
    pressed = rc.history(rough, modulus=1e9, pressure=[1e4, 3e4])
    assert list(pressed.to_dataframe())[:2] == ["pressure", "status"] and pressed.to_dataframe().pressure.tolist() == [1e4, 3e4]
    assert batch.index.names == ["contact", "step"] and batch.load.loc[1, 0] == answers[2].load[1, 0] and len(batch) == 4


def test_a_mask_is_stored_once(rough, tmp_path):
    mask = np.ones(rough.shape, bool)
    mask[0, 0] = False
    rc.history(rough, modulus=1e9, load=[1e-4] * 4, mask=mask).save(tmp_path / "history.npz")
    with np.load(tmp_path / "history.npz") as file:
        assert [name for name in file if "mask" in name] == ["results.0.grid.mask"]


def test_data_sets(answers):
    pytest.importorskip("xarray")
    result, path, batch = (answer.to_xarray() for answer in answers)
    assert (
        result.pressure.dims == ("y", "x")
        and result.x.values[1] == pytest.approx(1e-6)
        and result.attrs["load"] == answers[0].load
    )
    assert result.mask.values[0, 0] == 0 and result.gap.shape == (48, 64)
    assert path.pressure.dims == ("step", "y", "x") and path["load"].dims == ("step",)
    assert batch.pressure.dims == ("contact", "y", "x") and batch.approach.dims == ("contact", "step")


@pytest.mark.parametrize("package, method", [("pandas", "to_dataframe"), ("xarray", "to_xarray")])
def test_packages_that_are_not_installed_are_named(answers, package, method, monkeypatch):
    monkeypatch.setitem(sys.modules, package, None)
    refused(ImportError, f"{method} needs the package {package}", getattr(answers[0], method))


def test_notebooks_show_a_table_and_a_picture(answers, tmp_path):
    pages = [answer._repr_html_() for answer in answers]
    assert "certified" in pages[2] and "<svg" in pages[1] and all("OK" in page for page in pages)
    picture = base64.b64decode(re.search(r"base64,([^\"]+)", pages[0])[1])
    assert picture[:8] == b"\x89PNG\r\n\x1a\n"
    image = pytest.importorskip("matplotlib.image")
    (tmp_path / "a.png").write_bytes(picture)
    seen = image.imread(tmp_path / "a.png")
    assert seen.shape == (48, 64, 3)
    ground = np.abs(seen[..., :3] * 255 - (24, 26, 32)).max(2) < 1
    assert np.array_equal(~ground, answers[0].pressure > 0)


def test_what_is_remarked_is_shown(sphere_gap):
    how = {"undeformed_gap": sphere_gap, "pitch": 1e-6, "boundary": "free"}
    soft = rc.solve(**how, modulus=3.0, load=1e-2)
    assert "check the units" in soft.note and soft.note in repr(soft) and repr(soft).endswith("; note: " + soft.remarks + ")")
    assert "check the units; approach" in soft._repr_html_()
    assert str(rc.solve(**how, modulus=1e11, approach=-0.0).approach) == "0.0"
    quiet = rc.solve(**how, modulus=1e11, approach=1e-8)
    assert quiet.note == quiet.remarks == "" and "note" not in repr(quiet)
    worn = rc.solve(**how, modulus=1e11, hardness=1e9, approach=1e-6)
    assert worn.capped > 1 and f"1e+09 at {worn.capped} points" in worn._repr_html_() and "add hardness" not in repr(worn)
