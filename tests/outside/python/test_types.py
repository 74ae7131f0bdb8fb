"""Type hints: mypy --strict accepts the package, and programs that use it."""

import pathlib
import subprocess
import sys

import pytest

pytest.importorskip("mypy")
PACKAGE = pathlib.Path(__file__).resolve().parents[3] / "bindings" / "python"
USER = """
from typing import List

import numpy as np
import roughcontact as rc

surface: rc.Surface = rc.surface.spectral((32, 32), pitch=1e-6, rms_height=1e-7)
result: rc.Result = rc.solve(surface, E=210e9, nu=0.3, pressure=1e6, tol=1e-8, progress=True)
loads: List[float] = [step.load for step in rc.history(surface, modulus=1e9, load=[1e-4, 2e-4])]
upper: float = result.load_upper
with rc.Contact(rc.HalfSpace.under(rc.read("a.npy", pitch=1), modulus=1e9)) as contact:
    index, pressure = contact.points()
print(np.sum(pressure), rc.analysis.area(pressure, pitch=(1.0, 1.0)).area, rc.direct.nnls(np.eye(2), np.ones(2)).load, loads)
"""


def mypy(*arguments, **how):
    return subprocess.run([sys.executable, "-m", "mypy", *arguments], capture_output=True, text=True, **how)


def test_the_package(tmp_path):
    ran = mypy("--config-file", PACKAGE.parents[1] / "pyproject.toml", "--cache-dir", tmp_path, cwd=PACKAGE)
    assert ran.returncode == 0 and "no issues" in ran.stdout, ran.stdout + ran.stderr


@pytest.mark.parametrize(
    "line, says", [("", ""), ('upper = "much"', "Incompatible types"), ("rc.solve(surface, every=[])", "arg-type")]
)
def test_a_program(tmp_path, line, says):
    (tmp_path / "user.py").write_text(USER + line + "\n")
    (tmp_path / "roughcontact").symlink_to(PACKAGE / "roughcontact")
    ran = mypy("--strict", "--cache-dir", tmp_path / "cache", "user.py", cwd=tmp_path)
    assert says in ran.stdout and (ran.returncode == 0) == (not says), ran.stdout + ran.stderr
