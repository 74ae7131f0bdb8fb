"""test_two_blocks.py INTEGRATION BLOCK: two blocks, each as the module BLOCK makes it, against both blocks and the interface in series.
Exit code 77: without its finite element library."""

import importlib
import sys

sys.path.insert(0, sys.argv[1])
try:
    import numpy as np
    from scipy.optimize import brentq

    block = importlib.import_module(sys.argv[2]).block
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

import roughcontact as rc
from two_blocks import E, HEIGHT, NU, Blocks

G, M = E / 2 / (1 + NU), E * (1 - NU) / (1 + NU) / (1 - 2 * NU)  # shear modulus, stiffness without lateral strain


def steel():
    y, x = np.mgrid[:32, :32] * 2 * np.pi / 32
    heights = 1e-3 * (np.cos(x) + np.cos(x + 2 * y) + 0.3 * np.cos(3 * x - y) + 0.2 * np.cos(5 * y))
    return rc.law(heights, pitch=1e-3, E=E, nu=NU, boundary="periodic", pressure=(1, 3000))


def series(state, moved, along, down):
    """The state behind two springs whose ends are moved: overclosure first, which friction does not change."""
    x = brentq(lambda x: state.step(x).p - M / (2 * HEIGHT) * (down - x), -1e-9, down, xtol=1e-16) if down > 0 else down
    slip = brentq(lambda s: state.step(x, (s, 0)).shear[0] - G / (2 * HEIGHT) * (along - moved - s), -1, 1, xtol=1e-16)
    return state.step(x, (slip, 0)), moved + slip


def main():
    law = steel()
    slip = law.slip(mu=0.3, nu=NU)
    blocks, state, moved = Blocks(slip, block), slip.rest.step(0), 0.0
    for along, down in ((0, 2e-3), (0, 1e-2), (3e-3, 1e-2), (6e-3, 1.2e-2), (-2e-3, 1.2e-2), (1e-3, 1.2e-2), (1e-3, 4e-3), (9e-3, 4e-3)):
        pressure, shear = blocks.move(along, down)
        state, moved = series(state, moved, along, down)
        assert abs(pressure / state.p - 1) < 1e-8 and abs(shear - state.shear[0]) < 1e-8 * state.p, (along, down, pressure, shear, state.p, state.shear)
        print(f"top at {along:7.4f}, -{down:.4f} mm: pressure {pressure:8.3f} MPa, shear {shear:8.3f} MPa, {blocks.iterations[-1]} iterations")
    assert max(blocks.iterations) <= 8, blocks.iterations


main()
