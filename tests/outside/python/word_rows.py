"""Rows of test_words.py: what each word may say, and what must be the same or refused."""

import struct

import numpy as np

import roughcontact as rc

SIDE, STEP = 16, 1e-6
BASE = {"pitch": "1um", "unit": "m", "modulus": "1GPa", "load": "10uN", "boundary": "periodic"}
ELASTIC = {"modulus": None, "E": "2GPa", "nu": "0.3"}
FREE = {"boundary": "free"}
BODIES = {**ELASTIC, "E2": "1GPa", "nu2": "0.2"}


def equal(word, *texts, **more):
    """Rows in which the word's values mean the same."""
    return tuple({word: text, **more} for text in texts)


def by(word, text, **more):
    return {"load": None, word: text, **more}


#: {word: groups of changes of BASE with one answer; None takes a word away}
RIGHT = {
    "surface": [({},)],
    "gap": [],
    "format": [({"format": "npy"}, {})],
    "height-range": [equal("height-range", "120nm", "0.12um", "1.2e-7", surface="grey.tif")],
    "pitch": [
        equal(
            "pitch",
            *("1um", "1e-6", "1000nm", "1 um", "1\u00b5m", "1\u03bcm", "1micron", "1e6pm", "1e9fm", "1e-3mm", "1e-4cm"),
            *("1e4A", "1e4\u00c5", "1e-9km", "1e-12Mm", "1um,1e3nm"),
        ),
        equal("pitch", "1um,2um", "1e-6,2e-6", "1um,2000nm"),
    ],
    "unit": [
        ({"surface": "micrometres.npy", **by("approach", "0.02"), "unit": "um", "pitch": "1"}, by("approach", "20nm")),
        ({"surface": "micrometres.npy", "unit": "um"}, {"surface": "micrometres.npy", "unit": "\u00b5m"}, {}),
        ({"surface": "other.gsf", "unit": "m", "pitch": None}, {"surface": "other.gsf", "unit": None, "pitch": None}),
    ],
    "missing": [({"surface": "holed.npy", "missing": "fill"},), ({"surface": "holed.npy", "missing": "exclude"},)],
    "crop": [
        ({"crop": "2um..9um,1um..12um"}, {"crop": "2e-6..9e-6,1e-6..12e-6"}, {"surface": "part.npy"}),
        equal("crop", "1um", "1um..15um,1um..15um"),
    ],
    "despike": [({"surface": "spiked.npy", "despike": "10"}, {"surface": "clean.npy", "missing": "fill"})],
    "remove": [
        ({"remove": "none"}, {"remove": "mean"}, {}),
        ({"surface": "tilted.npy", "remove": "plane"}, {"remove": "plane"}),
        ({"surface": "bowed.npy", "remove": "quadric"}, {"remove": "quadric"}),
    ],
    "against": [
        ({"against": "other.npy"}, {"surface": "other.npy", "against": "surface.npy"}, {"surface": "sum.npy"}),
        ({"against": "tilted.npy", "remove": "plane"}, {"against": "surface.npy", "remove": "plane"}),
        ({"against": "holed.npy", "missing": "fill", "remove": "plane"},),
        (
            {"against": "holed.npy", "missing": "exclude"},
            {"surface": "holed.npy", "against": "surface.npy", "missing": "exclude"},
        ),
        *(
            (
                {"surface": f"{one}.gsf", "against": f"{two}.gsf", "boundary": None, "pitch": None, "unit": None},
                {"surface": "twice.npy", "boundary": both},
            )
            for one, two, both in (
                ("repeats", "repeats", "periodic"),
                ("repeats", "ends", "free"),
                ("ends", "unknown", "free"),
                ("unknown", "repeats", "periodic"),
            )
        ),
    ],
    "mirror": [({"against": "other.npy", "mirror": axes}, {"against": f"other-{axes}.npy"}) for axes in ("x", "y", "xy")],
    "shift": [
        ({"against": "other.npy", "shift": "2um,-1um"}, {"surface": "shifted.npy"}),
        ({"against": "other.npy", "shift": "0.5um"}, {"against": "other.npy", "shift": "5e-7"}),
    ],
    "resample": [({"against": "fine.gsf", "resample": method},) for method in ("linear", "cubic")],
    "shape": [
        (
            *equal("shape", "sphere:R=1mm", "sphere:R=1e-3", boundary=None),
            {"shape": "sphere:R=1mm", **FREE},
            {"surface": "ball.npy", **FREE},
        ),
        (*equal("shape", "cylinder:R=1mm", "cylinder:axis=x,R=0.1cm", boundary=None), {"surface": "roller.npy", **FREE}),
        (*equal("shape", "cylinder:R=1mm,axis=y", boundary=None), {"surface": "turned.npy", **FREE}),
        (
            *equal("shape", "wedge:angle=1deg", "wedge:angle=0.017453292519943295rad,axis=x", boundary=None),
            {"surface": "wedge.npy", **FREE},
        ),
        (*equal("shape", "wedge:angle=1deg,axis=y", boundary=None), {"surface": "ridge.npy", **FREE}),
        ({"shape": "sphere:R=1mm", "remove": "plane", "surface": "tilted.npy"}, {"shape": "sphere:R=1mm", "remove": "plane"}),
    ],
    "modulus": [equal("modulus", "3GPa", "3e9", "0.003TPa", "3e3 MPa", "3e6kPa", "3e9Pa")],
    "E": [(ELASTIC, {**ELASTIC, "E": "2e9"}, {"modulus": repr(2e9 / (1 - 0.3**2))})],
    "nu": [({**ELASTIC, "nu": nu}, {"modulus": repr(2e9 / (1 - float(nu) ** 2))}) for nu in ("-0.5", "0", "0.5")],
    "E2": [
        (
            BODIES,
            {**ELASTIC, "E": "1GPa", "nu": "0.2", "E2": "2GPa", "nu2": "0.3"},
            {"modulus": repr(1 / (0.91 / 2e9 + 0.96 / 1e9))},
        )
    ],
    "nu2": [({**BODIES, "nu2": "0.4"},)],
    "hardness": [equal("hardness", "3MPa", "3e6")],
    "layer": [
        equal("layer", "t=2um,E=3GPa,nu=0.4", "E=3e9,nu=0.4,t=2e-6"),
        ({"layer": "t=2um,E=300MPa,nu=0.5,base=rigid,interface=frictionless", **FREE},),
        ({"layer": "t=2e-6,E=3e9,nu=0.4", **ELASTIC},),
    ],
    "approach": [equal("approach", "20nm", "0.02um", "2e-8", load=None)],
    "load": [equal("load", "20uN", "2e-5", "0.02mN", "2e-11MN", "20\u00b5N"), ({"load": "0"},)],
    "pressure": [(by("pressure", "100kPa"), by("pressure", "1e5"), {"load": repr(1e5 * (SIDE * STEP) ** 2)})],
    "area": [equal("area", "10%", "0.1", load=None)],
    "closing-pressure": [],  # see test_a_word_of_flow_is_a_function_here
    "leak": [],
    "boundary": [({"boundary": name},) for name in ("free", "periodic-x", "periodic-y")]
    + [
        ({"boundary": None}, {}),
        tuple({"surface": "ends.gsf", "pitch": None, "unit": None, "boundary": name} for name in (None, "free")),
    ],
    "kernel": [({"kernel": "love", **FREE}, FREE), ({"kernel": "spectral"}, {})],
    "solver": [({"solver": "polonsky-keer"},)],
    "backend": [({"backend": "dense"},)],
    "tol": [equal("tol", "1e-10", "1.0e-10")],
    "threads": [({"threads": "2"}, {})],
}

