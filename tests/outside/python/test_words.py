"""Every word in every door: the same answer to 1e-12, or the same refusal; and none is missing in a door without a reason."""

import ctypes
import json
import os
import pathlib
import re
import struct
import subprocess
import warnings

import numpy as np
import pytest

import roughcontact as rc
from roughcontact import raw

SIDE = 16
CALLS = ("solve", "history", "batch", "law", "analyze", "ranks")
BASE = {"pitch": "1um", "unit": "m", "modulus": "1GPa", "load": "10uN", "boundary": "periodic"}
LOADING = ("approach", "load", "pressure")
ELASTIC = {"modulus": None, "E": "2GPa", "nu": "0.3"}

#: {word: values that are right; None takes a word away}
RIGHT = {
    "surface": [{}],
    "gap": [],
    "format": [{"format": "npy"}],
    "height-range": [{"surface": "grey.tif", "height-range": "120nm"}, {"surface": "grey.tif", "height-range": "1.2e-7"}],
    "pitch": [{"pitch": "1um,2um"}, {"pitch": "1e-6"}, {"pitch": "1000nm"}],
    "unit": [{"unit": "um", "pitch": "1"}, {"unit": "um", "pitch": "1um", "load": "1N"}],
    "missing": [{"surface": "holed.npy", "missing": "fill"}, {"surface": "holed.npy", "missing": "exclude"}],
    "crop": [{"crop": "2um..9um,1um..12um"}, {"crop": "1um"}],
    "despike": [{"surface": "spiked.npy", "despike": "10"}],
    "remove": [{"remove": form} for form in ("none", "mean", "plane", "quadric")],
    "against": [{"against": "other.npy"}, {"against": "holed.npy", "missing": "fill", "remove": "plane"}],
    "mirror": [{"against": "other.npy", "mirror": axes} for axes in ("x", "y", "xy")],
    "shift": [{"against": "other.npy", "shift": shift} for shift in ("2um,0um", "-1um,3um", "0.5um")],
    "resample": [{"against": "fine.gsf", "resample": method} for method in ("linear", "cubic")],
    "shape": [
        {"shape": shape, "boundary": None}
        for shape in ("sphere:R=1mm", "cylinder:R=1mm", "cylinder:R=1mm,axis=y", "wedge:angle=1deg")
    ],
    "modulus": [{"modulus": "3GPa"}, {"modulus": "3e9"}],
    "E": [ELASTIC],
    "nu": [{**ELASTIC, "nu": "0.5"}],
    "E2": [{**ELASTIC, "E2": "1GPa", "nu2": "0.2"}],
    "nu2": [{**ELASTIC, "E2": "1GPa", "nu2": "0.4"}],
    "hardness": [{"hardness": "30MPa"}],
    "layer": [
        {"layer": "t=2um,E=3GPa,nu=0.4"},
        {"layer": "t=2um,E=300MPa,nu=0.5,base=rigid,interface=frictionless", "boundary": "free"},
        {"layer": "t=2e-6,E=3e9,nu=0.4", **ELASTIC},
    ],
    "approach": [{"approach": "20nm", "load": None}],
    "load": [{"load": "20uN"}, {"load": "2e-5"}],
    "pressure": [{"pressure": "100kPa", "load": None}],
    "area": [{"area": "10%", "load": None}, {"area": "0.2", "load": None}],
    "closing-pressure": [],  # see test_a_word_of_flow_is_a_function_here
    "leak": [],
    "boundary": [{"boundary": name} for name in ("free", "periodic-x", "periodic-y")],
    "kernel": [{"kernel": "love", "boundary": "free"}],
    "solver": [{"solver": "polonsky-keer"}],
    "backend": [{"backend": "dense"}],
    "tol": [{"tol": "1e-10"}],
    "threads": [{"threads": "2"}],
}
#: {word: values that are refused}
WRONG = {
    "surface": [{"surface": "holed.npy"}, {"surface": "infinite.npy"}, {"surface": "empty.npy"}],
    "format": [{"format": "nonsense"}],
    "height-range": [{"surface": "grey.tif"}, {"height-range": "120nm"}, {"surface": "grey.tif", "height-range": "1MPa"}],
    "pitch": [
        {"pitch": "1"},
        {"pitch": "1kg"},
        {"pitch": "1MPa"},
        {"pitch": "-1um"},
        {"pitch": "1um,2um,3um"},
        {"pitch": "1um,2"},
        {"pitch": None},
    ][1:],
    "unit": [{"unit": "MPa"}],
    "missing": [{"missing": "fil"}],
    "crop": [{"crop": "1um..2um"}, {"crop": "-1um"}, {"crop": "9um"}],
    "despike": [{"despike": "0"}, {"despike": "much"}],
    "remove": [{"remove": "parabola"}],
    "against": [{"against": "narrow.npy"}],
    "mirror": [{"mirror": "z"}],
    "shift": [{"against": "other.npy", "shift": "20um,0um"}, {"against": "other.npy", "shift": "1MPa"}],
    "resample": [{"against": "fine.gsf"}, {"against": "fine.gsf", "resample": "nearest"}],
    "shape": [
        {"shape": text}
        for text in (
            "ball",
            "sphere",
            "sphere:R=0",
            "sphere:R=1um",
            "sphere:R=1mm,axis=x",
            "wedge:angle=5",
            "wedge:angle=95deg",
        )
    ],
    "modulus": [{"modulus": "3gpa"}, {"modulus": "0"}, {"modulus": None}, {**ELASTIC, "modulus": "1GPa"}],
    "E": [{**ELASTIC, "E": None}, {**ELASTIC, "E": "1N"}],
    "nu": [{**ELASTIC, "nu": None}, {**ELASTIC, "nu": "0.6"}, {**ELASTIC, "nu": "much"}],
    "E2": [{"modulus": None, "E2": "1GPa", "nu2": "0.3"}, {**ELASTIC, "E2": "1GPa"}],
    "nu2": [{**ELASTIC, "nu2": "0.3"}, {**ELASTIC, "E2": "1GPa", "nu2": "-1"}],
    "hardness": [{"hardness": "1m"}],
    "layer": [
        {"layer": text}
        for text in (
            "t=2um,E=3GPa",
            "t=0,E=3GPa,nu=0.4",
            "t=2um,E=3GPa,nu=0.6",
            "t=2MPa,E=3GPa,nu=0.4",
            "2um",
            "t=2um,E=1Pa,nu=0.3,base=soft",
        )
    ]
    + [{"layer": "t=2um,E=3GPa,nu=0.4", **ELASTIC, "E2": "1GPa", "nu2": "0.3"}],
    "approach": [{"approach": "1Pa", "load": None}, {"approach": "1nm"}],
    "load": [
        {"load": "1"},
        {"load": "1mm"},
        {"load": None},
        {"load": "1uN:2uN"},
        {"load": "0..1uN:3log"},
        {"load": "1uN..2uN:0"},
    ][1:],
    "pressure": [{"pressure": "1nm", "load": None}],
    "area": [{"area": "120%", "load": None}, {"area": "1m", "load": None}],
    "boundary": [{"boundary": "open"}],
}


