"""The page of a report: whole, without a network, small; and drawn by a browser, where Chromium is installed."""

import base64
import gzip
import json
import pathlib
import re
import shlex
import shutil
import struct
import subprocess
import zlib

import numpy as np
import pytest

import roughcontact as rc
from roughcontact.report import command

for name in ("jinja2", "plotly"):
    pytest.importorskip(name)

EVERY = ["area", "gap", "stiffness", "approach", "pressure", "heights", "gaps", "pressures", "patches", "spectrum", "bearing"]
DOCUMENT = pathlib.Path(__file__).resolve().parents[3] / "docs" / "python.md"
BROWSER = shutil.which("chromium") or shutil.which("google-chrome")


def written(tmp_path, shape, *arguments, name="a <b> & c.npy"):
    np.save(tmp_path / name, rc.surface.spectral(shape, pitch=1e-6, rms_slope=0.1, q_rolloff=2 * np.pi / 16e-6, seed=5).heights)
    out = tmp_path / "page.html"
    given = [str(tmp_path / name), "--pitch=1um", "--E=210GPa", "--nu=0.3", "--boundary=periodic", f"--out={out}"]
    assert command.main(["report", *given, *arguments]) == 0
    return out.read_text(encoding="utf-8")


def unpacked(page, name):
    return gzip.decompress(base64.b64decode(re.search(f'id="packed-{name}">([^<]*)<', page)[1])).decode()


def test_one_page_that_holds_all(tmp_path, capsys):
    page = written(tmp_path, (96, 128), "--pressure", "500MPa", "--tol", "1e-5")
    assert "page.html: " in capsys.readouterr().out
    assert "a &lt;b&gt; &amp; c.npy" in page and "<b>" not in page
    assert not re.search(r'(src|href)="(?!data:)', page) and "@import" not in page and "url(" not in page
    assert "default-src &#39;none&#39;" in page or "default-src 'none'" in page
    figures = json.loads(unpacked(page, "figures"))
    assert sorted(figures) == sorted(EVERY) and all(f'id="{name}"' in page for name in EVERY)
    assert "plotly.js v" in unpacked(page, "plotly")[:400]
    names = [trace.get("name") for trace in figures["area"]["data"]]
    assert "steps" in names and any("Persson" in each for each in names if each)
    assert not list(tmp_path.glob(".page*"))


def test_a_law_is_shown_with_the_steps(tmp_path):
    surface = rc.surface.spectral((32, 32), pitch=1e-6, rms_slope=0.1, q_rolloff=2 * np.pi / 16e-6, seed=5)
    law = rc.law(surface, E=210e9, nu=0.3, boundary="periodic", pressure=(1e7, 1e9), tolerance=0.01)
    law.save(tmp_path / "a.law")
    page = written(tmp_path, (32, 32), "--pressure", "500MPa,600MPa", "--law", str(tmp_path / "a.law"))
    lower, upper, line, steps = json.loads(unpacked(page, "figures"))["law"]["data"]

    def count(values):  # plotly may write an array of doubles as base64
        return len(base64.b64decode(values["bdata"])) // 8 if isinstance(values, dict) else len(values)

    assert 'id="law"' in page and count(line["x"]) == 200 and steps["name"] == "steps" and count(steps["x"]) == 2


def test_the_documented_command(tmp_path, monkeypatch):
    shown = re.search(r"^roughcontact (report .*)$", DOCUMENT.read_text(encoding="utf-8"), re.M) if DOCUMENT.exists() else None
    if shown is None:
        pytest.skip("docs/python.md is not beside the tests")
    monkeypatch.chdir(tmp_path)
    heights = rc.surface.noise((24, 24), rms_height=1e-7).heights.astype("<f4")
    header = b"Gwyddion Simple Field 1.0\nXRes = 24\nYRes = 24\nXReal = 2.4e-5\nYReal = 2.4e-5\nXYUnits = m\nZUnits = m\n"
    (tmp_path / "surface.gsf").write_bytes(header + b"\0" * (4 - len(header) % 4) + heights.tobytes())
    assert command.main(shlex.split(shown[1])) == 0
    assert "roughcontact solve surface.gsf --E 3GPa --nu 0.4 --load " in (tmp_path / "report.html").read_text(encoding="utf-8")


