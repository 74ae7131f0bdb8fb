#!/usr/bin/env python3
"""Reference coefficients of the kernel layer, by their Fourier integral: the response to a wave solves the layered problem in 30
digits (mpmath), the integral is Gauss' rule in the wave number and the trapezium rule, which converges exponentially, in its
direction.

usage: layer_reference.py > layer_reference.txt
       layer_reference.py COUNT PROGRAM: asks test_layer for COUNT coefficients of random layers
Each line: thickness modulus poisson substrate_poisson base interface hx hy ix iy value, the value being E* of the half-space times
the mean deflection of the cell at (ix*hx, iy*hy) by unit pressure on the cell at the origin. Errors are below 1e-14 of that at (0, 0)."""
import concurrent.futures
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import mpmath as mp
import numpy as np
from kernel_reference import galerkin

mp.mp.dps = 30
NEAR = [(0, 0), (1, 0), (0, 1), (0, 2), (1, 1), (3, 2), (11, 4), (12, 0), (13, 9)]
FAR = [(45, 40), (70, 10), (200, 150)]
LAYERS = [  # thickness, modulus, poisson, substrate_poisson, base, interface, hx, hy
    (2, .1, .3, .3, 'half-space', 'bonded', 1, 1), (.1, .1, .3, .3, 'half-space', 'bonded', 1, 1),
    (.3, 10, .3, .3, 'half-space', 'bonded', 1, 1.3), (30, 10, .45, .2, 'half-space', 'bonded', 1, 1),
    (.4, .2, .5, .3, 'half-space', 'bonded', 1, 1), (5, 1000, .3, .3, 'half-space', 'bonded', 1, 1),
    (1, 30, .3, .3, 'half-space', 'frictionless', 1, .7), (3, .02, .1, .4, 'half-space', 'frictionless', 1, 1),
    (1, 1, .3, .3, 'rigid', 'bonded', 1, 1), (2, 1, .5, .3, 'rigid', 'bonded', 1, 1),
    (.6, 2, .4, .3, 'rigid', 'bonded', 1, .8), (.2, 1, .3, .3, 'rigid', 'frictionless', 1, 1),
    (0.08887141836105016, 0.02666044626703841, 0.4486274496097779, 0.5, 'rigid', 'bonded', 1, 1.19),
    (.09, .03, .5, .3, 'half-space', 'bonded', 1, 1.2)]


def term(modulus, nu, slope, linear, origin, z, q, exp=mp.exp):
    """Stresses zz and xz, displacements x and z of one term of Airy's function."""
    g, shear = exp(slope * (z - origin)) / q**2, modulus * (1 - nu) / 2
    d = [(slope**k * z + (k * slope**(k - 1) if k else 0)) * g if linear else slope**k * g for k in range(4)]
    along = [((1 - nu) * d[k + 2] + nu * q * q * d[k]) / (2 * shear * q) for k in (0, 1)]
    return [-q * q * d[0], q * d[1], along[0], along[1] / q - d[1] / shear]


def equations(s, modulus, nu1, nu2, base, interface, exp, zero, one):
    """Their rows, and the deflection of the surface by each term."""
    terms = [(-s if k < 2 else s, k % 2 == 1, 0 if k < 2 else 1) for k in range(4)]
    top = [term(modulus, nu1, slope, linear, origin, zero, s, exp) for slope, linear, origin in terms]
    low = [term(modulus, nu1, slope, linear, origin, one, s, exp) for slope, linear, origin in terms]
    half = [[-x for x in term(one, nu2, -s, linear, 0, zero, s, exp)] for linear in (False, True)]
    rows = [[x[0] for x in top] + [0, 0], [x[1] for x in top] + [0, 0], [x[3] for x in low] + [x[3] for x in half]]
    if interface == 'bonded':
        rows += [[x[i] for x in low] + [x[i] for x in half] for i in (2, 0, 1)]
    else:
        rows += [[x[1] for x in low] + [0, 0], [x[0] for x in low] + [x[0] for x in half],
                 [0] * 4 + [x[1] for x in half]]
    if base == 'rigid':
        rows = [row[:4] for row in rows[:4]]
    return rows, [x[3] for x in top]


def response(s, modulus, nu1, nu2, base, interface):
    """Of a layer of thickness 1 to the wave number s: E* s / 2 times the deflection."""
    s, modulus, nu1, nu2 = map(mp.mpf, (s, modulus, nu1, nu2))
    rows, deflections = equations(s, modulus, nu1, nu2, base, interface, mp.exp, mp.mpf(0), mp.mpf(1))
    load = mp.matrix(len(rows), 1)
    load[0] = -1
    found = mp.lu_solve(mp.matrix(rows), load)
    return sum(deflections[k] * found[k] for k in range(4)) * s / 2


