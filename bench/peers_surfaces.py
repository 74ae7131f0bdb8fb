"""Gaps on the unit square, written once as .npy and read by every code."""
import hashlib
import os

import numpy as np

from surfaces import paraboloid_gap

HURST, SEED, WAVES, SHORTEST, RMS = 0.8, 42, 12, 0.33, 0.02


def own_self_affine(n):
    """The band, exponent and rms height of rough-H0.8 with other phases: for where rfgen is not installed."""
    k = np.hypot(np.fft.fftfreq(n)[:, None], np.fft.rfftfreq(n)[None, :])
    noise = np.fft.rfft2(np.random.default_rng(SEED).standard_normal((n, n)))
    with np.errstate(divide='ignore'):
        noise *= np.where((k >= WAVES / n) & (k <= SHORTEST), k**-(1 + HURST), 0)
    return np.fft.irfft2(noise, s=(n, n))


def rough(n):
    """The workload rough-H0.8 of ASPHER: 12 waves a side up to a third of a wave per cell, at every n. Free boundaries."""
    try:
        import rfgen
        heights = rfgen.selfaffine_field(dim=2, N=n, Hurst=HURST, k_low=WAVES / n, k_high=SHORTEST, plateau=False, noise=True,
                                         rng=np.random.default_rng(SEED), verbose=False)
        maker = 'rfgen'
    except ImportError:
        heights, maker = own_self_affine(n), 'own'
    heights *= -RMS / np.std(heights)
    return heights, maker


def wavy(n):
    """Tamaas' generator: 4 waves a side, power law of exponent 0.8 up to 8 cells a wave. Periodic."""
    try:
        import tamaas
    except ImportError:
        heights, maker = own_self_affine(n), 'own'
    else:
        generator = tamaas.SurfaceGeneratorFilter2D([n, n])
        generator.spectrum = tamaas.Isopowerlaw2D()
        generator.spectrum.q0, generator.spectrum.q1, generator.spectrum.q2 = 4, 4, max(n // 8, 8)
        generator.spectrum.hurst = HURST
        generator.random_seed = SEED
        heights, maker = np.array(generator.buildSurface()), 'tamaas'
    heights *= -RMS / np.std(heights)
    return heights, maker


MAKERS = {'rough': rough, 'wavy': wavy, 'sphere': lambda n: (paraboloid_gap(n), 'exact')}  # a sphere of radius 1, its top between the four middle cells


def write(kind, n, folder):
    """The file of a gap, how it was made and what it holds."""
    gap, maker = MAKERS[kind](n)
    gap = np.ascontiguousarray(gap, dtype=np.float64)
    gap -= gap.min()
    file = os.path.join(folder, f'{kind}-{n}-{maker}.npy')
    np.save(file + '.part.npy', gap)
    os.replace(file + '.part.npy', file)
    with open(file, 'rb') as source:
        digest = hashlib.blake2b(source.read(), digest_size=8).hexdigest()
    return {'file': file, 'maker': maker, 'digest': digest}