def tiff(values):
    """A TIFF of whole numbers of 16 bits in one strip."""
    data = values.astype("<u2").tobytes()
    tags = {256: SIDE, 257: SIDE, 258: 16, 259: 1, 262: 1, 273: 8, 277: 1, 278: SIDE, 279: len(data)}
    entries = b"".join(struct.pack("<HHII", tag, 4, 1, value) for tag, value in tags.items())
    return b"II*\0" + struct.pack("<I", 8 + len(data)) + data + struct.pack("<H", len(tags)) + entries + bytes(4)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    made = tmp_path_factory.mktemp("words")
    rough, other = (
        rc.surface.spectral((SIDE, SIDE), pitch=1e-6, rms_height=1e-7, hurst=0.8, seed=seed).heights for seed in (1, 2)
    )
    holed = other.copy()
    holed[3, 4] = holed[9, 2] = np.nan
    infinite = rough.copy()
    infinite[1, 2] = np.inf
    maps = {
        "surface": rough,
        "other": other,
        "holed": holed,
        "infinite": infinite,
        "empty": rough * np.nan,
        "narrow": rough[:, 1:],
    }
    spiked = rough.copy()
    spiked[5, 6] = 3e-6
    for name, z in {**maps, "spiked": spiked}.items():
        np.save(made / f"{name}.npy", z)
    (made / "grey.tif").write_bytes(tiff((rough - rough.min()) / np.ptp(rough) * 65535))
    fine = rc.surface.spectral((20, 20), pitch=0.8e-6, rms_height=1e-7, hurst=0.8, seed=4, q_high=1.5e6)
    rc.Surface(fine.heights, 0.8e-6, False, unit="m").save(made / "fine.gsf")
    return made


