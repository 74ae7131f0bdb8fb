"""Options, elastic constants and mean pressures as keywords; what is misspelt, contradicts or would be ignored is refused."""

import re

import numpy as np
import pytest

import roughcontact as rc
from conftest import refused

PRESS = {"modulus": 1e9, "load": 1e-4}


def test_options_are_keywords(rough):
    free = {**PRESS, "boundary": "free"}
    found = rc.solve(rough, **free, tol=1e-10, solver="polonsky-keer", backend="dense", threads=1, kernel="galerkin")
    assert (found.solver, found.backend, found.kernel, found.tolerance) == ("polonsky-keer", "dense", "galerkin", 1e-10)
    same = rc.solve(rough, **free, options={"tol": 1e-10}, solver="polonsky-keer", backend="dense", kernel="galerkin")
    assert np.array_equal(found.pressure, same.pressure)
    assert rc.solve(rough, **PRESS, haar_cg_nested=0, fft_precision="mixed").certified
    assert rc.solve(rough, **PRESS, tol=None).tolerance == rc.solve(rough, **PRESS).tolerance
    with rc.Contact(rc.HalfSpace.under(rough, modulus=1e9), tol=1e-10, nnls_pivoting="single") as contact:
        assert contact.solve(rough, load=1e-4).tolerance == 1e-10
    assert rc.history(rough, modulus=1e9, load=[1e-4], tol=1e-9).certificate[0] <= 1e-9
    assert rc.batch([rough, rough], **PRESS, threads=2, tol=1e-9).certified == 2


def test_a_misspelt_keyword_is_answered_by_the_right_one(rough):
    nearest = {"modlus": "modulus", "tolerance": "tol", "sovler": "solver", "dispacement": "approach", "max_iters": "max_iter"}
    for wrong, right in {**nearest, "force": "load", "displacement": "approach"}.items():
        says = f"solve\\(\\) got an unexpected keyword argument '{wrong}'; did you mean '{right}'"
        refused(TypeError, says, rc.solve, rough, **{wrong: 1})


def test_keywords_that_are_near_nothing_or_given_twice(rough):
    refused(TypeError, "'xyzzy'; see roughcontact.options", rc.history, rough, xyzzy=1)
    refused(rc.ArgumentError, "tol is given twice", rc.solve, rough, **PRESS, tol=1e-6, options={"tol": 1e-6})
    refused(rc.OptionError, "tol", rc.solve, rough, **PRESS, tol="much")


def test_a_surface_is_pressed_with_its_own_pitch(rough):
    """Neither a pitch that is given nor that of a half-space replaces it."""
    for call in (rc.solve, rc.history):
        refused(rc.ArgumentError, "has its own", call, rough, **PRESS, pitch=2e-6)
    refused(rc.ArgumentError, "has its own", rc.batch, [rough], **PRESS, pitch=2e-6)
    for judge in (rc.surface.analyze, rc.surface.psd, rc.plot.heights):
        refused(rc.ArgumentError, "has its own", judge, rough, pitch=2e-6)
    other = rc.HalfSpace(rough.shape, pitch=2e-6, modulus=1e9, boundary="free")
    for call, pressed in ((rc.solve, rough), (rc.batch, [rough]), (rc.batch, rough)):
        refused(rc.ArgumentError, "have the pitch", call, pressed, system=other, load=1e-4)
    with rc.Contact(other) as contact:
        refused(rc.ArgumentError, "have the pitch", contact.solve, rough, load=1e-4)
        contact.solve(rough.heights, load=1e-4)


def test_nothing_beside_a_system_is_ignored(rough):
    half_space = rc.HalfSpace.under(rough, modulus=1e9)
    for beside in ({"modulus": 2e9}, {"pitch": 1e-6}, {"boundary": "free"}, {"hardness": 1e9}, {"E": 1e9, "nu": 0.3}):
        for call in (rc.solve, rc.history, rc.batch):
            refused(rc.ArgumentError, "system are both given", call, rough, system=half_space, load=1e-4, **beside)
        refused(rc.ArgumentError, "unit and system are both given", call, rough.heights, system=half_space, load=1e-4, unit="m")


def test_modules_show_what_they_are_for():
    assert set(dir(rc)) == {*rc.__all__, "__version__"} and not any(name.startswith("_") for name in rc.__all__)
    for module in (rc.plot, rc.surface, rc.analysis, rc.direct, rc.raw):
        assert sorted(module.__all__) == dir(module) and all(hasattr(module, name) for name in module.__all__)
        for name in () if module is rc.raw else module.__all__:
            thing = getattr(module, name)  # what is shown is of this package
            assert "roughcontact" in getattr(thing, "__module__", type(thing).__module__), name
    names = {name for name in dir(rc.raw) if not name.startswith(("rc_", "RC_"))}
    assert names == {"contact_library", "surface_library", "formats_library", "flow_library", "request_library", "library_file"}


def test_help_names_every_keyword_with_its_default():
    import inspect

    text = inspect.getdoc(rc.solve)
    for name in inspect.signature(rc.solve).parameters:
        assert name == "words" or re.search(rf"^(E, )?{name}(, nu)?: ", text, re.M), name
    for name in ("load", "approach", "pressure", "hardness", "pitch", "unit", "missing", "against", "shape", "remove", "E2"):
        assert re.search(rf"^{name}: ", text, re.M), name


def test_options_are_printed_as_keywords(rough):
    options = rc.options()
    lines = str(options).splitlines()
    assert len(lines) == len(options) and all(spec.help.splitlines()[0] in line for spec, line in zip(options, lines))
    assert "tol=1e-08 (1e-16 .. 0.1): " in lines[3] and "solver='auto': " in lines[0]
    for spec, line in zip(options, lines):
        keyword, _, rest = line.partition("=")
        assert rest.startswith(repr(spec.default)), line
        rc.solve(rough, **PRESS, **({} if spec.key == "threads" else {keyword: spec.default}))
    for function in (rc.solve, rc.history, rc.batch):
        assert len(function.__doc__.splitlines()) < 60 and "fft_patience" not in function.__doc__
    assert "`roughcontact.options()`" in rc.solve.__doc__


@pytest.mark.parametrize("name", ["load", "approach", "pressure", "area"])
def test_histories_without_a_step_are_refused(rough, name):
    for call in (rc.history, rc.batch):
        refused(rc.ArgumentError, f"{name} is empty: one value for each step", call, rough, modulus=1e9, **{name: []})
    with rc.Contact(rc.HalfSpace.under(rough, modulus=1e9)) as contact:
        refused(rc.ArgumentError, f"{name} is empty", contact.history, rough, **{name: []})


@pytest.mark.parametrize("several", [[1e-7, 2e-7], (1e-7, 2e-7), np.array([1e-7, 2e-7]), np.full((2, 2), 1e-7)])
@pytest.mark.parametrize("name", ["approach", "load", "pressure", "area"])
def test_several_targets_of_one_step_name_the_history(name, several, sphere_gap, half_space):
    for call in (
        lambda: rc.solve(undeformed_gap=sphere_gap, system=half_space, **{name: several}),
        lambda: rc.Contact(half_space).solve(undeformed_gap=sphere_gap, **{name: several}),
    ):
        refused(rc.ArgumentError, rf"{name} has \d values", call)
