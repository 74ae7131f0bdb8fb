"""What is accepted for an array: every order and type, copied only where it must be; topographies; missing points."""

import numpy as np
import pytest
from conftest import MODULUS, PITCH, refused

import roughcontact as rc
from roughcontact._arrays import as_doubles


@pytest.fixture
def expected(sphere_gap):
    return rc.solve(undeformed_gap=sphere_gap, pitch=PITCH, modulus=MODULUS, boundary="free", approach=3e-7).pressure


FORMS = {
    "Fortran order": np.asfortranarray,
    "every second value": lambda gap: np.repeat(np.repeat(gap, 2, axis=0), 2, axis=1)[::2, ::2],
    "turned round": lambda gap: gap[::-1, ::-1].copy()[::-1, ::-1],
    "transposed": lambda gap: gap.T.copy().T,
    "big endian": lambda gap: gap.astype(">f8"),
    "extended": lambda gap: gap.astype(np.longdouble),
    "nested lists": lambda gap: gap.tolist(),
    "objects": lambda gap: gap.astype(object),
    "masked array without missing points": np.ma.array,
    "unaligned": lambda gap: np.frombuffer(b"." + gap.tobytes(), dtype=np.uint8)[1:].view(np.float64).reshape(gap.shape),
}


@pytest.mark.parametrize("form", FORMS)
def test_same_answer_from_every_form(form, sphere_gap, expected):
    result = rc.solve(undeformed_gap=FORMS[form](sphere_gap), pitch=PITCH, modulus=MODULUS, boundary="free", approach=3e-7)
    assert np.array_equal(result.pressure, expected)


@pytest.mark.parametrize("kind", [np.float32, np.float16, np.int64, np.uint8, np.int16, bool])
def test_types_are_converted(kind):
    gap = (np.arange(36).reshape(6, 6) % 7 > 2).astype(kind)
    result = rc.solve(undeformed_gap=gap, pitch=1.0, modulus=1.0, boundary="free", approach=1.5)
    as_float = rc.solve(undeformed_gap=gap.astype(float), pitch=1.0, modulus=1.0, boundary="free", approach=1.5)
    assert np.array_equal(result.pressure, as_float.pressure)


def test_no_copy_of_what_fits(sphere_gap):
    assert as_doubles(sphere_gap, "gap").ctypes.data == sphere_gap.ctypes.data
    assert as_doubles(sphere_gap[8:24], "gap").ctypes.data == sphere_gap[8:24].ctypes.data
    read_only = sphere_gap.copy()
    read_only.flags.writeable = False
    assert np.shares_memory(as_doubles(read_only, "gap"), read_only)
    assert not np.shares_memory(as_doubles(sphere_gap.T[:, ::2], "gap"), sphere_gap)


def test_inputs_are_left_alone(sphere_gap):
    before = sphere_gap.copy()
    start = np.ones_like(sphere_gap)
    rc.solve(undeformed_gap=sphere_gap, pitch=PITCH, modulus=MODULUS, boundary="free", approach=3e-7, start=start)
    assert np.array_equal(before, sphere_gap) and np.all(start == 1)


class Topography:
    """The part of SurfaceTopography's interface that is used."""

    def __init__(self, heights, physical_sizes, unit=None, is_periodic=False, is_uniform=True):
        self._heights, self.physical_sizes, self.unit, self.is_periodic = heights, physical_sizes, unit, is_periodic
        self.is_uniform = is_uniform

    def heights(self):
        return self._heights


