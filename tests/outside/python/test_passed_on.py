"""What a caller gives reaches the C function under its name, and what C answers comes back under its name. What the numbers must be
is tested in C."""

import ctypes
import types

import numpy as np
import pytest

import roughcontact as rc
from roughcontact import raw

GAP = 1.0 + np.arange(12.0).reshape(3, 4) % 5
ERROR, MASK = np.full((3, 4), 0.01), np.array([[1, 1, 0, 1]] * 3, np.uint8)
P = np.array([[2.0, 0, 0, 1], [3.0, 0, 4, 0], [0, 0, 0, 1.0]])
HEIGHTS = np.cos(np.arange(35.0)).reshape(5, 7)
MAP = {"nx": 7, "ny": 5, "hx": 2, "hy": 3, "heights": HEIGHTS}
SEVEN = rc.Surface(HEIGHTS, (2.0, 3.0), periodic=True)
SYSTEM = rc.HalfSpace((3, 4), pitch=(2.0, 3.0), modulus=5.0, boundary="free")
GRID = {"nx": 4, "ny": 3, "hx": 2, "hy": 3}
RIGHT, START = np.array([1.0, 0.2, 0.7]), np.array([0.3, 0.0, 0.2])
SQUARE = np.eye(3) + 1
PRESS = {"pitch": (2.0, 3.0), "modulus": 5.0, "boundary": "periodic"}
CARRIED = P * MASK
KEEPS = rc.HalfSpace((3, 4), pitch=(2.0, 3.0), modulus=5.0, hardness=99.0, creep=[(0.5, 1.0)], boundary="free")  # indentation, creep
SURFACE, LOADS, TIMES = {"undeformed_gap": GAP, "mask": MASK}, np.array([1.0, 3.0, 2.0]), np.array([1.0, 1.5, 4.0])
TWO = {"undeformed_gap": np.stack([GAP, GAP[::-1]]), "mask": np.stack([MASK, 1 - MASK])}


def law():
    return rc.law(undeformed_gap=GAP, pressure=(1e-3, 1e-2), tolerance=0.1, **PRESS)


def solved(**more):
    return rc.solve(undeformed_gap=GAP, system=SYSTEM, approach=2.5, want_gap=True, stiffness=2, **more)


def with_contact(call, system=SYSTEM, **options):
    with rc.Contact(system, options=options) as contact:
        contact.solve(undeformed_gap=GAP, approach=2.5, time=1.0 if system is KEEPS else None)
        return call(contact)


