"""Every word in every door: one answer to 1e-12, or one refusal; and none is missing in a door without a reason."""

import ctypes
import json
import os
import pathlib
import re
import shutil
import subprocess
import warnings

import numpy as np
import pytest

import roughcontact as rc
from roughcontact import raw
from roughcontact.report.run import read_arguments
from word_rows import BASE, ELASTIC, FREE, IN_TIME, NOT_IN_TIME, RIGHT, STEPS, WRONG, write_files

RANKS, LAW, ANALYZE = (getattr(raw, f"RC_CALL_{name}") for name in ("ROWS", "LAW", "ANALYZE"))
BUILD = pathlib.Path(rc.library_file()).resolve().parents[1]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    made = tmp_path_factory.mktemp("words")
    write_files(made)
    return made


@pytest.fixture
def here(folder, monkeypatch):
    monkeypatch.chdir(folder)
    return folder


def program(name="roughcontact"):
    """A program of this build; None: it has none."""
    own = os.environ.get("ROUGHCONTACT_COMMAND") if name == "roughcontact" else None
    found = pathlib.Path(own or BUILD / "bin" / name)
    return found if found.exists() else None


@pytest.fixture
def command():
    return program() or pytest.skip("this build has no command")


TABLE = []
for index in range(raw.request_library().rc_word_count()):
    TABLE.append(raw.rc_word())
    assert raw.request_library().rc_word_describe(index, TABLE[-1]) == 0
TAKEN = {word.name.decode(): word.calls for word in TABLE}


def given(change):
    return {name: value for name, value in {"surface": "surface.npy", **BASE, **change}.items() if value is not None}


def takes(call, words):
    return all(TAKEN[word] & call for word in words)


def plain(text):
    """A message without the spelling of its door."""
    text = re.sub(r"(\w+)( = |=)'([^']*)'", r"\1 \3", text)
    text = re.sub(r"^(rank 0|rc_\w+): ", "", text)
    return " ".join(text.replace("--", "").replace("opts.", "").replace("height_range", "height-range").split())


def run(command, surface, words, *more):
    options = [each for word, value in words.items() if word != "surface" for each in ("--" + word, value)]
    line = [*map(str, command), surface, *options, *more]
    return subprocess.run(line, capture_output=True, text=True)


def summary_of(words, *ranks):
    """What a run of the command wrote, or said; ranks: roughcontact-mpi instead."""
    command, how = (ranks, []) if ranks else ([program(), "solve"], ["--no-maps"])
    out = pathlib.Path(command[0]).name + ".out"
    done = run(command, words["surface"], words, "--quiet", "--out", out, *how)
    if done.returncode == 1:
        return plain(done.stderr.strip().splitlines()[-1].partition(": ")[2])
    return json.loads(pathlib.Path(out, "summary.json").read_text())


def by_command(words, *ranks):
    found = summary_of(words, *ranks)
    return found if isinstance(found, str) else tuple(found["steps"][-1][name] for name in ("load", "approach", "area_fraction"))


