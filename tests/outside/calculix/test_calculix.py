"""test_calculix.py INTEGRATION BUILD FOLDER: builds CalculiX with contact laws in FOLDER, and compares two pressed cubes with the scalar
series solution. Exit code 77: CalculiX's sources or the tools to build it are missing."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

import deck

SOURCE = pathlib.Path(__file__).resolve().parents[3]
USER = "*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=USER"
AREA = deck.AREA


def run(ccx, path):
    """Times and forces, times and heats, and the iterations of each increment."""
    job = path.with_suffix("")
    done = deck.solved(ccx, path.parent, job.name, "2")
    if done.returncode:
        return done.stdout, [], []
    printed = job.with_suffix(".dat").read_text()
    forces = re.findall(r"total force.*?time\s+(\S+)\s+\S+\s+\S+\s+(\S+)", printed)
    heats = re.findall(r"total heat.*?time\s+(\S+)\s+(\S+)", printed)
    rows = [line.split() for line in job.with_suffix(".sta").read_text().splitlines()]
    iterations = [(int(row[0]), int(row[3])) for row in rows if len(row) >= 7 and row[0].isdigit()]
    return [(float(time), float(force)) for time, force in forces], [-float(heat) for _, heat in heats], iterations


def heat_through(law, pressure):
    """Of both cubes and the contact in series, 100 K apart."""
    return 100 * AREA / (2 * deck.EDGE / deck.CONDUCTIVITY + 1 / law.conductance(pressure, (deck.CONDUCTIVITY,) * 2))


def check(what, worst, limit):
    print(f"{what}: {worst:.1e} (limit {limit:.0e})", flush=True)
    assert worst <= limit, what


def two_cubes(ccx, law, folder):
    path = folder / "cubes.inp"
    for kind in ("NODE", "SURFACE"):
        first_step = int(kind == "SURFACE")  # it has no load
        for down in (0.0005, 0.002, 0.01, 0.04):
            for increments in (1, 10):
                deck.write(path, [USER], kind, down, increments)
                forces, _, iterations = run(ccx, path)
                forces = [(time - first_step, force) for time, force in forces if time > first_step]
                assert len(forces) == increments, forces
                errors = [abs(force / (deck.series(law, time * down) * AREA) - 1) for time, force in forces]
                check(f"{kind} {down} mm, {increments} increments: force", max(errors), 5e-7)
                most = max(count for step, count in iterations if step > first_step)
                if increments == 1:
                    check("  iterations", most, 8)


def tilted(ccx, law, folder):
    """The sum of the forces is nearly that of the flat top."""
    path = folder / "tilted.inp"
    flat = deck.series(law, 0.01) * AREA
    for kind, most in (("NODE", 10), ("SURFACE", 6)):
        deck.write(path, [USER], kind, 0.01, elements=5, tilt=1.2)
        forces, _, iterations = run(ccx, path)
        check(f"{kind}, tilted: force against a flat top", abs(forces[-1][1] / flat - 1), 5e-3)
        check("  iterations", iterations[-1][1], most)


def heat(ccx, law, folder):
    path = folder / "heat.inp"
    for down in (0.0005, 0.002, 0.01):
        deck.write(path, [USER, f"{deck.CONDUCTIVITY},{deck.CONDUCTIVITY}", "*GAP CONDUCTANCE,USER"], "SURFACE", down, heat=True)
        forces, heats, _ = run(ccx, path)
        pressure = deck.series(law, down)
        check(f"heat, {down} mm: force", abs(forces[-1][1] / (pressure * AREA) - 1), 5e-7)
        check("  heat", abs(heats[-1] / heat_through(law, pressure) - 1), 5e-7)


def example(ccx, law, folder):
    """The two-block deck by call, whose interaction has the prefix that keeps it apart from the material STEEL."""
    path = folder / "by_call.inp"
    forces, heats, _ = run(ccx, path)
    pressure = deck.series(law, 0.002)
    check("deck by call: force", abs(forces[-1][1] / (pressure * AREA) - 1), 5e-7)
    check("  heat", abs(heats[-1] / heat_through(law, pressure) - 1), 5e-7)


def heat_alone(ccx, law, folder):
    """CalculiX without the patch, but for gapcon.f: conductance by the law, pressure by CalculiX' own stiffness."""
    path, stiffness = folder / "alone.inp", 1e5
    for name in ("PATCH", "LAW_PATCH"):
        linear = ["*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR", f"{stiffness}", "*GAP CONDUCTANCE,USER"]
        deck.write(path, linear, "SURFACE", 0.002, heat=True, name=name)
        forces, heats, _ = run(ccx, path)
        check(f"heat without the patch, {name}", abs(heats[-1] / heat_through(law, forces[-1][1] / AREA) - 1), 2e-6)