#: {word: (change that is refused, what the message says, in the spelling of no door)}
WRONG = {
    "surface": [
        ({"surface": "holed.npy"}, "2 missing values of 256, first at ix=4, iy=3; give missing fill"),
        ({"surface": "infinite.npy"}, "infinite"),
        ({"surface": "empty.npy"}, "missing"),
    ],
    "format": [({"format": "nonsense"}, "nonsense")],
    "height-range": [
        ({"surface": "grey.tif"}, "height-range"),
        ({"height-range": "120nm"}, "height-range"),
        ({"surface": "grey.tif", "height-range": "1MPa"}, "is a pressure, expected a length"),
    ],
    "pitch": [
        ({"pitch": "1kg"}, "not known"),
        ({"pitch": "39nmm"}, 'the unit of "39nmm" is not known (capitals count), expected a length'),
        ({"pitch": "1MPa"}, "is a pressure, expected a length"),
        ({"pitch": "nm"}, "not a number"),
        ({"pitch": "-1um"}, "not positive"),
        ({"pitch": "0"}, "not positive"),
        ({"pitch": "1um,-1um"}, "not positive"),
        ({"pitch": "1um,2um,3um"}, "pitch"),
        ({"pitch": "1um,2"}, "every number its unit"),
        ({"pitch": None}, "give pitch, one number or two, along x and y"),
        ({"surface": "other.gsf", "pitch": "3um"}, "but other.gsf has its own, 1 \u00b5m"),
    ],
    "unit": [
        ({"unit": "MPa"}, "unit"),
        ({"unit": "inch"}, "inch"),
        ({"surface": "other.gsf", "pitch": None, "unit": "um"}, "is m in the file"),
        ({"pitch": "0.02", "unit": None}, "pitch would be 20 mm, as lengths without a unit are in m"),
    ],
    "missing": [({"missing": "fil"}, "fill or exclude")],
    "crop": [({"crop": "1um..2um"}, "crop"), ({"crop": "-1um"}, "crop"), ({"crop": "9um"}, "has the middle of no cell")],
    "despike": [({"despike": "0"}, "despike"), ({"despike": "much"}, "not a number")],
    "remove": [({"remove": "parabola"}, "plane or quadric"), ({"remove": "plain"}, 'did you mean "plane"?')],
    "against": [
        (
            {"against": "narrow.npy"},
            "narrow.npy has 15 x 16 points, pitch 1 \u00b5m x 1 \u00b5m, surface.npy has 16 x 16 points",
        ),
        ({"against": "fine.gsf"}, "fine.gsf has 20 x 20 points, pitch 800 nm x 800 nm"),
        ({"against": "holed.npy"}, "2 missing values"),
    ],
    "mirror": [({"mirror": "z"}, "mirror")],
    "shift": [
        ({"against": "other.npy", "shift": "20um,0um"}, "shift"),
        ({"against": "other.npy", "shift": "1MPa"}, "expected a length"),
    ],
    "resample": [
        ({"against": "fine.gsf"}, "resample cubic"),
        ({"against": "fine.gsf", "resample": "nearest"}, "linear or cubic"),
    ],
    "shape": [
        ({"shape": text}, says)
        for text, says in (
            ("ball", "give sphere, cylinder or wedge"),
            ("spher:R=1mm", 'did you mean "sphere"?'),
            ("sphere", "has no size"),
            ("sphere:", "key=value"),
            ("sphere:1mm", "key=value"),
            ("sphere:R=0", "not positive"),
            ("sphere:R=1GPa", "is a pressure, expected a length"),
            ("sphere:r=1mm", '"r"'),
            ("sphere:R=1um", "beyond R = 1 \u00b5m"),
            ("sphere:R=1mm,axis=x", "no axis"),
            ("cylinder:axis=x", "has no size"),
            ("cylinder:R=1mm,axis=z", "x or y"),
            ("wedge:angle=5", "deg or rad"),
            ("wedge:angle=95deg", "below 90deg"),
            ("wedge:angle=5mm", "is a length, expected an angle"),
            ("wedge:R=1mm", '"R"'),
        )
    ],
    "modulus": [
        ({"modulus": "3gpa"}, "capitals"),
        ({"modulus": "1e9x"}, 'the unit of "1e9x" is not known (capitals count), expected a pressure'),
        ({"modulus": "210nm"}, "is a length, expected a pressure"),
        ({"modulus": "0"}, "not positive"),
        ({"modulus": "-5"}, "not positive"),
        ({"modulus": "nan"}, "not finite"),
        ({"modulus": None}, "modulus is missing"),
        ({**ELASTIC, "modulus": "1GPa"}, "not both"),
        ({"nu": "0.3", "modulus": "1GPa"}, "not both"),
    ],
    "E": [
        ({**ELASTIC, "E": None}, "E is missing"),
        ({**ELASTIC, "E": "1N"}, "is a force, expected a pressure"),
        ({**ELASTIC, "E": "-1"}, "not positive"),
    ],
    "nu": [
        ({**ELASTIC, "nu": None}, "nu is missing"),
        ({**ELASTIC, "nu": "0.6"}, "(-1, 0.5]"),
        ({**ELASTIC, "nu": "-1"}, "(-1, 0.5]"),
        ({**ELASTIC, "nu": "much"}, "not a number"),
    ],
    "E2": [({"modulus": None, "E2": "1GPa", "nu2": "0.3"}, "E is missing"), ({**ELASTIC, "E2": "1GPa"}, "nu2 is missing")],
    "nu2": [({**ELASTIC, "nu2": "0.3"}, "E2 is missing"), ({**BODIES, "nu2": "-1"}, "(-1, 0.5]")],
    "hardness": [({"hardness": "1m"}, "is a length, expected a pressure"), ({"hardness": "2kN"}, "is a force")],
    "layer": [
        ({"layer": "t=2um,E=3GPa"}, "nu"),
        ({"layer": "t=0,E=3GPa,nu=0.4"}, "not positive"),
        ({"layer": "t=2um,E=3GPa,nu=0.6"}, "nu"),
        ({"layer": "t=2MPa,E=3GPa,nu=0.4"}, "expected a length"),
        ({"layer": "2um"}, "give t, E, nu, base or interface"),
        ({"layer": "t=2um,E=1Pa,nu=0.3,base=soft"}, "soft"),
        ({"layer": "t=2um,E=3GPa,nu=0.4", **BODIES}, "pressed by a rigid body"),
    ],
    "approach": [
        (by("approach", "1Pa"), "is a pressure, expected a length"),
        (by("approach", "10deg"), "is an angle, expected a length"),
        (by("approach", "-1e-9"), "negative"),
        (by("approach", "nan"), "approach"),
        (by("approach", "1,,2"), "not a number"),
        ({"approach": "1nm"}, "give only one of approach and load"),
    ],
    "load": [
        ({"load": "1mm"}, "is a length, expected a force"),
        ({"load": "5MPa"}, "is a pressure, expected a force"),
        ({"load": None}, "what to press with is missing"),
        ({"load": "1uN:2uN"}, "a..b:n"),
        ({"load": "1mN,2"}, "every number its unit"),
        ({"load": "1:2mN:3"}, "every number its unit"),
        ({"load": "0..1uN:3log"}, "two ends above 0"),
        ({"load": "1uN..2uN:0"}, "whole number"),
        ({"load": "1uN..2uN:2.5"}, "whole number"),
        ({"load": "1uN..2uN:log"}, "whole number"),
        ({"load": "1uN..2uN:99999999999"}, "whole number"),
    ],
    "pressure": [
        (by("pressure", "1nm"), "is a length, expected a pressure"),
        ({"pressure": "1MPa"}, "give only one of load and pressure"),
    ],
    "area": [
        (by("area", "120%"), "more than the whole"),
        (by("area", "20"), "more than the whole"),
        (by("area", "-1%"), "negative"),
        (by("area", "1m"), "is a length, expected a share"),
        ({"area": "1%"}, "give only one of load and area"),
    ],
    "boundary": [({"boundary": "open"}, "periodic"), ({"boundary": "perodic"}, 'did you mean "periodic"?')],
    "kernel": [({"kernel": "lov"}, 'did you mean "love"?'), ({"kernel": "love"}, "love")],
    "solver": [({"solver": "polonsky"}, 'did you mean "polonsky-keer"?')],
    "backend": [({"backend": "fftt"}, 'did you mean "fft"?')],
}

