"""test_stock.py SOURCE LIBRARY FOLDER: the two-block deck by table in CalculiX as the system has it, against the series solution. Exit code 77:
ccx (Debian: calculix-ccx), cc or NumPy is missing."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

try:
    import numpy  # noqa: F401
except ImportError:
    print("skipped: NumPy is missing (Debian: python3-numpy)")
    sys.exit(77)
for tool in ("ccx", "cc"):
    if not shutil.which(tool):
        print(f"skipped: {tool} is missing (Debian: calculix-ccx, gcc)")
        sys.exit(77)

SOURCE, LIBRARY, FOLDER = (pathlib.Path(each).resolve() for each in sys.argv[1:])
sys.path.insert(0, str(SOURCE / "bindings/python"))
os.environ["ROUGHCONTACT_LIBRARY"] = str(LIBRARY)

import roughcontact as rc

DOWN, AREA, COMPLIANCE = 0.002, 100.0, 2 * 10 / 210000  # as in the deck


def run(name):
    done = subprocess.run(["ccx", "-i", name], cwd=FOLDER, env=dict(os.environ, OMP_NUM_THREADS="1"), capture_output=True, text=True, timeout=300)
    printed = FOLDER / f"{name}.dat"
    forces = re.findall(r"^ +\S+ +\S+ +(\S+)\n", printed.read_text(), re.M) if printed.exists() else []
    return done.stdout, [float(each) for each in forces]


def series(law):
    lower, upper = 0.0, DOWN
    for _ in range(200):
        x = (lower + upper) / 2
        lower, upper = (lower, x) if law(x) * COMPLIANCE + x > DOWN else (x, upper)
    return law(x) * AREA


def main():
    FOLDER.mkdir(exist_ok=True)
    for deck in (SOURCE / "integrations/calculix").glob("*.inp"):
        shutil.copy(deck, FOLDER)
    library = [f"-L{LIBRARY.parent}", "-lroughcontact", f"-Wl,-rpath,{LIBRARY.parent}", "-lm"]
    subprocess.run(["cc", "-O2", f"-I{SOURCE / 'include'}", SOURCE / "integrations/calculix/steel.c", "-o", "steel", *library], cwd=FOLDER, check=True)
    subprocess.run(["./steel", "steel.law"], cwd=FOLDER, check=True)
    law = rc.Law.load(FOLDER / "steel.law")
    for friction in ({}, {"mu": 0.3, "nu": 0.3}):
        error = law.export(FOLDER / "joint.inp", "calculix", **friction)
        said, forces = run("by_table")
        assert len(forces) == 1 and abs(forces[0] / series(law) - 1) < error, (said[-2000:], forces)
    print(f"force {forces[0]} N, by the series {series(law)} N")

    # Materials and interactions share their names in CalculiX.
    (FOLDER / "trap.inp").write_text((FOLDER / "by_table.inp").read_text().replace("LAW_STEEL", "STEEL"))
    said, forces = run("trap")
    assert not forces and "no PRESSURE-OVERCLOSURE" in said, said[-2000:]


if __name__ == "__main__":
    main()