def units(ccx, law, folder):
    """A law in m, N, Pa in a deck in mm, N, MPa: every x, p of the file is scaled, so numbers of the deck scale back."""
    path = folder / "units.inp"
    deck.write(path, [USER, "0,0,1.,1."], "SURFACE", 0.01)
    same = run(ccx, path)[0]
    assert abs(same[-1][1] / (deck.series(law, 0.01) * AREA) - 1) < 5e-7
    deck.write(path, [USER, "0,0,2.,4."], "SURFACE", 0.02)  # pressures the same, lengths twice
    scaled = run(ccx, path)[0]
    check("lengths of the law doubled: force", abs(scaled[-1][1] / (deck.series(lambda x: law(x / 2), 0.02) * AREA) - 1), 5e-7)


def errors(ccx, _, folder):
    """Every mistake ends the run with a message."""
    path = folder / "wrong.inp"

    def message(expected, behaviour, kind="SURFACE", hot=False):
        deck.write(path, behaviour, kind, 0.01, heat=hot)
        output, forces, _ = run(ccx, path)
        assert not forces and expected in re.sub(r"\s+", " ", output), (expected, output[-2000:])

    conductance = "*GAP CONDUCTANCE,USER"
    message("needs TYPE=SURFACE TO SURFACE", [USER, "50.,50.", conductance], "NODE", True)
    message("needs the conductivities", [USER, conductance], hot=True)
    message("must not be negative", [USER, "0,0,-1."])
    message("needs PRESSURE-OVERCLOSURE=USER", ["*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR", "1.E5,1.E-3", conductance], hot=True)
    file = folder / "patch.law"
    text = file.read_text()
    file.write_text(text[: len(text) // 2])
    message("patch.law", [USER])
    file.unlink()
    message("patch.law", [USER])
    file.write_text(text)


def main():
    integration, build, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    prefix = folder / "installed"
    for part in ("runtime", "development"):
        install = ["cmake", "--install", build, "--prefix", prefix, "--component", part]
        subprocess.run(install, check=True, stdout=subprocess.DEVNULL)
    settings = next(prefix.rglob("roughcontact.pc")).parent
    os.environ.update(PKG_CONFIG_PATH=str(settings), CCX_OPTIMIZE="-O1")
    built = subprocess.run([integration / "build.sh", folder / "calculix"])
    if built.returncode:
        return built.returncode
    library = next(prefix.rglob("libroughcontact.so"))
    os.environ["ROUGHCONTACT_LIBRARY"] = str(library)
    sys.path.insert(0, str(SOURCE / "bindings/python"))
    try:
        import roughcontact as rc
    except ImportError as missing:
        print(f"skipped: {missing}")
        return 77
    deck.make_law(SOURCE, library, folder)
    shutil.copy(folder / "steel.law", folder / "patch.law")
    law = rc.Law.load(folder / "patch.law")
    for name in ("blocks.inp", "by_call.inp"):
        shutil.copy(integration / name, folder)
    for part in (two_cubes, tilted, heat, example, units, errors):
        part(folder / "calculix/ccx", law, folder)
    subprocess.run([integration / "build.sh", folder / "calculix_heat", "heat"], check=True)
    heat_alone(folder / "calculix_heat/ccx", law, folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
