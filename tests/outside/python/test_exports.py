"""Exports as instruments write them, through Python and the command: right without further words, or solved with a remark, or
refused, which name the word that makes them right."""

import json
import os
import pathlib
import struct
import subprocess
import warnings

import numpy as np
import pytest

import roughcontact as rc

NY, NX, PITCH = 12, 16, 0.5e-6
Z = np.round(1e4 * rc.surface.spectral((NY, NX), pitch=PITCH, rms_height=3e-7, hurst=0.8, seed=7).heights * 1e9) / 1e4  # [nm]
PRESS = {"E": "1GPa", "nu": "0.3", "pressure": "1MPa", "boundary": "periodic"}
TWO = "Pixel size: 0.5 um\nValue units: nm\n"
TEN = (
    "Instrument;ProfilerX 3000\nOperator;A. Smith\nDate;2024-03-11 10:22:31\n12,5;3\nObjective;50x\nNA;0.8\nX-Pixels;16\n"
    "Y-Pixels;12\nPixel size;0.5 um\nZ-Unit;nm\n"
)


def rows(separator, z=Z, comma=False, empty=""):
    fields = [[empty if np.isnan(v) else f"{v:.4f}".replace(".", "," if comma else ".") for v in row] for row in z]
    return "".join(separator.join(row) + "\n" for row in fields)


def points(order):
    """x in mm, y in um, z in nm."""
    lines = [f"{ix * 5e-4:.4f};{iy * 0.5:.2f};{Z[iy, ix]:.4f}\n" for iy in range(NY) for ix in range(NX)]
    return "X [mm];Y [um];Z [nm]\n" + "".join(lines[k] for k in order)


def tiff(values):
    """Whole numbers of 16 bits in one strip."""
    data = values.astype("<u2").tobytes()
    tags = {256: NX, 257: NY, 258: 16, 259: 1, 262: 1, 273: 8, 277: 1, 278: NY, 279: len(data)}
    entries = b"".join(struct.pack("<HHII", tag, 4, 1, value) for tag, value in tags.items())
    return b"II*\0" + struct.pack("<I", 8 + len(data)) + data + struct.pack("<H", len(tags)) + entries + bytes(4)


TILT = Z + 600 * np.arange(NX)
SPIKE, CLEAN, EMPTY, HOLES = (Z.copy() for _ in range(4))
SPIKE[5, 5] += 5e5
CLEAN[5, 5] = np.nan
EMPTY[3, 4] = EMPTY[-1, -1] = np.nan
HOLES[3:6, 4:8] = np.nan
WHOLE = np.round((Z - Z.min()) / np.ptp(Z) * 65535)


def filled(z):
    return rc.Surface(z * 1e-9, PITCH).filled().heights


#: (file, contents, its heights [m], how it ends without the word, the word and its value, the heights with it)
EXPORTS = [
    ("two_lines.csv", TWO + rows(","), Z * 1e-9, "right", {}, None),
    ("ten_lines.csv", TEN + rows(";"), Z * 1e-9, "right", {}, None),
    ("german.csv", "Breite: 8,0 µm\nHöhe: 6,0 µm\nEinheiten: nm\n" + rows(";", comma=True), Z * 1e-9, "right", {}, None),
    ("one_line.csv", "Protokoll;7\nBreite: 8,0 µm; Höhe: 6,0 µm; Einheiten: nm\n" + rows(";", comma=True), Z * 1e-9, "right", {}, None),
    ("step.csv", "Schrittweite: 0,5 µm\nEinheiten: nm\n" + rows(";", comma=True), Z * 1e-9, "right", {}, None),
    ("empty.csv", TWO + rows(",", EMPTY), None, "refused", {"missing": "fill"}, filled(EMPTY)),
    ("columns.csv", points(range(NX * NY)), Z * 1e-9, "right", {}, None),
    ("tilt.csv", TWO + rows(",", TILT), TILT * 1e-9, "remark", {"remove": "plane"}, None),
    ("spike.csv", TWO + rows(",", SPIKE), SPIKE * 1e-9, "remark", {"despike": "10"}, filled(CLEAN)),
    ("holes.csv", TWO + rows(",", HOLES, empty="bad"), None, "refused", {"missing": "fill"}, filled(HOLES)),
    ("deep.tif", tiff(WHOLE), None, "refused", {"height-range": "1.5um", "pitch": "0.5um"}, 1.5e-6 * WHOLE / 65535),
    ("any_order.csv", points(np.random.default_rng(1).permutation(NX * NY)), Z * 1e-9, "right", {}, None),
    ("bruker.txt", "Scan size: 8 um\nSamps/line: 16\nLines: 12\nZ-Unit: nm\n" + rows("\t"), Z * 1e-9, "right", {}, None),
]


def by_python(file, words):
    """(numbers, what was said) or the refusal."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            found = rc.solve(file, **PRESS, **{name.replace("-", "_"): value for name, value in words.items()})
        except rc.RoughContactError as error:
            return None, str(error)
    return (found.load, found.approach, found.contacts), found.note


def by_command(file, words):
    found = os.environ.get("ROUGHCONTACT_COMMAND") or pathlib.Path(rc.library_file()).resolve().parents[1] / "bin/roughcontact"
    if not pathlib.Path(found).exists():
        pytest.skip("the command is not beside this library")
    options = [word for name, value in {**PRESS, **words}.items() for word in ("--" + name, value)]
    line = [str(found), "solve", str(file), *options, "--quiet", "--out", str(file.parent / "out"), "--no-maps"]
    done = subprocess.run(line, capture_output=True, text=True)
    if done.returncode == 1:
        return None, done.stderr
    step = json.loads((file.parent / "out/summary.json").read_text())["steps"][0]
    return (step["load"], step["approach"], step["contacts"]), done.stderr


@pytest.mark.parametrize("door", [by_python, by_command])
@pytest.mark.parametrize("name, contents, z, ends, word, cured", EXPORTS, ids=[each[0] for each in EXPORTS])
def test_an_export(name, contents, z, ends, word, cured, door, tmp_path):
    if name.endswith(".tif") and "tiff" not in {each.name for each in rc.formats()}:
        pytest.skip("this build reads no pictures")
    file = tmp_path / name
    file.write_bytes(contents if isinstance(contents, bytes) else contents.encode())

    def right(found, heights, **how):
        found = np.array(found)
        want = rc.solve(heights, pitch=PITCH, unit="m", **PRESS, **how)
        np.testing.assert_allclose(found, (want.load, want.approach, want.contacts), rtol=1e-6)

    pitch = {key: value for key, value in word.items() if key == "pitch"}
    (named,) = [key for key in word if key != "pitch"] or [""]
    spelt = {by_python: named.replace("-", "_"), by_command: "--" + named}[door]
    numbers, said = door(file, pitch)
    assert (numbers is None) == (ends == "refused"), said
    if ends != "right":
        assert spelt in said
        numbers, _ = door(file, word)
    elif named == "":
        assert "remark" not in said
    if ends != "refused":
        right(door(file, pitch)[0], z)
    if cured is not None:
        right(numbers, cured)
    if name == "tilt.csv":
        right(numbers, z, remove="plane")