#: (word, steps, their values)
STEPS = [
    ("approach", "1nm:100nm:3log", [1e-9, 1e-8, 1e-7]),
    ("approach", "30nm,10nm,20nm", [3e-8, 1e-8, 2e-8]),
    ("approach", "10nm..30nm:5", [1e-8, 1.5e-8, 2e-8, 2.5e-8, 3e-8]),
    ("load", "1uN..8uN:4log", [1e-6, 2e-6, 4e-6, 8e-6]),
    ("load", "3uN:9uN:1log", [3e-6]),
    ("load", "0,1uN", [0, 1e-6]),
    ("load", "4e-6:2e-6:2", [4e-6, 2e-6]),
    ("pressure", "100kPa:1kPa:2log", [1e5, 1e3]),
    ("area", "1%..4%:3log", [0.01, 0.02, 0.04]),
]


def tiff(values):
    """A TIFF of whole numbers of 16 bits in one strip."""
    data = values.astype("<u2").tobytes()
    tags = {256: SIDE, 257: SIDE, 258: 16, 259: 1, 262: 1, 273: 8, 277: 1, 278: SIDE, 279: len(data)}
    entries = b"".join(struct.pack("<HHII", tag, 4, 1, value) for tag, value in tags.items())
    return b"II*\0" + struct.pack("<I", 8 + len(data)) + data + struct.pack("<H", len(tags)) + entries + bytes(4)