GAP, ROW, HOLE = np.zeros((3, 4)), -np.linspace(-1, 1, 32) ** 2, np.ma.array(np.zeros((3, 4)), mask=np.eye(3, 4))
ONE, OF_ROW = {"pitch": 1.0, "modulus": 1.0, "approach": 1.0}, "one axis: give pitch=\\(hx, hy\\)"
ENDLESS = np.array([[0, np.inf, 0], [-1, 0, np.inf]])
FREE = rc.HalfSpace((3, 4), pitch=1.0, modulus=1.0, boundary="free")
READERS = "solve, law, prepare and budget read texts with units"
REFUSED = [
    (rc.solve, {"undeformed_gap": [[1, 2], [3]]}, ValueError, "gap"),
    (rc.solve, {"undeformed_gap": "flat"}, TypeError, "real numbers"),
    (rc.solve, {"undeformed_gap": [[1j]]}, TypeError, "complex"),
    (rc.solve, {"undeformed_gap": np.zeros((2, 3, 4))}, rc.ShapeError, "3 axes"),
    (rc.solve, {"undeformed_gap": np.zeros((0, 3))}, rc.ShapeError, "ny"),
    (rc.solve, {"undeformed_gap": [[0.0, np.nan]]}, rc.ArgumentError, "not finite"),
    (rc.solve, {"undeformed_gap": np.zeros((2, 2), "M8[s]")}, TypeError, "datetime64"),
    (rc.solve, {"undeformed_gap": HOLE}, rc.ArgumentError, "gap is a masked array with 3 masked values"),
    (rc.solve, {"undeformed_gap": GAP, "mask": np.ones((3, 4))}, TypeError, "mask holds float64"),
    (rc.solve, {"undeformed_gap": GAP, "mask": np.ones((3, 3), bool)}, rc.ShapeError, "mask has shape"),
    (rc.solve, {"undeformed_gap": GAP, "heights": GAP}, rc.ArgumentError, "given: one of heights, undeformed_gap is needed"),
    (rc.solve, {}, rc.ArgumentError, "given: one of heights, undeformed_gap is needed"),
    (rc.solve, {"undeformed_gap": GAP, "remove": "plane"}, rc.ArgumentError, "changes heights, but undeformed_gap is given"),
    (rc.solve, {"heights": GAP, "E": (1, 1), "nu": 0.3, "modulus": None}, rc.ArgumentError, "two each"),
    (rc.solve, {"heights": ENDLESS}, rc.ArgumentError, "at ix=1, iy=0"),
    (rc.solve, {"heights": ENDLESS, "missing": "exclude"}, rc.ArgumentError, "at ix=1, iy=0"),
    (rc.solve, {"heights": Topography(np.zeros(4), (4.0,), is_uniform=False), "pitch": None}, rc.ArgumentError, "uniform"),
    (rc.solve, {"heights": Topography(np.zeros(4), (4.0,)), "pitch": None}, rc.ArgumentError, "line"),
    (rc.Surface, {"heights": np.float64(1)}, rc.ShapeError, "0 axes"),
    (rc.Surface, {"heights": GAP + 0j}, TypeError, "complex"),
    (rc.Surface, {"heights": [[1, 2], [3]]}, rc.ShapeError, "heights"),
    (rc.Surface, {"heights": GAP, "pitch": (1, 2, 3)}, rc.ShapeError, "pitch has 3"),
    (rc.Surface, {"heights": np.zeros(4)}, rc.ArgumentError, "one axis"),
    (rc.Surface, {"heights": GAP, "mask": np.ones((4, 3), bool)}, rc.ShapeError, "mask has shape"),
    *((call, {"heights": ROW}, rc.ArgumentError, OF_ROW) for call in (rc.solve, rc.history)),
    *((call, {"surface": ROW}, rc.ArgumentError, OF_ROW) for call in (rc.surface.analyze, rc.surface.psd, rc.surface.power_law)),
    (rc.HalfSpace.under, {"surface": ROW, "modulus": 1.0}, rc.ArgumentError, OF_ROW),
    (rc.batch, {"undeformed_gap": -ROW}, rc.ArgumentError, OF_ROW),
    (rc.surface.cmr_advice, {"surface": ROW, "levels": 1}, rc.ArgumentError, OF_ROW),
    (rc.surface.downsample, {"surface": GAP, "filter": "median"}, rc.ArgumentError, "filter"),
    (rc.surface.downsample, {"surface": ROW, "filter": "max"}, rc.ArgumentError, OF_ROW),
    *((call, {"pressure": -ROW}, rc.ArgumentError, OF_ROW) for call in (rc.analysis.area, rc.analysis.patches)),
    (rc.analysis.histogram, {"pressure": -ROW, "bins": 4}, rc.ArgumentError, OF_ROW),
    *((rc.Contact, {"system": FREE, "options": {"tol": value}}, TypeError, "int, float or str") for value in (None, [1], 1j)),
    (rc.HalfSpace, {"shape": (4, 4), "boundary": "open"}, rc.ArgumentError, "'free', 'periodic', 'periodic-x' or 'periodic-y'"),
    (rc.HalfSpace, {"shape": (4, 4, 4)}, rc.ShapeError, "3 axes"),
    (rc.HalfSpace, {"shape": (4, 4), "pitch": (1, 2, 3)}, rc.ShapeError, "pitch has 3 values"),
    (rc.HalfSpace, {"shape": (4, 4), "pitch": "0.5um"}, rc.ArgumentError, "pitch is .*" + READERS),
    (rc.flow, {"gap": GAP, "viscosity": "1mPas", "pressure_drop": 1}, rc.ArgumentError, "viscosity is .*" + READERS),
    (rc.solve, {"undeformed_gap": GAP, "system": FREE, "modulus": None}, rc.ArgumentError, "pitch and system are both given"),
    (rc.surface.spectral, {"pitch": 1e-6, "q_rolloff": 20e-6}, rc.ArgumentError, "q_rolloff = 2e-05 is below .*2 pi / wavelength"),
    (rc.surface.spectral, {"pitch": 1e-6, "q_low": 20e-6}, rc.ArgumentError, "q_low"),
    (rc.surface.spectral, {"q_rolloff": 20.0}, rc.ArgumentError, "q_rolloff = 20 is above q_high, 3.14"),
    (rc.surface.spectral, {"q_rolloff": 2.0, "q_high": 1.0}, rc.ArgumentError, "q_rolloff = 2 is above q_high, 1"),
    (rc.direct.cmr, {"heights": ROW, "levels": 1, "modulus": 1.0, "approach": 0.1}, rc.ArgumentError, OF_ROW),
]