def test_large_maps_stay_small_pages(tmp_path):
    page = written(tmp_path, (1024, 1024), "--pressure", "300MPa,500MPa", "--tol", "1e-3")
    assert len(page) < 6e6
    assert "largest of 3 × 3 points" in page


def test_one_step_has_no_curves(tmp_path):
    page = written(tmp_path, (32, 32), "--load", "0")
    figures = json.loads(unpacked(page, "figures"))
    assert sorted(figures) == sorted(["pressure", "heights", "gaps", "spectrum", "bearing"]) and 'id="area"' not in page


def test_a_step_that_is_not_certified(tmp_path, capsys):
    np.save(tmp_path / "z.npy", rc.surface.noise((32, 32), rms_height=1e-7).heights)
    out = tmp_path / "page.html"
    assert (
        command.main(
            ["report", str(tmp_path / "z.npy"), "--pitch", "1um", "--modulus", "1GPa", "--load", "1mN", "--out", str(out)]
            + ["--solver", "polonsky-keer", "--tol", "1e-14", "--set", "max_iter=1"]
        )
        == 2
    )
    assert "Not certified" in capsys.readouterr().out and "STOP_MAX_ITER" in out.read_text(encoding="utf-8")


def browse(tmp_path, *arguments):
    quiet = ["--headless", "--no-sandbox", "--disable-gpu", "--enable-logging=stderr", f"--user-data-dir={tmp_path / 'profile'}"]
    asked = [BROWSER, *quiet, "--window-size=1280,6000", "--virtual-time-budget=30000", *arguments, (tmp_path / "page.html").as_uri()]
    done = subprocess.run(asked, capture_output=True, timeout=120, cwd=tmp_path)
    said = [line for line in done.stderr.decode(errors="replace").splitlines() if "CONSOLE" in line]
    return done.stdout.decode(errors="replace"), said


def colours_of(png):
    """How many colours each of the picture's rows has, read with the standard library: 8 bits a channel, no interlacing."""
    width, height, depth, kind, _, _, interlaced = struct.unpack(">IIBBBBB", png[16:29])
    assert depth == 8 and kind in (2, 6) and not interlaced
    data, at = b"", 8
    while at < len(png):
        size, what = struct.unpack(">I4s", png[at : at + 8])
        data += png[at + 8 : at + 8 + size] if what == b"IDAT" else b""
        at += size + 12
    return len(set(zlib.decompress(data))), (width, height)


@pytest.mark.skipif(BROWSER is None, reason="no Chromium (Debian: chromium)")
@pytest.mark.parametrize("shape, pressure", [((128, 128), "500MPa"), ((32, 256), "2GPa,10GPa,40GPa"), ((256, 32), "20MPa")])
def test_a_browser_draws_every_figure(tmp_path, shape, pressure):
    page = written(tmp_path, shape, "--pressure", pressure, "--tol", "1e-5")
    names = list(json.loads(unpacked(page, "figures")))
    dom, said = browse(tmp_path, "--dump-dom")
    assert said == []
    assert f'data-drawn="{len(names)}"' in dom and 'id="failed" hidden' in dom
    for name in names:
        figure = dom[dom.index(f'id="{name}"') :]
        assert "main-svg" in figure[: figure.index("<figcaption>")], name
    _, said = browse(tmp_path, f"--screenshot={tmp_path / 'page.png'}")
    assert said == []
    kinds, size = colours_of((tmp_path / "page.png").read_bytes())
    assert size == (1280, 6000) and kinds > 100


@pytest.mark.skipif(BROWSER is None, reason="no Chromium (Debian: chromium)")
def test_the_console_is_heard(tmp_path):
    """A page that is spoilt on purpose shows that the test above would see it."""
    page = written(tmp_path, (32, 32), "--pressure", "50MPa")
    packed = re.search(r'id="packed-figures">([^<]*)<', page)[1]
    (tmp_path / "page.html").write_text(page.replace(packed, packed[:100]), encoding="utf-8")
    dom, said = browse(tmp_path, "--dump-dom")
    assert said and "data-drawn" not in dom and "The figures cannot be drawn" in dom
