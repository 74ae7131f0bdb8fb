"""test_abaqus.py SOURCE LIBRARY FOLDER: the user subroutines of integrations/abaqus in programs that call them as Abaqus does, against the
library. Exit code 77: gfortran, a C compiler or NumPy is missing."""

import os
import pathlib
import shutil
import subprocess
import sys

if not shutil.which("gfortran") or not shutil.which("cc"):
    print("skipped: gfortran or cc is missing")
    sys.exit(77)
try:
    import numpy as np
except ImportError:
    print("skipped: NumPy is missing (Debian: python3-numpy)")
    sys.exit(77)

SOURCE, LIBRARY, FOLDER = (pathlib.Path(each).resolve() for each in sys.argv[1:])
sys.path.insert(0, str(SOURCE / "bindings/python"))
os.environ["ROUGHCONTACT_LIBRARY"] = str(LIBRARY)

import roughcontact as rc

HERE = pathlib.Path(__file__).resolve().parent
LENGTH = 1000.0  # the law is in m and N, the deck in mm and N
PRESSURE = 1 / LENGTH**2
SPRINGS = np.array([4e4, 2e4, 2e4])
MU, NU, K = 0.3, 0.25, (50.0, 20.0)


def compiled(name, *sources):
    subprocess.run(["cc", "-O2", "-c", "-DROUGHCONTACT_LAW_FORTRAN", SOURCE / "src/law/table.c", "-o", "table.o"], cwd=FOLDER, check=True)
    include = [f"-I{SOURCE / 'integrations/abaqus'}", "-I."]
    subprocess.run(["gfortran", "-std=legacy", "-O2", "-w", *include, *sources, HERE / "utilities.f", "table.o", "-lm", "-o", name], cwd=FOLDER,
                   check=True)


def run(name, rows):
    text = "\n".join(" ".join(f"{value:.17g}" for value in np.atleast_1d(row)) for row in rows) + "\n"
    return subprocess.run([f"./{name}"], cwd=FOLDER, input=text, capture_output=True, text=True)


def numbers(done):
    assert done.returncode == 0, done.stdout + done.stderr
    return [[float(each) for each in line.split()] for line in done.stdout.splitlines()]


def path_of(law):
    """Pressed, sheared in two directions, turned back, pressed on, lifted until it opens, pressed again."""
    deep, wide = 1.5 * LENGTH * law.info["x_upper"], 2 * MU * LENGTH * law.info["x_upper"]
    corners = [(0.3, 0, 0), (1, 0, 0), (1, 0.3, 0), (1, 0.6, 0.1), (1, -0.2, 0.1), (1.2, 0, 0.2), (0.7, 0.2, 0), (0.5, 3, 0), (-0.1, 0, 0),
               (0.6, 0.1, 0.1)]
    return [np.array([deep * a, wide * b, wide * c]) for a, b, c in corners]


def interface(law, slip):
    """What UINTER has to say, by the library; equilibrium with the springs to round-off."""
    state, before = slip.rest.step(-1e-4 / LENGTH), np.array([-1e-4, 0, 0])
    path, iterations, dissipated = path_of(law), [], 0
    rows = numbers(run("uinter", [(*u, 300, 400) for u in path]))
    perturbed = rows.pop()
    for u, (count, *row) in zip(path, rows):
        r, stress, flux, energy, dissipated = np.array(row[:3]), np.array(row[3:6]), *row[6:]
        state = state.step(r[0] / LENGTH, (r - before)[1:] / LENGTH)
        expected = PRESSURE * np.array([state.p, *state.shear])
        assert np.allclose(stress, expected, rtol=1e-9, atol=1e-12 * abs(expected[0])), (stress, expected)
        assert np.allclose(SPRINGS * (u - r), stress, rtol=1e-8, atol=1e-9 * max(1, stress[0])), (u, r, stress)
        heat = law.conductance(state.p, K) * 100 / LENGTH if state.p > 0 else 0
        assert np.isclose(flux, heat, rtol=1e-8), (flux, heat)
        assert np.isclose(energy, law.energy(r[0] / LENGTH) * PRESSURE * LENGTH, rtol=1e-9)
        assert np.isclose(dissipated, state.dissipated * PRESSURE * LENGTH, rtol=1e-6, atol=1e-15)
        iterations.append(int(count))
        before = r
    assert len(iterations) == len(path) and max(iterations) <= 8, iterations
    assert dissipated > 0
    change = np.array([1e-7, 2e-7, -1e-7])
    still = state.step(r[0] / LENGTH)
    tangent = np.zeros((3, 3))
    tangent[0, 0], tangent[1:, 0], tangent[1:, 1:] = still.slope, still.shear_by_x, still.shear_by_slip
    assert np.allclose(perturbed, tangent @ change * PRESSURE / LENGTH, rtol=1e-6), (perturbed, tangent)
    print("iterations of the increments:", *iterations)