@pytest.mark.parametrize("call, given, error, words", REFUSED)
def test_what_is_refused(call, given, error, words):
    more = {**ONE, "approach": [1.0]} if call is rc.history else ONE if call in (rc.solve, rc.batch) else {"pitch": 1.0}
    more = {} if call is rc.Contact else {**more, "modulus": 1.0} if call is rc.HalfSpace else more
    more = {**more, "shape": (64, 64), "rms_height": 1e-7} if call is rc.surface.spectral else more
    refused(error, words, call, **{**more, **given})


def test_one_row():
    result = rc.solve(undeformed_gap=[0.0, 0.1, 1.0], pitch=(1.0, 2.0), modulus=1.0, boundary="free", approach=0.6)
    assert result.pressure.shape == (3,) and result.contacts == 2
    column = rc.solve(undeformed_gap=[[0.0], [0.1], [1.0]], pitch=(2.0, 1.0), modulus=1.0, boundary="free", approach=0.6)
    assert np.allclose(column.pressure[:, 0], result.pressure)


def test_topographies(rough):
    topography = Topography(rough.heights, (48.0, 64.0), None, True)
    result = rc.solve(topography, modulus=1e3, load=0.1)
    assert result.pressure.shape == (48, 64) and result.grid.pitch == (1.0, 1.0) and result.grid.periodic
    stretched = Topography(rough.heights, (48.0, 128.0))
    assert rc.HalfSpace.under(stretched, modulus=1.0).pitch == (2.0, 1.0)  # the last axis is 64 points on a length of 128
    assert rc.solve(stretched, modulus=1e3, load=0.1, pitch=(2.0, 1.0)).grid.pitch == (2.0, 1.0)
    refused(rc.ArgumentError, "has its own", rc.solve, stretched, modulus=1e3, load=0.1, pitch=3.0)
    assert rc.solve(Topography(rough.heights, None), modulus=1e3, load=0.1, pitch=3.0).grid.pitch == (3.0, 3.0)