@pytest.fixture(scope="module")
def command():
    found = os.environ.get("ROUGHCONTACT_COMMAND") or pathlib.Path(rc.library_file()).resolve().parents[1] / "bin/roughcontact"
    return pathlib.Path(found)


def table():
    library, words = raw.request_library(), []
    for index in range(library.rc_word_count()):
        word = raw.rc_word()
        assert library.rc_word_describe(index, word) == 0
        words.append(word)
    return words


def given(change):
    return {name: value for name, value in {"surface": "surface.npy", **BASE, **change}.items() if value is not None}


def plain(text):
    """A message without the spelling of its door."""
    text = re.sub(r"([A-Za-z0-9]+)='([^']*)'", r"\1 \2", text)
    return " ".join(text.replace("--", "").replace("height_range", "height-range").split())


def by_command(command, folder, words):
    words = dict(words)
    options = [word for name, value in words.items() if name != "surface" for word in ("--" + name, value)]
    done = subprocess.run(
        [str(command), "solve", words["surface"], *options, "--quiet", "--out", "out", "--no-maps"],
        cwd=folder,
        capture_output=True,
        text=True,
        env={**os.environ, "PATH": "/nonexistent"},
    )
    if done.returncode == 1:
        return plain(done.stderr.strip().splitlines()[-1].partition(": ")[2])
    step = json.loads((folder / "out/summary.json").read_text())["steps"][0]
    return step["load"], step["approach"], step["area_fraction"]