#: (function of C, call, its arguments or members of its structs; None: of no interest, members of the answer that C names otherwise)
ROWS = [
    (
        "rc_flow_solve",
        lambda: rc.flow(
            GAP, pitch=(2, 3), viscosity=5, pressure_drop=7, along="y", sides="periodic", gap_error=ERROR, width=0.1, memory=1e6,
            want_potential=True,
        ),  # fmt: skip
        [
            {**GRID, "viscosity": 5, "pressure_drop": 7, "along": raw.RC_FLOW_Y, "sides": raw.RC_FLOW_PERIODIC, "gap": GAP}
            | {"gap_error": ERROR, "width": 0.1, "memory": 1e6},
            {},
        ],
        {},
    ),
    ("rc_flow_factors_find", lambda: rc.flow_factors(GAP, pitch=(2, 3), gap_error=ERROR, width=0.1, memory=1e6),
     [{**GRID, "gap": GAP, "gap_error": ERROR, "width": 0.1, "memory": 1e6}, {}], {}),
    ("rc_flow_of_result", lambda: solved().leak(viscosity=5, pressure_drop=7, along="y", load=3, width=0.5, want_potential=True),
     [{**GRID, "modulus": 5, "boundary": raw.RC_BOUNDARY_FREE}, None, {"approach": 2.5},
      {"viscosity": 5, "pressure_drop": 7, "along": raw.RC_FLOW_Y, "load": 3, "width": 0.5}, {}], {}),
    ("rc_flow_closing_pressure", lambda: rc.closing_pressure(undeformed_gap=GAP, along="y", width=0.1, mask=MASK, **PRESS),
     [{**GRID, "modulus": 5, "boundary": raw.RC_BOUNDARY_PERIODIC}, None, {"undeformed_gap": GAP, "mask": MASK},
      {"along": raw.RC_FLOW_Y, "width": 0.1}, {}], {}),
    ("rc_area_measure", lambda: rc.analysis.area(P, pitch=(2, 3), periodic="x", mask=MASK),
     [{**GRID, "boundary": raw.RC_BOUNDARY_PERIODIC_X}, P, MASK, {}], {}),
    ("rc_patches_find", lambda: rc.analysis.patches(P, pitch=(2, 3), periodic=True, mask=MASK, corners=True),
     [{**GRID, "boundary": raw.RC_BOUNDARY_PERIODIC}, P, MASK, {"neighbours": 8}], {}),
    ("rc_histogram_fill", lambda: rc.analysis.histogram(P, 4, 2.5, pitch=(2, 3), periodic="y", mask=MASK),
     [{**GRID, "boundary": raw.RC_BOUNDARY_PERIODIC_Y}, P, MASK, {"bins": 4, "upper": 2.5}], {}),
    ("rc_crossing_find", lambda: rc.analysis.crossing(P, pitch=(2, 3), mask=MASK), [{**GRID, "boundary": raw.RC_BOUNDARY_FREE}, P, MASK], {}),
    ("rc_punch_stiffness", lambda: rc.analysis.punch_stiffness(SYSTEM, MASK), [{**GRID, "modulus": 5}, MASK], {}),
    ("rc_conductance", lambda: solved().conductance(2, 3), [{**GRID, "modulus": 5}, None, 2, 3], {}),
    ("rc_contact_gradient", lambda: with_contact(lambda contact: contact.gradient(P, GAP, load=2, approach=3)),
     [None, {"dJ_dp": P, "dJ_dgap": GAP, "dJ_dload": 2, "dJ_dapproach": 3}], {"target": "dJ_dtarget", "modulus": "dJ_dmodulus"}),
    ("rc_contact_tangent", lambda: with_contact(lambda contact: contact.tangent(GAP, target=2, modulus=3)),
     [None, {"dundeformed_gap": GAP, "dtarget": 2, "dmodulus": 3}], {"load": "dload", "approach": "dapproach"}),
    ("rc_contact_solve", lambda: with_contact(lambda contact: contact.solve(**SURFACE, start=CARRIED, load=3, warm_start=False, want_gap=True)),
     [None, {**SURFACE, "control": raw.RC_CONTROL_LOAD, "target": 3, "p0": CARRIED, "warm_start": 0, "borrow": 0}, {}], {"pressure": "p"}),
    ("rc_contact_solve", lambda: with_contact(lambda contact: contact.solve(approach=2, time=1.5, borrow=True), KEEPS),
     [None, {"control": raw.RC_CONTROL_APPROACH, "target": 2, "time": 1.5, "warm_start": 1, "borrow": 1}, {}], {"pressure": "p"}),
    ("rc_contact_solve", lambda: rc.solve(**SURFACE, start=CARRIED, load=3, want_gap=True, **PRESS),
     [None, {**SURFACE, "control": raw.RC_CONTROL_LOAD, "target": 3, "p0": CARRIED}, {}], {"pressure": "p"}),
    ("rc_contact_solve_history", lambda: rc.history(**SURFACE, approach=LOADS, time=TIMES, virgin=True, creep=[(0.5, 1.0)], **PRESS),
     [None, {**SURFACE, "control": raw.RC_CONTROL_APPROACH, "targets": LOADS, "times": TIMES, "virgin": 1}], {}),
    ("rc_contact_certify",
     lambda: with_contact(lambda contact: contact.certify(CARRIED, **SURFACE, load=3, time=1.5, want_gap=True, check=False), KEEPS),
     [None, {**SURFACE, "control": raw.RC_CONTROL_LOAD, "target": 3, "time": 1.5}, {"p": CARRIED}], {"pressure": "p"}),
    ("rc_contact_restore",
     lambda: with_contact(lambda contact: contact.restore(**SURFACE, last=(CARRIED, 2, 3), before=(MASK * 1.0, 1, 4), indentation=ERROR,
                                                          creep=(np.stack([GAP, ERROR]), 1.5)), KEEPS),
     [None, {**SURFACE, "p": CARRIED, "approach": 2, "load": 3, "p_before": MASK * 1.0, "approach_before": 1, "load_before": 4,
             "indentation": ERROR, "creep": np.stack([GAP, ERROR]), "time": 1.5}], {}),
    ("rc_contact_solve_history",
     lambda: with_contact(lambda contact: contact.history(**SURFACE, load=LOADS, time=TIMES, warm_start=False, virgin=True), KEEPS),
     [None, {**SURFACE, "control": raw.RC_CONTROL_LOAD, "n": 3, "targets": LOADS, "times": TIMES, "warm_start": 0, "virgin": 1}], {}),
    ("rc_batch_solve",
     lambda: rc.batch(**TWO, system=KEEPS, start=TWO["mask"] * 1.0, load=LOADS, time=TIMES, warm_start=False, virgin=True, stiffness=True,
                      mean_gap=True, energy=True, intervals=True, keep_pressure=True),
     [{**GRID, "hardness": 99}, None, {**TWO, "control": raw.RC_CONTROL_LOAD, "n": 2, "steps": 3, "targets": LOADS, "times": TIMES,
                                       "target_stride": raw.RC_BATCH_SHARED, "mask_stride": 0, "p0": TWO["mask"] * 1.0, "warm_start": 0,
                                       "virgin": 1}], {"pressure": "p", "statuses": "status"}),
    ("rc_batch_solve", lambda: rc.batch(**SURFACE, system=SYSTEM, load=[[1.0, 3.0], [2.0, 4.0]]),
     [{**GRID}, None, {**SURFACE, "n": 2, "steps": 2, "targets": np.array([[1.0, 3], [2, 4]]), "target_stride": 0, "virgin": 0,
                       "undeformed_gap_stride": raw.RC_BATCH_SHARED, "mask_stride": raw.RC_BATCH_SHARED}], {}),
    ("rc_law_create",
     lambda: rc.law(undeformed_gap=GAP, pressure=(1e-3, 1e-2), tolerance=0.1, conductance_tolerance=0.5, bulk=700.0, mask=MASK,
                    nominal_area=110, max_nodes=13, check_status=False, **{**PRESS, "boundary": "free"}),
     [{**GRID, "modulus": 5}, None, {"p_lower": 1e-3, "p_upper": 1e-2, "tolerance": 0.1, "tolerance_conductance": 0.5, "mask": MASK,
                                     "bulk": raw.RC_LAW_BULK_GIVEN, "bulk_stiffness": 700, "area": 110, "max_nodes": 13}], {}),
    ("rc_law_export", lambda: law().export("a.csv", "abaqus", rows=20, k=(4, 5), length=2, force=3, beyond=6, mu=0.25, nu=0.5),
     [None, b"a.csv", {"format": raw.RC_LAW_ABAQUS, "rows": 20, "rho1": 1 / 4, "rho2": 1 / 5, "length": 2, "force": 3, "beyond": 6,
                       "mu": 0.25, "nu": 0.5}], {}),
    ("rc_law_gap_conductance", lambda: law().conductance(2e-3, k=(4, 5)), [None, 2e-3, 1 / 4, 1 / 5], {}),
    ("rc_law_slip", lambda: law().slip(mu=0.5, nu=0.25).rest.step(1.5, (0.1, 0.2)), [None, {"mu": 0.5, "nu": 0.25}, 1.5, None, {}], {}),
    ("rc_nnls", lambda: rc.direct.nnls(SQUARE, RIGHT, start=START, tol=1e-5, max_iter=77), [3, SQUARE, 3, RIGHT, START, None, 1e-5, 77, {}], {}),
    ("rc_gp", lambda: rc.direct.gp(np.asfortranarray(SQUARE), RIGHT.tolist()),
     [3, SQUARE, 3, RIGHT, np.zeros(3), None, rc.effective_options()["tol"], rc.effective_options()["max_iter"], {}], {}),
    ("rc_cmr", lambda: rc.direct.cmr(HEIGHTS, pitch=1, modulus=5, approach=0.5, levels=2),
     [7, 5, 1, 1, 5, HEIGHTS, 0.5, 2, rc.effective_options()["cmr.radius"], None], {}),
    ("rc_cmr", lambda: rc.direct.cmr(HEIGHTS, pitch=(2, 3), modulus=5, approach=0.5, levels=2, radius=4, inner="nnls"),
     [7, 5, 2, 3, 5, HEIGHTS, 0.5, 2, 4, b"nnls"], {}),
    ("rc_kernel_coefficients", lambda: rc.kernel_coefficients("love", (3, 4), (2.0, 1.5)), [b"love", 2, 1.5, 4, 3], {}),
    ("rc_surface_rmd",
     lambda: rc.surface.rmd(5, pitch=2, hurst=0.6, sigma=3, rms_height=4, seed=7, additions=True, stage=4, crop=False),
     [{"levels": 5, "hurst": 0.6, "sigma": 3, "rms_height": 4, "seed": 7, "additions": 1}, 4, 0], {}),
    ("rc_surface_spectral",
     lambda: rc.surface.spectral((5, 7), pitch=(2, 3), hurst=0.6, q_low=0.5, q_rolloff=0.7, q_high=0.9, rms_slope=4, fixed_amplitudes=True, seed=7),
     [{"nx": 7, "ny": 5, "hx": 2, "hy": 3, "hurst": 0.6, "q_low": 0.5, "q_rolloff": 0.7, "q_high": 0.9, "rms_slope": 4, "rms_height": 0,
       "fixed_amplitudes": 1, "seed": 7}], {}),
    ("rc_surface_analyze", lambda: rc.surface.analyze(SEVEN, trend="mean"), [{**MAP, "periodic": 1, "trend": raw.RC_SURFACE_TREND_MEAN}, {}], {}),
    ("rc_surface_psd", lambda: rc.surface.psd(HEIGHTS, pitch=(2, 3), trend="plane"), [{**MAP, "periodic": 0, "trend": raw.RC_SURFACE_TREND_PLANE}], {}),
    ("rc_surface_fit", lambda: rc.surface.power_law(HEIGHTS, pitch=(2, 3), periodic=True), [{**MAP, "periodic": 1, "trend": raw.RC_SURFACE_TREND_AUTO}, {}], {}),
    ("rc_surface_cmr_advice", lambda: rc.surface.cmr_advice(SEVEN, 1, 0.5), [MAP, 1, 0.5, {}], {}),
    ("rc_surface_downsample", lambda: rc.surface.downsample(HEIGHTS, "max", pitch=1), [7, 5, HEIGHTS, None, raw.RC_SURFACE_MAX], {}),
]  # fmt: skip
SHAPES = {
    "paraboloid": ({"radius": 4}, {"shape": raw.RC_SURFACE_PARABOLOID, "radius": 4}),
    "sphere": ({"radius": 4}, {"shape": raw.RC_SURFACE_SPHERE, "radius": 4}),
    "waves": ({"amplitude": 4, "period": (5, 6)}, {"shape": raw.RC_SURFACE_WAVES, "height": 4, "period_x": 5, "period_y": 6}),
    "pyramids": ({"height": 4, "period": (5, 6)}, {"shape": raw.RC_SURFACE_PYRAMIDS, "height": 4, "period_x": 5, "period_y": 6}),
    "noise": ({"rms_height": 4, "seed": 7}, {"shape": raw.RC_SURFACE_NOISE, "height": 4, "seed": 7}),
}
for shape, (words, members) in SHAPES.items():
    made = types.MethodType(lambda row, shape=shape: getattr(rc.surface, shape)((5, 7), pitch=(2, 3), **row), words)
    ROWS.append(("rc_surface_shape", made, [{"nx": 7, "ny": 5, "hx": 2, "hy": 3, **members}], {}))
