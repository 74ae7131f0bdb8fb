#!/usr/bin/env python3
"""Reference values of the free kernels, by their closed forms in 60 digits (mpmath).

usage: kernel_reference.py > kernel_reference.txt
Each line: kernel hx hy ix iy value, the value being E* times the deflection at (ix*hx, iy*hy) for unit pressure on the cell.
The closed forms are the textbook ones, not the arrangements that the library uses."""
from mpmath import asin, asinh, ellipe, ellipk, mp, mpf, nstr, pi, sqrt

mp.dps = 60

NEAR = [(0, 0), (1, 0), (0, 1), (1, 1), (2, 0), (0, 2), (2, 1), (1, 2), (2, 2), (3, 0), (3, 1), (0, 3), (3, 3), (4, 0), (2, 4),
        (5, 0), (4, 3), (5, 2), (6, 1), (7, 7)]
FAR = [(10, 0), (12, 9), (0, 17), (31, 5), (40, 40), (100, 1), (3, 144), (360, 0), (150, 149), (1000, 7), (2047, 2048),
       (16384, 0), (0, 16384), (1, 16384), (16384, 1), (5000, 12), (16384, 16384), (9999, 16001)]
# Offsets along the short side of a cell of aspect 100 that are still near in units of the long one.
NARROW = [(5, 0), (20, 0), (50, 0), (100, 0), (199, 1), (300, 0), (300, 2), (420, 1), (449, 3), (700, 0), (1500, 4)]


def love(x, y, hx, hy):
    def corner(x, y):
        return (x * asinh(y / abs(x)) if x else 0) + (y * asinh(x / abs(y)) if y else 0)
    a, b = hx / 2, hy / 2
    return (corner(x + a, y + b) - corner(x - a, y + b) - corner(x + a, y - b) + corner(x - a, y - b)) / pi


def galerkin(x, y, hx, hy):
    def corner(x, y):
        x, y = abs(x), abs(y)
        r = sqrt(x * x + y * y)
        return (x * y / 2 * (x * asinh(y / x) + y * asinh(x / y)) if x and y else 0) - r**3 / 6
    difference = [(-1, 1), (0, -2), (1, 1)]
    return sum(cx * cy * corner(x + i * hx, y + j * hy) for i, cx in difference for j, cy in difference) / (pi * hx * hy)


def disc(x, y, hx, hy):
    if x == y == 0:
        return 4 * hx / pi
    r = sqrt(x * x + y * y)
    m = (hx / (2 * r))**2
    return 16 * r / pi**2 * (ellipe(m) - (1 - m) * ellipk(m))


def punch(x, y, hx, hy):
    return hx if x == y == 0 else 2 * hx / pi * asin(hx / (2 * sqrt(x * x + y * y)))


def eq9(x, y, hx, hy):
    return 2 * hx / pi if x == y == 0 else punch(x, y, hx, hy)


def rows(kernel, hx, hy, offsets):
    for ix, iy in offsets:
        value = kernel(ix * mpf(hx), iy * mpf(hy), mpf(hx), mpf(hy))
        print(kernel.__name__, hx, hy, ix, iy, nstr(value, 20, min_fixed=-1, max_fixed=1))


if __name__ == '__main__':
    print('# kernel hx hy ix iy value')
    transposed = [(iy, ix) for ix, iy in NARROW]
    for kernel in love, galerkin:
        for hx, hy in (1.0, 1.0), (0.7, 1.9):
            rows(kernel, hx, hy, NEAR + FAR)
        rows(kernel, 0.01, 1.0, NEAR + FAR + NARROW)
        rows(kernel, 5.0, 0.05, NEAR + FAR + transposed)
    for kernel in disc, punch, eq9:
        rows(kernel, 1.0, 1.0, NEAR + FAR)
        rows(kernel, 0.3, 0.3, NEAR[:8])
