"""test_stock.py SOURCE LIBRARY FOLDER: the two-block deck by table in CalculiX as the system has it, against the series solution. Exit code 77:
ccx (Debian: calculix-ccx), cc or NumPy is missing."""

import os
import pathlib
import re
import shutil
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

import deck
import roughcontact as rc

DOWN = 0.002  # mm, as in the deck


def run(name):
    done, printed = deck.solved("ccx", FOLDER, name, "1"), FOLDER / f"{name}.dat"
    forces = re.findall(r"^ +\S+ +\S+ +(\S+)\n", printed.read_text(), re.M) if printed.exists() else []
    return done.stdout, [float(each) for each in forces]


def main():
    FOLDER.mkdir(exist_ok=True)
    for file in (SOURCE / "integrations/calculix").glob("*.inp"):
        shutil.copy(file, FOLDER)
    deck.make_law(SOURCE, LIBRARY, FOLDER)
    law = rc.Law.load(FOLDER / "steel.law")
    expected = deck.series(law, DOWN) * deck.AREA
    for friction in ({}, {"mu": 0.3, "nu": 0.3}):
        error = law.export(FOLDER / "joint.inp", "calculix", **friction)
        said, forces = run("by_table")
        assert len(forces) == 1 and abs(forces[0] / expected - 1) < error, (said[-2000:], forces)
    print(f"force {forces[0]} N, by the series {expected} N")

    # Materials and interactions share their names in CalculiX.
    (FOLDER / "trap.inp").write_text((FOLDER / "by_table.inp").read_text().replace("LAW_STEEL", "STEEL"))
    said, forces = run("trap")
    assert not forces and "no PRESSURE-OVERCLOSURE" in said, said[-2000:]


if __name__ == "__main__":
    main()
