"""Archard's wear: a pin that slides under a constant load wears flat. The model has no wear and no bed of springs; the caller's
own product adds what they need.

wear.py [--points 64]

Wear by w' = k p per sliding distance. Implicit in a step of length ds, the pressures of its end add k ds p to the gap: the
contact of a step has H + k ds as its matrix, on the gap that the steps before have worn. Every step is certified.
"""

import argparse

import numpy as np

import roughcontact as rc

RADIUS, SIDE, MODULUS, LOAD = 10.0, 2.0, 1e5, 20.0  # mm, mm, MPa, N
RATE, DISTANCE, STEPS = 1e-7, 2e4, 20  # k [mm^2/N], mm


def worn(points):
    """(radius of contact, largest pressure, worn volume, largest residual) after each step"""
    pitch, wear = SIDE / points, np.zeros((points, points))
    x = (np.arange(points) + 0.5) * pitch - SIDE / 2
    gap = (x[:, None] ** 2 + x**2) / (2 * RADIUS)
    H = rc.Influence(rc.HalfSpace(gap.shape, pitch=pitch, modulus=MODULUS, boundary="free"))
    lengths = DISTANCE * np.diff(np.linspace(0, 1, STEPS + 1) ** 2)  # short steps first
    for length in lengths:
        springs = rc.Product(lambda p, c=RATE * length: H @ p + c * p, gap.shape, pitch=pitch)
        step = rc.solve(undeformed_gap=gap + wear, system=springs, load=LOAD, tol=1e-9)
        wear += RATE * length * step.pressure
        deformed = gap + wear + H @ step.pressure - step.approach
        off = max(-deformed.min(), np.abs(deformed[step.pressure > 0]).max()) / step.approach
        yield np.sqrt(step.contact_area / np.pi), step.pressure.max(), wear.sum() * pitch**2, off


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--points", type=int, default=64)
    for number, (radius, largest, volume, off) in enumerate(worn(parser.parse_args().points), 1):
        if number in (1, 2, 5, 10, STEPS):
            print(f"step {number}: radius {radius:.3f} mm, at most {largest:.0f} MPa, worn {volume:.3e} mm^3, off by {off:.0e}")
    print(f"k F s = {RATE * LOAD * DISTANCE:.3e} mm^3, worn flat: radius {(4 * RADIUS * volume / np.pi) ** 0.25:.3f} mm")
