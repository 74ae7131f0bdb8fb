"""test_gapflow.py INTEGRATION: deformations and a run of GaPFlow, with its own half-space and with the one in INTEGRATION."""

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

warnings.simplefilter("ignore")
THEIRS, OURS = topography.ElasticDeformation, rough_elasticity.ElasticDeformation

# The parabolic slider of GaPFlow's tutorial 9.
SLIDER = """
options: {silent: True}
grid:
    Lx: 0.0762
    Ly: 1.
    Nx: 100
    Ny: 1
    xE: ['D', 'N', 'N']
    xW: ['D', 'N', 'N']
    yS: ['P', 'P', 'P']
    yN: ['P', 'P', 'P']
    xE_D: 850.
    xW_D: 850.
geometry: {type: parabolic, hmin: 0.5e-5, hmax: 5.0e-4, U: 10.0, V: 0.}
numerics: {adaptive: 1, CFL: 0.45, tol: 1e-8, dt: 1.e-10, max_it: 300}
properties:
    EOS: Bayada
    rho0: 850.
    shear: 0.039
    bulk: 0.
    cl: 1600.
    cv: 352.
    elastic: {E: 5e09, v: 0.3, alpha_underrelax: 1e-03}
    piezo: {name: Dukler, shearv: 3.9e-5, rhol: 850., rhov: 0.019}
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


def run(kind):
    topography.ElasticDeformation = kind
    problem = Problem.from_string(SLIDER)
    problem.run()
    return problem.topo.deformation.copy(), problem.step


def main():
    differences()
    (theirs, steps), (ours, again) = run(THEIRS), run(OURS)
    off = abs(theirs - ours).max() / abs(theirs).max()
    print(f"slider: {off:.1e} of the largest deformation, {abs(theirs).max():.3g} m, after {steps} steps")
    assert steps == again and off < 1e-8


main()