def of(call):
    """What a call in Python answers or says."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return call()
        except (rc.RoughContactError, OSError) as error:
            return plain(str(error))


def numbers(step):
    return step.load, step.approach, step.area_fraction


def keywords(words):
    numeric = {"tol": float, "threads": int}
    return {name.replace("-", "_"): numeric[name](value) if name in numeric else value for name, value in words.items()}


def in_python(words, timed):
    named = keywords(words)
    surface = named.pop("surface")
    if not timed:
        yield "solve", of(lambda: numbers(rc.solve(surface, stiffness=1, **named)))
    yield "history", of(lambda: numbers(rc.history(surface, stiffness=True, **named)[-1]))

    def batch():
        found = rc.batch(surface, **named)
        return found.load[0, -1], found.approach[0, -1], found.contact_area[0, -1] / found.grid.area

    if not timed or "," in words.get("load", ",") or "steps" in words:  # a batch has a target for each time
        yield "batch", of(batch)
    if not timed and "unit" in words and surface.endswith(".npy") and pathlib.Path(surface).exists():  # an array has no unit of its own
        named.pop("format", None)
        yield "array", of(lambda: numbers(rc.solve(np.load(surface), stiffness=1, **named)))


#: what ranks refuse by design: they fill no holes, and have neither factors nor the search for an area
NOT_BY_RANKS = {"missing": ("fill", "fil"), "backend": ("dense",), "boundary": ("periodic-x", "periodic-y")}


def by_ranks(words):
    taken = all(TAKEN[word] & RANKS for word in words) and words["surface"].endswith(".npy") and "pitch" in words
    names_others = any(word in words and (values is None or words[word] in values) for word, values in NOT_BY_RANKS.items())
    holes = {"holed.npy", "infinite.npy"} & set(words.values()) and "missing" not in words  # their message offers no fill
    return taken and not names_others and not holes and not words.get("against", "").endswith(".gsf")


def doors(words, ranks, timed=False):
    """(door, the last step's numbers, or what it says). ranks: whether they are asked, whose start takes half a second; timed: of doors
    that solve several steps"""
    yield from in_python(words, timed)
    if program():
        yield "command", by_command(words)
    if ranks and program("roughcontact-mpi") and (timed or by_ranks(words)):
        yield "ranks", by_command(words, program("roughcontact-mpi"))


def assert_one_answer(group, timed=False):
    """In all doors to 1e-12; of words that mean the same to what heights and units are rounded to. Returns it."""
    first, compared = None, 3 if timed else 2
    for change in group:
        found = dict(doors(given(change), timed or change is group[0], timed))
        want = found["history"]
        first = first or want
        assert not isinstance(want, str), (change, want)
        assert want[:compared] == pytest.approx(first[:compared], rel=1e-8, abs=0), (change, group)
        for door, answer in found.items():
            assert not isinstance(answer, str), (door, change, answer)
            within = 1e-8 if timed and door == "ranks" else 1e-6 if "tol" in change else 1e-12
            assert answer[:compared] == pytest.approx(want[:compared], rel=within, abs=0), (door, change)
    return first


def skip_without_pictures(word):
    if word == "height-range" and "tiff" not in {each.name for each in rc.formats()}:
        pytest.skip("this build reads no pictures")


def test_every_word_is_in_the_matrix_and_says_where_it_is_not():
    assert list(TAKEN) == list(RIGHT)
    for word in TABLE:
        assert word.help and word.form and (word.calls == 63) == (not word.why_not), word.name
        assert word.calls & ~63 == 0 and word.struct_size == ctypes.sizeof(word)


@pytest.mark.parametrize("word", [name for name in RIGHT if RIGHT[name]])
def test_the_same_answer(word, here):
    skip_without_pictures(word)
    words = given({})
    base = numbers(rc.solve(words.pop("surface"), stiffness=1, **words))
    for group in RIGHT[word]:
        first = assert_one_answer(group)
        if {} not in group and word not in ("solver", "backend", "tol", "pitch", "despike"):
            assert first[:2] != pytest.approx(base[:2], rel=1e-6), f"{group[0]} changes nothing"


@pytest.mark.parametrize("word", WRONG)
def test_the_same_refusal(word, here):
    skip_without_pictures(word)
    for change, says in WRONG[word]:
        found = dict(doors(given(change), change is WRONG[word][0][0]))
        found.pop("array", None)  # its map is named otherwise
        assert all(isinstance(said, str) for said in found.values()), (change, found)
        if "one step is solved here" in found["solve"]:  # a list, of which the others read the values
            found.pop("solve")
        for door, text in found.items():
            found[door] = re.sub(r", (or )?area| or area", "", text).replace("load, pressure", "load or pressure")
        assert len(set(found.values())) == 1 and says in found["history"], (change, found)


RESIDUALS = {"seconds", "setup_seconds", "note", "duality_gap", "kkt_primal", "kkt_dual", "kkt_complementarity", "kkt_control"}


OTHERS = {"hardness": "5MPa"}, {"surface": "holed.npy", "missing": "exclude", **FREE}  # bodies with columns of their own


@pytest.mark.parametrize("word, text, values, change", [(*row, {}) for row in STEPS] + [(*STEPS[2], change) for change in OTHERS])
def test_the_same_steps(word, text, values, change, here, command):
    words = given({"load": None, word: text, **change})
    written = summary_of(words)
    surface = words.pop("surface")
    history, batch = rc.history(surface, **words), rc.batch(surface, **words)
    assert written["input"]["targets"] == list(history.targets) == pytest.approx(values, rel=1e-12, abs=0)
    assert written["input"]["control"] == history.prescribed == word
    assert batch.approach[0] == pytest.approx(history.approach, rel=1e-12, abs=0)
    columns = rc.history(surface, **words, stiffness=True, want_gap=True, resumable=1)._columns()
    for k, step in enumerate(written["steps"]):
        assert len(step) > 45
        for name in set(step) - RESIDUALS:
            own = columns[name][k]
            if isinstance(own, str):
                assert {"OK": "RC_OK"}.get(own, own) == step[name], name
            else:
                assert np.isnan(own) if step[name] is None else step[name] == pytest.approx(own, rel=1e-6), name


@pytest.mark.parametrize("group", IN_TIME)
def test_the_same_answer_in_time(group, here):
    assert_one_answer(group, True)


@pytest.mark.parametrize("change, says", NOT_IN_TIME)
def test_the_same_refusal_in_time(change, says, here):
    found = dict(doors(given(change), True, True))
    found.pop("batch", None)  # its times may differ from contact to contact
    assert len(set(found.values())) == 1 and says in found["history"], (change, found)
    assert not pathlib.Path("roughcontact.out", "pressure-1.npy").exists()


def test_one_step_has_no_time(here):
    with pytest.raises(TypeError, match="creep"):
        rc.solve("surface.npy", **BASE, creep="1:1")


def test_an_analysis_has_every_number(here, command):
    words = {"pitch": "1um,2um", "unit": "m", "boundary": "periodic"}
    done = run([command, "analyze"], "surface.npy", words, "--json", "analysis.json", "--levels", "2", "--approach", "50nm")
    assert done.returncode == 0, done.stderr
    written = json.loads(pathlib.Path("analysis.json").read_text())
    surface = rc.Surface(np.load("surface.npy"), (1e-6, 2e-6), periodic=True)
    parts = {
        "statistics": rc.surface.analyze(surface),
        "spectrum": rc.surface.power_law(surface),
        "cmr": rc.surface.cmr_advice(surface, 2, 50e-9),
    }
    for part, found in parts.items():
        for name in set(vars(found)) & set(written[part]):
            value, own = written[part][name], getattr(found, name)
            assert value == own or np.isnan(own) if value is None or isinstance(own, (str, bool)) else value == pytest.approx(own), name
    assert len(set(vars(parts["statistics"])) & set(written["statistics"])) > 7
    spectrum = rc.surface.psd(surface)
    assert written["psd"]["C"] == pytest.approx(spectrum.psd.tolist()) and written["psd"]["modes"] == spectrum.modes.tolist()
    assert written["psd"]["q"] == pytest.approx(spectrum.q.tolist())


@pytest.mark.parametrize("call, word", [(call, word) for call in (ANALYZE, LAW) for word in RIGHT if TAKEN[word] & LAW and TAKEN[word] & call])
def test_the_same_analysis_and_law(call, word, here, command):
    skip_without_pictures(word)
    for change, *_ in RIGHT[word] if call == ANALYZE else RIGHT[word][:1] if word != "pressure" else ():
        more = {"pressure": "1kPa..3kPa"} if call == LAW else {}
        words = {name: value for name, value in given({**change, **more}).items() if TAKEN[name] & call}
        if call == ANALYZE and (words.get("boundary", "").startswith("periodic-") or words.get("missing") == "exclude"):
            continue
        how = ["--quiet", "--tolerance", "10%"] if call == LAW else []
        done = run([command, "law" if call == LAW else "analyze"], words["surface"], words, "--json", "found.json", *how)
        assert done.returncode == 0, (change, done.stderr)
        written, named = json.loads(pathlib.Path("found.json").read_text()), keywords(words)
        surface = named.pop("surface")
        if call == LAW:
            law = of(lambda: rc.law(surface, tolerance=0.1, **named))
            assert not isinstance(law, str) and written["nodes"][0]["x"] == pytest.approx(law.nodes["x"][0], rel=1e-9), (change, law)
            parts, found, within = written["law"], law.info, 1e-12
        else:
            parts, found, within = written["statistics"], vars(of(lambda: rc.surface.analyze(rc.prepare(surface, **named)))), 1e-9
        for name in ("nodes", "area", "modulus") if call == LAW else ("rms_height", "rms_slope", "skewness"):
            assert parts[name] == pytest.approx(found[name], rel=within), (change, name)


def for_octave(words):
    """A call of Octave's, which has maps as matrices of its own; None: the words are about files."""
    name, *rest = words["surface"].split(".")
    if rest != ["npy"] or {"format", "height-range"} & set(words) or "unit" not in words:
        return None
    fields = (each for word, value in words.items() if word != "surface" for each in (word.replace("-", "_"), value))
    return f"press (dlmread ('{name}.txt'), struct ({', '.join(repr(each) for each in fields)}));\n"


def test_the_same_in_octave(here, tmp_path):
    octave, built = shutil.which("octave-cli"), BUILD / "bindings/octave"
    if octave is None or not (built / "rc_solve.mex").exists():
        pytest.skip("this build has no rc_solve")
    for file in here.glob("*.npy"):
        np.savetxt(file.with_suffix(".txt"), np.load(file).T, "%.17g")
    rows = [(change, "") for word in RIGHT for group in RIGHT[word] for change in group]
    rows += [row for word in WRONG for row in WRONG[word]]
    rows += [(change, "") for group in IN_TIME for change in group if "time" in change]
    rows += [row for row in NOT_IN_TIME if "time" in row[0] and "steps" not in row[0]]
    asked = [(change, says, for_octave(given(change))) for change, says in rows]
    asked = [row for row in asked if row[2]]
    script = tmp_path / "words.m"
    script.write_text(
        "1; warning ('off');\nfunction press (z, opts)\n  try\n    [~, info] = rc_solve (z, opts);\n    "
        "printf ('%.17g %.17g\\n', info.load, info.approach);\n  catch e\n    printf ('%s\\n', e.message);\n  end\nend\n"
        + "".join(call for _, _, call in asked),
        encoding="utf-8",
    )
    done = subprocess.run([octave, "--no-init-file", "--quiet", "--path", built, script], capture_output=True, text=True)
    lines = done.stdout.splitlines()
    assert len(lines) == len(asked) > 100, done.stderr
    for (change, says, _), line in zip(asked, lines):
        if says:
            for file in ("surface.npy", "infinite.npy", "empty.npy"):  # a matrix has no name
                says = says.replace(file, "z")
            said = plain(line.partition(": ")[2])
            assert says in said or "one step is solved here" in said, (change, line)
        else:
            words = given(change)
            solve = rc.solve if "time" not in words else lambda *how, **named: rc.history(*how, **named)[-1]
            want = of(lambda: numbers(solve(np.load(words.pop("surface")), **keywords(words))))
            assert tuple(map(float, line.split())) == pytest.approx(
                want[:2], rel=1e-12 if "tol" not in change else 1e-6
            ), change


def test_words_that_a_call_does_not_take_are_refused(here):
    says = "a law is made between two pressures; nothing presses when a surface is analysed"
    assert of(lambda: rc.law("surface.npy", **{**BASE, "pressure": "1kPa..1MPa"})) == f"load is not a word of law: {says}"
    assert of(lambda: rc.prepare("surface.npy", load="1N")) == f"load is not a word of analyze: {says}"
    assert "nothing is solved" in of(lambda: rc.prepare("surface.npy", tol=1e-6))


@pytest.mark.parametrize("word", RIGHT)
def test_a_report_hands_every_word_over(word):
    words = ["surface.npy", f"--{word}", "value"]
    assert read_arguments([*words, "--out", "page.html"])[1] == words


def test_a_word_of_flow_is_a_function_here(here, command):
    written = summary_of({**given({}), "leak": "viscosity=2mPas,drop=3bar,along=y"})
    if "built without" in str(written):
        pytest.skip(written)
    written = written["steps"][0]
    words = {**given({}), "want_gap": True}
    result = rc.solve(words.pop("surface"), **words)
    leak = result.leak(viscosity=2e-3, pressure_drop=3e5, along="y")
    names = ("leak", "leak_lower", "leak_upper", "constriction")
    assert [written[name] for name in names] == pytest.approx([leak.flow, leak.lower, leak.upper, leak.constriction], rel=1e-9)
    words = {"pitch": "1um", "modulus": "1GPa", "boundary": "periodic"}
    done = run([command, "solve"], "surface.npy", {**words, "closing-pressure": "x"})
    found = rc.closing_pressure("surface.npy", **words)
    assert re.findall(r"(\S+) MPa \(proven", done.stdout) == [f"{p / 1e6:.4g}" for p in (found.lower, found.upper)]


def test_what_was_assumed_is_listed(here):
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
    bare.save("answer.npz")
    assert rc.load("answer.npz").assumed == bare.assumed


def test_the_smooth_answer_is_hertz(here):
    words = given({"shape": "sphere:R=1mm", "boundary": None, "load": "1mN"})
    found = rc.solve(words.pop("surface"), **words).smooth
    assert found.radius == pytest.approx((3 * 1e-3 * 1e-3 / (4 * 1e9)) ** (1 / 3), rel=1e-12, abs=0)
    assert rc.solve(np.zeros((8, 8)), pitch=1, modulus=1, load=1, boundary="free").smooth is None
    if program():
        (step,) = summary_of({"surface": "surface.npy", **words})["steps"]
        assert [step["smooth_" + name] for name in ("width", "approach", "max_pressure")] == pytest.approx(
            [found.width, found.approach, found.max_pressure], rel=1e-12, abs=0
        )


def test_a_layer_is_the_kernel_of_that_name(here):
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
