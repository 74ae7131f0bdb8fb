"""Rows of test_words.py, from tests/outside/words.txt, and the files that they name."""

import pathlib
import struct

import numpy as np

import roughcontact as rc

SIDE, STEP = 16, 1e-6
BASE = {"pitch": "1um", "unit": "m", "modulus": "1GPa", "load": "10uN", "boundary": "periodic"}
ELASTIC = {"modulus": None, "E": "2GPa", "nu": "0.3"}
FREE = {"boundary": "free"}
TABLE = pathlib.Path(__file__).resolve().parents[1] / "words.txt"


def change(text):
    """{word: value}; None takes a word away."""
    parts = [part.strip() for part in text.split(" ; ") if part.strip() != "."]
    return dict(part.split("=", 1) if "=" in part else (part[:-1], None) for part in parts)


def table():
    """({word: groups of changes with one answer}, {word: (change, what the message says)}, (word, steps, their values), the same
    groups and changes of steps in time)"""
    right, wrong, steps, timed, untimely = {}, {}, [], [], []
    for line in TABLE.read_text("utf-8").splitlines():
        kind, _, rest = line.partition(" ")
        row, _, says = rest.rpartition(" => ")
        if line.startswith("[") and line not in ("[targets]", "[in time]"):
            word = line[1:-1]
            right[word] = []
        elif kind == "same":
            right[word].append(tuple(map(change, rest.split(" | "))))
        elif kind == "wrong":
            wrong.setdefault(word, []).append((change(row), says))
        elif kind == "steps":
            steps.append((*row.split(), [float(each) for each in says.split()]))
        elif kind == "timed":
            timed.append(tuple(map(change, rest.split(" | "))))
        elif kind == "untimely":
            untimely.append((change(row), says))
    return right, wrong, steps, timed, untimely


RIGHT, WRONG, STEPS, IN_TIME, NOT_IN_TIME = table()


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
    for name, text in (
        ("steps", "# of a press\ntime [s],load\n0,10uN\n1,1e-2mN\n\n10s,10uN\n1h,10uN\n"),
        ("elastic", "load [uN]\n10\n20\n"),
        ("short", "time,load\n0,1uN\n1\n"),
        ("nameless", "time,force\n0,1uN\n"),
        ("both", "load;approach\n1uN;1nm\n"),
        ("empty", "load\n"),
        ("back", "time\tload\n2\t1uN\n1\t1uN\n"),
    ):
        (folder / f"{name}.csv").write_text(text)
    (folder / "grey.tif").write_bytes(tiff((rough - rough.min()) / np.ptp(rough) * 65535))
    fine = rc.surface.spectral((20, 20), pitch=0.8e-6, rms_height=1e-7, hurst=0.8, seed=4, q_high=1.5e6)
    rc.Surface(fine.heights, 0.8e-6, False, unit="m").save(folder / "fine.gsf")
    single = other.astype(np.float32).astype(float)
    np.save(folder / "twice.npy", 2 * single)
    for name, repeats in (("other", True), ("repeats", True), ("ends", False), ("unknown", None)):
        rc.Surface(single, STEP, repeats, unit="m").save(folder / f"{name}.gsf")