def of(call):
    """What a call in Python answers or says."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return call()
        except rc.RoughContactError as error:
            return plain(str(error))


def numbers(step):
    return step.load, step.approach, step.area_fraction


def doors(folder, words):
    words = dict(words)
    surface = words.pop("surface")
    numeric = {"tol": float, "threads": int}
    named = {name.replace("-", "_"): numeric[name](value) if name in numeric else value for name, value in words.items()}
    yield "solve", of(lambda: numbers(rc.solve(surface, stiffness=1, **named)))
    yield "history", of(lambda: numbers(rc.history(surface, stiffness=True, **named)[0]))
    if (
        "unit" in words and surface.endswith(".npy") and "height-range" not in words
    ):  # as an array the surface has no unit of its own
        yield "array", of(
            lambda: numbers(rc.solve(np.load(surface), stiffness=1, **{k: v for k, v in named.items() if k != "format"}))
        )

    def batch():
        found = rc.batch(surface, **named)
        return found.load[0, 0], found.approach[0, 0], found.contact_area[0, 0]

    yield "batch", of(batch)


def test_every_word_is_in_the_matrix_and_says_where_it_is_not():
    words = table()
    assert [word.name.decode() for word in words] == list(RIGHT)
    for word in words:
        assert word.help and word.form and (word.calls == 63) == (not word.why_not), word.name
        assert word.calls & ~63 == 0 and word.struct_size == ctypes.sizeof(word)


def test_a_word_of_flow_is_a_function_here(folder, command):
    if not command.exists():
        pytest.skip("this build has no command")
    said = by_command(command, folder, {**given({}), "leak": "viscosity=2mPas,drop=3bar,along=y"})
    if "built without" in str(said):
        pytest.skip(said)
    told = json.loads((folder / "out/summary.json").read_text())["steps"][0]
    words = {**given({}), "want_gap": True}
    result = rc.solve(str(folder / words.pop("surface")), **words)
    leak = result.leak(viscosity=2e-3, pressure_drop=3e5, along="y")
    for name, value in (
        ("leak", leak.flow),
        ("leak_lower", leak.lower),
        ("leak_upper", leak.upper),
        ("constriction", leak.constriction),
    ):
        assert told[name] == pytest.approx(value, rel=1e-9), name
    done = subprocess.run(
        [
            str(command),
            "solve",
            "surface.npy",
            "--pitch",
            "1um",
            "--modulus",
            "1GPa",
            "--boundary",
            "periodic",
            "--closing-pressure",
            "x",
        ],
        cwd=folder,
        capture_output=True,
        text=True,
    )
    found = rc.closing_pressure(str(folder / "surface.npy"), pitch="1um", modulus="1GPa", boundary="periodic")
    assert re.findall(r"(\S+) MPa \(proven", done.stdout) == [f"{p / 1e6:.4g}" for p in (found.lower, found.upper)]


def skip_without_pictures(word):
    if word == "height-range" and "tiff" not in {each.name for each in rc.formats()}:
        pytest.skip("this build reads no pictures")


@pytest.mark.parametrize("word", [name for name in RIGHT if RIGHT[name]])
def test_the_same_answer(word, folder, command, monkeypatch):
    skip_without_pictures(word)
    monkeypatch.chdir(folder)
    for change in RIGHT[word]:
        words = given(change)
        found = dict(doors(folder, words))
        if command.exists():
            found["command"] = by_command(command, folder, words)
        want = found["solve"]
        assert not isinstance(want, str), (change, want)
        for door, answer in found.items():
            close = 1e-12 if "tol" not in change else 1e-6
            assert not isinstance(answer, str), (door, change, answer)
            assert answer[:2] == pytest.approx(want[:2], rel=close, abs=0), (door, change)


@pytest.mark.parametrize("word", WRONG)
def test_the_same_refusal(word, folder, command, monkeypatch):
    skip_without_pictures(word)
    monkeypatch.chdir(folder)
    for change in WRONG[word]:
        words = given(change)
        found = dict(doors(folder, words))
        found.pop("array", None)  # its map is named otherwise
        if command.exists():
            found["command"] = by_command(command, folder, words)
        assert all(isinstance(said, str) for said in found.values()), (change, found)
        said = {
            re.sub(r", (or )?area| or area", "", text).replace("load, pressure", "load or pressure") for text in found.values()
        }
        assert len(said) == 1, (change, found)


@pytest.mark.parametrize("call, how", [(rc.law, {"pressure": "1kPa..1MPa", "tolerance": 0.2}), (rc.surface.analyze, {})])
def test_words_that_a_call_does_not_take_are_refused(call, how, folder, monkeypatch):
    monkeypatch.chdir(folder)
    if call is rc.law:
        text = of(lambda: call("surface.npy", **{**BASE, "load": "1N", **how}))
        assert (
            text == "load is not a word of law: a law is made between two pressures; nothing presses when a surface is analysed"
        )
    else:
        with pytest.raises(TypeError, match="load"):
            call("surface.npy", load="1N")


def test_preparation_is_what_its_words_say(folder, monkeypatch):
    monkeypatch.chdir(folder)
    rough, other, spiked = (np.load(f"{name}.npy") for name in ("surface", "other", "spiked"))
    how = {"modulus": 1e9, "load": 1e-5, "boundary": "periodic", "pitch": "1um"}

    def same(found, heights):
        assert found.grid.shape == heights.shape
        assert found.approach == pytest.approx(rc.solve(heights, **{**how, "pitch": 1e-6}).approach, rel=1e-12, abs=0)

    same(rc.solve("surface.npy", unit="m", crop="2um..9um,1um..12um", **how), rough[1:12, 2:9])
    same(rc.solve("surface.npy", unit="m", against="other.npy", mirror="x", **how), rough + other[:, ::-1])
    same(rc.solve("surface.npy", unit="m", against="other.npy", mirror="y", **how), rough + other[::-1])
    shifted = rc.solve("surface.npy", unit="m", against="other.npy", shift="2um,-1um", **how)
    same(shifted, rough[:-1, 2:] + other[1:, :-2])
    clean = spiked.copy()
    clean[5, 6] = np.nan
    same(rc.solve("spiked.npy", unit="m", despike=10, **how), rc.Surface(clean, 1e-6).filled().heights)


def test_what_was_assumed_is_listed(folder, monkeypatch):
    monkeypatch.chdir(folder)
    bare = rc.solve("surface.npy", pitch="1um", modulus="1GPa", load="10uN", check=False)
    assert [text.split(";")[0] for text in bare.assumed] == [
        "lengths without a unit are taken in m (heights of surface.npy)",
        "boundary periodic, the map is taken as a sample of a larger surface",
    ]
    assert rc.history("surface.npy", pitch="1um", modulus="1GPa", load=["10uN"]).assumed == bare.assumed
    assert rc.batch("surface.npy", pitch="1um", modulus="1GPa", load="10uN").assumed == bare.assumed
    said = rc.solve("fine.gsf", modulus="1GPa", load="10uN").assumed
    assert said[0] == "pitch 800 nm, 800 nm, as fine.gsf says" and "boundary free" in said[1]
    assert rc.solve(np.load("surface.npy"), pitch=1e-6, modulus=1e9, load=1e-5, boundary="free").assumed == ()
    assert rc.load(saved(bare)).assumed == bare.assumed


def saved(answer):
    answer.save("answer.npz")
    return "answer.npz"


def test_the_smooth_answer_is_hertz(folder, command, monkeypatch):
    monkeypatch.chdir(folder)
    words = given({"shape": "sphere:R=1mm", "boundary": None, "load": "1mN"})
    found = rc.solve(words.pop("surface"), **words).smooth
    radius = (3 * 1e-3 * 1e-3 / (4 * 1e9)) ** (1 / 3)
    assert (found.radius, found.approach) == pytest.approx((radius, radius**2 / 1e-3), rel=1e-12, abs=0)
    assert found.max_pressure == pytest.approx(1.5e-3 / (np.pi * radius**2), rel=1e-12, abs=0)
    assert rc.solve(np.zeros((8, 8)), pitch=1, modulus=1, load=1, boundary="free").smooth is None
    if command.exists():
        by_command(command, folder, {"surface": "surface.npy", **words})
        step = json.loads((folder / "out/summary.json").read_text())["steps"][0]
        assert [step["smooth_" + name] for name in ("width", "approach", "max_pressure")] == pytest.approx(
            [found.width, found.approach, found.max_pressure], rel=1e-12, abs=0
        )


def test_metres_that_only_a_mistaken_unit_explains_are_refused(folder, monkeypatch):
    monkeypatch.chdir(folder)
    with pytest.raises(rc.ArgumentError, match="pitch would be 20 mm.*give unit"):
        rc.solve("surface.npy", pitch=0.02, modulus=1e9, load=1e-5)
    assert rc.solve("surface.npy", pitch=0.02, unit="m", modulus=1e9, load=1e-5).certified
    assert rc.solve(np.load("surface.npy"), pitch=0.02, modulus=1e9, load=1e-5).certified  # in the caller's units


def test_a_layer_is_the_kernel_of_that_name(folder, monkeypatch):
    monkeypatch.chdir(folder)
    words = given({**ELASTIC})
    words["surface"], surface = None, words["surface"]
    words = {name: value for name, value in words.items() if value is not None}
    own = {"thickness": 2e-6, "modulus": 3e9 / (1 - 0.4**2), "poisson": 0.4, "substrate_poisson": 0.3}
    want = rc.solve(surface, kernel="layer", options={f"layer.{name}": value for name, value in own.items()}, **words)
    found = rc.solve(surface, layer="t=2um,E=3GPa,nu=0.4", **words)
    assert (
        found.kernel == "layer"
        and found.approach == pytest.approx(want.approach, rel=1e-14, abs=0) != rc.solve(surface, **words).approach
    )
    assert any("Poisson's ratio 0.3" in text for text in rc.solve(surface, layer="t=2um,E=3GPa,nu=0.4", **BASE).assumed)
    with pytest.raises(rc.ArgumentError, match="layer.poisson is given twice"):
        rc.solve(surface, layer="t=2um,E=3GPa,nu=0.4", layer_poisson=0.3, **words)
    shaped = rc.solve(surface, layer="t=2um,E=3GPa,nu=0.4", shape="sphere:R=1mm", **{**words, "boundary": None})
    assert shaped.smooth is None