def test_units_of_topographies(rough):
    micrometres = Topography(rough.heights * 1e6, (48.0, 64.0), "\u00b5m", True)
    silent = Topography(rough.heights * 1e6, (48.0, 64.0), None, True)
    plain = rc.solve(rough, modulus=1e9, load=1e-4)
    for metres in (rc.solve(micrometres, modulus=1e9, load=1e-4), rc.solve(silent, modulus=1e9, load=1e-4, unit="um")):
        assert metres.approach == pytest.approx(plain.approach, rel=1e-6)
    refused(rc.ArgumentError, "leave unit out", rc.solve, micrometres, modulus=1e9, load=1e-4, unit="m")
    sizeless = Topography(rough.heights * 1e6, None, "um")
    refused(rc.ArgumentError, "pitch has no unit", rc.solve, sizeless, pitch=1.0, modulus=1e9, load=1e-4)


@pytest.mark.parametrize("absent", ["masked", "nan"])
def test_missing_points(rough, absent):
    holes = np.zeros(rough.shape, bool)
    holes[10:14, 20:30] = holes[0, 0] = True
    holes[np.unravel_index(rough.heights.argmax(), rough.shape)] = True  # the highest point must not count
    heights = np.ma.array(rough.heights, mask=holes) if absent == "masked" else np.where(holes, np.nan, rough.heights)
    how = {"pitch": 1e-6, "modulus": 1e9, "approach": 1e-7}
    refused(rc.ArgumentError, f"{holes.sum()} missing values.*first at ix=0, iy=0;.*missing='exclude'", rc.solve, heights, **how)
    result = rc.solve(heights, **how, missing="exclude")
    present = rough.heights[~holes].max()
    by_hand = rc.solve(undeformed_gap=present - rough.heights, mask=~holes, **how)
    assert np.array_equal(result.pressure, by_hand.pressure) and result.pressure[holes].max() == 0
    assert np.array_equal(rc.solve(heights, **how, mask=~holes).pressure, by_hand.pressure)  # said by hand, nothing is missing
    refused(rc.ArgumentError, "reject, fill or exclude", rc.solve, heights, **how, missing="ignore")


@pytest.mark.parametrize("kind", [bool, np.uint8, np.int64])
def test_masks_of_every_type(sphere_gap, kind):
    mask = np.ones((64, 64), kind)
    mask[:, 32:] = 0
    result = rc.solve(undeformed_gap=sphere_gap, mask=np.asfortranarray(mask), pitch=PITCH, modulus=MODULUS, boundary="free", approach=3e-7)
    assert result.pressure[:, 32:].max() == 0 and result.pressure[:, :32].max() > 0


def test_single_arrays_are_worth_their_values(sphere_gap, tmp_path):
    stored = sphere_gap.astype(np.float32)
    file = tmp_path / "gap.f32"
    stored.tofile(file)
    mapped = np.memmap(file, np.float32, "r", shape=stored.shape)
    with rc.Contact(rc.HalfSpace(stored.shape, pitch=PITCH, modulus=MODULUS, boundary="free")) as contact:
        wide = contact.solve(undeformed_gap=stored.astype(float), approach=3e-7, warm_start=False, want_gap=True)
        for gap, borrow in ((stored, False), (mapped, True), (sphere_gap, False)):
            found = contact.solve(
                undeformed_gap=gap, approach=3e-7, warm_start=False, want_gap=True, single=True, borrow=borrow
            )
            assert found.pressure.dtype == found.gap.dtype == np.float32 and found.load == wide.load
            assert np.array_equal(found.pressure, wide.pressure.astype(np.float32))
            assert np.array_equal(found.gap, wide.gap.astype(np.float32))


