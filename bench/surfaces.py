"""The surfaces that are pressed: gaps [n, n] over the unit square at the centres of cells, heights of rough and textured ones; and the scenes of the
comparison of speed with accuracy, which grids of several cell sizes show, what is known of their contacts, and errors against that."""
import functools
import math
import os
from dataclasses import dataclass, replace
from typing import Callable, Optional

import numpy as np
import roughcontact as rc

from contact import Scene, find_load, solve, unit_square

GOLDEN = 0x9e3779b97f4a7c15
WORD = (1 << 64) - 1


def mixed(z):
    """The output function of splitmix64 (Steele, Lea & Flood 2014): the same numbers everywhere."""
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xbf58476d1ce4e5b9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94d049bb133111eb)
    return z ^ (z >> np.uint64(31))


def uniform(state, count):
    """The first numbers of splitmix64 from this state, uniform on (0, 1)."""
    steps = np.arange(1, count + 1, dtype=np.uint64) * np.uint64(GOLDEN) + np.uint64(state & WORD)
    return np.ldexp((mixed(steps) >> np.uint64(11)) + 0.5, -53)


def phases(seed, kx, ky):
    wave = (kx.astype(np.uint64) << np.uint64(32)) ^ (ky & 0xffffffff).astype(np.uint64)
    z = mixed(np.array([(seed + GOLDEN) & WORD], np.uint64)) ^ wave
    return 2 * math.pi * np.ldexp((mixed(z + np.uint64(GOLDEN)) >> np.uint64(11)).astype(float), -53)


def self_affine_gap(n, seed=1, hurst=0.8, roll_off=4, cut_off=0, rms_slope=0.1, longest=0):
    """About a mean plane at 0: random phases, power ~ |k|^-2(1+H) between roll_off and cut_off waves a side, flat below down to `longest`, none
    below that and above cut_off; cut_off 0: a shortest wave of 8 cells. Every wave's phase depends on the seed and its wave vector alone: a
    finer grid samples the same surface where cut_off is the same, and adds shorter waves to it where it grows with n."""
    cut_off = cut_off or n / 8
    most = int(cut_off)
    ky, kx = np.arange(-most, most + 1)[:, None], np.arange(most + 1)[None, :]
    k = np.hypot(kx, ky)
    amplitude = np.where((k <= cut_off) & (k >= longest) & ((kx > 0) | (ky > 0)), np.maximum(k, max(roll_off, 1e-300))**-(1 + hurst), 0)
    square_slope = 2 * np.sum((2 * math.pi * k * amplitude)**2)
    phase = phases(seed, kx, ky) + math.pi * (kx + ky) / n  # half a cell further: the centre of the first cell
    spectrum = np.zeros((n, most + 1), complex)
    spectrum[ky[:, 0] % n] = amplitude * np.exp(1j * phase)
    positive = np.arange(1, most + 1)
    spectrum[-positive, 0] = spectrum[positive, 0].conj()
    del k, amplitude, phase
    heights = np.fft.irfft(np.fft.ifft(spectrum, axis=0), n, axis=1)
    heights *= rms_slope / math.sqrt(square_slope) * n * n
    return heights


def coordinates(n):
    """(x [1, n], y [n, 1]) from the middle of the square."""
    x = (np.arange(n) + 0.5) / n - 0.5
    return x[None, :], x[:, None]


def paraboloid_gap(n):
    """Radius of curvature 1."""
    x, y = coordinates(n)
    return (x * x + y * y) / 2


class Hertz:
    """The paraboloid's contact of this radius."""

    def __init__(self, radius):
        self.radius, self.approach, self.load, self.area = radius, radius**2, 4 / 3 * radius**3, math.pi * radius**2

    def pressure(self, n):
        return 2 / math.pi * np.sqrt(np.maximum(0, self.radius**2 - 2 * paraboloid_gap(n)))


def below_highest(heights):
    return heights.max() - heights


def midpoint_surface(levels, hurst, seed):
    """Random midpoint displacement as in Bemporad & Paggi (2015): 2^levels points a side."""
    return rc.surface.rmd(levels, hurst=hurst, seed=seed).heights


def block_means(values, n):
    ratio = values.shape[0] // n
    return values if ratio == 1 else values.reshape(n, ratio, n, ratio).mean(axis=(1, 3))


@dataclass(frozen=True)
class SurfaceClass:
    """Surfaces whose spectrum is a power law, and others. Waves a side; 0: none."""
    name: str
    hurst: float = 0.7
    roll_off: float = 0
    low: float = 0    # the band's longest and shortest wave
    high: float = 0
    period: float = 0  # of pyramids, in cells
    noise: bool = False

    def heights(self, n, seed):
        if self.noise:
            return rc.surface.noise((n, n), pitch=1 / n, seed=seed).heights
        if self.period:  # of unequal heights, as etched
            pyramids = rc.surface.pyramids((n, n), pitch=1 / n, height=1, period=(self.period / n,) * 2)
            return pyramids.heights + 0.1 * SurfaceClass('slow', high=8).heights(n, seed)
        waves = {name: 2 * math.pi * value for name, value in (('q_low', self.low), ('q_rolloff', self.roll_off), ('q_high', self.high))}
        return rc.surface.spectral((n, n), pitch=1 / n, hurst=self.hurst, rms_height=1, seed=seed, **waves).heights


