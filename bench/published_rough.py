"""Rough surfaces as in published studies: loads at which the gap stops crossing, areas and mean gaps against load, and the surface of the
contact-mechanics challenge. E* and the side are 1; pressures are over E* times the rms slope, gaps over the rms height."""
import math

import numpy as np
import roughcontact as rc

from contact import status_of
from surfaces import self_affine_gap

SLOPE = 0.1
HURSTS = (0.3, 0.8)
NEAR_CROSSING = (0.21, 0.25)  # pressures between which the gap mostly stops crossing
AREA_PRESSURES = (0.01, 0.02, 0.05, 0.1, 0.2, 0.4, 0.8)
CHALLENGE_PRESSURES = (0.0005, 0.002, 0.01, 0.03, 0.075)  # 0.1 to 15 % of the area; 0.01 is the challenge's own
BINS, HIGHEST = 26, 1.3  # of the histogram, over E* slope
GAP_BINS, WIDEST = 40, 3.0  # over the rms height


def persson(pressure, weight=lambda area: 1, steps=400):
    """Area by Persson's theory. weight: share, at an area in contact, by which further roughness widens the distribution of pressures."""
    if not pressure:
        return 0
    area, variance = 1.0, 0.0
    for _ in range(steps):
        variance += weight(area) / (4 * steps)
        area = math.erf(pressure / math.sqrt(2 * variance))
    return area


def wang_mueser(area):
    """Wang & Müser, Tribology Letters 65(3) (2017)."""
    return 5 / 9 - 2 / 9 * area**2 + 2 / 3 * area**4


class Pressed:
    """A periodic surface under one load after another; each starts from those before."""

    def __init__(self, n, seed, hurst, roll_off, cut_off, options, longest=0):
        self.gap = self_affine_gap(n, seed, hurst, roll_off, cut_off, SLOPE, longest)
        self.contact = rc.Contact(rc.HalfSpace((n, n), pitch=1 / n, modulus=1, boundary='periodic'), options=options)
        self.mean, self.rms, self.set = self.gap.mean(), self.gap.std(), False

    def at(self, pressure, **more):
        result = self.contact.solve(load=pressure * SLOPE, undeformed_gap=None if self.set else self.gap, borrow=True, check=False, **more)
        self.set = True
        return result

    def row(self, pressure):
        result = self.at(pressure)
        area = result.measure_area()
        return {'status': status_of(result), 'area': area.area, 'lower': result.area_lower, 'upper': result.area_upper,
                'corrected': area.corrected_area, 'mean_gap': (self.mean - result.approach) / self.rms}

    def distributions(self, pressure):
        """Densities of pressures and of open gaps over all points, and patches of 2^k .. 2^(k+1) - 1 cells."""
        result = self.at(pressure, want_gap=True)
        found, cells = result.histogram(BINS, HIGHEST * SLOPE), result.find_patches().cells
        counts, _ = np.histogram(result.gap[result.pressure == 0] / self.rms, GAP_BINS, (0, WIDEST))
        return {'pressures': found.density * result.contact_area * SLOPE, 'gaps': counts * GAP_BINS / WIDEST / result.points,
                'patch_octaves': np.bincount(np.frexp(cells.astype(float))[1] - 1)}


def nayak(hurst, roll_off, cut_off, longest):
    """m0 m4 / m2^2 of the spectrum on a grid of wave numbers."""
    k = np.hypot(*np.meshgrid(np.arange(-cut_off, cut_off + 1), np.arange(cut_off + 1)))
    power = np.where((k <= cut_off) & (k >= max(longest, 1)), np.maximum(k, roll_off)**(-2 - 2 * hurst), 0)
    m0, m2, m4 = power.sum(), (power * k**2).sum() / 2, (power * k**4).sum() * 3 / 8
    return m0 * m4 / m2**2


def last_crossing(pressed, finest):
    """{axis: corrected area at which the gap stops crossing along it}, the middle of two loads whose areas are `finest` apart at most."""
    seen = []

    def look(pressure):
        result = pressed.at(pressure)
        seen.append((pressure, result.corrected_area, result.gap_crosses, result.contact_area))
        seen.sort()

    for pressure in NEAR_CROSSING:
        look(pressure)
    found = {}
    for axis in 'xy':
        while True:
            crossing = max((each for each in seen if axis in each[2]), default=None)
            closed = min((each for each in seen if axis not in each[2] and (not crossing or each > crossing)), default=None)
            if not crossing:
                look(0.7 * closed[0])
            elif not closed:
                look(1.3 * crossing[0])
            elif closed[1] - crossing[1] < finest:
                break
            else:
                look((closed[0] + crossing[0]) / 2)
        found[axis] = (closed[1] + crossing[1]) / 2
        found[axis + '_raw'], found[axis + '_pressure'] = (closed[3] + crossing[3]) / 2, (closed[0] + crossing[0]) / 2
    return {**found, 'steps': len(seen)}
