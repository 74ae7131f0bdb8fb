"""Decks of two cubes of 10 mm, one on the other, with symmetric supports; the upper one is pressed down by its top."""

import os
import subprocess

EDGE = 10.0  # mm
YOUNG = 210000.0  # MPa
CONDUCTIVITY = 50.0  # mW/(mm K)

COMPLIANCE = 2 * EDGE / YOUNG  # mm/MPa, of both cubes
AREA = EDGE**2

# With the stock line search, heat across a contact stalls Newton's method.
NO_LINE_SEARCH = ["*CONTROLS,PARAMETERS=LINE SEARCH", ",1.01,.999,0.1,0.1"]


def write(path, behaviour, kind, down, increments=1, elements=2, tilt=0.0, heat=False, residual=1e-6, name="PATCH"):
    """name: the interaction's. kind: NODE or SURFACE to surface. down: displacement of the top in mm, which increases by tilt times itself along x."""
    nodes = range(elements + 1)
    cells = range(elements)
    side = EDGE / elements

    def node(block, i, j, k):
        return block * (elements + 1) ** 3 + (k * (elements + 1) + j) * (elements + 1) + i + 1

    def element(block, i, j, k):
        return block * elements**3 + (k * elements + j) * elements + i + 1

    lines = ["*NODE,NSET=NALL"]
    for block in (0, 1):
        for k in nodes:
            lines += [f"{node(block, i, j, k)},{i * side},{j * side},{block * EDGE + k * side}" for j in nodes for i in nodes]
    corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
    for block in (0, 1):
        lines.append(f"*ELEMENT,TYPE=C3D8,ELSET=BLOCK{block}")
        for k in cells:
            for j in cells:
                for i in cells:
                    of = [node(block, i + a, j + b, k + c) for c in (0, 1) for a, b in corners]
                    lines.append(",".join(map(str, [element(block, i, j, k)] + of)))

    def node_set(name, members):
        lines.append(f"*NSET,NSET={name}")
        lines.extend(f"{member}," for member in members)

    node_set("BOTTOM", [node(0, i, j, 0) for i in nodes for j in nodes])
    node_set("TOP", [node(1, i, j, elements) for i in nodes for j in nodes])
    node_set("X0", [node(b, 0, j, k) for b in (0, 1) for j in nodes for k in nodes])
    node_set("Y0", [node(b, i, 0, k) for b in (0, 1) for i in nodes for k in nodes])
    lines.append("*SURFACE,NAME=SLAVE")
    lines += [f"{element(1, i, j, 0)},S1" for j in cells for i in cells]
    lines.append("*SURFACE,NAME=MASTER")
    lines += [f"{element(0, i, j, elements - 1)},S2" for j in cells for i in cells]
    # Without lateral strain the slave area stays 100 mm2, and the answer is that of bars in series.
    lines += ["*MATERIAL,NAME=STEEL", "*ELASTIC", f"{YOUNG},0.", "*CONDUCTIVITY", f"{CONDUCTIVITY}"]
    lines += ["*EXPANSION", "0.", "*SPECIFIC HEAT", "1.", "*DENSITY", "1."] if heat else []
    lines += [f"*SOLID SECTION,ELSET=BLOCK{block},MATERIAL=STEEL" for block in (0, 1)]
    lines += [f"*SURFACE INTERACTION,NAME={name}"] + behaviour
    lines += [f"*CONTACT PAIR,INTERACTION={name},TYPE={kind} TO SURFACE", "SLAVE,MASTER"]
    lines += ["*INITIAL CONDITIONS,TYPE=TEMPERATURE", "NALL,300."] if heat else []
    lines += ["*BOUNDARY", "BOTTOM,3,3", "X0,1,1", "Y0,2,2"]
    procedure = "*COUPLED TEMPERATURE-DISPLACEMENT,STEADY STATE" if heat else "*STATIC"
    if kind == "SURFACE":  # step without load: in the first step overclosures at the start of an increment fade out
        lines += ["*STEP", procedure, "1.,1.", "*BOUNDARY", "TOP,3,3,0."]
        lines += ["BOTTOM,11,11,300.", "TOP,11,11,300."] if heat else []
        lines.append("*END STEP")
    lines += ["*STEP,INC=1000", procedure + ("" if heat else ",DIRECT"), f"{1 / increments},1."]
    lines += ["*CONTROLS,PARAMETERS=FIELD", f"{residual},{residual}"]
    lines += NO_LINE_SEARCH if heat else []
    lines.append("*BOUNDARY")
    for j in nodes:
        lines += [f"{node(1, i, j, elements)},3,3,{-down * (1 + tilt * (i / elements - 0.5)):.12f}" for i in nodes]
    lines += ["BOTTOM,11,11,300.", "TOP,11,11,400."] if heat else []
    lines += ["*NODE PRINT,NSET=BOTTOM,TOTALS=ONLY,FREQUENCY=1", "RF" + (",RFL" if heat else ""), "*END STEP"]
    path.write_text("\n".join(lines) + "\n")


def series(law, down):
    """The pressure at which both cubes and the law together yield by `down`."""
    lower, upper = 0.0, down
    for _ in range(200):
        x = (lower + upper) / 2
        lower, upper = (lower, x) if law(x) * COMPLIANCE + x > down else (x, upper)
    return law(x)


def make_law(source, library, folder):
    """steel.law in the folder, by the program of integrations/calculix."""
    links = [f"-L{library.parent}", "-lroughcontact", f"-Wl,-rpath,{library.parent}", "-lm"]
    program = source / "integrations/calculix/steel.c"
    subprocess.run(["cc", "-O2", f"-I{source / 'include'}", program, "-o", "steel", *links], cwd=folder, check=True)
    subprocess.run(["./steel", "steel.law"], cwd=folder, check=True)


def solved(ccx, folder, name, threads):
    """What CalculiX says of a job."""
    environment = dict(os.environ, OMP_NUM_THREADS=threads, CCX_NPROC_RESULTS=threads)
    return subprocess.run([ccx, "-i", name], cwd=folder, env=environment, capture_output=True, text=True, timeout=300)