def write_files(folder):
    """The files of the rows."""
    rough, other = (
        rc.surface.spectral((SIDE, SIDE), pitch=STEP, rms_height=1e-7, hurst=0.8, seed=seed).heights for seed in (1, 2)
    )
    x = (np.arange(SIDE) - (SIDE - 1) / 2) * STEP + np.zeros((SIDE, 1))
    y, maps = x.T, {"surface": rough, "other": other, "sum": rough + other, "twice": 2 * other}
    for name, place, value in (
        ("holed", (3, 4), np.nan),
        ("infinite", (1, 2), np.inf),
        ("spiked", (5, 6), 3e-6),
        ("clean", (5, 6), np.nan),
    ):
        maps[name] = (other if name == "holed" else rough).copy()
        maps[name][place] = value
    maps["holed"][9, 2] = np.nan
    maps.update(empty=rough * np.nan, narrow=rough[:, 1:], part=rough[1:12, 2:9], micrometres=rough * 1e6)
    maps.update(tilted=rough + 0.05 * x - 0.02 * y, bowed=rough + 900 * x**2 - 300 * x * y)
    maps.update({"other-x": other[:, ::-1], "other-y": other[::-1], "other-xy": other[::-1, ::-1]})
    maps["shifted"] = rough[:-1, 2:] + other[1:, :-2]
    maps["ball"] = rough + np.sqrt(1e-6 - x**2 - y**2) - 1e-3
    maps.update(roller=rough + np.sqrt(1e-6 - y**2) - 1e-3, turned=rough + np.sqrt(1e-6 - x**2) - 1e-3)
    slope = np.tan(np.pi / 180)
    maps.update(wedge=rough - np.abs(y) * slope, ridge=rough - np.abs(x) * slope)
    for name, z in maps.items():
        np.save(folder / f"{name}.npy", z)
    (folder / "grey.tif").write_bytes(tiff((rough - rough.min()) / np.ptp(rough) * 65535))
    fine = rc.surface.spectral((20, 20), pitch=0.8e-6, rms_height=1e-7, hurst=0.8, seed=4, q_high=1.5e6)
    rc.Surface(fine.heights, 0.8e-6, False, unit="m").save(folder / "fine.gsf")
    single = other.astype(np.float32).astype(float)
    np.save(folder / "twice.npy", 2 * single)
    for name, repeats in (("other", True), ("repeats", True), ("ends", False), ("unknown", None)):
        rc.Surface(single, STEP, repeats, unit="m").save(folder / f"{name}.gsf")