def conductances(law):
    pressures = np.geomspace(law.info["p_lower"], law.info["p_upper"] * 0.99, 30) * PRESSURE
    found = np.array(numbers(run("gapcon", [0, *pressures])))
    assert not found[0].any()
    expected = law.conductance(pressures / PRESSURE, K) / LENGTH
    assert np.allclose(found[1:, 0], expected, rtol=1e-9)
    more = law.conductance(pressures * (1 + 1e-6) / PRESSURE, K) / LENGTH
    rates = (more - expected) / (1e-6 * pressures)  # they jump where points touch
    assert np.mean(np.abs(found[1:, 1] - rates) <= 1e-3 * np.abs(rates) + 1e-6 * expected / pressures) > 0.9


def mistakes():
    """Each ends the job with a message."""
    laws = FOLDER / "roughcontact.laws"
    good = laws.read_text()
    for text, message in (("", "has no law of the interaction Joint"), ("JOINT joint.table .3 .7 0 0 1 1\n", "is not NAME FILE MU NU"),
                          ("JOINT joint.table .3\n", "is not NAME FILE MU NU"), ("JOINT none.table .3 .3 0 0 1 1\n", "no table of a law: none"),
                          ("JOINT roughcontact.laws .3 .3 0 0 1 1\n", "no table of a law"), (None, "cannot be read: roughcontact.laws")):
        laws.unlink() if text is None else laws.write_text(text)
        done = run("uinter", [(0, 0, 0, 0, 0)])
        assert done.returncode == 3 and message in done.stdout, (text, done)
    laws.write_text(good)


def main():
    FOLDER.mkdir(exist_ok=True)
    (FOLDER / "ABA_PARAM.INC").write_text("      IMPLICIT REAL*8(A-H,O-Z)\n      PARAMETER (NPRECD=2)\n")
    y, x = np.mgrid[:32, :32] * 2 * np.pi / 32
    heights = 1e-6 * (np.cos(x) + np.cos(x + 2 * y) + 0.3 * np.cos(3 * x - y) + 0.2 * np.cos(5 * y))
    law = rc.law(heights, pitch=1e-6, modulus=115e9, boundary="periodic", pressure=(1e6, 5e9))
    law.export(FOLDER / "joint.table", "table")
    (FOLDER / "roughcontact.laws").write_text(f"* interface\njoint joint.table {MU} {NU} {K[0]} {K[1]} {LENGTH} 1\n")
    integration = SOURCE / "integrations/abaqus"
    compiled("uinter", integration / "uinter.f", HERE / "driver.f")
    compiled("gapcon", integration / "gapcon.f", HERE / "heat_driver.f")
    old = (HERE / "driver.f").read_text().replace("C,DV,DS,FLUX", "C,FLUX").replace("1D0,0D0,CINAME", "1D0,CINAME")
    (FOLDER / "driver66.f").write_text(old)
    compiled("uinter66", integration / "uinter66.f", FOLDER / "driver66.f")
    interface(law, law.slip(mu=MU, nu=NU))
    rows = [(*u, 300, 400) for u in path_of(law)]
    assert run("uinter66", rows).stdout == run("uinter", rows).stdout
    conductances(law)
    mistakes()


if __name__ == "__main__":
    main()
