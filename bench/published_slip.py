"""Partial slip of periodic rough surfaces: the model of Ciavarella and Jäger, from which rc_law_slip follows, beside the problem with both components of
the shear. E* and the side are 1.

The latter: min 1/2 q'Cq - slip . sum q over |q_i| <= mu p_i, C of symbol 2/((1-nu)|k|) (I - nu kk'/|k|^2). Its duality gap is
sum(mu p_i |w_i| - q_i . w_i), w = slip - Cq. Projected gradients with Nesterov's steps and restarts."""
import math

import numpy as np
import roughcontact as rc

from surfaces import self_affine_gap

SLOPE, FRICTION = 0.1, 0.3
RATIOS = (0.0, 0.15, 0.3, 0.4, 0.5)  # Poisson's
SHARES = (0.3, 0.7)  # of the friction, by the model
WITHIN, ITERATIONS = 1e-8, 5000  # duality gap over energy


def shear_compliance(n, nu):
    kx, ky = np.meshgrid(2 * math.pi * np.fft.rfftfreq(n, 1 / n), 2 * math.pi * np.fft.fftfreq(n, 1 / n))
    k = np.hypot(kx, ky)
    k[0, 0] = 1
    scale = 2 / ((1 - nu) * k)
    symbol = [scale * (1 - nu * (kx / k)**2), scale * (1 - nu * (ky / k)**2), -scale * nu * kx * ky / k**2]
    for each in symbol:
        each[0, 0] = 0

    def product(q):
        x, y = np.fft.rfft2(q[0]), np.fft.rfft2(q[1])
        return np.array([np.fft.irfft2(symbol[0] * x + symbol[2] * y, (n, n)), np.fft.irfft2(symbol[2] * x + symbol[1] * y, (n, n))])
    return product, scale[0, 1]  # and the largest eigenvalue


def sheared(product, largest, friction, slip, start):
    """(shears, duality gap over energy)"""
    def projected(q):
        size = np.hypot(q[0], q[1])
        return q * np.where(size > friction, friction / np.maximum(size, 1e-300), 1)

    def gap(q):
        deflected = product(q)
        rest, energy = slip - deflected, 0.5 * (q * deflected).sum() - (slip * q).sum()
        return (friction * np.hypot(rest[0], rest[1]) - (q * rest).sum(0)).sum() / abs(energy)
    q = ahead = start
    t, found = 1.0, math.inf
    for iteration in range(1, ITERATIONS + 1):
        moved = projected(ahead + (slip - product(ahead)) / largest)
        if ((ahead - moved) * (moved - q)).sum() > 0:
            t = 1.0
        longer = (1 + math.sqrt(1 + 4 * t * t)) / 2
        ahead, q, t = moved + (t - 1) / longer * (moved - q), moved, longer
        if iteration % 25 == 0:
            found = gap(q)
            if found < WITHIN:
                break
    return q, found


def model_errors(n, seed, hurst, pressure):
    """{force, field: [[of a share] of a ratio], relative; gap: the largest}"""
    gap = self_affine_gap(n, seed, hurst, 4, n // 8, SLOPE)

    def pressed(load):
        return rc.solve(undeformed_gap=gap, pitch=1 / n, modulus=1, load=load, boundary='periodic', options={'tol': 1e-10})
    all_stick = pressed(pressure * SLOPE)
    still = {share: pressed(pressure * SLOPE * (1 - share)) for share in SHARES}
    found = {'area': all_stick.area_fraction, 'force': [], 'field': [], 'gap': 0}
    for nu in RATIOS:
        product, largest = shear_compliance(n, nu)
        errors = []
        for share, rest in still.items():
            slip = np.array([FRICTION * (2 - nu) / (2 - 2 * nu) * (all_stick.approach - rest.approach), 0])[:, None, None]
            model = np.array([FRICTION * (all_stick.pressure - rest.pressure), np.zeros((n, n))])
            shear, within = sheared(product, largest, FRICTION * all_stick.pressure, slip, model)
            errors.append((shear[0].sum() / model[0].sum() - 1, np.linalg.norm(shear - model) / np.linalg.norm(shear)))
            found['gap'] = max(found['gap'], within)
        found['force'].append([force for force, _ in errors])
        found['field'].append([field for _, field in errors])
    return found