def test_heights_are_gaps_upside_down(sphere_gap):
    gap = rc.solve(undeformed_gap=sphere_gap - sphere_gap.min(), pitch=PITCH, modulus=MODULUS, boundary="free", approach=3e-7)
    heights = rc.solve(-sphere_gap, pitch=PITCH, modulus=MODULUS, boundary="free", approach=3e-7)
    assert np.array_equal(gap.pressure, heights.pressure)


def test_axes_are_rows_and_columns():
    """A ridge along x on cells that are not square: what varies along the last axis has pitch hx."""
    y = np.arange(33) - 16.0
    gap = np.repeat((y**2 / 50)[:, None], 20, axis=1)
    result = rc.solve(undeformed_gap=gap, pitch=(2.0, 1.0), modulus=1.0, boundary="free", approach=1.0)
    assert result.pressure.shape == (33, 20)
    assert result.pressure[16].min() > 0 and result.pressure[0].max() == 0
    turned = rc.solve(undeformed_gap=gap.T, pitch=(1.0, 2.0), modulus=1.0, boundary="free", approach=1.0)
    assert turned.load == pytest.approx(result.load, rel=1e-7)
    assert np.allclose(turned.pressure.T, result.pressure, atol=1e-6 * result.pressure.max())


def test_accuracy_is_a_success_on_a_coarser_grid():
    surface = rc.surface.spectral((512, 512), pitch=1e-6, rms_height=1e-7, hurst=0.8, q_high=2e5)
    result = rc.solve(surface, modulus=1e9, load=1e-2, options={"accuracy": 0.2})
    assert result.status == rc.Status.WITHIN_GOAL and not result.certified
    assert result.accuracy.model_nx < 512 and result.accuracy.error_estimate <= 0.2 and result.pressure.shape == (512, 512)


#: whole numbers reach C as they are, or are refused: none loses its high bits or its fraction on the way
WHOLE = {
    "levels": lambda: rc.surface.rmd(2**32 + 8),
    "stage": lambda: rc.surface.rmd(8, stage=2**32 + 8),
    "a side of the shape": lambda: rc.surface.spectral((-(2**64) + 512, 512)),
    "seed": lambda: rc.surface.noise((4, 4), seed=2**64 + 1),
    "seed below zero": lambda: rc.surface.spectral((4, 4), seed=-1),
    "levels of advice": lambda: rc.surface.cmr_advice(rc.surface.noise((8, 8)), 2**32 + 1),
    "bins": lambda: rc.analysis.histogram(np.zeros((4, 4)), bins=-(2**64) + 200000, pitch=1.0),
    "a side": lambda: rc.HalfSpace((2**64 + 4, 4), pitch=1.0, modulus=1.0),
    "a fraction": lambda: rc.HalfSpace((2.7, 3.2), pitch=1.0, modulus=1.0),
    "text": lambda: rc.HalfSpace("44", pitch=1.0, modulus=1.0),
    "every": lambda: rc.Contact(rc.HalfSpace((4, 4), pitch=1.0, modulus=1.0), every=2**64 + 1),
    "every of one call": lambda: rc.solve(undeformed_gap=np.zeros((4, 4)), approach=1.0, every=1.5, pitch=1.0, modulus=1.0),
    "max_iter": lambda: rc.direct.nnls(np.eye(2), np.ones(2), max_iter=2**64 + 1),
    "levels of the cascade": lambda: rc.direct.cmr(np.zeros((4, 4)), approach=1.0, levels=2**64 + 2, pitch=1.0, modulus=1.0),
    "sides of coefficients": lambda: rc.kernel_coefficients("love", 2**64 + 2, 1.0),
}


@pytest.mark.parametrize("case", WHOLE)
def test_what_does_not_fit_is_refused(case):
    refused(rc.ArgumentError, "whole number is needed|the library takes", WHOLE[case])
