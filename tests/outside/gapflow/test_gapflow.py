"""test_gapflow.py INTEGRATION: deformations and runs of GaPFlow, with its own half-space and with the one in INTEGRATION."""

import os
import runpy
import sys
import time
import warnings

try:
    import numpy as np
    from GaPFlow import topography
    from GaPFlow.problem import Problem
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

sys.path.insert(0, sys.argv[1])
import rough_elasticity  # noqa: E402
import roughcontact as rc  # noqa: E402

warnings.simplefilter("ignore")
THEIRS, OURS = topography.ElasticDeformation, rough_elasticity.ElasticDeformation

# The parabolic slider of GaPFlow's tutorial 9.
with open(sys.argv[1] + "/input.yaml", encoding="utf-8") as text:
    SLIDER = text.read()


# The journal bearing of the same tutorial.
JOURNAL = """
options: {silent: True}
grid:
    dx: 1.e-5
    dy: 1.
    Nx: 100
    Ny: 1
    xE: ['P', 'P', 'P']
    xW: ['P', 'P', 'P']
    yS: ['P', 'P', 'P']
    yN: ['P', 'P', 'P']
geometry: {type: journal, CR: 1.e-2, eps: 0.7, U: 0.1, V: 0.}
numerics: {adaptive: 1, CFL: 0.25, tol: 1e-30, dt: 1e-10, max_it: 6000}
properties:
    EOS: DH
    P0: 101325.
    rho0: 877.7007
    T0: 323.15
    C1: 3.5e10
    C2: 1.23
    shear: 0.0794
    bulk: 0.
    elastic: {E: 5e09, v: 0.3, alpha_underrelax: 1e-03}
"""


def differences():
    """Largest difference of deformations over the largest one, from a corner, as GaPFlow takes them."""
    pressure = np.random.default_rng(1).standard_normal((64, 32)) * 1e7
    for repeats, images, allowed in (
        ((True, True), 10, 1e-12),
        ((False, False), 10, 1e-10),
        ((True, False), 10, 1e-3),
        ((False, True), 10, 2e-3),
        ((True, False), 100, 1e-5),
        ((False, True), 100, 4e-5),
    ):
        grid = dict(Nx=62, Ny=30, Lx=2e-3, Ly=1e-3, dx=2e-3 / 62, dy=1e-3 / 30)
        grid |= dict(bc_xE_P=[repeats[0]] * 3, bc_yS_P=[repeats[1]] * 3)
        fields, seconds = [], []
        for kind in (THEIRS, OURS):
            walls = kind(5e9, 0.3, 1e-3, grid, images)
            walls.get_deformation(pressure)
            start = time.perf_counter()
            for _ in range(100):
                found = walls.get_deformation(pressure)
            seconds.append(time.perf_counter() - start)
            fields.append(found - found[0, 0])
        off = abs(fields[0] - fields[1]).max() / abs(fields[0]).max()
        print(f"{walls.periodicity}, {images} images: {off:.1e} of the largest deformation, their time over ours {seconds[0] / seconds[1]:.1f}")
        assert off < allowed, f"{off} is more than {allowed}"


def run(text):
    problem = Problem.from_string(text)
    problem.run()
    return problem


def same_steps():
    """With the input's relaxation every step is GaPFlow's own."""
    topography.ElasticDeformation = THEIRS
    theirs = run(SLIDER)
    rough_elasticity.install(relaxation=None)
    ours = run(SLIDER)
    off = abs(theirs.topo.deformation - ours.topo.deformation).max() / abs(theirs.topo.deformation).max()
    print(f"slider: {off:.1e} of the largest deformation after {theirs.step} steps")
    assert theirs.step == ours.step and off < 1e-8


def same_end():
    """With whole deformations the bearing settles within 6000 steps, and GaPFlow's own walls stay where that leaves them."""
    rough_elasticity.install()
    problem = run(JOURNAL)
    settled, residual = problem.topo.deformation.copy(), problem.residual
    problem.topo.ElasticDeformation = THEIRS(5e9, 0.3, 1e-3, problem.grid, 10)
    problem.topo.ElasticDeformation.u_prev = settled.copy()
    problem.max_it += 300
    problem.run()
    off = abs(problem.topo.deformation - settled).max() / abs(settled).max()
    print(f"journal bearing: residual {residual:.1e}; {off:.1e} of the largest deformation in 300 more steps with GaPFlow's walls")
    assert problem.step == 6300 and residual < 1e-9 and off < 1e-8


def from_the_dry_contact():
    """The run of dry_contact.py: it begins with the solved gap, and its flow is that of Reynolds' equation."""
    os.chdir(sys.argv[1])
    ran = runpy.run_path("dry_contact.py")
    problem, dry = ran["problem"], ran["dry"]
    assert np.array_equal(problem.topo.h_undeformed[1:-1, 1:-1], np.maximum(dry.gap.T, 5e-7))
    assert np.array_equal(problem.topo.h_undeformed[1:-1, 0], problem.topo.h_undeformed[1:-1, -2])
    p = problem.pressure.pressure[:, 1:-1]
    drop = (p[0] + p[1] - p[-1] - p[-2]).mean() / 2
    exact = rc.flow(problem.topo.h[1:-1, 1:-1], pitch=1, viscosity=0.01, pressure_drop=drop, along="y", sides="periodic").flow
    print(f"flow around a dry contact: {ran['flow'].mean():.5g} m^3/s, by Reynolds' equation {exact:.5g}")
    assert abs(ran["flow"].mean() / exact - 1) < 5e-3 and np.ptp(ran["flow"]) < 0.03 * exact
    for gap, least in ((dry.gap[1:], 5e-7), (dry.gap, 0.0)):
        try:
            rough_elasticity.start_from_contact(problem, gap, least)
        except ValueError as refused:
            print(refused)
        else:
            raise AssertionError("a gap of another size or no film was taken")


from_the_dry_contact()
differences()
same_steps()
same_end()