CLASSES = (SurfaceClass('power law'), SurfaceClass('roll-off at 8 waves', roll_off=8), SurfaceClass('roll-off at 16 waves', roll_off=16),
           SurfaceClass('roll-off at 48 waves', roll_off=48), SurfaceClass('band of 40 to 80 waves', low=40, high=80),
           SurfaceClass('pyramids of 21.3 cells', period=64 / 3), SurfaceClass('pyramids of 5.3 cells', period=16 / 3),
           SurfaceClass('white noise', noise=True))


def measured_scene(file):
    """A surface file, approach half of the height of the highest point above the mean."""
    surface = rc.read(file)
    gap = below_highest(surface.heights)
    return Scene(os.path.splitext(os.path.basename(file))[0], gap, gap.mean() / 2, surface.pitch)


def asperity_band(n, seed):
    """The gap of the band of waves that ASPHER's authors press: 12 waves a side up to a third of a wave per cell, rms height 0.02."""
    return below_highest(0.02 * SurfaceClass('rough', hurst=0.8, low=12, high=0.33 * n).heights(n, seed))


def rough_scene(levels, seed, hurst=0.7):
    gap = below_highest(midpoint_surface(levels, hurst, seed))
    return Scene('rough', gap, gap.mean() / 2)


def example_one(side, spacing, seed, kernel='love'):
    """Bemporad & Paggi (2015), Example 1: side x side unit cells, every one a candidate, penetrations uniform on (0, 1). Spacing 2: a
    masked cell between each two."""
    width = spacing * (side - 1) + 1
    gap, mask = np.full((width, width), 2.0), None
    gap[::spacing, ::spacing] = 1 - uniform(seed * 0x2545f4914f6cdd1d + 1, side * side).reshape(side, side)
    if spacing > 1:
        mask = np.zeros((width, width), np.uint8)
        mask[::spacing, ::spacing] = 1
    return Scene('example 1', gap, 1.0, mask=mask, kernel=kernel)


def hertz_scene(n):
    """A paraboloid pressed in over a contact radius of about a third of n cells."""
    x = np.arange(n) - 0.5 * (n - 1)
    return Scene('Hertz', (x[None, :]**2 + x[:, None]**2) / (2 * n), n / 9)


def influence(kernel, side, spacing=1):
    """The matrix of side x side cells whose centres are `spacing` cells apart, for contact modulus 1."""
    width = spacing * (side - 1) + 1
    table = rc.kernel_coefficients(kernel, (width, width), 1)[::spacing, ::spacing]
    y, x = np.divmod(np.arange(side * side), side)
    return table[np.abs(y[:, None] - y), np.abs(x[:, None] - x)]


HEIGHT = 0.01  # of waves, and the depth of the punch
CAPACITY = 0.36679  # of the unit square (Read 1997)
MEASURED = {  # title, and file below the folder of measured surfaces
    'afm_film': ('AFM, film', 'measured/afm_film_10um.gsf'), 'afm_selfaffine': ('AFM, self-affine', 'measured/afm_selfaffine_10um.gsf'),
    'afm_patch': ('AFM, one hill', 'measured/afm_patch_10um.gsf'), 'confocal_lay': ('confocal, machined', 'measured/confocal_lay_1275um.gsf'),
    'fv_rubber': ('focus variation, rubber', 'measured-lgpl/fv_rubber_2mm.gsf')}
RANDOM = {'self-affine': 'self-affine', **{f'rmd-0.{digit}': f'midpoint, H = 0.{digit}' for digit in (3, 5, 7, 9)}}  # by seeds
TITLES = {'hertz': 'Hertz', 'wave': 'one wave', 'waves': 'two waves, flat', 'punch': 'square punch', **RANDOM,
          **{name: title for name, (title, _) in MEASURED.items()}}
NAMES = tuple(TITLES)


@dataclass(frozen=True)
class Truth:
    """target: approach, or load in load control. pressure: on a grid, or by points a side where theory has it."""
    load: float
    area: float
    pressure: object = None
    target: float = 0.0

    def on(self, n):
        return replace(self, pressure=block_means(self.pressure, n))

    def errors(self, result):
        """Relative errors: of the load, and of the pressures in the L2 norm, on the same grid."""
        off = np.linalg.norm(result.pressure - self.pressure) / np.linalg.norm(self.pressure)
        return {'load_error': abs(result.load / self.load - 1), 'pressure_error': float(off)}


@dataclass(frozen=True)
class GridScene:
    """n: points a side of the grid that methods are compared on; the finest has 4n. gap(points a side). known(contact): None where the
    approach has to be searched and the finest grid is the truth. full: full contact alone."""
    gap: Callable
    name: str = ''
    n: int = 0
    boundary: str = 'free'
    control: str = 'approach'
    aspect: float = 1.0
    most_contact: float = 1.0
    full: bool = False
    known: Optional[Callable] = None

    def system(self, points):
        return unit_square(points, self.boundary, self.aspect)


