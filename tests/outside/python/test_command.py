"""`python -m roughcontact` is the command; a wheel's script runs the same file without the package."""

import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest

import roughcontact as rc
from roughcontact import _command

if _command.program() is None:
    pytest.skip("the command is not beside the library", allow_module_level=True)


def ran(*words, **how):
    return subprocess.run([sys.executable, *words], capture_output=True, text=True, **how)


def test_the_module_is_the_command():
    listed = ran("-m", "roughcontact", "backends")
    assert listed.returncode == 0 and "dense" in listed.stdout, listed.stderr
    wrong = ran("-m", "roughcontact", "solve", "nothing.gsf", "--E", "1GPa", "--nu", "0.3", "--load", "1N")
    assert wrong.returncode != 0 and "nothing.gsf" in wrong.stderr and "Traceback" not in wrong.stderr


def test_reports_are_python():
    assert "--out PAGE" in ran("-m", "roughcontact", "report", "--help").stdout


def test_scripts_do_not_start_each_other(tmp_path, monkeypatch):
    script = tmp_path / "roughcontact"
    script.write_text("#!/bin/sh\n")
    script.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path) + os.pathsep + os.environ["PATH"])
    assert not _command._is_program(script) and _command.program() != str(script)


def test_the_command_does_not_wait_for_numpy():
    """The file that a wheel's script runs imports nothing of the package before it starts the command."""
    file = pathlib.Path(_command.__file__)
    code = f"import sys, runpy; runpy.run_path({str(file)!r}); print('numpy' in sys.modules, 'roughcontact' in sys.modules)"
    assert ran("-c", code).stdout.split() == ["False", "False"]


def test_a_missing_command_is_said(monkeypatch, capsys):
    monkeypatch.setattr(_command, "program", lambda: None)
    assert _command.main(["solve"]) == 1 and "not installed beside this Python package" in capsys.readouterr().err


def test_command_report_and_package_make_the_same_remark(tmp_path):
    """On the largest pressure, without a hardness: from one table."""
    from roughcontact.report import wording
    from roughcontact.report.content import collect
    from roughcontact.report.run import run_of

    surface = rc.surface.spectral((48, 48), pitch=1e-6, rms_height=3e-6, hurst=0.8, seed=3)
    np.save(tmp_path / "map.npy", surface.heights)
    seen = set()
    for modulus, pressure in ((210e9, 1e3), (230e9, 20e6), (5e12, 1e9), (210e9, 20e9), (2e9, 3e7)):
        words = ["map.npy", "--pitch", "1um", "--boundary", "periodic", "--modulus", str(modulus), "--pressure", str(pressure)]
        last = ran("-m", "roughcontact", "solve", *words, cwd=tmp_path).stdout.splitlines()[-1]
        remark = last.partition("; warning: ")[2]
        with run_of([str(tmp_path / "map.npy"), *words[1:]]) as (folder, _):
            said = wording.conclusion(collect(folder))
        assert said.rstrip(".").partition(" Warning: ")[2] == remark
        result = rc.solve(tmp_path / "map.npy", pitch=1e-6, boundary="periodic", modulus=modulus, pressure=pressure)
        assert remark.replace("--hardness", "hardness=") in result.remarks and ("largest pressure" in result.remarks) == bool(
            remark
        )
        seen.add(" ".join(remark.split()[:6]))
    assert len(seen) >= 3, seen


def test_the_command_starts_the_report(tmp_path):
    """With the Python that a shell finds; it says what is missing."""
    command = _command.program()
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "python3").write_text(f'#!/bin/sh\nexec "{sys.executable}" "$@"\n')
    (tmp_path / "bin" / "python3").chmod(0o755)
    for path, words, says in (
        ("bin", [str(tmp_path)], ("no summary.json", "not installed, which a page is made with")),
        ("bin", [str(tmp_path), "--lod", "1"], ('no option "--lod"; did you mean "--load"?',)),
        ("none", [str(tmp_path)], ("report needs Python 3",)),
    ):
        place = {**os.environ, "PATH": str(tmp_path / path), "PYTHONPATH": str(pathlib.Path(rc.__file__).parents[1])}
        done = subprocess.run([command, "report", *words], env=place, capture_output=True, text=True)
        assert done.returncode == 1 and any(text in done.stderr for text in says), done.stderr