for name in ("greedy", "polonsky_keer", "gp", "admm"):
    ROWS.append((f"rc_{name}", lambda name=name: getattr(rc.direct, name)(SQUARE, RIGHT, start=START, tol=1e-2, max_iter=77),
                 [3, SQUARE, 3, RIGHT, START, None, 1e-2, 77], {}))  # fmt: skip


def address(value):
    return ctypes.cast(value, ctypes.c_void_p).value


def heard(value):
    """A struct's members, those of structs within it too, arrays as their addresses."""
    if isinstance(value, raw.Sized):
        if hasattr(value, "memory") and hasattr(value, "data"):
            return value.data
        found = {name: heard(getattr(value, name)) for name, *_ in value._fields_}
        return {**found, **{name: each for within in found.values() if isinstance(within, dict) for name, each in within.items()}}
    return address(value) if isinstance(value, ctypes._Pointer) else value


def library_of(function):
    for library in (raw.contact_library, raw.surface_library, raw.flow_library):
        try:
            found = library()
        except rc.LibraryNotFoundError:
            pytest.skip(f"this build has no {function}")
        if hasattr(found, function):
            return found
    raise AssertionError(function)


def same(found, wanted):
    """Of arrays: the values that are there."""
    if isinstance(wanted, np.ndarray):
        return bool(found) and (ctypes.c_char * wanted.nbytes).from_address(found).raw == wanted.tobytes()
    return found == wanted


