#!/usr/bin/env python3
"""Where the response of a layer (src/kernel/layer/response.h) has its nearest singularity in the first quadrant of s or within 0.6
of its edge, the imaginary axis: zeros of its denominator within a sector of a disc, by the turns of its argument along the edge.
Prints, for each base and ratio m of the moduli, the smallest distance over Poisson's ratios, and the smallest share of the lesser of
(6/m)^(1/3) and 1.4 - 0.9 nu1 (sliding: 2.3); the least share last."""
import numpy as np

WIDTH = np.pi / 2 + 0.6


def denominator(s, m, nu1, nu2, base):
    e = np.exp(-2 * s)
    k1, k2, mu, rest = 3 - 4 * nu1, 3 - 4 * nu2, m * (1 - nu1) / (1 - nu2), 1 - e
    a, c = rest * rest - 4 * s * s * e, 1 - e * e + 4 * s * e
    if base == 'half-space, bonded':
        return (mu - 1) * (1 + mu * k2) * a + (1 + k1) * (1 + k1 + rest * (mu * k2 - k1 + (mu - 1) * e))
    if base == 'half-space, sliding':
        return (c + m * a) / s
    return k1 * (1 + e * e) + 4 * s * s * e + (1 + k1 * k1) * e if base == 'rigid, bonded' else c / s


def zeros(radius, *layer, n=4000):
    edge = np.concatenate([np.linspace(1e-9, radius, n), radius * np.exp(1j * np.linspace(0, WIDTH, n)),
                           np.exp(1j * WIDTH) * np.linspace(radius, 1e-9, n)])
    turned = np.unwrap(np.angle(denominator(edge, *layer)))
    return abs(turned[-1] - turned[0]) / (2 * np.pi)


def nearest(*layer):
    low, high = 0.0, 6.0
    for _ in range(30):
        middle = (low + high) / 2
        low, high = (middle, high) if zeros(middle, *layer) < 0.3 else (low, middle)
    return low


shares = []
for base in ('half-space, bonded', 'half-space, sliding', 'rigid, bonded', 'rigid, sliding'):
    for m in [1] if base.startswith('rigid') else [1e-6, 1e-4, 1e-2, 0.1, 0.3, 0.5, 0.8, 1.2, 2, 3, 5, 10, 30, 100, 1e3, 1e4, 1e6]:
        found = [(nearest(m, nu1, nu2, base), 1.4 - 0.9 * nu1 if base.endswith('bonded') else 2.3)
                 for nu1 in (0, 0.15, 0.3, 0.4, 0.5) for nu2 in (0, 0.3, 0.5)]
        plate = np.inf if base.startswith('rigid') else (6 / m) ** (1 / 3)
        shares.append(min(zero / min(other, plate) for zero, other in found))
        print(f'{base}, m = {m}: {min(found)[0]:.4f}, {shares[-1]:.3f}')
print(f'least share {min(shares):.3f}')