def responses(s, modulus, nu1, nu2, base, interface):
    """The same of an array in double precision, which is off by less than 1e-12 where s is 0.5 or more."""
    rows, deflections = equations(s, modulus, nu1, nu2, base, interface, np.exp, 0.0, 1.0)
    matrix = np.array([[np.broadcast_to(x, s.shape) for x in row] for row in rows]).transpose(2, 0, 1)
    load = np.zeros((len(s), len(rows), 1))
    load[:, 0] = -1
    found = np.linalg.solve(matrix, load)[:, :4, 0]
    return np.sum(found * np.array([np.broadcast_to(x, s.shape) for x in deflections]).T, 1) * s / 2


def coefficients(layer, offsets, fast=False):
    t, modulus, nu1, nu2, base, interface, hx, hy = layer
    x, y = (np.array([each[axis] * h for each in offsets], float) for axis, h in ((0, hx), (1, hy)))
    far = (np.hypot(x, y).max() + 2 * max(hx, hy)) / t
    gauss, weights = np.polynomial.legendre.leggauss(20)
    chebyshev = np.cos(np.pi * (np.arange(28) + .5) / 28)
    ends = np.concatenate([[0], np.geomspace(1e-5, 1, 18), np.arange(2, 23)])
    total = np.zeros(len(offsets))
    for a, b in zip(ends[:-1], ends[1:]):
        at = (a + b) / 2 + (b - a) / 2 * chebyshev
        if fast and a >= .5:
            beyond = responses(at, modulus, nu1, nu2, base, interface) - 1 / modulus
        else:
            beyond = [float(response(each, modulus, nu1, nu2, base, interface) - 1 / mp.mpf(modulus)) for each in at]
        series = np.polynomial.chebyshev.chebfit(chebyshev, beyond, 27)
        parts = int(np.ceil((b - a) * far / 10))
        for part in range(parts):
            width = (b - a) / parts
            s = a + width * (part + (gauss + 1) / 2)
            g = np.polynomial.chebyshev.chebval((s - (a + b) / 2) / ((b - a) / 2), series) * width * weights / 2
            quarter = int(10 + .55 * s.max() * far) + 1
            angle, share = np.pi / 2 * np.arange(quarter + 1) / quarter, np.full(quarter + 1, 1 / quarter)
            share[0] = share[-1] = .5 / quarter
            qx, qy = np.outer(s, np.cos(angle)) / t, np.outer(s, np.sin(angle)) / t
            common = g[:, None] * share * np.sinc(qx * hx / 2 / np.pi)**2 * np.sinc(qy * hy / 2 / np.pi)**2
            total += [np.sum(common * np.cos(qx * each_x) * np.cos(qy * each_y)) for each_x, each_y in zip(x, y)]
    own = np.array([float(galerkin(mp.mpf(a), mp.mpf(b), mp.mpf(hx), mp.mpf(hy))) for a, b in zip(x, y)])
    return own / modulus + total * hx * hy / np.pi / t


def random_layer(random):
    """(a layer of any kind, offsets of which it has coefficients)"""
    thickness, modulus = 10**random.uniform(-1.3, 2), 10**random.uniform(-2, 2)
    nu1, nu2 = (random.choice([0, .5, random.uniform(0, .5)], p=[.1, .2, .7]) for _ in range(2))
    base, interface = random.choice(['half-space', 'rigid']), random.choice(['bonded', 'frictionless'])
    hx, hy = 1, round(random.uniform(.6, 1.6), 2)
    offsets = [(0, 0), (1, 0), (0, 1)]
    while len(offsets) < 12:
        reach = 10**random.uniform(0, np.log10(min(250, max(3, 80 * thickness))))
        offsets.append(tuple(int(abs(each)) for each in random.uniform(-reach, reach, 2)))
    return (thickness, modulus, nu1, nu2, base, interface, hx, hy), offsets


def rows(layer, offsets, fast=False):
    values = coefficients(layer, offsets, fast)
    return [' '.join(map(str, [*layer, ix, iy, f'{value:.17g}'])) for (ix, iy), value in zip(offsets, values)]


def fast_rows(layer, offsets):
    return rows(layer, offsets, fast=True)


def ask(count, program):
    random, chosen = np.random.default_rng(64), []
    while sum(len(offsets) for _, offsets in chosen) < count:
        chosen.append(random_layer(random))
    with concurrent.futures.ProcessPoolExecutor(2) as processes:
        text = sum(processes.map(fast_rows, *zip(*chosen)), [])
    with tempfile.NamedTemporaryFile('w', suffix='.txt') as file:
        file.write('\n'.join(text[:count]) + '\n')
        file.flush()
        return subprocess.run([program, file.name]).returncode


if __name__ == '__main__':
    if len(sys.argv) == 3:
        sys.exit(ask(int(sys.argv[1]), sys.argv[2]))
    print('# thickness modulus poisson substrate_poisson base interface hx hy ix iy value')
    for each in LAYERS:
        chosen = NEAR + (FAR if each[0] >= .3 else [])
        print('\n'.join(rows(each, chosen)))