def hertz(contact):
    sphere = Hertz(math.sqrt(contact / math.pi))
    return Truth(sphere.load, sphere.area, sphere.pressure, sphere.approach)


def wave(contact):
    """One wave of height 2 HEIGHT: Westergaard (1939) in the form of Johnson (1985), 13.2. The approach, measured between mean planes,
    follows from dd/dp = 2/(pi E*) ln(1/s), the field of a periodic row of flat strips, and p = pi E* height s^2."""
    s = math.sin(math.pi * contact / 2)
    load = math.pi * HEIGHT * s * s

    def pressure(n):
        x, y = coordinates(n)
        square = np.maximum(0, s * s - np.sin(math.pi * x)**2) + 0 * y
        return 2 * load / (s * s) * np.cos(math.pi * x) * np.sqrt(square)
    return Truth(load, contact, pressure, HEIGHT * s * s * (1 - 2 * math.log(s)))


def two_waves(n):
    x, y = (2 * math.pi * (np.arange(n) + 0.5) / n for _ in range(2))
    return np.cos(x)[None, :] * np.cos(y)[:, None]


def waves(_):
    """Pressed flat by 1.2 times the load that it takes: Johnson, Greenwood & Higginson (1985)."""
    amplitude = math.sqrt(2) * math.pi * HEIGHT
    load = 1.2 * amplitude
    return Truth(load, 1, lambda n: load + amplitude * two_waves(n), load)


def measured(file):
    """The largest square of a power of two points, from the middle."""
    surface = rc.read(file)
    heights, (hx, hy) = surface.heights, surface.pitch
    ny, nx = heights.shape
    side = 1 << (min(nx, ny).bit_length() - 1)
    left, top = (nx - side) // 2, (ny - side) // 2
    gap = below_highest(heights[top:top + side, left:left + side] / (side * hx))
    return GridScene(functools.partial(block_means, gap), n=side // 4, aspect=hy / hx)


# Scenes of n points a side, a power of two.
MADE = {
    'hertz': lambda n, seed: GridScene(paraboloid_gap, most_contact=0.5, known=hertz),  # the disc has to fit into the square
    'wave': lambda n, seed: GridScene(lambda m: HEIGHT * (1 - np.cos(2 * math.pi * coordinates(m)[0])) + 0 * coordinates(m)[1],
                                      boundary='periodic', known=wave),
    # Flat, the approach no longer tells the load.
    'waves': lambda n, seed: GridScene(lambda m: HEIGHT * (1 - two_waves(m)), boundary='periodic', control='load', full=True, known=waves),
    # A flat square punch that covers the grid: load = pi E* depth C.
    'punch': lambda n, seed: GridScene(lambda m: np.zeros((m, m)), full=True, known=lambda _: Truth(math.pi * CAPACITY * HEIGHT, 1, None, HEIGHT)),
    'self-affine': lambda n, seed: GridScene(lambda m: self_affine_gap(m, seed, cut_off=n / 8))}


def make_scene(name, n, folder, seed=1):
    """(scene or None, why it is not there). n: of the scenes that are not measured. folder: where measured surfaces lie."""
    if name in MEASURED:
        file = os.path.join(folder, MEASURED[name][1])
        if not folder or not os.path.exists(file):
            return None, f'{file} is not there' if folder else 'no folder of measured surfaces is given (--surfaces)'
        scene = measured(file)
    elif name in MADE:
        scene = MADE[name](n, seed)
    else:  # heights are made on the finest grid; the others have means over blocks of its cells
        hurst, levels = float(name.split('-')[1]), (4 * n).bit_length() - 1
        scene = GridScene(lambda m: block_means(below_highest(midpoint_surface(levels, hurst, seed)), m))
    return replace(scene, name=name, n=scene.n or n), ''


def search_approach(scene, contact, threads):
    """At which a share of the cells of the scene's grid is in contact, to 3 %, by loose solves."""
    return find_load(scene.system(scene.n), scene.gap(scene.n), contact, 0.2 * contact, 30, {'threads': threads}).approach


def solve_certified(scene, target, n, tol, threads):
    """(truth, result) of the certified solution on n x n cells."""
    result = solve(scene.system(n), scene.gap(n), {'tol': tol, 'threads': threads}, **{scene.control: target})
    return Truth(result.load, result.contact_area, result.pressure, target), result


def best_truth(scene, contact, target, threads):
    """(truth, source): what theory knows of the contact, completed by the solution on the finest grid, with pressures there."""
    known = scene.known and scene.known(contact)
    if known and known.pressure:
        return replace(known, pressure=known.pressure(4 * scene.n)), 'analytic'
    solved, _ = solve_certified(scene, target, 4 * scene.n, 1e-10, threads)
    return (replace(known, pressure=solved.pressure), 'analytic load') if known else (solved, 'finest grid')
