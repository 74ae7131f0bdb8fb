"""Roughness finer than the grid: its contact law is a bed of springs at every point, in the caller's own product.

fine_roughness.py [--points 32]

Fine waves let the bodies approach by x(p) more: the contact is p >= 0, h + H p + x(p) - d >= 0. Newton's steps replace x by its
tangent at the last pressures q: a contact with the matrix H + diag(x'), on the gap h + x(q) - x' q. Every step is certified.
For comparison a grid eight times finer has all waves.
"""

import argparse

import numpy as np

import roughcontact as rc

MODULUS, LOADS, FINER = 1.0, (0.002, 0.005, 0.01), 8  # a square of side 1
PRESS = {"modulus": MODULUS, "boundary": "periodic"}


def with_law(gap, law, load):
    """(approach, Newton's steps, how far the final gap is off by the approach, at pressed points)"""
    H = rc.Influence(rc.HalfSpace(gap.shape, pitch=1 / len(gap), **PRESS))
    p, change, steps = np.full(gap.shape, load), 1.0, 0
    while change > 1e-8 and steps < 30:
        at = np.maximum(p, law.info["p_lower"])
        x = law.overclosure(at)
        give = 1 / law.slope(x)  # x'
        springs = rc.Product(lambda q, c=give: H @ q + c * q, gap.shape, pitch=1 / len(gap))
        step = rc.solve(undeformed_gap=gap + x - give * at, system=springs, load=load, tol=1e-9)
        change, p, steps = np.abs(step.pressure - p).max() / step.pressure.max(), step.pressure, steps + 1
    pressed = p > law.info["p_lower"]
    off = np.abs((gap + H @ p - step.approach)[pressed] + law.overclosure(p[pressed])).max()
    return step.approach, steps, off / step.approach


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--points", type=int, default=32)
    points = parser.parse_args().points
    n, highest = FINER * points, np.pi / 2 * FINER * points
    wave = np.cos(2 * np.pi * (np.arange(n) + 0.5) / n)
    waves = 0.02 * (wave[:, None] + wave)
    shape = {"rms_slope": 0.2, "hurst": 0.8, "q_rolloff": highest / 4, "q_high": highest}
    fine = rc.surface.spectral(waves.shape, pitch=1 / n, seed=1, **shape)
    law = rc.law(fine, pressure=(1e-4, 0.1), tolerance=0.01, **PRESS)
    both, coarse = waves + fine.heights, waves.reshape(points, FINER, points, FINER).mean((1, 3))
    for load in LOADS:
        approach, steps, off = with_law(waves.max() - coarse, law, load)
        exact = rc.solve(both, pitch=1 / n, load=load, **PRESS).approach + waves.max() + fine.heights.max() - both.max()
        smooth = rc.solve(coarse, pitch=1 / points, load=load, **PRESS).approach + waves.max() - coarse.max()
        found = f"load {load}: approach {approach:.5f} in {steps} steps, off by {off:.0e}"
        print(f"{found}; fine grid {exact:.5f}, fine waves rigid {smooth + fine.heights.max():.5f}")
