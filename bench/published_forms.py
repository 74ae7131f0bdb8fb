"""Contacts whose loads, areas or pressures are known in closed form, on several grids; and Greenwood & Tripp's rough sphere beside rough spheres that
are pressed point by point. E* and the side of the grid are 1."""
import math
from dataclasses import dataclass
from typing import Callable

import numpy as np
import roughcontact as rc

from contact import certified, solve, unit_square
from surfaces import HEIGHT, Hertz, coordinates, paraboloid_gap, self_affine_gap, two_waves, wave

OPTIONS = {'tol': 1e-9, 'threads': 1}
FULL_WAVES = math.sqrt(2) * math.pi * HEIGHT  # the load that presses two crossed waves flat


def radius(n):
    x, y = coordinates(n)
    return np.hypot(x, y)


@dataclass(frozen=True)
class Form:
    """known: the closed form's value; found: ours on n x n points."""
    title: str
    source: str
    quantity: str
    known: float
    found: Callable


def load_at(gap, approach, boundary='free', mask=None):
    def found(n):
        result = solve(unit_square(n, boundary), gap(n), OPTIONS, approach=approach, mask=mask and mask(n))
        return certified(result).load
    return found


def pressed_waves(n, share, corrected=True):
    """Two crossed waves under a share of the load that presses them flat."""
    result = certified(solve(unit_square(n, 'periodic'), HEIGHT * (1 - two_waves(n)), OPTIONS, load=share * FULL_WAVES))
    return result.corrected_area if corrected else float(result.pressure.max())


SPHERE, HALF_WAVE, CONE, CONE_SLOPE, PUNCH = Hertz(0.25), wave(0.5), 0.25, 0.05, 0.25  # radii in contact
FORMS = (
    Form('sphere, radius of contact 1/4', 'Hertz 1881', 'load', SPHERE.load, load_at(paraboloid_gap, SPHERE.approach)),
    Form('cone, radius of contact 1/4', 'Sneddon 1965', 'load', math.pi / 2 * CONE**2 * CONE_SLOPE,
         load_at(lambda n: CONE_SLOPE * radius(n), math.pi / 2 * CONE * CONE_SLOPE)),
    Form('flat round punch, radius 1/4', 'Sneddon 1965', 'load', 2 * PUNCH * HEIGHT,
         load_at(lambda n: np.zeros((n, n)), HEIGHT, mask=lambda n: (radius(n) <= PUNCH).astype(np.uint8))),
    Form('one wave, half in contact', 'Westergaard 1939', 'load', HALF_WAVE.load,
         load_at(lambda n: HEIGHT * (1 - np.cos(2 * math.pi * coordinates(n)[0])) + 0 * coordinates(n)[1],
                 HALF_WAVE.target, 'periodic')),
    Form('two crossed waves, 1.2 of the load that closes them', 'Johnson, Greenwood & Higginson 1985', 'highest pressure', 2.2 * FULL_WAVES,
         lambda n: pressed_waves(n, 1.2, corrected=False)))

# Both ends of the area of two crossed waves (Johnson, Greenwood & Higginson 1985): exact as the share of the load goes to 0, or to 1.
LIGHT_SHARES, HEAVY_SHARES = (0.04, 0.02, 0.01, 0.005), (0.9, 0.95, 0.98, 0.99)


def crossed_waves(n, share):
    """Row: area in contact (light) or out of contact (heavy), the asymptote's, and their ratio."""
    light = share < 0.5
    area = pressed_waves(n, share)
    ours = area if light else 1 - area
    theirs = math.pi * (3 * share / (8 * math.pi))**(2 / 3) if light else 3 / (2 * math.pi) * (1 - share)
    return {'quantity': 'area in contact' if light else 'area out of contact', 'ours': ours, 'theirs': theirs, 'difference': ours / theirs - 1}


# Rough sphere: radius 1, roughness between 16 and 64 waves a side, under the load that makes the smooth one's radius of contact 0.2.
ROUGH_SLOPES, ROUGH_HERTZ, BAND = (0.5, 1.0, 2.0), Hertz(0.2), (16, 64)