def differences(given, wanted):
    for place, (found, want) in enumerate(zip(given, wanted)):
        for name, value in want.items() if isinstance(want, dict) else [] if want is None else [("", want)]:
            if not same(found[name] if name else found, value):
                yield place, name, found[name] if name else found, value


@pytest.mark.parametrize("function, call, wanted, renamed", ROWS, ids=[f"{row[0]}-{k}" for k, row in enumerate(ROWS)])
def test_what_is_given_and_what_comes_back(function, call, wanted, renamed, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    calls, library = [], library_of(function)
    inner = getattr(library, function)

    def listening(*arguments):
        given = [heard(each) for each in arguments]
        wrong = list(differences(given, wanted))
        status = inner(*arguments)
        calls.append((given, [heard(each) for each in arguments], wrong, arguments))
        return status

    monkeypatch.setattr(library, function, listening)
    answer = call()
    given, after, wrong, arguments = calls[-1 if function != "rc_patches_find" else 0]
    assert not wrong
    values = {name: value for struct in after if isinstance(struct, dict) for name, value in struct.items()}
    fields = getattr(answer, "__dataclass_fields__", {})
    compared = 0
    for name in fields:
        source, value = renamed.get(name, name), getattr(answer, name)
        if source not in values or name in ("status", "kernel"):
            continue
        if isinstance(value, np.ndarray):
            assert value.ctypes.data == values[source] or value.size not in (12, 6, 24), name
        elif isinstance(value, str):
            assert value == values[source].decode(), name
        else:
            np.testing.assert_equal(value, values[source], err_msg=name)
        compared += 1
    assert compared or not fields or not any(isinstance(part, dict) and not part for part in wanted), "nothing of the answer was compared"
    if isinstance(answer, rc.Surface) and function != "rc_surface_downsample":
        assert answer.pitch == ((2, 2) if function == "rc_surface_rmd" else (2, 3))
        assert answer.periodic == (None if function == "rc_surface_rmd" else shape_repeats(given[0]))
    if function == "rc_surface_psd":
        assert [each.ctypes.data for each in (answer.q, answer.psd, answer.modes)] == given[1:4]
    if function == "rc_surface_fit":
        assert len(answer.peak_q) == len(answer.peak_share) == values["peaks"]
    if function in ("rc_conductance", "rc_punch_stiffness"):
        assert (answer.value, answer.lower, answer.upper) == tuple(each.value for each in arguments[-3:])


def shape_repeats(spec):
    return spec.get("shape") not in (raw.RC_SURFACE_PARABOLOID, raw.RC_SURFACE_SPHERE)


def test_systems():
    terms, matrix = [(0.1, 2.0), (0.2, 3.0)], np.eye(12) + 1
    more = {"pitch": (2.0, 3.0), "hardness": 7}
    half_space = rc.HalfSpace((3, 4), modulus=5, boundary="periodic-x", relaxation=terms, **more)
    for system, members in (
        (half_space, {"op": raw.RC_OPERATOR_HALFSPACE, "modulus": 5, "boundary": raw.RC_BOUNDARY_PERIODIC_X, "creep_by": raw.RC_CREEP_MODULI}),
        (rc.Matrix(matrix, shape=(3, 4), creep=terms, **more), {"op": raw.RC_OPERATOR_DENSE, "dense": matrix, "dense_ld": 12}),
        (rc.Product(matrix.dot, (3, 4), creep=terms, **more), {"op": raw.RC_OPERATOR_CALLBACK}),
    ):
        struct, _kept = system.struct()
        terms_of = {"creep_terms": 2, "creep_ratio": np.array([0.1, 0.2]), "creep_time": np.array([2.0, 3.0])}
        assert not list(differences([heard(struct)], [{**GRID, "hardness": 7, **terms_of, **members}]))