class Summits:
    """Greenwood & Tripp (Journal of Applied Mechanics 34 (1967) 153): spherical summits of one radius, Gaussian in height, each pressed by Hertz's
    formula without its neighbours, on a sphere that their mean pressure deforms. Density, radius and scatter of the summits: Nayak's, from
    the moments of the spectrum (McCool 1986)."""

    def __init__(self, gap):
        spectrum = np.abs(np.fft.fft2(gap - gap.mean()) / gap.size)**2
        k = 2 * math.pi * np.fft.fftfreq(len(gap), 1 / len(gap))
        square = k[None, :]**2 + k[:, None]**2
        m0, m2, m4 = spectrum.sum(), (spectrum * square).sum() / 2, (spectrum * square**2).sum() * 3 / 8
        self.nayak = m0 * m4 / m2**2
        self.sigma = math.sqrt((1 - 0.8968 / self.nayak) * m0)
        density, tip = m4 / m2 / (6 * math.pi * math.sqrt(3)), 3 * math.sqrt(math.pi) / (8 * math.sqrt(m4))
        self.mean_height = 4 * math.sqrt(m0 / (math.pi * self.nayak))
        over, step = np.linspace(0, 14, 1401, retstep=True)
        self.separations = np.linspace(-8, 6, 701)  # over sigma
        density_at = np.exp(-0.5 * (self.separations[:, None] + over)**2) / math.sqrt(2 * math.pi)
        self.pressures = 4 / 3 * density * math.sqrt(tip) * self.sigma**1.5 * step * density_at @ over**1.5

    def pressure(self, separation):
        """E* is 1. separation: of the deformed sphere from the mean plane of the roughness."""
        return np.interp((separation - self.mean_height) / self.sigma, self.separations, self.pressures)

    def pressed(self, load, n, relaxation, rounds=1000):
        """Pressures [n, n] under a load: the deflection relaxes towards that of its pressures, at an approach which keeps the load."""
        table = np.zeros((2 * n, 2 * n))
        table[:n, :n] = rc.kernel_coefficients('love', (n, n), 1 / n)
        for axis in (0, 1):
            table += np.roll(np.flip(table, axis), 1, axis) * (np.arange(2 * n) > n).reshape((-1, 1) if axis == 0 else (1, -1))
        response, sphere = np.fft.rfft2(table), paraboloid_gap(n)
        deflection, low, high = np.zeros((n, n)), -1.0, 1.0
        for _ in range(rounds):
            for _ in range(50):
                approach = (low + high) / 2
                pressures = self.pressure(sphere + deflection - approach)
                low, high = (approach, high) if pressures.mean() < load else (low, approach)
            target = np.fft.irfft2(response * np.fft.rfft2(pressures, (2 * n, 2 * n)))[:n, :n]
            change = target - deflection
            deflection += relaxation * change
            low, high = approach - 0.01, approach + 0.01
            if np.abs(change).max() < 1e-5 * np.abs(target).max():
                break
        return pressures


def spread_of(pressures):
    """(pressure near the middle over Hertz's, mean distance of the load from the axis over Hertz's)"""
    n = len(pressures)
    x = radius(n)
    middle = x < 0.3 * ROUGH_HERTZ.radius
    return (pressures[middle].mean() / ROUGH_HERTZ.pressure(n)[middle].mean(),
            (pressures * x).sum() / pressures.sum() / (3 * math.pi / 16 * ROUGH_HERTZ.radius))


def rough_sphere(n, slope, seeds):
    """Row: both numbers by the model, and over rough spheres."""
    gaps = [self_affine_gap(n, seed, 0.8, BAND[0], BAND[1], slope, longest=BAND[0]) for seed in seeds]
    model, row = Summits(gaps[0]), {}
    roughness = model.sigma / ROUGH_HERTZ.approach
    theirs = spread_of(model.pressed(ROUGH_HERTZ.load, 128, min(0.5, roughness / 2)))
    ours = np.array([spread_of(certified(solve(unit_square(n), paraboloid_gap(n) + gap, OPTIONS, load=ROUGH_HERTZ.load)).pressure) for gap in gaps])
    for column, name in enumerate(('middle', 'distance')):
        row.update({f'model_{name}': theirs[column], name: ours[:, column].mean(), f'{name}_scatter': np.ptp(ours[:, column]) / 2})
    return {'roughness': roughness, 'nayak': model.nayak, **row}
